#include "engine/film/time_map.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/film/pace.h"

namespace trocar::film {
namespace {

using demonstration::Demonstration;

// A stage ends with its last sample, not with the first of the next: half a sample before it.
constexpr double kBack_s = 0.0025;
constexpr double kTiny_s = 1e-9;
constexpr double kMostFrames = 1e7;

std::size_t stage_count(Sync sync) {
  if (sync == Sync::kClock) return 1;
  return sync == Sync::kGrasp ? 2 : 1 + demonstration::kSegmentCount;
}

/// When the left gripper first holds the block, or `otherwise`.
double first_grasp_s(const Demonstration& shown, double in_s, double out_s, double otherwise) {
  for (const demonstration::Sample sample : shown.samples_within(in_s, out_s)) {
    if ((sample.flags & demonstration::kLeftHolds) != 0) return shown.time_of(sample);
  }
  return otherwise;
}

/// Where the labels first come, one after the other; what does not come begins with the next.
std::vector<double> segment_begins(const Demonstration& shown, double in_s, double out_s) {
  std::vector<double> begins(stage_count(Sync::kSegment), out_s);
  begins[0] = in_s;
  double after_s = in_s;
  std::vector<bool> there(begins.size(), false);
  for (std::size_t i = 1; i < begins.size(); ++i) {
    for (const demonstration::SegmentSpan& span : shown.segments) {
      if (static_cast<std::size_t>(span.label) + 1 != i || span.end_s <= after_s || span.begin_s >= out_s) continue;
      begins[i] = after_s = std::max(after_s, span.begin_s);
      there[i] = true;
      break;
    }
  }
  for (std::size_t i = begins.size() - 1; i > 0; --i) {
    if (!there[i]) begins[i] = i + 1 < begins.size() ? begins[i + 1] : out_s;
  }
  return begins;
}

}  // namespace

double Stages::duration_s(std::size_t stage) const {
  const double end = stage + 1 < begins_s.size() ? begins_s[stage + 1] : end_s;
  return std::max(0.0, end - begins_s[stage]);
}

Stages stages_of(const Demonstration& shown, double in_s, double out_s, Sync sync) {
  switch (sync) {
    case Sync::kClock:
      return {{in_s}, out_s};
    case Sync::kGrasp:
      return {{in_s, first_grasp_s(shown, in_s, out_s, out_s)}, out_s};
    case Sync::kSegment:
      break;
  }
  return {segment_begins(shown, in_s, out_s), out_s};
}

Stages still_stages(Sync sync) {
  return {std::vector<double>(stage_count(sync), 0.0), 0.0};
}

Result<TimeMap> TimeMap::create(std::vector<Stages> sources, const Pace& pace, double fps) {
  TROCAR_CHECK(!sources.empty() && fps > 0.0);
  TimeMap map;
  map.pace_ = pace;
  map.fps_ = fps;
  map.common_s_ = {0.0};
  for (std::size_t stage = 0; stage < sources.front().begins_s.size(); ++stage) {
    double longest_s = 0.0;
    for (const Stages& source : sources) {
      TROCAR_CHECK(source.begins_s.size() == sources.front().begins_s.size());
      longest_s = std::max(longest_s, source.duration_s(stage));
    }
    map.common_s_.push_back(map.common_s_.back() + longest_s);
  }
  map.sources_ = std::move(sources);
  double film_s = running_at(map.pace_, map.duration_s());
  for (const Hold& hold : pace.holds) film_s += hold.at_s <= map.duration_s() ? hold.for_s : 0.0;
  const double frames = std::floor(film_s * fps + 1e-6) + 1.0;
  if (!(frames * pace.loops <= kMostFrames)) {
    return fail(ErrorCode::kInvalidArgument, "the film would have more than ten million frames");
  }
  map.frames_of_a_pass_ = static_cast<int>(frames);
  return map;
}

Moment TimeMap::at(int frame) const {
  TROCAR_CHECK(frame >= 0 && frame < frame_count());
  Moment moment;
  moment.film_s = (frame % frames_of_a_pass_) / fps_;
  double running_s = moment.film_s;
  bool held = false;
  for (const Hold& hold : pace_.holds) {
    const double from_s = running_at(pace_, hold.at_s);
    if (hold.at_s > duration_s() || running_s < from_s) break;
    held = running_s < from_s + hold.for_s;
    running_s = held ? from_s : running_s - hold.for_s;
    if (held) break;
  }
  moment.common_s = std::min(area_to(pace_.ramps, running_s, pace_.speed), duration_s());
  moment.speed = held ? 0.0 : value_at(pace_.ramps, running_s, pace_.speed);
  while (moment.stage + 1 < stage_count() && moment.common_s + kTiny_s >= common_s_[moment.stage + 1]) ++moment.stage;

  const double into_s = std::max(0.0, moment.common_s - common_s_[moment.stage]);
  const double longest_s = common_s_[moment.stage + 1] - common_s_[moment.stage];
  for (const Stages& source : sources_) {
    const double begin_s = source.begins_s[moment.stage];
    const double lasts_s = source.duration_s(moment.stage);
    Instant instant;
    const bool last = begin_s + lasts_s >= source.end_s - kTiny_s;
    const bool held_up = into_s > lasts_s + kTiny_s || (lasts_s <= 0.0 && longest_s > 0.0);
    instant.over = held_up && last;
    instant.waiting = held_up && !last;
    const double latest_s = last ? begin_s + lasts_s : std::max(source.begins_s.front(), begin_s + lasts_s - kBack_s);
    instant.at_s = std::min(begin_s + into_s, latest_s);
    moment.sources.push_back(instant);
  }
  return moment;
}

}  // namespace trocar::film
