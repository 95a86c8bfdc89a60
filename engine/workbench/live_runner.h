/// Owns the simulation thread: steps a session in real time (or as fast as it goes) and hands out what it recorded.
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "engine/core/spsc_queue.h"
#include "engine/core/triple_buffer.h"
#include "engine/demonstration/recording.h"
#include "engine/link/tick_pacer.h"
#include "engine/simulation/world_state.h"
#include "engine/trial/live_session.h"
#include "engine/workbench/take_writer.h"

namespace trocar::workbench {

/// A session that runs now.
struct LiveView {
  simulation::WorldState world;
  demonstration::Segment segment = demonstration::Segment::kA;
  demonstration::Authority authority = demonstration::Authority::kOperator;
  double elapsed_s = 0.0;  ///< Simulated, since recording began.
  std::int64_t samples = 0;
  double realtime_factor = 0.0;  ///< Simulated seconds for each second of wall time, over the whole run.
  double rate_hz = 0.0;          ///< Samples for each second of wall time, lately; 0 until known.
  trial::SessionStatus status;
  std::optional<trial::TrialStatus> trial;
  link::LatenessHistogram lateness;  ///< Of the ticks so far; none if it goes as fast as it can.
};

/// What the thread recorded since the last batch, and how it ended if it has.
struct LiveBatch {
  TakePart part;
  bool last = false;
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;
  bool placed = false;
};

/// Threads: everything here in the main thread.
class LiveRunner {
 public:
  /// Starts to step at once. `realtime` false: as fast as it goes. A machine that falls behind real time by more than a
  /// quarter of a second is not made to catch up.
  LiveRunner(std::unique_ptr<trial::LiveSession> session, bool realtime);
  LiveRunner(const LiveRunner&) = delete;
  LiveRunner& operator=(const LiveRunner&) = delete;
  ~LiveRunner();

  /// Asks for the end; the last batch follows.
  void stop() { stopping_.store(true, std::memory_order_relaxed); }
  std::optional<LiveBatch> take();
  /// True if there is a newer view since the last call.
  bool update() { return views_.update(); }
  const LiveView& view() const { return views_.front(); }

 private:
  void run(const std::stop_token& stop);
  void show(double wall_s);
  void count(const TakePart& part);
  void measure_rate(double wall_s);
  /// Puts what waits into the queue, as far as there is room; `all`: waits for it.
  void hand_over(const std::stop_token& stop, bool all);

  std::unique_ptr<trial::LiveSession> session_;
  bool realtime_;
  std::int64_t samples_ = 0;
  std::int64_t first_tick_ = 0;
  std::int64_t last_tick_ = 0;
  double rate_hz_ = 0.0;
  double rate_from_s_ = 0.0;  ///< Wall time; likewise the samples then.
  std::int64_t rate_from_samples_ = 0;
  std::atomic<bool> stopping_{false};
  link::LatenessHistogram lateness_;
  std::deque<LiveBatch> waiting_;
  SpscQueue<LiveBatch> batches_{256};
  TripleBuffer<LiveView> views_;
  std::jthread thread_;
};

}  // namespace trocar::workbench
