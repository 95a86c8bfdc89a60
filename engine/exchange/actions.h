/// Actions for policies: the step of each arm's setpoint from one sample to the next, every number in [−1, 1].
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "engine/demonstration/recording.h"

namespace trocar::exchange {

constexpr std::size_t kActionWidth = 14;

/// "robot0_dx" …: for each arm, left then right, 3 of position (in W), 3 of rotation (axis times angle, in W) and
/// the jaw: where it is to be next, −1 wide open, 1 closed.
const std::vector<std::string>& action_names();

/// One for a whole file: a step of 1 in metres and in radians, and the jaws' range. Fits all of its demonstrations.
struct ActionScale {
  double position_m = 1e-6;
  double rotation_rad = 1e-6;
  double jaw_open_rad = 0.0;    ///< −1.
  double jaw_closed_rad = 0.0;  ///< 1.

  /// Value = `factor()[i]` · action + `offset()[i]`.
  std::array<double, kActionWidth> factor() const;
  std::array<double, kActionWidth> offset() const;
};

/// Grows by what it is shown; a scale's steps are rounded up to 1, 2 or 5 of a decade, so that files are alike.
class ActionRange {
 public:
  /// Of the jaws' own limits, and no step.
  ActionRange();
  void add(std::span<const demonstration::Sample> samples);
  ActionScale scale() const;

 private:
  double position_m_ = 0.0;
  double rotation_rad_ = 0.0;
  double jaw_low_rad_;
  double jaw_high_rad_;
};

/// By rows, `kActionWidth` a row; the last row holds still.
std::vector<double> actions(std::span<const demonstration::Sample> samples, const ActionScale& scale);

}  // namespace trocar::exchange
