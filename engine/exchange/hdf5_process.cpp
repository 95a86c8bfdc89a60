#include "engine/exchange/hdf5_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "engine/exchange/tree_stream.h"

namespace trocar::exchange {
namespace {

namespace fs = std::filesystem;

struct Process {
  int socket = -1;
  pid_t id = -1;
};

/// As for the media plugin: where a developer says, where it is installed, where it is built.
std::optional<fs::path> find_program() {
  std::error_code ignored;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  std::vector<fs::path> folders{prefix / "lib" / "trocar", prefix / "lib"};
  if (const char* chosen = std::getenv("TROCAR_PLUGINS")) folders.insert(folders.begin(), chosen);
  for (const fs::path& folder : folders) {
    fs::path program = folder / "trocar-hdf5";
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  return std::nullopt;
}

/// `pair[1]` becomes its standard input and output.
Result<pid_t> spawn(const fs::path& program, const char* mode, const fs::path& file, int socket) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = program.string();
  std::string mode_text = mode;
  std::string path = fs::absolute(file).string();
  char* arguments[] = {name.data(), mode_text.data(), path.data(), nullptr};
  pid_t id = -1;
  const int failed = ::posix_spawn(&id, name.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == 0) return id;
  return tl::unexpected(
      Error(ErrorCode::kUnsupported, fmt::format("could not start the HDF5 process ({})", std::strerror(failed)))
          .at(name));
}

Result<Process> start(const char* mode, const fs::path& file) {
  const std::optional<fs::path> program = find_program();
  if (!program) {
    return fail(ErrorCode::kUnsupported, "trocar-hdf5 is missing, so HDF5 files cannot be read or written");
  }
  int pair[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) {
    return fail(ErrorCode::kIo, fmt::format("could not start the HDF5 process ({})", std::strerror(errno)));
  }
  const Result<pid_t> id = spawn(*program, mode, file, pair[1]);
  ::close(pair[1]);
  if (!id) {
    ::close(pair[0]);
    return tl::unexpected(id.error());
  }
  return Process{pair[0], *id};
}

/// Hangs up and waits; the process ends by itself when nobody listens.
int end(int socket, pid_t id) {
  ::close(socket);
  int status = 0;
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// What the process said last; nothing if that all went well.
Status verdict(const TreeNode& last) {
  if (last.why.empty()) return {};
  const auto code = last.attributes.find("code");
  const auto* number = code == last.attributes.end() ? nullptr : std::get_if<std::int64_t>(&code->second);
  const bool known = number != nullptr && *number >= 0 && *number <= static_cast<int>(ErrorCode::kCancelled);
  return fail(known ? static_cast<ErrorCode>(*number) : ErrorCode::kCorrupt, last.why);
}

/// Of a process that ended without a last word.
Error silence(int status) {
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM)) {
    return Error(ErrorCode::kCancelled, "the HDF5 process was interrupted");
  }
  return Error(ErrorCode::kCorrupt, "the HDF5 file is damaged: HDF5 fails over it");
}

/// A pipe would keep the process waiting for ever, a device give it what is no file.
Status check_file(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return fail(ErrorCode::kIo, fmt::format("could not open the file ({})", std::strerror(errno)));
  struct stat what {};
  const bool file = ::fstat(fd, &what) == 0 && S_ISREG(what.st_mode);
  ::close(fd);
  return file ? Status() : fail(ErrorCode::kIo, "could not read the file (it is a folder, a device or a pipe)");
}

}  // namespace

Status read_hdf5(const fs::path& path, const std::function<Status(TreeNode&&)>& take) {
  TROCAR_RETURN_IF_ERROR(check_file(path));
  TROCAR_ASSIGN_OR_RETURN(const Process process, start("read", path));
  for (;;) {
    Result<std::optional<TreeNode>> node = receive_node(process.socket);
    if (node && *node && (*node)->kind != TreeNode::Kind::kFailure) {
      const Status taken = take(std::move(**node));
      if (taken) continue;
      end(process.socket, process.id);
      return taken;
    }
    const int status = end(process.socket, process.id);
    if (!node || !*node) return tl::unexpected(silence(status));
    return verdict(**node);
  }
}

Result<Hdf5Writer> Hdf5Writer::create(const fs::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const Process process, start("write", path));
  return Hdf5Writer(process.socket, process.id);
}

Hdf5Writer::Hdf5Writer(Hdf5Writer&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), process_(std::exchange(other.process_, -1)) {}

Hdf5Writer::~Hdf5Writer() {
  if (process_ >= 0) end(socket_, process_);
}

Status Hdf5Writer::add(const TreeNode& node) {
  // When the process is gone, its last word is still there to be read, and says more than that.
  if (const Status sent = send_node(socket_, node); !sent) {
    TROCAR_RETURN_IF_ERROR(finish());
    return sent;
  }
  return {};
}

Status Hdf5Writer::finish() {
  if (process_ < 0) return fail(ErrorCode::kIo, "the HDF5 process is gone");
  TreeNode last;
  last.kind = TreeNode::Kind::kFailure;
  send_node(socket_, last).map_error([](const Error&) {});  // NOLINT(bugprone-unused-return-value)
  const Result<std::optional<TreeNode>> answer = receive_node(socket_);
  const int status = end(std::exchange(socket_, -1), std::exchange(process_, -1));
  if (!answer || !*answer) {
    const Error error = silence(status);
    if (error.code() == ErrorCode::kCancelled) return tl::unexpected(error);
    return fail(ErrorCode::kIo, "could not write the file (the HDF5 process failed)");
  }
  return verdict(**answer);
}

}  // namespace trocar::exchange
