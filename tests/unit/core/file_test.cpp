#include "engine/core/file.h"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

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

TEST_CASE("a missing file is an I/O error, and the message ends with the path") {
  const auto text = trocar::read_file("/nowhere/at/all");
  REQUIRE_FALSE(text);
  CHECK(text.error().code() == ErrorCode::kIo);
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

TEST_CASE("a disk that fills up while writing is an error, and the old file stays as it was") {
  const fs::path folder = scratch_folder();
  REQUIRE(trocar::write_file(folder / "x", "old"));
  // In a process of its own, as the limit is one of a process.
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{5000, 5000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = trocar::write_file(folder / "x", std::string(10000, 'n'));
    ::_exit(!written && written.error().code() == ErrorCode::kIo ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  CHECK(trocar::read_file(folder / "x").value() == "old");
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}) == 1);
  fs::remove_all(folder);
}

TEST_CASE("a link is written through and stays a link, also where it leads to nothing yet") {
  const fs::path folder = scratch_folder();
  fs::create_directory(folder / "far");
  fs::create_symlink("far/target", folder / "middle");
  fs::create_symlink(folder / "middle", folder / "link");
  for (const std::string text : {"first", "second"}) {
    REQUIRE(trocar::write_file(folder / "link", text));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(fs::is_symlink(folder / "middle"));
    CHECK(trocar::read_file(folder / "far" / "target").value() == text);
  }
  fs::create_symlink("circle", folder / "circle");
  CHECK(trocar::write_file(folder / "circle", "x").error().code() == ErrorCode::kIo);
  CHECK(fs::is_symlink(folder / "circle"));
  fs::remove_all(folder);
}

TEST_CASE("what is no file is never replaced by one") {
  const fs::path folder = scratch_folder();
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_directory(folder / "folder");
  fs::create_symlink("pipe", folder / "to_pipe");
  for (const char* name : {"pipe", "to_pipe", "folder"}) {
    const auto written = trocar::write_file(folder / name, "x");
    REQUIRE_FALSE(written);
    CHECK(written.error().code() == ErrorCode::kIo);
    CHECK(written.error().text().ends_with((folder / name).string()));
  }
  CHECK(fs::is_fifo(folder / "pipe"));
  CHECK(fs::is_directory(folder / "folder"));
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}) == 3);
  fs::remove_all(folder);
}

TEST_CASE("a file is written and read in pieces, and its pieces are whole but for the last") {
  const fs::path folder = scratch_folder();
  const auto make = [](const trocar::TakeBytes& take) -> trocar::Status {
    for (int i = 0; i < 100; ++i) TROCAR_RETURN_IF_ERROR(take(std::string(7, static_cast<char>('a' + i % 26))));
    return {};
  };
  REQUIRE(trocar::write_file(folder / "x", make, {}));
  std::string all;
  std::vector<std::size_t> sizes;
  const auto take = [&](std::string_view piece) -> trocar::Status {
    all += piece;
    sizes.push_back(piece.size());
    return {};
  };
  REQUIRE(trocar::read_pieces(folder / "x", 256, take));
  CHECK(sizes == std::vector<std::size_t>{256, 256, 188});
  CHECK(all == trocar::read_file(folder / "x").value());
  CHECK_FALSE(trocar::read_pieces(folder / "none", 256, take));
  fs::remove_all(folder);
}

TEST_CASE("what a check refuses is not put in place, and the check sees all that was written") {
  const fs::path folder = scratch_folder();
  REQUIRE(trocar::write_file(folder / "x", "old"));
  std::string seen;
  const auto written = trocar::write_file(
      folder / "x", [](const trocar::TakeBytes& take) { return take("new"); },
      [&](const fs::path& path) -> trocar::Status {
        seen = trocar::read_file(path).value();
        return trocar::fail(ErrorCode::kIo, "it is not good enough");
      });
  CHECK_FALSE(written);
  CHECK(seen == "new");
  CHECK(trocar::read_file(folder / "x").value() == "old");
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}) == 1);
  fs::remove_all(folder);
}
