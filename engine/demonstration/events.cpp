#include "engine/demonstration/events.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/demonstration/jaw_limits.h"

namespace trocar::demonstration {
namespace {

constexpr double kHalfSample_s = 0.5 / kSampleRate_hz;
constexpr std::array<std::uint32_t, 2> kHolds{kLeftHolds, kRightHolds};

enum class Jaw : std::uint8_t { kUnknown, kOpen, kClosed };

Jaw jaw_of(const Sample& sample, std::size_t arm) {
  const double jaw_rad = sample.arms[arm].setpoint_jaw_rad;
  return jaw_rad >= kJawOpen_rad ? Jaw::kOpen : jaw_rad <= kJawClosed_rad ? Jaw::kClosed : Jaw::kUnknown;
}

/// The newest jaw that was open or closed at or before the sample `index`.
Jaw jaw_before(const SampleTrack& track, std::size_t index, std::size_t arm) {
  for (std::size_t i = index + 1; i > 0; --i) {
    if (const Jaw jaw = jaw_of(track[i - 1], arm); jaw != Jaw::kUnknown) return jaw;
  }
  return Jaw::kUnknown;
}

void add_gripper_events(const Demonstration& document, double from_s, double to_s, std::vector<Event>& found) {
  const SampleTrack& track = document.samples;
  const std::size_t first = track.lower_bound(document.tick_from(from_s));
  const std::size_t last = track.lower_bound(document.tick_after(to_s));
  if (first >= last) return;
  // What is so at the first sample of all has not happened there.
  const std::size_t before = first == 0 ? 0 : first - 1;
  std::array<Jaw, 2> jaws{jaw_before(track, before, 0), jaw_before(track, before, 1)};
  std::uint32_t flags = track[before].flags;
  for (const Sample& sample : track.slice(first, last - first)) {
    const double t_s = document.time_of(sample);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const Jaw now = jaw_of(sample, arm);
      const int side = static_cast<int>(arm);
      if (now != Jaw::kUnknown && now != jaws[arm]) {
        if (jaws[arm] != Jaw::kUnknown) {
          found.push_back({t_s, now == Jaw::kOpen ? EventKind::kJawOpens : EventKind::kJawCloses, side});
        }
        jaws[arm] = now;
      }
      if (((sample.flags ^ flags) & kHolds[arm]) == 0) continue;
      found.push_back({t_s, (sample.flags & kHolds[arm]) != 0 ? EventKind::kGrasp : EventKind::kRelease, side});
    }
    flags = sample.flags;
  }
}

void add_edges(const Demonstration& document, double from_s, double to_s, std::vector<Event>& found) {
  const auto add = [&](double t_s, EventKind kind) {
    const Event event{t_s, kind, -1};
    if (t_s < from_s || t_s > to_s || std::find(found.begin(), found.end(), event) != found.end()) return;
    found.push_back(event);
  };
  for (const SegmentSpan& span : document.segments) {
    add(span.begin_s, EventKind::kSegment);
    add(span.end_s, EventKind::kSegment);
  }
  for (const Note& note : document.notes) {
    add(note.begin_s, EventKind::kNote);
    add(note.end_s, EventKind::kNote);
  }
}

}  // namespace

std::vector<Event> events_within(const Demonstration& document, double from_s, double to_s) {
  std::vector<Event> found;
  add_edges(document, from_s, to_s, found);
  add_gripper_events(document, from_s, to_s, found);
  std::stable_sort(found.begin(), found.end(), [](const Event& a, const Event& b) { return a.t_s < b.t_s; });
  return found;
}

double next_event(const Demonstration& document, double t_s, int direction) {
  const bool forward = direction > 0;
  const double gate_s = forward ? document.end_s : document.begin_s;
  // An hour of samples is not read to find what is a second away.
  for (double reach_s = 2.0;; reach_s *= 4.0) {
    const double near_s = forward ? t_s + kHalfSample_s : t_s - kHalfSample_s;
    const double far_s = forward ? std::min(near_s + reach_s, gate_s) : std::max(near_s - reach_s, gate_s);
    if (forward ? near_s >= far_s : near_s <= far_s) return gate_s;
    const std::vector<Event> found = events_within(document, std::min(near_s, far_s), std::max(near_s, far_s));
    if (!found.empty()) return forward ? found.front().t_s : found.back().t_s;
    if (far_s == gate_s) return gate_s;
  }
}

}  // namespace trocar::demonstration
