#include "app/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <stop_token>
#include <thread>

namespace trocar::app {
namespace {

std::atomic<Progress*> interrupted{nullptr};

void on_signal(int /*signal*/) {
  Progress* progress = interrupted.load();
  if (progress == nullptr || progress->cancelled()) _exit(kExitWorld);
  progress->cancel();
}

void draw_bar(double fraction, double elapsed_s) {
  constexpr int kWidth = 30;
  const int full = std::clamp(static_cast<int>(fraction * kWidth), 0, kWidth);
  fmt::print(stderr, "\r{:━<{}}{:─<{}} {:3.0f} %  {:.0f} s ", "", full, "", kWidth - full, 100.0 * fraction, elapsed_s);
  std::fflush(stderr);
}

}  // namespace

ExitCode exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::kCheckFailed:
      return kExitCheckFailed;
    case ErrorCode::kInvalidArgument:
    case ErrorCode::kNotFound:
      return kExitUsage;
    case ErrorCode::kOutOfReach:
    case ErrorCode::kIo:
    case ErrorCode::kCorrupt:
    case ErrorCode::kUnsupported:
    case ErrorCode::kCancelled:
      return kExitWorld;
  }
  return kExitWorld;
}

void Console::restart_progress() {
  progress_->set(0.0);
}

Status Console::check_not_cancelled() const {
  return progress_->cancelled() ? Status(fail(ErrorCode::kCancelled, "stopped by the user")) : Status();
}

Status Console::print(const Answer& answer) {
  std::string text;
  if (json) {
    text = answer.json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  } else if (!quiet) {
    text = (answer.text.empty() ? answer.summary : answer.text) + "\n";
  }
  errno = 0;
  std::fwrite(text.data(), 1, text.size(), stdout);
  const bool flushed = std::fflush(stdout) == 0;
  const int reason = errno;
  print_warnings();
  if (flushed && std::ferror(stdout) == 0) return {};
  return fail(ErrorCode::kIo, reason == 0 ? "the answer could not be printed"
                                          : fmt::format("the answer could not be printed ({})", std::strerror(reason)));
}

void Console::print_error(const Error& error) const {
  fmt::print(stderr, "{}: {}\n", program, error.text());
}

ExitCode Console::give_up(const Error& error) const {
  const ExitCode code = exit_code(error.code());
  if (json) {
    const Json object = {{"error", error.text()}, {"exit", static_cast<int>(code)}};
    fmt::print("{}\n", object.dump(2, ' ', false, Json::error_handler_t::replace));
    std::fflush(stdout);
  }
  print_error(error);
  return code;
}

void Console::print_warnings() {
  for (; printed_warnings_ < diagnostics.warnings().size(); ++printed_warnings_) {
    fmt::print(stderr, "warning: {}\n", diagnostics.warnings()[printed_warnings_]);
  }
}

void cancel_on_signals(Console& console) {
  interrupted.store(&console.progress());
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);  // NOLINT(bugprone-signal-handler): ignored, not handled
}

std::string shown(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const Json& part : value) text += (text.empty() ? "" : ", ") + shown(part);
  return text.empty() ? "–" : text;
}

struct ProgressBar::Impl {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::jthread thread;
};

ProgressBar::ProgressBar(Console& console) {
  if (console.quiet) return;
  impl_ = std::make_unique<Impl>();
  impl_->thread = std::jthread([impl = impl_.get(), &console](const std::stop_token& stop) {
    const bool terminal = isatty(STDERR_FILENO) != 0;
    constexpr double kBetweenLines_s = 10.0;
    const double begin_s = console.clock->now_s();
    double next_line_s = kBetweenLines_s;
    bool drawn = false;
    std::unique_lock lock(impl->mutex);
    while (!impl->wake.wait_for(lock, stop, std::chrono::milliseconds(150), [] { return false; })) {
      if (stop.stop_requested()) break;
      const double elapsed_s = console.clock->now_s() - begin_s;
      if (!terminal && elapsed_s >= next_line_s) {
        next_line_s += kBetweenLines_s;
        fmt::print(stderr, "{:.0f} % after {:.0f} s\n", 100.0 * console.progress().fraction(), elapsed_s);
      }
      if (!terminal || elapsed_s < 0.4) continue;
      draw_bar(console.progress().fraction(), elapsed_s);
      drawn = true;
    }
    if (drawn) fmt::print(stderr, "\r\033[K");
  });
}

ProgressBar::~ProgressBar() = default;

}  // namespace trocar::app
