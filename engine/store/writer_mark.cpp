#include "engine/store/writer_mark.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

namespace trocar::store {
namespace {

/// Field 22 of /proc/PID/stat, in clock ticks since the boot; nothing if there is no such process.
std::optional<std::string> start_of(long pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  // The program's name in field 2 may hold spaces; it ends at the last parenthesis.
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(name_end + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i) fields >> field;
  return field;
}

std::string boot() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

std::string mark_of(long pid, const std::string& start) {
  return fmt::format("{} {} {}", pid, start, boot());
}

}  // namespace

std::string writer_mark() {
  return mark_of(::getpid(), start_of(::getpid()).value_or("0"));
}

bool writer_lives(std::string_view mark) {
  long pid = 0;
  if (std::from_chars(mark.data(), mark.data() + mark.size(), pid).ec != std::errc()) return false;
  const std::optional<std::string> start = start_of(pid);
  return start && mark == mark_of(pid, *start);
}

}  // namespace trocar::store
