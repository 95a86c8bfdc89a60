/// Assertions for our own promises: a failed one is a bug of ours and ends the program with file and line.
#pragma once

namespace trocar::core {

/// Prints `expression`, `file` and `line` to standard error and aborts.
[[noreturn]] void check_failed(const char* expression, const char* file, int line);

}  // namespace trocar::core

/// Always on.
#define TROCAR_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::trocar::core::check_failed(#condition, __FILE__, __LINE__))

/// On in builds without NDEBUG; for hot loops.
#ifdef NDEBUG
#define TROCAR_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#else
#define TROCAR_ASSERT(condition) TROCAR_CHECK(condition)
#endif
