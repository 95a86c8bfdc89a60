// A project with damage: each 4 bytes of the input overwrite one byte of a sound file (offset in 24 bits, then the
// byte); an odd byte at the end cuts the file to that many 256ths. It must be refused or read, and a file that is
// refused must be as it was.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/core/file.h"
#include "engine/workbench/project_file.h"

namespace {

namespace fs = std::filesystem;
using namespace trocar;
using namespace trocar::workbench;

fs::path scratch(const char* name) {
  return fs::temp_directory_path() / ("trocar_project_fuzz_" + std::to_string(::getpid()) + name);
}

std::string sound_project() {
  const fs::path path = scratch("_sound.trocar");
  fs::remove(path);
  {
    ProjectFile file = ProjectFile::create(path, std::make_shared<ManualClock>()).value();
    demonstration::Recording recording;
    for (int i = 0; i < 4; ++i) {
      recording.samples.emplace_back();
      recording.samples.back().tick = std::int64_t{i} * demonstration::kTicksPerSample;
    }
    const auto id = file.store_recording(recording).value();
    const DemonstrationId added{file.commit(AddDemonstration{id, "a"}).value()};
    (void)file.commit(EditDemonstration{added, demonstration::Rename{"b"}}).value();
  }
  std::string bytes = read_file(path).value();
  fs::remove(path);
  return bytes;
}

std::string damaged(std::string bytes, const std::uint8_t* data, std::size_t size) {
  for (std::size_t i = 0; i + 4 <= size; i += 4) {
    const std::size_t offset = std::size_t{data[i]} << 16 | std::size_t{data[i + 1]} << 8 | data[i + 2];
    bytes[offset % bytes.size()] = static_cast<char>(data[i + 3]);
  }
  if (size % 4 != 0) bytes.resize(bytes.size() * data[size - 1] / 256);
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sound = sound_project();
  const fs::path path = scratch(".trocar");
  const std::string bytes = damaged(sound, data, size);
  if (!write_file(path, bytes)) return 0;
  Diagnostics diagnostics;
  if (auto file = ProjectFile::open(path, std::make_shared<ManualClock>(), diagnostics)) {
    (void)file->undo();
    (void)file->redo();
  } else if (read_file(path).value() != bytes) {
    __builtin_trap();
  }
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(fs::path(path) += suffix);
  return 0;
}
