#include "ui/panels/time_snap.h"

#include <cmath>

namespace trocar::ui {

std::optional<double> nearest_place(std::span<const double> places, double t_s, double reach_s) {
  std::optional<double> nearest;
  for (const double place_s : places) {
    const double distance_s = std::abs(place_s - t_s);
    if (distance_s > reach_s || (nearest && std::abs(*nearest - t_s) <= distance_s)) continue;
    nearest = place_s;
  }
  return nearest;
}

double at_sample(double t_s) {
  return std::round(t_s * demonstration::kSampleRate_hz) / demonstration::kSampleRate_hz;
}

std::vector<double> places_of(const demonstration::Demonstration& shown, std::span<const demonstration::Event> events) {
  std::vector<double> places{shown.begin_s, shown.end_s};
  for (const demonstration::Event& event : events) places.push_back(event.t_s);
  for (const demonstration::SegmentSpan& span : shown.segments) {
    places.insert(places.end(), {span.begin_s, span.end_s});
  }
  for (const demonstration::Note& note : shown.notes) places.insert(places.end(), {note.begin_s, note.end_s});
  return places;
}

}  // namespace trocar::ui
