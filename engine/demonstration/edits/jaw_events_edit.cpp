// JawEvents: each opening and closing that a trace shows, made one ramp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/events.h"

namespace trocar::demonstration {
namespace {

using JawOf = std::function<double(const ArmSample&)>;

/// Of samples from `first` to `last`, the last not included; there is at least one.
double rest_of(const std::vector<Sample>& samples, std::size_t arm, const JawOf& jaw, std::size_t first,
               std::size_t last) {
  std::vector<double> values;
  for (std::size_t i = first; i < last; ++i) values.push_back(jaw(samples[i].arms[arm]));
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A ramp about `middle_s`, up or down to `to_rad`.
struct Ramp {
  double middle_s = 0.0;
  double half_s = 0.0;
  double to_rad = 0.0;
};

/// What a trace becomes: at rest, with a ramp for each event; events are indices of samples.
class CleanTrace {
 public:
  CleanTrace(const std::vector<Sample>& samples, std::size_t arm, const JawOf& jaw,
             const std::vector<std::size_t>& events, double ramp_s) {
    first_rad_ = rest_of(samples, arm, jaw, 0, events.front());
    double from_rad = first_rad_;
    for (std::size_t i = 0; i < events.size(); ++i) {
      const std::size_t next = i + 1 < events.size() ? events[i + 1] : samples.size();
      const double to_rad = rest_of(samples, arm, jaw, events[i], next);
      const double half_way = 0.5 * (from_rad + to_rad);
      // Where the trace went through the middle, on the way to where it counts as open or closed.
      std::size_t at = events[i];
      const std::size_t least = i == 0 ? 0 : events[i - 1];
      while (at > least && (jaw(samples[at].arms[arm]) > half_way) == (to_rad > from_rad)) --at;
      ramps_.push_back({samples[at].t_s(), 0.5 * ramp_s, to_rad});
      from_rad = to_rad;
    }
    // Ramps that would overlap share what lies between them.
    for (std::size_t i = 0; i + 1 < ramps_.size(); ++i) {
      const double room_s = 0.5 * std::max(ramps_[i + 1].middle_s - ramps_[i].middle_s, 0.0);
      ramps_[i].half_s = std::min(ramps_[i].half_s, room_s);
      ramps_[i + 1].half_s = std::min(ramps_[i + 1].half_s, room_s);
    }
  }

  double at(double t_s) const {
    double jaw_rad = first_rad_;
    for (const Ramp& ramp : ramps_) {
      const double from_s = ramp.middle_s - ramp.half_s;
      if (t_s <= from_s) break;
      const double share = ramp.half_s > 0.0 ? std::min((t_s - from_s) / (2.0 * ramp.half_s), 1.0) : 1.0;
      jaw_rad += share * (ramp.to_rad - jaw_rad);
    }
    return jaw_rad;
  }

 private:
  double first_rad_ = 0.0;
  std::vector<Ramp> ramps_;
};

/// Samples of the stretch at which the arm's gripper has opened or closed.
std::vector<std::size_t> jaw_events(const Demonstration& document, const Stretch& stretch, std::size_t arm) {
  std::vector<std::size_t> found;
  const double from_s = document.time_of(stretch.samples.front());
  for (const Event& event : events_within(document, from_s, document.time_of(stretch.samples.back()))) {
    const bool of_jaw = event.kind == EventKind::kJawOpens || event.kind == EventKind::kJawCloses;
    if (!of_jaw || event.arm != static_cast<int>(arm)) continue;
    const std::size_t at = document.samples.lower_bound(document.tick_from(event.t_s)) - stretch.first;
    if (at > 0) found.push_back(at);
  }
  return found;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const JawEvents& edit) {
  if (!(edit.ramp_s >= 0.0) || edit.ramp_s > 60.0) {
    return fail(ErrorCode::kInvalidArgument, "the ramp must be a number from 0 to 60 s");
  }
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 2));
  const std::vector<Sample> before = stretch.samples;
  bool any = false;
  for (const std::size_t arm : indices_of(edit.arms)) {
    const std::vector<std::size_t> events = jaw_events(document, stretch, arm);
    if (events.empty()) continue;
    any = true;
    const CleanTrace told(
        before, arm, [](const ArmSample& each) { return each.setpoint_jaw_rad; }, events, edit.ramp_s);
    const CleanTrace seen(
        before, arm, [](const ArmSample& each) { return static_cast<double>(each.jaw_rad); }, events, edit.ramp_s);
    for (Sample& sample : stretch.samples) {
      // What lies outside of the span stays, and the jaw goes there without a jump.
      const double edge_s = std::min(sample.t_s() - before.front().t_s(), before.back().t_s() - sample.t_s());
      const double share = edit.ramp_s > 0.0 ? std::clamp(edge_s / edit.ramp_s, 0.0, 1.0) : 1.0;
      ArmSample& moved = sample.arms[arm];
      moved.setpoint_jaw_rad += share * (told.at(sample.t_s()) - moved.setpoint_jaw_rad);
      const auto jaw_rad = static_cast<double>(moved.jaw_rad);
      moved.jaw_rad = static_cast<float>(jaw_rad + share * (seen.at(sample.t_s()) - jaw_rad));
    }
  }
  if (any) return with_stretch(document, std::move(stretch));
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("no gripper opens or closes from {:.2f} to {:.2f} s", edit.from_s, edit.to_s));
}

}  // namespace trocar::demonstration
