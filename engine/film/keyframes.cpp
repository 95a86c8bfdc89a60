#include "engine/film/keyframes.h"

#include <algorithm>

namespace trocar::film {
namespace {

/// The area below `eased` from 0 to `u`.
double eased_area(Ease ease, double u) {
  switch (ease) {
    case Ease::kLinear:
      return 0.5 * u * u;
    case Ease::kSmooth:
    case Ease::kSpline:
      return u * u * u - 0.5 * u * u * u * u;
    case Ease::kHold:
      break;
  }
  return 0.0;
}

double slope_after(const std::vector<Key>& keys, std::size_t i) {
  return (keys[i + 1].value - keys[i].value) / (keys[i + 1].t_s - keys[i].t_s);
}

/// Of the spline at a key: the weighted harmonic mean of the slopes at either side, flat at a summit and at the ends.
double tangent(const std::vector<Key>& keys, std::size_t i) {
  if (i == 0 || i + 1 == keys.size()) return 0.0;
  const double before = slope_after(keys, i - 1);
  const double after = slope_after(keys, i);
  if (before * after <= 0.0) return 0.0;
  const double h0 = keys[i].t_s - keys[i - 1].t_s;
  const double h1 = keys[i + 1].t_s - keys[i].t_s;
  const double weight = (h0 + 2.0 * h1) / (3.0 * (h0 + h1));
  return before * after / (weight * after + (1.0 - weight) * before);
}

/// Cubic Hermite between key `i` and the next, at `u` (0 … 1) of the way in time.
double spline_at(const std::vector<Key>& keys, std::size_t i, double u) {
  const double span = keys[i + 1].t_s - keys[i].t_s;
  const double rise = u * u * (3.0 - 2.0 * u);
  return keys[i].value + (keys[i + 1].value - keys[i].value) * rise +
         span * (tangent(keys, i) * u * (1.0 - u) * (1.0 - u) - tangent(keys, i + 1) * u * u * (1.0 - u));
}

/// The area below it from 0 to `u`, in value times `u`.
double spline_area(const std::vector<Key>& keys, std::size_t i, double u) {
  const double span = keys[i + 1].t_s - keys[i].t_s;
  const double u2 = u * u;
  const double from_left = u2 / 2.0 - 2.0 * u2 * u / 3.0 + u2 * u2 / 4.0;
  const double from_right = u2 * u / 3.0 - u2 * u2 / 4.0;
  return keys[i].value * u + (keys[i + 1].value - keys[i].value) * eased_area(Ease::kSmooth, u) +
         span * (tangent(keys, i) * from_left - tangent(keys, i + 1) * from_right);
}

}  // namespace

double eased(Ease ease, double u) {
  if (u >= 1.0) return 1.0;
  if (u <= 0.0 || ease == Ease::kHold) return 0.0;
  return ease == Ease::kLinear ? u : u * u * (3.0 - 2.0 * u);
}

double value_at(const std::vector<Key>& keys, double t_s, double otherwise) {
  if (keys.empty()) return otherwise;
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), t_s, [](double t, const Key& key) { return t < key.t_s; });
  if (next == keys.begin()) return keys.front().value;
  if (next == keys.end()) return keys.back().value;
  const Key& from = *(next - 1);
  const double u = (t_s - from.t_s) / (next->t_s - from.t_s);
  if (from.ease == Ease::kSpline) return spline_at(keys, static_cast<std::size_t>(next - keys.begin()) - 1, u);
  return from.value + (next->value - from.value) * eased(from.ease, u);
}

double area_to(const std::vector<Key>& keys, double t_s, double otherwise) {
  if (keys.empty()) return otherwise * t_s;
  if (t_s <= keys.front().t_s) return keys.front().value * t_s;
  double area = keys.front().value * keys.front().t_s;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const Key& from = keys[i];
    const Key& to = keys[i + 1];
    const double span = to.t_s - from.t_s;
    const double u = std::clamp((t_s - from.t_s) / span, 0.0, 1.0);
    area += span * (from.ease == Ease::kSpline ? spline_area(keys, i, u)
                                               : from.value * u + (to.value - from.value) * eased_area(from.ease, u));
    if (t_s <= to.t_s) return area;
  }
  return area + keys.back().value * (t_s - keys.back().t_s);
}

}  // namespace trocar::film
