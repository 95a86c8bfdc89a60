/// All that is wrong, odd or worth knowing about a demonstration: one list for command line, timeline and panel.
#pragma once

#include <string>
#include <vector>

#include "engine/demonstration/problems.h"
#include "engine/review/clearance.h"
#include "engine/spatial/grid.h"

namespace trocar::review {

using demonstration::Problem;

/// What a model asks of one segment of a demonstration.
struct SegmentGoal {
  std::string model;  ///< Its name.
  demonstration::Segment segment = demonstration::Segment::kA;
  spatial::Grid grid;
  spatial::CellSet safe;
  spatial::CellIndex goal;
};

struct ReviewOptions {
  spatial::Grid grid;
  demonstration::MotionBounds bounds;
  double clearance_m = 0.0002;  ///< Nearer is a warning.
  /// Deeper is a collision. Less is a warning: jaws and pegs yield, and the simulator does not hold wrist and shaft off
  /// the pegs, which its experts graze by up to 0.7 mm.
  double touch_m = 0.001;
  std::vector<SegmentGoal> goals;  ///< May be empty.
};

struct Review {
  std::vector<Problem> problems;  ///< By time, each with its id.
  ClearanceCurve clearance;       ///< Of the gated samples.
};

/// Threads: one at a time.
class Reviewer {
 public:
  explicit Reviewer(std::shared_ptr<ClearanceStore> store = std::make_shared<ClearanceStore>())
      : clearance_(std::move(store)) {}

  /// Quick after a small edit: distances are worked out anew for what it touched alone.
  Review make(const demonstration::Demonstration& document, const ReviewOptions& options = {});

 private:
  ClearanceMaker clearance_;
};

/// How many of a severity.
std::size_t count_of(const std::vector<Problem>& problems, demonstration::Severity severity);

}  // namespace trocar::review
