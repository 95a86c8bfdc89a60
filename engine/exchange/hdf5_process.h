/// The process that reads and writes HDF5 files for us (plugin/hdf5_main.cpp). Private to the module.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>

#include "engine/core/result.h"
#include "engine/exchange/tree_node.h"

namespace trocar::exchange {

/// Hands every node of the file to `take`, a group before what is in it; see `hdf5::read_file`.
/// Errors: kIo; kCorrupt, also if the file broke the process; kUnsupported if the process is not installed; those of
/// `take`, after which no more comes.
Status read_hdf5(const std::filesystem::path& path, const std::function<Status(TreeNode&&)>& take);

/// Writes a new file, node by node.
class Hdf5Writer {
 public:
  /// The file itself, not one beside it: see `write_hdf5`. Errors: kUnsupported, kIo.
  static Result<Hdf5Writer> create(const std::filesystem::path& path);
  Hdf5Writer(Hdf5Writer&& other) noexcept;
  Hdf5Writer& operator=(Hdf5Writer&&) = delete;
  ~Hdf5Writer();

  /// Groups come before what is in them. Errors: kIo, perhaps only at `finish`.
  Status add(const TreeNode& node);
  Status finish();

 private:
  Hdf5Writer(int socket, pid_t process) : socket_(socket), process_(process) {}
  int socket_;
  pid_t process_;
};

}  // namespace trocar::exchange
