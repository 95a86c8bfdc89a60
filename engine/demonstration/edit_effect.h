/// What an edit does to the motion, measured in the span that it works on: for its form and for the command line.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// Of the span, and not of more; arrays are by arm, left first.
struct SpanMotion {
  double from_s = 0.0;
  double to_s = 0.0;
  std::array<double, 2> peak_speed_m_s{};
  std::array<double, 2> mean_jerk_m_s3{};  ///< Mean magnitude, tremor included.

  double fastest_m_s() const;
};

struct EditEffect {
  SpanMotion before;
  SpanMotion after;
  /// What a person should know before committing it, sentences without a full stop; most edits have none.
  std::vector<std::string> remarks;
};

/// `after` is what `edit` made of `before`. Time: by the samples of the span.
EditEffect effect_of(const Edit& edit, const Demonstration& before, const Demonstration& after);

/// The share, 0 … 1, of the energy of the motion (squared speed of both tools between the gates, along each axis) that
/// lies above a frequency; what a rate of twice that frequency cannot hold. 0 of what does not move.
double energy_above(const Demonstration& document, double frequency_hz);

}  // namespace trocar::demonstration
