#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/demonstration/comparison.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/demonstration/time_warping.h"

namespace trocar::demonstration {
namespace {

constexpr std::array<std::string_view, 4> kAlignmentNames{"time", "arc", "dtw", "segment"};
constexpr double kTimeTolerance_s = 1e-9;

/// What lies between the gates, unpacked once.
struct TimedPath {
  std::vector<std::int64_t> ticks;
  std::vector<double> t_s;  ///< Of the demonstration.
  std::vector<TipPair> tips;

  std::size_t size() const { return tips.size(); }
};

TimedPath path_of(const Demonstration& document) {
  TimedPath path;
  for (const Sample& sample : document.gated()) {
    path.ticks.push_back(sample.tick);
    path.t_s.push_back(document.time_of(sample));
    path.tips.push_back({measured_tip(sample, 0), measured_tip(sample, 1)});
  }
  return path;
}

/// Between two samples, or the first or last beyond the ends. Precondition: `along` is not empty and does not decrease.
Eigen::Vector3d tip_at(const TimedPath& path, const std::vector<double>& along, double at, std::size_t arm) {
  const auto after =
      static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), at - kTimeTolerance_s) - along.begin());
  if (after == 0) return path.tips.front()[arm];
  if (after == along.size()) return path.tips.back()[arm];
  const double share = std::min((at - along[after - 1]) / (along[after] - along[after - 1]), 1.0);
  const Eigen::Vector3d& low = path.tips[after - 1][arm];
  return low + share * (path.tips[after][arm] - low);
}

double time_at(const TimedPath& path, const std::vector<double>& along, double at) {
  const auto after = static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), at) - along.begin());
  if (after == 0) return path.t_s.front();
  if (after == along.size()) return path.t_s.back();
  const double share = (at - along[after - 1]) / (along[after] - along[after - 1]);
  return path.t_s[after - 1] + share * (path.t_s[after] - path.t_s[after - 1]);
}

Match pair(const TimedPath& before, std::size_t i, const TimedPath& after, std::size_t j) {
  return {after.t_s[j], {before.t_s[i], before.t_s[i]}, after.tips[j], before.tips[i]};
}

/// Versions of one recording. An instant that one of them has no sample of is compared with the way between its
/// neighbours, unless they are `gap` ticks apart or more.
std::vector<Match> by_tick(const TimedPath& before, const TimedPath& after, std::int64_t gap) {
  std::vector<Match> matches;
  for (std::size_t i = 0, j = 0; j < after.size(); ++j) {
    while (i < before.size() && before.ticks[i] < after.ticks[j]) ++i;
    if (i == before.size()) break;
    if (before.ticks[i] == after.ticks[j]) {
      matches.push_back(pair(before, i, after, j));
      continue;
    }
    if (i == 0 || before.ticks[i] - before.ticks[i - 1] >= gap) continue;
    const double share = static_cast<double>(after.ticks[j] - before.ticks[i - 1]) /
                         static_cast<double>(before.ticks[i] - before.ticks[i - 1]);
    const double before_s = before.t_s[i - 1] + share * (before.t_s[i] - before.t_s[i - 1]);
    Match match{after.t_s[j], {before_s, before_s}, after.tips[j], before.tips[i - 1]};
    for (std::size_t arm = 0; arm < 2; ++arm) {
      match.p_before[arm] += share * (before.tips[i][arm] - before.tips[i - 1][arm]);
    }
    matches.push_back(std::move(match));
  }
  return matches;
}

/// `to_before` gives the time of `before` that answers to one of `after`.
template <typename ToBefore>
std::vector<Match> by_time(const TimedPath& before, const TimedPath& after, ToBefore to_before) {
  std::vector<Match> matches;
  for (std::size_t j = 0; j < after.size(); ++j) {
    const double before_s = to_before(after.t_s[j]);
    if (before_s > before.t_s.back() + kTimeTolerance_s) break;
    matches.push_back({after.t_s[j],
                       {before_s, before_s},
                       after.tips[j],
                       {tip_at(before, before.t_s, before_s, 0), tip_at(before, before.t_s, before_s, 1)}});
  }
  return matches;
}

/// From 0 to 1 along the path of one tool; of a tool that does not move, along its time.
std::vector<double> shares_of(const TimedPath& path, std::size_t arm) {
  std::vector<double> shares(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    shares[i] = shares[i - 1] + (path.tips[i][arm] - path.tips[i - 1][arm]).norm();
  }
  const double length = shares.back();
  const double covered_s = std::max(path.t_s.back() - path.t_s.front(), kTimeTolerance_s);
  for (std::size_t i = 0; i < path.size(); ++i) {
    shares[i] = length > 0.0 ? shares[i] / length : (path.t_s[i] - path.t_s.front()) / covered_s;
  }
  return shares;
}

