#include "app/crash_report.h"

#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

namespace trocar::app {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

const char* program_name = "trocar";
// A stack that overflowed leaves no room for the handler.
alignas(16) std::array<char, 65536> handler_stack;

// Only what POSIX allows in a handler; a short write to a closed standard error is nobody's loss.
void say(const char* text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
}

const char* signal_name(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV";
    case SIGBUS:
      return "SIGBUS";
    case SIGFPE:
      return "SIGFPE";
    case SIGILL:
      return "SIGILL";
    default:
      return "SIGABRT";
  }
}

void on_crash(int signal) {
  say(program_name);
  say(": crashed (");
  say(signal_name(signal));
  say("); what was done up to here is in the project. Please report these lines:\n");
  std::array<void*, 64> calls;
  const int count = backtrace(calls.data(), static_cast<int>(calls.size()));
  backtrace_symbols_fd(calls.data(), count, STDERR_FILENO);
  // The handler was taken away on entry (SA_RESETHAND): this ends the program in the usual way.
  raise(signal);
}

}  // namespace

void report_crashes(const char* program) {
  if (kSanitized) return;
  program_name = program;
  // The first call loads a library, which a handler must not.
  std::array<void*, 1> here;
  backtrace(here.data(), 1);
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int each : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(each, &action, nullptr);
}

}  // namespace trocar::app
