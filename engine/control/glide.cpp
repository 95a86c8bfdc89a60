#include "engine/control/glide.h"

#include <algorithm>

#include "engine/core/check.h"

namespace trocar::control {

// At t = 0 a span has the place (P₀ + 4 P₁ + P₂)/6 and the velocity (P₂ − P₀)/2 a step: with P₂ given, P₀ and P₁
// follow.
Glide::Glide(const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W, double rate_hz, const Eigen::Vector3d& first)
    : rate_hz_(rate_hz) {
  TROCAR_CHECK(rate_hz > 0.0);
  places_[2] = first;
  places_[0] = first - 2.0 * v_W / rate_hz;
  places_[1] = (6.0 * p_W - places_[0] - places_[2]) / 4.0;
  places_[3] = first;
}

void Glide::add(const Eigen::Vector3d& p_W) {
  TROCAR_CHECK(wants_);
  places_[3] = p_W;
  wants_ = false;
}

Eigen::Vector3d Glide::advance(double seconds) {
  TROCAR_CHECK(!wants_ && seconds >= 0.0 && seconds * rate_hz_ < 1.0);
  t_ += seconds * rate_hz_;
  const Eigen::Vector3d place = at(t_);
  // Ends a whisker early rather than late by rounding.
  if (t_ < 1.0 - 1e-9) return place;
  t_ = std::max(0.0, t_ - 1.0);
  places_ = {places_[1], places_[2], places_[3], places_[3]};
  wants_ = true;
  return place;
}

Eigen::Vector3d Glide::at(double t) const {
  const double u = 1.0 - t;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (u * u * u * places_[0] + (3.0 * t3 - 6.0 * t2 + 4.0) * places_[1] +
          (-3.0 * t3 + 3.0 * t2 + 3.0 * t + 1.0) * places_[2] + t3 * places_[3]) /
         6.0;
}

Eigen::Vector3d Glide::velocity() const {
  const double t = t_;
  const double u = 1.0 - t;
  return rate_hz_ * 0.5 *
         (-u * u * places_[0] + (3.0 * t * t - 4.0 * t) * places_[1] + (-3.0 * t * t + 2.0 * t + 1.0) * places_[2] +
          t * t * places_[3]);
}

bool Glide::at_rest() const {
  return places_[0] == places_[1] && places_[1] == places_[2] && places_[2] == places_[3];
}

}  // namespace trocar::control
