/// The state of one transfer, found from what happens in the world: segment, lift attempt, drop, hand-off, placed.
#pragma once

#include <array>
#include <optional>

#include "engine/demonstration/recording.h"
#include "engine/simulation/world_state.h"

namespace trocar::trial {

/// Whether a condition has held without a break for a given time. Threads: one at a time.
class Lasting {
 public:
  explicit Lasting(Tick needed) : needed_(needed) {}
  /// Precondition: `now` does not run backwards.
  bool update(bool condition, Tick now);

 private:
  Tick needed_;
  std::optional<Tick> since_;
};

/// The definitions are those of "Shared control", section Trial. Threads: one at a time.
///
/// Segments only go forward: A ends over the block, B when it is lifted clear of the pegs, C near the hand-off, D when
/// the user has let go of a block that the assistant holds.
class Task {
 public:
  /// Preconditions: 0 ≤ block, goal < 6.
  Task(int block, int goal);

  /// Call every `kTicksPerSample` ticks, in order.
  void update(const simulation::WorldState& state);

  demonstration::Segment segment() const { return segment_; }
  /// `kUnfinished` until it is a success (paper) or dropped.
  demonstration::Outcome outcome() const { return outcome_; }
  /// Seated on the goal peg with both grippers open, now.
  bool placed() const { return placed_; }
  bool lift_attempted() const { return lift_attempted_; }
  /// Times the left jaws closed and stayed shut without the block.
  int misses() const { return misses_; }
  /// Times it was lifted after it had rested: each is an attempt, as is each miss.
  int lifts() const { return lifts_; }
  /// When the outcome was decided.
  std::optional<Tick> decided_at() const { return decided_at_; }

 private:
  void update_outcome(const simulation::WorldState& state);
  void update_segment(const simulation::WorldState& state);
  void update_misses(const simulation::WorldState& state);
  void decide(demonstration::Outcome outcome, Tick now);

  int block_;
  int goal_;
  demonstration::Segment segment_ = demonstration::Segment::kA;
  demonstration::Outcome outcome_ = demonstration::Outcome::kUnfinished;
  std::optional<Tick> decided_at_;
  bool placed_ = false;
  bool lift_attempted_ = false;
  int misses_ = 0;
  int lifts_ = 0;
  bool lifting_ = false;
  Lasting lifted_;
  Lasting lost_;
  Lasting handed_;
  Lasting seated_;
  Lasting shut_;
  bool shut_before_ = true;
  std::array<Eigen::Vector3d, 10> tips_{};  ///< Of the left arm, the last 50 ms.
  std::size_t tip_count_ = 0;
};

/// Smaller openings count as closed when nothing is between the jaws.
constexpr double kClosed_rad = 0.035;
/// The opening from which a gripper counts as open.
constexpr double kOpen_rad = 0.12;

}  // namespace trocar::trial
