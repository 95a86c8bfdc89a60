/// HDF5 files to and from tree nodes. Lives in a process of its own (hdf5_main.cpp): a file that breaks HDF5 breaks
/// nothing else.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/exchange/tree_node.h"

namespace trocar::exchange::hdf5 {

/// No error stack on standard error, no filters loaded from elsewhere, no locks. Once in a process, first.
void be_quiet();

/// Hands every group, array and link to `take`, a group before what is in it. Only hard links are followed, each object
/// once; of arrays, numbers of up to 64 bits in at most two dimensions and texts in one are read.
/// Errors: kCorrupt if the file is not HDF5 or its root cannot be read, kUnsupported if it holds too much; those of
/// `take`.
Status read_file(const std::string& path, const std::function<Status(const TreeNode&)>& take);

/// A new file; `close` must be called to know that it is whole.
class FileWriter {
 public:
  /// Errors: kIo.
  static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&&) noexcept;
  FileWriter& operator=(FileWriter&&) noexcept;
  ~FileWriter();

  /// Groups come before what is in them; the root is there. Errors: kIo.
  Status add(const TreeNode& node);
  Status close();

 private:
  struct Impl;
  explicit FileWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::exchange::hdf5
