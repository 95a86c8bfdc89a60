/// Numbers that change over time by keys, and what they add up to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trocar::film {

/// How one goes from a key to the next: evenly, slowly at both ends, not at all until there, or without a corner: a
/// number by a monotone cubic, which never leaves what lies between two keys (Fritsch and Butland, 1984), a camera by a
/// spline of Catmull and Rom.
enum class Ease : std::uint8_t { kLinear, kSmooth, kHold, kSpline };

struct Key {
  double t_s = 0.0;  ///< Of the film.
  double value = 0.0;
  Ease ease = Ease::kLinear;  ///< From here to the next key.
  bool operator==(const Key&) const = default;
};

/// A property and its keys, by increasing time.
struct Track {
  std::string property;  ///< "orbit.yaw"
  std::vector<Key> keys;
  bool operator==(const Track&) const = default;
};

/// 0 … 1 of the way from one key to the next, where `u` (0 … 1) of the time has gone; of a spline, which depends on the
/// keys around, as if it were smooth.
double eased(Ease ease, double u);

/// Before the first key its value, after the last its; `otherwise` without keys.
double value_at(const std::vector<Key>& keys, double t_s, double otherwise);
/// The area below `value_at` from 0 to `t_s`, exactly. Precondition: 0 ≤ t_s.
double area_to(const std::vector<Key>& keys, double t_s, double otherwise);

}  // namespace trocar::film
