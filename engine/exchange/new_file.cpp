#include "engine/exchange/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/core/file.h"

namespace trocar::exchange {

NewFile::NewFile(std::filesystem::path target) : target_(std::move(target)), temporary_(temporary_beside(target_)) {}

NewFile::~NewFile() {
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);  // after a rename there is none
}

Status NewFile::put_in_place() {
  const int fd = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = fd >= 0 && (::fsync(fd) == 0 || errno == EINVAL);
  const int reason = errno;
  if (fd >= 0) ::close(fd);
  if (!synced) return fail(ErrorCode::kIo, fmt::format("could not write the file ({})", std::strerror(reason)));
  if (::rename(temporary_.c_str(), target_.c_str()) == 0) return {};
  return fail(ErrorCode::kIo, fmt::format("could not put the file in place ({})", std::strerror(errno)));
}

}  // namespace trocar::exchange
