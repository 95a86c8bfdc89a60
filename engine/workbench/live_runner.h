/// Owns the simulation thread: steps a transfer in real time (or as fast as it goes) and hands out what it recorded.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "engine/core/spsc_queue.h"
#include "engine/core/triple_buffer.h"
#include "engine/demonstration/recording.h"
#include "engine/simulation/world_state.h"
#include "engine/trial/transfer_session.h"

namespace trocar::workbench {

/// A transfer that is being recorded now.
struct LiveView {
  simulation::WorldState world;
  demonstration::Segment segment = demonstration::Segment::kA;
  demonstration::Authority authority = demonstration::Authority::kOperator;
  double elapsed_s = 0.0;  ///< Simulated.
  std::int64_t samples = 0;
  double realtime_factor = 0.0;  ///< Simulated seconds for each second of wall time, over the whole run.
};

/// What the thread recorded since the last batch, and how it ended if it has.
struct LiveBatch {
  std::vector<demonstration::Sample> samples;
  std::vector<demonstration::HashMark> marks;
  bool last = false;
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;
  bool placed = false;
};

/// Threads: everything here in the main thread.
class LiveRunner {
 public:
  /// Starts to step at once. `realtime` false: as fast as it goes.
  LiveRunner(trial::TransferSession session, bool realtime);
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
  void show(std::int64_t samples, double wall_s);
  bool hand_over(LiveBatch batch, const std::stop_token& stop);

  trial::TransferSession session_;
  bool realtime_;
  std::atomic<bool> stopping_{false};
  SpscQueue<LiveBatch> batches_{256};
  TripleBuffer<LiveView> views_;
  std::jthread thread_;
};

}  // namespace trocar::workbench
