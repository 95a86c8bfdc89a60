#include "engine/core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace trocar {
namespace {

/// Closes on every path out.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

std::string reason() {
  return std::strerror(errno);
}

Status write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return fail(ErrorCode::kIo, "could not write the file (" + reason() + ")");
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

Status sync(int fd) {
  if (::fsync(fd) != 0 && errno != EINVAL) return fail(ErrorCode::kIo, "could not write the file (" + reason() + ")");
  return {};
}

/// Fills `buffer` as far as the file goes; the number of bytes, or -1 with `errno`.
ssize_t read_full(int fd, std::string& buffer) {
  std::size_t filled = 0;
  while (filled < buffer.size()) {
    const ssize_t n = ::read(fd, buffer.data() + filled, buffer.size() - filled);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return n;
    if (n == 0) break;
    filled += static_cast<std::size_t>(n);
  }
  return static_cast<ssize_t>(filled);
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) {
    return tl::unexpected(Error(ErrorCode::kIo, "could not open the file (" + reason() + ")").at(path.string()));
  }
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t n = ::read(file.get(), buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      return tl::unexpected(Error(ErrorCode::kIo, "could not read the file (" + reason() + ")").at(path.string()));
    if (n == 0) return text;
    if (text.size() + static_cast<std::size_t>(n) > limit_bytes) {
      return tl::unexpected(
          Error(ErrorCode::kIo, fmt::format("the file is larger than {} bytes", limit_bytes)).at(path.string()));
    }
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

Result<std::filesystem::path> replaceable_file(const std::filesystem::path& path) {
  constexpr int kMostLinks = 40;  // As the kernel's own limit.
  const auto refuse = [&path](std::string_view why) {
    return tl::unexpected(Error(ErrorCode::kIo, fmt::format("could not write the file ({})", why)).at(path.string()));
  };
  std::filesystem::path target = path;
  for (int links = 0;; ++links) {
    std::error_code error;
    const std::filesystem::file_type type = std::filesystem::symlink_status(target, error).type();
    // What cannot be looked at cannot be written either; the write itself says why.
    if (type == std::filesystem::file_type::not_found || type == std::filesystem::file_type::none) return target;
    if (type == std::filesystem::file_type::regular) return target;
    if (type == std::filesystem::file_type::directory) return refuse("a folder has that name");
    if (type != std::filesystem::file_type::symlink) return refuse("it is a device or a pipe, not a file");
    if (links == kMostLinks) return refuse("its links lead in a circle");
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) return refuse(error.message());
    target = target.parent_path() / next;  // An absolute `next` replaces all of it.
  }
}

Status write_file(const std::filesystem::path& path, std::string_view bytes) {
  return write_file(path, [bytes](const TakeBytes& take) { return take(bytes); }, {});
}

Status write_file(const std::filesystem::path& path, const std::function<Status(const TakeBytes&)>& make,
                  const std::function<Status(const std::filesystem::path&)>& check) {
  TROCAR_ASSIGN_OR_RETURN(const std::filesystem::path target, replaceable_file(path));
  const std::filesystem::path temporary = temporary_beside(target);
  Status status;
  {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.get() < 0) {
      status = fail(ErrorCode::kIo, "could not create the file (" + reason() + ")");
    } else {
      status = make([&file](std::string_view bytes) { return write_all(file.get(), bytes); });
      if (status) status = sync(file.get());
    }
  }
  if (status && check) status = check(temporary);
  if (status && ::rename(temporary.c_str(), target.c_str()) != 0) {
    status = fail(ErrorCode::kIo, "could not put the file in place (" + reason() + ")");
  }
  if (status) return status;
  ::unlink(temporary.c_str());
  return tl::unexpected(std::move(status).error().at(path.string()));
}

Status read_pieces(const std::filesystem::path& path, std::size_t piece_bytes, const TakeBytes& take) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) {
    return tl::unexpected(Error(ErrorCode::kIo, "could not open the file (" + reason() + ")").at(path.string()));
  }
  std::string piece(piece_bytes, '\0');
  for (;;) {
    const ssize_t n = read_full(file.get(), piece);
    if (n < 0) {
      return tl::unexpected(Error(ErrorCode::kIo, "could not read the file (" + reason() + ")").at(path.string()));
    }
    if (n > 0) TROCAR_RETURN_IF_ERROR(take(std::string_view(piece).substr(0, static_cast<std::size_t>(n))));
    if (static_cast<std::size_t>(n) < piece.size()) return {};
  }
}

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::filesystem::path name = path.stem();
  name += fmt::format(".{}.part", ::getpid());
  name += path.extension();
  return path.parent_path() / name;
}

std::filesystem::path share_path(std::string_view relative) {
  if (const char* share = std::getenv("TROCAR_SHARE")) return std::filesystem::path(share) / relative;
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  std::filesystem::path installed = program.parent_path().parent_path() / "share" / "trocar" / relative;
  if (std::filesystem::exists(installed, ignored)) return installed;
  return std::filesystem::path(TROCAR_SOURCE_DIR) / relative;
}

}  // namespace trocar
