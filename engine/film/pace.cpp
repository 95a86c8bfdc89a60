#include "engine/film/pace.h"

#include <algorithm>

namespace trocar::film {
namespace {

constexpr double kNoTime_s = 1e-9;

}  // namespace

double running_at(const Pace& pace, double common_s) {
  if (pace.ramps.empty()) return common_s / pace.speed;
  // The area below the speed grows with time, at least by the slowest of its keys.
  double slowest = pace.ramps.front().value;
  for (const Key& key : pace.ramps) slowest = std::min(slowest, key.value);
  double low = 0.0;
  double high = common_s / slowest;
  for (int i = 0; i < 100 && high - low > kNoTime_s; ++i) {
    const double middle = 0.5 * (low + high);
    (area_to(pace.ramps, middle, pace.speed) < common_s ? low : high) = middle;
  }
  return high;
}

double running_of(const Pace& pace, double film_s) {
  double running_s = film_s;
  for (const Hold& hold : pace.holds) {
    const double from_s = running_at(pace, hold.at_s);
    if (running_s < from_s) break;
    if (running_s < from_s + hold.for_s) return from_s;
    running_s -= hold.for_s;
  }
  return running_s;
}

double film_time_of(const Pace& pace, double running_s) {
  double film_s = running_s;
  for (const Hold& hold : pace.holds) {
    if (running_at(pace, hold.at_s) < running_s) film_s += hold.for_s;
  }
  return film_s;
}

}  // namespace trocar::film
