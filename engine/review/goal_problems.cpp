// Begins and ends elsewhere than it should: the block's pegs, a model's goal, a model's safe set.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/demonstration/motion.h"
#include "engine/review/problem_parts.h"

namespace trocar::review {
namespace {

using namespace demonstration;

/// Further from a peg's axis a block is not seated on it; the task's own tolerance.
constexpr double kSeated_m = 0.005;

bool exists(int place) {
  return place >= 0 && place < peg_board::kBlockCount;
}

double across_m(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

void add_peg_problems(const Reviewed& of, std::vector<Problem>& found) {
  const Demonstration& document = of.document;
  if (!exists(document.block)) return;
  const auto block = static_cast<std::size_t>(document.block);
  const auto place = [&](const Sample& sample) { return sample.blocks[block].pose().p; };
  const auto report = [&](double t_s, std::string message) {
    found.push_back({ProblemKind::kEnds, Severity::kWarning, t_s, t_s, std::move(message), ""});
  };
  // A block that is where nobody put it is not known, as in imports.
  const Eigen::Vector3d first = place(of.samples.front());
  if (first == Eigen::Vector3d::Zero()) return;
  const double start_m = across_m(first, peg_board::start_peg(document.block));
  if (document.segment(Segment::kA) && start_m > kSeated_m) {
    report(of.times_s.front(),
           fmt::format("block {} begins {:.1f} mm from its start peg", document.block, 1e3 * start_m));
  }
  if (!exists(document.goal) || !document.segment(Segment::kE)) return;
  const Eigen::Vector3d last = place(of.samples.back());
  const double goal_m = across_m(last, peg_board::goal_peg(document.goal));
  if (goal_m > kSeated_m) {
    report(of.times_s.back(),
           fmt::format("block {} ends {:.1f} mm from goal peg {}", document.block, 1e3 * goal_m, document.goal));
  }
}

/// In cells, along the axis on which they are farthest apart.
int cells_between(const spatial::Grid& grid, spatial::CellIndex a, spatial::CellIndex b) {
  const spatial::CellCoordinates at = grid.coordinates(a);
  const spatial::CellCoordinates to = grid.coordinates(b);
  return std::max({std::abs(at.x - to.x), std::abs(at.y - to.y), std::abs(at.z - to.z)});
}

void add_model_problems(const Reviewed& of, const SegmentGoal& goal, std::vector<Problem>& found) {
  const std::optional<SegmentSpan> span = of.document.segment(goal.segment);
  if (!span) return;
  const auto cell_at = [&](std::size_t i) { return goal.grid.cell_at(measured_tip(of.samples[i], 0)); };
  std::size_t last = of.times_s.size();
  std::vector<std::size_t> all(of.times_s.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto outside = runs_of(of, all, [&](std::size_t i) -> std::optional<double> {
    if (of.times_s[i] < span->begin_s || of.times_s[i] >= span->end_s) return std::nullopt;
    last = i;
    const auto cell = cell_at(i);
    // Outside of the cube is another problem.
    if (!cell || goal.safe.contains(*cell)) return std::nullopt;
    return 1.0;
  });
  for (const ProblemRun& run : outside) {
    found.push_back({ProblemKind::kSafeSet, Severity::kWarning, of.times_s[run.first], of.times_s[run.last],
                     fmt::format("{} samples of segment {} lie outside of the safe set of {}", run.count,
                                 letter(goal.segment), goal.model),
                     "", 0});
  }
  if (last == of.times_s.size()) return;
  const auto end = cell_at(last);
  const int cells = end ? cells_between(goal.grid, *end, goal.goal) : 0;
  if (cells == 0) return;
  found.push_back({ProblemKind::kEnds, cells > 1 ? Severity::kWarning : Severity::kInfo, of.times_s[last],
                   of.times_s[last],
                   fmt::format("segment {} ends {} {} from the goal of {}", letter(goal.segment), cells,
                               cells == 1 ? "cell" : "cells", goal.model),
                   "", 0});
}

}  // namespace

void add_goal_problems(const Reviewed& of, std::vector<Problem>& found) {
  add_peg_problems(of, found);
  for (const SegmentGoal& goal : of.options.goals) add_model_problems(of, goal, found);
}

}  // namespace trocar::review
