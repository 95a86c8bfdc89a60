/// A file that another process writes: under another name until it is whole. Private to the module.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace trocar::exchange {

class NewFile {
 public:
  /// `target` as `replaceable_file` gives it.
  explicit NewFile(std::filesystem::path target);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  /// Where it is to be written.
  const std::filesystem::path& path() const { return temporary_; }
  /// Syncs and renames. Errors: kIo.
  Status put_in_place();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

}  // namespace trocar::exchange
