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
      return u * u * u - 0.5 * u * u * u * u;
    case Ease::kHold:
      break;
  }
  return 0.0;
}

}  // namespace

double eased(Ease ease, double u) {
  if (u >= 1.0) return 1.0;
  if (u <= 0.0 || ease == Ease::kHold) return 0.0;
  return ease == Ease::kSmooth ? u * u * (3.0 - 2.0 * u) : u;
}

double value_at(const std::vector<Key>& keys, double t_s, double otherwise) {
  if (keys.empty()) return otherwise;
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), t_s, [](double t, const Key& key) { return t < key.t_s; });
  if (next == keys.begin()) return keys.front().value;
  if (next == keys.end()) return keys.back().value;
  const Key& from = *(next - 1);
  return from.value + (next->value - from.value) * eased(from.ease, (t_s - from.t_s) / (next->t_s - from.t_s));
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
    area += span * (from.value * u + (to.value - from.value) * eased_area(from.ease, u));
    if (t_s <= to.t_s) return area;
  }
  return area + keys.back().value * (t_s - keys.back().t_s);
}

}  // namespace trocar::film
