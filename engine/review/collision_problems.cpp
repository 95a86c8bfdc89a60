// Tools that go into the board, the pegs, the blocks or each other, or pass too near to them.
#include <fmt/format.h>

#include <algorithm>

#include "engine/review/fixes.h"
#include "engine/review/problem_parts.h"
#include "engine/review/sweep.h"

namespace trocar::review {
namespace {

using namespace demonstration;
using peg_board::kBlockCount;

/// What comes again so soon is one passage.
constexpr double kTogether_s = 0.5;

std::string name_of(Obstacle obstacle, const Nearest& nearest) {
  switch (obstacle) {
    case Obstacle::kBoard:
      return "the board";
    case Obstacle::kPeg:
      return nearest.index < kBlockCount ? fmt::format("start peg {}", nearest.index)
                                         : fmt::format("goal peg {}", nearest.index - kBlockCount);
    case Obstacle::kBlock:
      return fmt::format("block {}", nearest.index);
    case Obstacle::kOtherTool:
      return fmt::format("the other tool's {}", to_string(static_cast<Part>(nearest.index)));
  }
  return "something";
}

/// Where the jaws work, between a block and its peg, a touch is as it must be.
bool works_there(Obstacle obstacle, const Nearest& nearest) {
  return obstacle == Obstacle::kPeg && (nearest.part == Part::kJaw0 || nearest.part == Part::kJaw1);
}

/// Of two tools that meet, the one that holds nothing gives way, and else the assistant's.
std::size_t arm_that_gives_way(Obstacle obstacle, std::size_t arm, const Sample& sample) {
  if (obstacle != Obstacle::kOtherTool) return arm;
  const bool left_holds = (sample.flags & kLeftHolds) != 0;
  const bool right_holds = (sample.flags & kRightHolds) != 0;
  return right_holds && !left_holds ? 0 : 1;
}

/// How near this may come.
double allowed_m(const ReviewOptions& options, Obstacle obstacle, const Nearest& nearest) {
  return works_there(obstacle, nearest) ? -0.5 * options.touch_m : options.clearance_m;
}

/// True if a tool that is moved so keeps clear of the obstacle that `arm` was too near to, runs into nothing else, and
/// can reach where it goes.
bool keeps_clear(const Reviewed& of, const MoveTool& edit, std::size_t arm, Obstacle obstacle) {
  const std::size_t moved = edit.arms == Arms::kLeft ? 0 : 1;
  Sweep sweep(of.document.block);
  for (Sample sample : of.document.samples_within(edit.at_s - edit.radius_s, edit.at_s + edit.radius_s)) {
    const Eigen::Vector3d by_m = fade(edit, of.document.time_of(sample)) * edit.by_m;
    ArmSample& tool = sample.arms[moved];
    spatial::Pose pose = tool.measured.pose();
    pose.p += by_m;
    tool.measured = CompactPose::from(pose);
    for (std::size_t i = 0; i < 3; ++i) tool.setpoint_p[i] += by_m[static_cast<Eigen::Index>(i)];
    const SampleReview review = sweep.next(sample);
    const Nearest& watched = review[arm].nearest[static_cast<std::size_t>(obstacle)];
    if (static_cast<double>(watched.distance_m) < allowed_m(of.options, obstacle, watched)) return false;
    if (review[moved].least_m() < -of.options.touch_m) return false;
    if (!review[moved].reachable || review[moved].excess.joint >= 0) return false;
  }
  return true;
}

/// The smallest displacement that helps, of those along the way out, up, between the two, and to the sides.
std::string fix_of(const Reviewed& of, std::size_t arm, Obstacle obstacle, const ProblemRun& run) {
  const auto kind = static_cast<std::size_t>(obstacle);
  const Sample worst = of.samples[run.worst];
  const Separation apart = separation_at(worst, arm, obstacle, of.clearance.nearest(run.worst, arm, kind));
  const std::size_t moved = arm_that_gives_way(obstacle, arm, worst);
  std::vector<Need> needs;
  for (std::size_t i = run.first; i <= run.last; ++i) {
    const auto distance_m = static_cast<double>(of.clearance.nearest(i, arm, kind).distance_m);
    needs.push_back({of.times_s[i], std::max(0.0, 1.1 * of.options.clearance_m - distance_m)});
  }
  const Eigen::Vector3d out = moved == arm ? apart.normal : Eigen::Vector3d(-apart.normal);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d side = up.cross(out);
  std::vector<Eigen::Vector3d> directions{out, up};
  if ((out + up).norm() > 0.1) directions.push_back((out + up).normalized());
  if (side.norm() > 0.1) directions.insert(directions.end(), {side.normalized(), -side.normalized()});
  constexpr double kLarger = 1.6;
  for (int i = 0; i < 6; ++i) {
    for (const Eigen::Vector3d& direction : directions) {
      const std::optional<MoveTool> edit = moved_away(moved, of.times_s[run.worst], direction, needs);
      if (edit && keeps_clear(of, *edit, arm, obstacle)) return words_of_fix(*edit);
    }
    for (Need& need : needs) need.by_m *= kLarger;
  }
  return "";
}

void add_kind(const Reviewed& of, std::size_t arm, Obstacle obstacle, std::vector<Problem>& found) {
  const auto kind = static_cast<std::size_t>(obstacle);
  const auto nearest_at = [&](std::size_t i) { return of.clearance.nearest(i, arm, kind); };
  // Nothing that is said here is of samples that are farther apart than both bounds.
  const std::vector<std::size_t> near =
      of.clearance.nearer_than(std::max(of.options.clearance_m, -of.options.touch_m), arm, kind);
  const auto shown = [&](double metres) { return fmt::format("{:.1f} mm", 1e3 * metres); };
  const auto add = [&](ProblemKind what, Severity severity, const ProblemRun& run, std::string message) {
    const bool both = obstacle == Obstacle::kOtherTool;
    found.push_back({what, severity, of.times_s[run.first], of.times_s[run.last], std::move(message),
                     fix_of(of, arm, obstacle, run), both ? -1 : static_cast<int>(arm)});
  };
  const std::vector<ProblemRun> collisions = runs_of(
      of, near,
      [&](std::size_t i) -> std::optional<double> {
        const auto depth_m = -static_cast<double>(nearest_at(i).distance_m);
        if (depth_m <= of.options.touch_m) return std::nullopt;
        return depth_m;
      },
      kTogether_s);
  for (const ProblemRun& run : collisions) {
    const Nearest worst = nearest_at(run.worst);
    add(ProblemKind::kCollision, Severity::kError, run,
        fmt::format("the {} {} go{} {} into {}", tool_name(arm), to_string(worst.part),
                    to_string(worst.part) == "jaws" ? "" : "es", shown(run.value), name_of(obstacle, worst)));
  }
  const std::vector<ProblemRun> passes = runs_of(
      of, near,
      [&](std::size_t i) -> std::optional<double> {
        const Nearest nearest = nearest_at(i);
        const auto distance_m = static_cast<double>(nearest.distance_m);
        const double least_m = allowed_m(of.options, obstacle, nearest);
        if (distance_m >= least_m) return std::nullopt;
        return of.options.clearance_m - distance_m;
      },
      kTogether_s);
  for (const ProblemRun& run : passes) {
    const bool collides = std::any_of(collisions.begin(), collisions.end(), [&](const ProblemRun& other) {
      return other.first <= run.last && run.first <= other.last;
    });
    if (collides) continue;
    const Nearest worst = nearest_at(run.worst);
    const double distance_m = of.options.clearance_m - run.value;
    add(ProblemKind::kClearance, Severity::kWarning, run,
        distance_m < 0.0
            ? fmt::format("the {} {} touch{} {}, {:.2f} mm deep", tool_name(arm), to_string(worst.part),
                          to_string(worst.part) == "jaws" ? "" : "es", name_of(obstacle, worst), -1e3 * distance_m)
            : fmt::format("the {} {} pass{} {} at {:.2f} mm, nearer than {:.2g}", tool_name(arm), to_string(worst.part),
                          to_string(worst.part) == "jaws" ? "" : "es", name_of(obstacle, worst), 1e3 * distance_m,
                          1e3 * of.options.clearance_m));
  }
}

}  // namespace

void add_collisions(const Reviewed& of, std::vector<Problem>& found) {
  for (std::size_t arm = 0; arm < 2; ++arm) {
    for (const Obstacle obstacle : {Obstacle::kBoard, Obstacle::kPeg, Obstacle::kBlock}) {
      add_kind(of, arm, obstacle, found);
    }
  }
  // One meeting is one problem, told of the left tool.
  add_kind(of, 0, Obstacle::kOtherTool, found);
}

}  // namespace trocar::review
