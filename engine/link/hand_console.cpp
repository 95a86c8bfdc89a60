#include "engine/link/hand_console.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

namespace trocar::link {
namespace {

constexpr std::int64_t kRetry_ns = 200'000'000;
constexpr double kLastAnswers_s = 2.0;

void sleep_until(std::int64_t at_ns) {
  std::this_thread::sleep_until(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(at_ns)));
}

std::int64_t later(std::int64_t now_ns, double seconds) {
  return now_ns + static_cast<std::int64_t>(std::llround(seconds * 1e9));
}

Result<HandClient> connect(const HandConsoleOptions& options, const Progress& progress) {
  const std::int64_t until_ns = later(monotonic_ns(), options.patience_s);
  while (true) {
    auto client = HandClient::connect(options.to, options.name, options.scripted);
    if (client || progress.cancelled() || monotonic_ns() >= until_ns) return client;
    sleep_until(monotonic_ns() + kRetry_ns);
  }
}

void settle(HandClient& client, HandConsoleReport& report) {
  report.sent += static_cast<std::int64_t>(client.sent());
  report.answered += static_cast<std::int64_t>(client.answered());
  for (const double seconds : client.round_trips().newest()) report.round_trips.add(seconds);
  for (const double seconds : client.delays().newest()) report.delays.add(seconds);
  if (client.answered() > 0) report.authority = client.ack().authority;
}

}  // namespace

Result<HandConsoleReport> run_hand_console(const HandConsoleOptions& options, Progress& progress) {
  if (!(options.rate_hz >= 1.0 && options.rate_hz <= 2000.0)) {
    return fail(ErrorCode::kInvalidArgument, "a console sends 1 to 2000 times a second");
  }
  if (!(options.seconds > 0.0 && options.seconds <= 86400.0)) {
    return fail(ErrorCode::kInvalidArgument, "a console sends for more than 0 s and no more than a day");
  }
  TROCAR_ASSIGN_OR_RETURN(HandClient client, connect(options, progress));
  HandConsoleReport report;
  report.connections = 1;
  const std::int64_t begin_ns = monotonic_ns();
  std::int64_t answered_ns = begin_ns;
  std::uint64_t answered = 0;
  for (std::int64_t i = 0; !progress.cancelled(); ++i) {
    const double t_s = static_cast<double>(i) / options.rate_hz;
    if (t_s > options.seconds) break;
    sleep_until(later(begin_ns, t_s));
    progress.set(t_s / options.seconds);
    // Who woke late sends what is true now, not what was then.
    const double now_s = 1e-9 * static_cast<double>(monotonic_ns() - begin_ns);
    i = std::max(i, static_cast<std::int64_t>(std::floor(now_s * options.rate_hz)));
    const Status sent = client.send(options.hand(static_cast<double>(i) / options.rate_hz));
    if (client.answered() != answered) answered_ns = monotonic_ns();
    answered = client.answered();
    if (!sent) {
      if (sent.error().code() == ErrorCode::kUnsupported) return tl::unexpected(sent.error());
      settle(client, report);
      // A relay takes every connection; only an answer tells that the workbench is behind it.
      if (answered == 0) sleep_until(monotonic_ns() + kRetry_ns);
      const bool gone = monotonic_ns() > later(answered_ns, options.patience_s);
      auto again = gone ? Result<HandClient>(tl::unexpected(sent.error())) : connect(options, progress);
      if (!again) {
        report.ended = sent.error().text();
        report.seconds = 1e-9 * static_cast<double>(monotonic_ns() - begin_ns);
        return report;
      }
      client = std::move(*again);
      answered = 0;
      ++report.connections;
    }
  }
  static_cast<void>(client.settle(kLastAnswers_s));
  report.seconds = 1e-9 * static_cast<double>(monotonic_ns() - begin_ns);
  settle(client, report);
  return report;
}

}  // namespace trocar::link
