#include "engine/review/fixes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/demonstration/edit_words.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/events.h"
#include "engine/demonstration/jaw_limits.h"
#include "engine/demonstration/motion.h"

namespace trocar::review {
namespace {

using namespace demonstration;

constexpr double kFarthest_m = 0.020;
/// From here on a gripper is open.
constexpr double kCountsAsOpen_rad = 0.3;
/// What a speed is brought to, of what it may be: a cap that is met to the digit would be one by rounding only.
constexpr double kBelowBound = 0.9;

Arms arms_of(const Problem& problem) {
  return problem.arm == 0 ? Arms::kLeft : problem.arm == 1 ? Arms::kRight : Arms::kBoth;
}

/// A time as it is typed; outwards, so that the span that is meant is in the one that is typed.
double down(double t_s, double margin_s, double low_s) {
  return std::max(std::floor((t_s - margin_s) * 100.0) / 100.0, low_s);
}
double up(double t_s, double margin_s, double high_s) {
  return std::min(std::ceil((t_s + margin_s) * 100.0) / 100.0, high_s);
}

template <typename Edited>
Edited over(const Demonstration& document, const Problem& problem, double margin_s) {
  Edited edit;
  edit.from_s = down(problem.begin_s, margin_s, document.begin_s);
  edit.to_s = up(problem.end_s, margin_s, document.end_s);
  return edit;
}

std::optional<Edit> speed_fix(const Demonstration& document, const Problem& problem, const MotionBounds& bounds) {
  auto edit = over<Retime>(document, problem, 0.05);
  edit.mode = RetimeTo::kSpeedCap;
  edit.speed_m_s = kBelowBound * bounds.speed_m_s;
  return edit;
}

/// A new motion from before a leap or a gap to behind it, slow enough.
std::optional<Edit> bridge_fix(const Demonstration& document, const Problem& problem, const MotionBounds& bounds,
                               double margin_s) {
  auto edit = over<Bridge>(document, problem, margin_s);
  edit.arms = arms_of(problem);
  const Sample from = document.sample_at(edit.from_s);
  const Sample to = document.sample_at(edit.to_s);
  const double seconds = document.time_of(to) - document.time_of(from);
  if (!(seconds > 0.0)) return std::nullopt;
  constexpr double kPeakOfMinimumJerk = 1.875;
  double farthest_m = 0.0;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    if (problem.arm >= 0 && static_cast<std::size_t>(problem.arm) != arm) continue;
    farthest_m = std::max(farthest_m, (measured_tip(to, arm) - measured_tip(from, arm)).norm());
  }
  const double cap_m_s = kBelowBound * bounds.speed_m_s;
  if (kPeakOfMinimumJerk * farthest_m / seconds > cap_m_s) edit.peak_speed_m_s = cap_m_s;
  return edit;
}

std::optional<Edit> smooth_fix(const Demonstration& document, const Problem& problem) {
  auto edit = over<Smooth>(document, problem, 0.25);
  edit.arms = arms_of(problem);
  edit.filter = Filter::kGaussian;
  return edit;
}

std::size_t labels_of(const Demonstration& document) {
  std::set<Segment> labels;
  for (const SegmentSpan& span : document.segments) labels.insert(span.label);
  return labels.size();
}

/// Only where a proposal knows no fewer segments than there are, and another arrangement of them.
std::optional<Edit> label_fix(const Demonstration& document) {
  const Result<Demonstration> proposed = transformed(document, ProposeLabels{});
  if (!proposed || proposed->segments == document.segments) return std::nullopt;
  if (labels_of(*proposed) < labels_of(document)) return std::nullopt;
  return ProposeLabels{};
}

/// When a gripper opens again after a problem; the end if it does not.
double next_opening_s(const Demonstration& document, const Problem& problem) {
  // An hour of samples is not read to find what is a second away.
  for (double reach_s = 2.0;; reach_s *= 4.0) {
    const double end_s = std::min(problem.begin_s + reach_s, document.end_s);
    for (const Event& event : events_within(document, problem.begin_s, end_s)) {
      if (event.kind == EventKind::kJawOpens && event.arm == problem.arm) return event.t_s;
    }
    if (end_s >= document.end_s) return document.end_s;
  }
}

/// A gripper that closes on nothing stays as open as it was until it opens again.
std::optional<Edit> open_fix(const Demonstration& document, const Problem& problem) {
  if (problem.end_s > problem.begin_s) return std::nullopt;
  const auto arm = static_cast<std::size_t>(problem.arm);
  SetJaw edit;
  edit.arms = arms_of(problem);
  edit.from_s = document.begin_s;
  edit.to_s = document.end_s;
  edit.ramp_s = 0.0;
  const SampleTrack before = document.samples_within(document.begin_s, problem.begin_s);
  for (std::size_t i = before.size(); i > 0; --i) {
    const Sample sample = before[i - 1];
    const double jaw_rad = sample.arms[arm].setpoint_jaw_rad;
    if (jaw_rad < kCountsAsOpen_rad) continue;
    edit.from_s = document.time_of(sample);
    edit.jaw_rad = std::min(jaw_rad, kJawHigh_rad);
    break;
  }
  if (!(edit.jaw_rad > 0.0)) return std::nullopt;
  edit.to_s = next_opening_s(document, problem);
  return edit;
}

/// Jaws that are told to turn too fast begin to turn early enough; nothing where they are slow enough.
std::optional<Edit> jaw_rate_fix(const Demonstration& document, const Problem& problem) {
  const auto arm = static_cast<std::size_t>(problem.arm);
  constexpr double kSlower = 1.05;
  const SampleTrack before = document.samples_within(document.begin_s, problem.begin_s);
  // The step that is too fast ends at the problem's begin.
  if (before.size() < 2) return std::nullopt;
  const Sample from = before[before.size() - 2];
  const Sample first = before[before.size() - 1];
  const Sample to = document.sample_at(problem.end_s);
  const auto jaw = [arm](const Sample& sample) { return sample.arms[arm].setpoint_jaw_rad; };
  const double step_s = document.time_of(first) - document.time_of(from);
  if (!(std::abs(jaw(first) - jaw(from)) > demonstration::kJawRate_rad_s * step_s)) return std::nullopt;
  SetJaw edit;
  edit.arms = arms_of(problem);
  edit.jaw_rad = std::clamp(jaw(to), kJawLow_rad, kJawHigh_rad);
  edit.ramp_s = kSlower * std::abs(jaw(to) - jaw(from)) / demonstration::kJawRate_rad_s;
  edit.from_s = std::max(document.time_of(first) - edit.ramp_s, document.begin_s);
  edit.to_s = std::min(std::max(document.time_of(to), document.time_of(first)) + edit.ramp_s, document.end_s);
  return edit;
}

std::optional<Edit> jaw_fix(const Demonstration& document, const Problem& problem) {
  if (problem.arm < 0) return std::nullopt;
  if (problem.severity != Severity::kError) {
    if (auto slower = jaw_rate_fix(document, problem)) return slower;
  }
  if (problem.severity != Severity::kError) return open_fix(document, problem);
  const Sample sample = document.sample_at(problem.begin_s);
  auto edit = over<SetJaw>(document, problem, 0.0);
  edit.arms = arms_of(problem);
  edit.jaw_rad =
      std::clamp(sample.arms[static_cast<std::size_t>(problem.arm)].setpoint_jaw_rad, kJawLow_rad, kJawHigh_rad);
  edit.ramp_s = 0.0;
  return edit;
}

/// From `p_WT` to the nearest point of a safe cell, a little within.
Eigen::Vector3d way_to_safety(const SegmentGoal& goal, const Eigen::Vector3d& p_WT) {
  constexpr double kInside_m = 1e-4;
  const double half_m = 0.5 * goal.grid.cell_m - kInside_m;
  Eigen::Vector3d way = Eigen::Vector3d::Constant(kFarthest_m);
  for (std::int32_t i = 0; i < goal.grid.cell_count(); ++i) {
    if (!goal.safe.contains({i})) continue;
    const Eigen::Vector3d from_middle = p_WT - goal.grid.centre({i});
    const Eigen::Vector3d one = from_middle.cwiseMax(-half_m).cwiseMin(half_m) - from_middle;
    if (one.squaredNorm() < way.squaredNorm()) way = one;
  }
  return way;
}

std::optional<Edit> safe_set_fix(const Demonstration& document, const Problem& problem,
                                 const std::vector<SegmentGoal>& goals) {
  constexpr std::size_t kLooks = 20;  // a run is short, and neighbours go the same way
  const auto goal = std::find_if(goals.begin(), goals.end(), [&](const SegmentGoal& one) {
    const auto span = document.segment(one.segment);
    return span && problem.begin_s >= span->begin_s && problem.begin_s < span->end_s;
  });
  if (goal == goals.end()) return std::nullopt;
  const SampleTrack run = document.samples_within(problem.begin_s, problem.end_s);
  std::vector<Need> needs;
  Eigen::Vector3d worst{0.0, 0.0, 0.0};
  double at_s = problem.begin_s;
  for (std::size_t i = 0; i < run.size(); i += std::max<std::size_t>(run.size() / kLooks, 1)) {
    const Sample sample = run[i];
    const Eigen::Vector3d way = way_to_safety(*goal, measured_tip(sample, 0));
    needs.push_back({document.time_of(sample), way.norm()});
    if (way.norm() <= worst.norm()) continue;
    worst = way;
    at_s = needs.back().t_s;
  }
  if (!(worst.norm() > 0.0)) return std::nullopt;
  return moved_away(0, at_s, worst.normalized(), needs);
}

std::optional<Edit> lattice_fix(const Demonstration& document, const Problem& problem, const spatial::Grid& grid) {
  constexpr double kInside_m = 1e-4;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kInside_m);
  const Eigen::Vector3d low = grid.p_WGo + margin;
  const Eigen::Vector3d high = (grid.p_WGo.array() + grid.cell_m * grid.n).matrix() - margin;
  std::vector<Need> needs;
  Eigen::Vector3d worst{0.0, 0.0, 0.0};
  double at_s = problem.begin_s;
  for (const Sample& sample : document.samples_within(problem.begin_s, problem.end_s)) {
    const Eigen::Vector3d p_WT = measured_tip(sample, 0);
    const Eigen::Vector3d away = p_WT.cwiseMax(low).cwiseMin(high) - p_WT;
    needs.push_back({document.time_of(sample), away.norm()});
    if (away.norm() <= worst.norm()) continue;
    worst = away;
    at_s = needs.back().t_s;
  }
  if (!(worst.norm() > 0.0)) return std::nullopt;
  return moved_away(0, at_s, worst.normalized(), needs);
}