std::vector<Match> by_arc(const TimedPath& before, const TimedPath& after) {
  std::vector<Match> matches(after.size());
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const std::vector<double> from = shares_of(before, arm);
    const std::vector<double> to = shares_of(after, arm);
    for (std::size_t j = 0; j < after.size(); ++j) {
      matches[j].t_s = after.t_s[j];
      matches[j].p_after[arm] = after.tips[j][arm];
      matches[j].before_s[arm] = time_at(before, from, to[j]);
      matches[j].p_before[arm] = tip_at(before, from, to[j], arm);
    }
  }
  return matches;
}

std::vector<Match> by_warping(const TimedPath& before, const TimedPath& after) {
  std::vector<Match> matches;
  double nearest_m = 0.0;
  for (const WarpStep& step : warp(before.tips, after.tips)) {
    const double apart_m = distance(before.tips[step.first], after.tips[step.second]);
    const bool next = step.second == matches.size();
    if (!next && apart_m >= nearest_m) continue;
    if (next) matches.emplace_back();
    matches.back() = pair(before, step.first, after, step.second);
    nearest_m = apart_m;
  }
  return matches;
}

/// Times of `after` and of `before` that answer to each other: gates, and both ends of segments that both have.
std::vector<std::pair<double, double>> anchors_of(const Demonstration& before, const Demonstration& after) {
  std::vector<std::pair<double, double>> anchors{{after.begin_s, before.begin_s}};
  const auto add = [&](double after_s, double before_s) {
    if (after_s >= anchors.back().first && before_s >= anchors.back().second) anchors.emplace_back(after_s, before_s);
  };
  for (const SegmentSpan& span : after.segments) {
    const std::optional<SegmentSpan> there = before.segment(span.label);
    const std::optional<SegmentSpan> here = after.segment(span.label);
    if (!there || !here || here->end_s <= span.begin_s || here->begin_s >= span.end_s) continue;
    add(here->begin_s, there->begin_s);
    add(here->end_s, there->end_s);
  }
  return anchors;
}

Result<std::vector<Match>> by_segment(const Demonstration& before, const TimedPath& from, const Demonstration& after,
                                      const TimedPath& to) {
  std::vector<std::pair<double, double>> anchors = anchors_of(before, after);
  if (anchors.size() == 1) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} and {} have no segment in common", before.name, after.name));
  }
  anchors.emplace_back(std::max(after.end_s, anchors.back().first), std::max(before.end_s, anchors.back().second));
  std::size_t at = 1;
  return by_time(from, to, [&](double t_s) {
    while (at + 1 < anchors.size() && t_s > anchors[at].first) ++at;
    const auto& [low_after, low_before] = anchors[at - 1];
    const auto& [high_after, high_before] = anchors[at];
    const double span_s = high_after - low_after;
    const double share = span_s > 0.0 ? std::clamp((t_s - low_after) / span_s, 0.0, 1.0) : 1.0;
    return std::min(low_before + share * (high_before - low_before), from.t_s.back());
  });
}

}  // namespace

std::string_view to_string(Alignment alignment) {
  return kAlignmentNames[static_cast<std::size_t>(alignment)];
}

Result<Alignment> alignment_from(std::string_view text) {
  const auto* found = std::find(kAlignmentNames.begin(), kAlignmentNames.end(), text);
  if (found != kAlignmentNames.end()) return static_cast<Alignment>(found - kAlignmentNames.begin());
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("there is no alignment '{}'; there are time, arc, dtw, segment", text));
}

Result<std::vector<Match>> match(const Demonstration& before, const Demonstration& after, Alignment alignment) {
  const TimedPath from = path_of(before);
  const TimedPath to = path_of(after);
  if (from.size() == 0 || to.size() == 0) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} has no samples between its gates", from.size() == 0 ? before.name : after.name));
  }
  switch (alignment) {
    case Alignment::kTime:
      if (of_one_recording(before, after)) return by_tick(from, to, 2 * usual_step(before.gated()));
      break;
    case Alignment::kArcLength:
      return by_arc(from, to);
    case Alignment::kWarping:
      return by_warping(from, to);
    case Alignment::kSegment:
      return by_segment(before, from, after, to);
  }
  const double later_s = from.t_s.front() - to.t_s.front();
  return by_time(from, to, [later_s](double t_s) { return t_s + later_s; });
}

}  // namespace trocar::demonstration
