#include "engine/workbench/live_runner.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace trocar::workbench {
namespace {

using SteadyClock = std::chrono::steady_clock;
using std::chrono::duration;

}  // namespace

LiveRunner::LiveRunner(std::unique_ptr<trial::LiveSession> session, bool realtime)
    : session_(std::move(session)), realtime_(realtime) {
  show(0.0);  // there is a world to look at before the first tick
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LiveRunner::~LiveRunner() = default;  // jthread asks it to stop and joins

std::optional<LiveBatch> LiveRunner::take() {
  return batches_.pop();
}

void LiveRunner::run(const std::stop_token& stop) {
  const int steps_per_batch = realtime_ ? 10 : 50;
  constexpr double kTick_s = 1e-3;
  constexpr double kMostBehind_s = 0.25;
  const SteadyClock::time_point begin = SteadyClock::now();
  const auto wall_now_s = [begin] { return duration<double>(SteadyClock::now() - begin).count(); };
  double due_s = 0.0;
  while (!stop.stop_requested()) {
    const bool stopping = stopping_.load(std::memory_order_relaxed);
    for (int step = 0; step < steps_per_batch && !stopping && !session_->done(); ++step) {
      if (realtime_) {
        // Each tick in its own time: what a person does, a pedal let go say, is heard by the next one.
        const double tick_due_s = due_s + step * kTick_s;
        const double ahead_s = tick_due_s - wall_now_s();
        if (ahead_s > 0.0) std::this_thread::sleep_for(duration<double>(ahead_s));
        lateness_.add(static_cast<std::int64_t>(1e9 * (wall_now_s() - tick_due_s)));
      }
      session_->step();
    }
    LiveBatch batch{take_part(*session_), stopping || session_->done(), session_->outcome(), session_->placed()};
    if (stopping && !session_->done()) batch.outcome = demonstration::Outcome::kAborted;
    count(batch.part);
    show(wall_now_s());

    const bool last = batch.last;
    waiting_.push_back(std::move(batch));
    // What goes in real time never waits for the main thread, nor may anything be lost because that is behind.
    hand_over(stop, last || !realtime_);
    if (last) return;
    due_s = std::max(due_s + steps_per_batch * kTick_s, wall_now_s() - kMostBehind_s);
  }
}

void LiveRunner::count(const TakePart& part) {
  if (part.samples.empty()) return;
  if (samples_ == 0) first_tick_ = part.samples.front().tick;
  last_tick_ = part.samples.back().tick;
  samples_ += static_cast<std::int64_t>(part.samples.size());
}

void LiveRunner::measure_rate(double wall_s) {
  constexpr double kWindow_s = 0.5;
  const bool recording = session_->status().phase == trial::Phase::kRecording && samples_ > 0;
  const double passed_s = wall_s - rate_from_s_;
  if (recording && passed_s < kWindow_s) return;
  // What was no recording throughout tells nothing.
  if (recording && rate_from_samples_ > 0) {
    rate_hz_ = static_cast<double>(samples_ - rate_from_samples_) / passed_s;
  }
  rate_from_s_ = wall_s;
  rate_from_samples_ = recording ? samples_ : 0;
}

void LiveRunner::show(double wall_s) {
  measure_rate(wall_s);
  const double simulated_s = session_->state().tick.seconds();
  views_.back() = {session_->state(),
                   session_->segment(),
                   session_->authority(),
                   Tick{last_tick_ - first_tick_}.seconds(),
                   samples_,
                   wall_s > 0.0 ? simulated_s / wall_s : 0.0,
                   rate_hz_,
                   session_->status(),
                   session_->trial_status(),
                   lateness_};
  views_.publish();
}

void LiveRunner::hand_over(const std::stop_token& stop, bool all) {
  while (!waiting_.empty()) {
    if (batches_.push(std::move(waiting_.front()))) {  // moved only where there is room
      waiting_.pop_front();
      continue;
    }
    if (!all || stop.stop_requested()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the main thread is behind
  }
}

}  // namespace trocar::workbench
