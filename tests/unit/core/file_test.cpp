#include "engine/core/file.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>

namespace fs = std::filesystem;
using trocar::ErrorCode;

namespace {

fs::path scratch_folder() {
  fs::path folder = fs::temp_directory_path() / ("trocar_file_test_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  return folder;
}

}  // namespace

TEST_CASE("what is written is what is read, and nothing else is left in the folder") {
  const fs::path folder = scratch_folder();
  const std::string bytes("a\0b\n", 4);
  REQUIRE(trocar::write_file(folder / "x.bin", bytes));
  CHECK(trocar::read_file(folder / "x.bin").value() == bytes);
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}) == 1);
  fs::remove_all(folder);
}

TEST_CASE("a missing file is not found, and the message ends with the path") {
  const auto text = trocar::read_file("/nowhere/at/all");
  REQUIRE_FALSE(text);
  CHECK(text.error().code() == ErrorCode::kNotFound);
  CHECK(text.error().text().ends_with(": /nowhere/at/all"));
}

TEST_CASE("a folder that does not exist gives an I/O error and no file") {
  const auto status = trocar::write_file("/nowhere/at/all", "x");
  REQUIRE_FALSE(status);
  CHECK(status.error().code() == ErrorCode::kIo);
}

TEST_CASE("a file over the limit is refused") {
  const fs::path folder = scratch_folder();
  REQUIRE(trocar::write_file(folder / "big", std::string(1000, 'x')));
  CHECK_FALSE(trocar::read_file(folder / "big", 999));
  CHECK(trocar::read_file(folder / "big", 1000));
  fs::remove_all(folder);
}

TEST_CASE("a full disk is an error and leaves the old file alone") {
  if (!fs::exists("/dev/full")) return;
  // /dev/full cannot be renamed onto, but writing to it fails as a full disk does.
  CHECK_FALSE(trocar::write_file("/dev/full/x", "data"));
}