std::optional<Edit> fix_of(const Demonstration& document, const ReviewOptions& options, const Problem& problem) {
  switch (problem.kind) {
    case ProblemKind::kSpeed:
      // A leap from one sample to the next is no motion that could be slowed down.
      return problem.severity == Severity::kError ? bridge_fix(document, problem, options.bounds, 0.15)
                                                  : speed_fix(document, problem, options.bounds);
    case ProblemKind::kAcceleration:
    case ProblemKind::kJerk:
      return smooth_fix(document, problem);
    case ProblemKind::kTime:
      if (problem.end_s <= problem.begin_s) return std::nullopt;
      return bridge_fix(document, problem, options.bounds, 0.0);
    case ProblemKind::kJaw:
      return jaw_fix(document, problem);
    case ProblemKind::kSafeSet:
      return safe_set_fix(document, problem, options.goals);
    case ProblemKind::kLattice:
      return lattice_fix(document, problem, options.grid);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string words_of_fix(const Edit& edit) {
  const std::vector<std::string> words = to_words(edit);
  const Edit usual = std::visit([]<typename Edited>(const Edited&) { return Edit(Edited{}); }, edit);
  const std::vector<std::string> usual_words = to_words(usual);
  std::vector<std::string> kept{words.front()};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const bool named = words[i].starts_with("--") && words[i].find('=') == std::string::npos;
    const std::size_t value = named ? i + 1 : i;
    const bool when = words[i] == "--from" || words[i] == "--to" || words[i] == "--at";
    if (when || words[value] != usual_words[value]) {
      for (std::size_t k = i; k <= value; ++k) kept.push_back(words[k]);
    }
    i = value;
  }
  return fmt::format("{}", fmt::join(kept, " "));
}

Result<Edit> edit_of_fix(const Problem& problem) {
  if (problem.fix.empty()) {
    return fail(ErrorCode::kNotFound, fmt::format("{} has no quick fix: {}", problem.id, problem.message));
  }
  TROCAR_ASSIGN_OR_RETURN(const std::vector<std::string> words, split_words(problem.fix));
  return edit_from_words(words);
}

double fade(const MoveTool& edit, double t_s) {
  const double share = std::min(std::abs(t_s - edit.at_s) / edit.radius_s, 1.0);
  return 0.5 * (1.0 + std::cos(std::numbers::pi * share));
}

std::optional<MoveTool> moved_away(std::size_t arm, double at_s, const Eigen::Vector3d& direction,
                                   const std::vector<Need>& needs) {
  double reach_s = 0.0;
  for (const Need& need : needs) reach_s = std::max(reach_s, std::abs(need.t_s - at_s));
  MoveTool edit;
  edit.arms = arm == 0 ? Arms::kLeft : Arms::kRight;
  edit.at_s = std::round(at_s * 200.0) / 200.0;
  edit.radius_s = std::ceil(std::max(0.4, 2.0 * reach_s) * 100.0) / 100.0;
  double by_m = 0.0;
  for (const Need& need : needs) {
    by_m = std::max(by_m, need.by_m / std::max(fade(edit, need.t_s), 1e-3));
  }
  if (!(by_m > 0.0) || by_m > kFarthest_m) return std::nullopt;
  // In whole micrometres.
  edit.by_m = 1e-6 * (1e6 * by_m * direction).array().round().matrix();
  return edit;
}

namespace {

std::array<std::size_t, 3> score_of(const std::vector<Problem>& problems) {
  return {count_of(problems, Severity::kError), count_of(problems, Severity::kWarning),
          count_of(problems, Severity::kInfo)};
}

/// The worst problem with a fix that was not tried yet.
const Problem* next_of(const std::vector<Problem>& problems, const std::set<std::string>& tried) {
  const Problem* next = nullptr;
  for (const Problem& problem : problems) {
    if (problem.fix.empty() || tried.contains(problem.fix)) continue;
    if (next == nullptr || problem.severity > next->severity) next = &problem;
  }
  return next;
}

}  // namespace

std::vector<Edit> fixes_of_all(const Demonstration& document, const ReviewOptions& options) {
  constexpr std::size_t kMostTries = 200;
  Reviewer reviewer;
  Demonstration now = document;
  Review review = reviewer.make(now, options);
  std::vector<Edit> edits;
  std::set<std::string> tried;
  while (tried.size() < kMostTries) {
    const Problem* problem = next_of(review.problems, tried);
    if (problem == nullptr) break;
    tried.insert(problem->fix);
    const Result<Edit> edit = edit_of_fix(*problem);
    if (!edit) continue;
    Result<Demonstration> mended = demonstration::apply(now, *edit);
    if (!mended) continue;
    Review after = reviewer.make(*mended, options);
    if (score_of(after.problems) >= score_of(review.problems)) continue;
    edits.push_back(*edit);
    now = std::move(*mended);
    review = std::move(after);
  }
  return edits;
}

void add_fixes(const Demonstration& document, const ReviewOptions& options, std::vector<Problem>& problems) {
  const bool labelled = std::none_of(problems.begin(), problems.end(),
                                     [](const Problem& problem) { return problem.kind == ProblemKind::kSegments; });
  const std::optional<Edit> labels = labelled ? std::nullopt : label_fix(document);
  for (Problem& problem : problems) {
    if (!problem.fix.empty()) continue;
    const std::optional<Edit> fix =
        problem.kind == ProblemKind::kSegments ? labels : fix_of(document, options, problem);
    if (fix) problem.fix = words_of_fix(*fix);
  }
}

}  // namespace trocar::review
