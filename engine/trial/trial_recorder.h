/// What a trial leaves behind while it runs: samples, hashes, events.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/demonstration/recording.h"
#include "engine/trial/trial_options.h"

namespace trocar::trial {

/// Each `take_…` gives what came since the last one. Threads: one at a time.
class TrialRecorder {
 public:
  explicit TrialRecorder(std::string initial_world) : initial_world_(std::move(initial_world)) {}

  /// Of every 5th tick.
  void add(const demonstration::Sample& sample);
  /// Of a tick before the next of these: only kept if the setpoints are cut short there (`keep_between`).
  void add_between(const demonstration::Sample& sample) { between_.push_back(sample); }
  void keep_between();
  void mark(Tick now, std::uint64_t hash) { marks_.push_back({now.count, hash}); }
  void log(Tick now, TrialEventKind kind, std::string text) { events_.push_back({now.count, kind, std::move(text)}); }

  /// Once.
  std::optional<std::string> take_initial_world();
  std::vector<demonstration::Sample> take_samples() { return std::exchange(samples_, {}); }
  std::vector<demonstration::HashMark> take_marks() { return std::exchange(marks_, {}); }
  std::vector<TrialEvent> take_events() { return std::exchange(events_, {}); }

 private:
  std::optional<std::string> initial_world_;
  std::vector<demonstration::Sample> samples_;
  std::vector<demonstration::Sample> between_;
  std::vector<demonstration::HashMark> marks_;
  std::vector<TrialEvent> events_;
};

}  // namespace trocar::trial
