#include "engine/workbench/live_runner.h"

#include <chrono>
#include <utility>

namespace trocar::workbench {
namespace {

using SteadyClock = std::chrono::steady_clock;
using std::chrono::duration;

}  // namespace

LiveRunner::LiveRunner(trial::TransferSession session, bool realtime)
    : session_(std::move(session)), realtime_(realtime) {
  show(0, 0.0);  // there is a world to look at before the first tick
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LiveRunner::~LiveRunner() = default;  // jthread asks it to stop and joins

std::optional<LiveBatch> LiveRunner::take() {
  return batches_.pop();
}

void LiveRunner::run(const std::stop_token& stop) {
  constexpr int kTicksPerBatch = 50;  // 20 batches a second
  const SteadyClock::time_point begin = SteadyClock::now();
  std::int64_t samples = 0;
  while (!stop.stop_requested()) {
    const bool stopping = stopping_.load(std::memory_order_relaxed);
    for (int tick = 0; tick < kTicksPerBatch && !stopping && !session_.done(); ++tick) session_.step();
    LiveBatch batch{session_.take_samples(), session_.take_marks(), stopping || session_.done(), session_.outcome(),
                    session_.placed()};
    if (stopping && !session_.done()) batch.outcome = demonstration::Outcome::kAborted;
    samples += static_cast<std::int64_t>(batch.samples.size());

    const double simulated_s = session_.state().tick.seconds();
    const double wall_s = duration<double>(SteadyClock::now() - begin).count();
    show(samples, wall_s);

    const bool last = batch.last;
    if (!hand_over(std::move(batch), stop) || last) return;
    if (realtime_ && simulated_s > wall_s) std::this_thread::sleep_for(duration<double>(simulated_s - wall_s));
  }
}

void LiveRunner::show(std::int64_t samples, double wall_s) {
  const double simulated_s = session_.state().tick.seconds();
  views_.back() = {session_.state(),
                   session_.segment(),
                   session_.authority(),
                   simulated_s,
                   samples,
                   wall_s > 0.0 ? simulated_s / wall_s : 0.0};
  views_.publish();
}

bool LiveRunner::hand_over(LiveBatch batch, const std::stop_token& stop) {
  while (!batches_.push(std::move(batch))) {  // NOLINT(bugprone-use-after-move): moved only where there is room
    if (stop.stop_requested()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the main thread is behind; nothing may be lost
  }
  return true;
}

}  // namespace trocar::workbench
