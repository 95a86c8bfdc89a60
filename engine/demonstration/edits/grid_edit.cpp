// SnapToGrid: a path as single actions of the agent, each along one axis by one cell.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/demonstration/discretise.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/snap_figures.h"
#include "engine/spatial/grid.h"

namespace trocar::demonstration {
namespace {

/// When the tool reaches the centre of which cell.
struct Visit {
  double tick = 0.0;
  Eigen::Vector3d p_WT{0.0, 0.0, 0.0};
  spatial::CellIndex cell;
  bool passed = false;  ///< No sample lies in it: it is on the way from one to the next.
};

/// From where to where the tool is within the lattice, the longest such span of the samples.
std::string longest_inside(const Demonstration& document, const std::vector<Sample>& samples, std::size_t arm,
                           const spatial::Grid& grid) {
  std::pair<double, double> longest{0.0, 0.0};
  double begin_s = 0.0;
  bool inside = false;
  for (const Sample& sample : samples) {
    const double now_s = document.time_of(sample);
    const bool was = inside;
    inside = grid.cell_at(measured_tip(sample, arm)).has_value();
    if (inside && !was) begin_s = now_s;
    if (inside && now_s - begin_s > longest.second - longest.first) longest = {begin_s, now_s};
  }
  if (!(longest.second > longest.first)) return "it is nowhere within it in that span";
  // Inwards, so that the times can be typed.
  return fmt::format("it is within it from {:.2f} to {:.2f} s", std::ceil(100.0 * longest.first) / 100.0,
                     std::floor(100.0 * longest.second) / 100.0);
}

/// A tool that went through a corner of a cell in one sample would leap: visits are moved apart, as little as need be
/// and with their ends held, to the time that a cell takes at `kSnappedSpeed_m_s`; to even steps where there is not so
/// much time.
void move_apart(std::vector<Visit>& visits, const spatial::Grid& grid) {
  constexpr double kSnappedSpeed_m_s = 0.15;
  if (visits.size() < 3) return;
  const double begin = visits.front().tick;
  const double end = visits.back().tick;
  const double even = (end - begin) / static_cast<double>(visits.size() - 1);
  const double least = std::min(grid.cell_m / kSnappedSpeed_m_s * static_cast<double>(Tick::kPerSecond), even);
  for (std::size_t i = 1; i < visits.size(); ++i) visits[i].tick = std::max(visits[i].tick, visits[i - 1].tick + least);
  visits.back().tick = end;
  for (std::size_t i = visits.size() - 1; i-- > 1;) {
    visits[i].tick = std::min(visits[i].tick, visits[i + 1].tick - least);
  }
}

/// The path's cells, with what diagonal steps leave out spread evenly over the time that the step took.
Result<std::vector<Visit>> visits_of(const Demonstration& document, const std::vector<Sample>& samples, std::size_t arm,
                                     const spatial::Grid& grid) {
  std::vector<Visit> visits;
  spatial::CellIndex cell;
  double entered = 0.0;
  for (const Sample& sample : samples) {
    const auto now = grid.cell_at(measured_tip(sample, arm));
    if (!now) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("the {} tool is outside the agent's lattice at {:.2f} s; {}", arm == 0 ? "left" : "right",
                              document.time_of(sample), longest_inside(document, samples, arm, grid)));
    }
    const auto tick = static_cast<double>(sample.tick);
    if (visits.empty()) {
      visits.push_back({tick, grid.centre(*now), *now, false});
    } else if (*now != cell) {
      const std::vector<spatial::CellIndex> path = steps_between(grid, cell, *now);
      for (std::size_t i = 0; i < path.size(); ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(path.size());
        visits.push_back({entered + share * (tick - entered), grid.centre(path[i]), path[i], i + 1 < path.size()});
      }
    }
    if (visits.size() == 1 || *now != cell) entered = tick;
    cell = *now;
  }
  move_apart(visits, grid);
  return visits;
}

/// The lattice, moved so that the first sample is in the middle of a cell if it is to keep its place.
Result<spatial::Grid> lattice_for(const SnapToGrid& edit, const Eigen::Vector3d& first_p_WT) {
  spatial::Grid grid;
  if (!edit.keep_offset) return grid;
  TROCAR_ASSIGN_OR_RETURN(const spatial::CellIndex first, grid.cell_at(first_p_WT));
  grid.p_WGo += first_p_WT - grid.centre(first);
  return grid;
}

/// True if each sample lies between the centres of two neighbours, as snapping leaves it.
bool lies_on(const spatial::Grid& grid, const std::vector<Sample>& samples, std::size_t arm) {
  constexpr double kRounding_m = 1e-6;  // far above single precision, far below what a hand can hold
  return std::all_of(samples.begin(), samples.end(), [&](const Sample& sample) {
    const Eigen::Vector3d p_WT = measured_tip(sample, arm);
    const auto cell = grid.cell_at(p_WT);
    if (!cell) return false;
    const Eigen::Vector3d from_centre = (p_WT - grid.centre(*cell)).cwiseAbs();
    return (from_centre.array() > kRounding_m).count() <= 1;
  });
}

/// The place at `tick` on the way from visit to visit; `next` is the last visit before, and goes on.
Eigen::Vector3d place_at(const std::vector<Visit>& visits, double tick, std::size_t& next) {
  while (next + 1 < visits.size() && visits[next + 1].tick <= tick) ++next;
  Eigen::Vector3d p_WT = visits[next].p_WT;
  if (next + 1 < visits.size()) {
    const double share = (tick - visits[next].tick) / (visits[next + 1].tick - visits[next].tick);
    p_WT += share * (visits[next + 1].p_WT - p_WT);
  }
  return p_WT;
}

SnapFigures figures_of(const std::vector<Visit>& visits, std::size_t arm) {
  SnapFigures figures;
  figures.arm = arm;
  figures.actions = static_cast<int>(visits.size()) - 1;
  std::set<std::int32_t> seen;
  for (const Visit& visit : visits) {
    figures.skipped_cells += visit.passed ? 1 : 0;
    figures.repeated_cells += seen.insert(visit.cell.value).second ? 0 : 1;
  }
  return figures;
}

/// Moves the arm in `samples`, which are `before` until then.
Result<SnapFigures> snap_arm(const Demonstration& document, const SnapToGrid& edit, const std::vector<Sample>& before,
                             std::size_t arm, std::vector<Sample>& samples) {
  TROCAR_ASSIGN_OR_RETURN(const spatial::Grid grid, lattice_for(edit, measured_tip(before.front(), arm)));
  TROCAR_ASSIGN_OR_RETURN(const std::vector<Visit> visits, visits_of(document, before, arm, grid));
  SnapFigures figures = figures_of(visits, arm);
  if (edit.keep_snapped && lies_on(grid, before, arm)) return figures;
  std::size_t next = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Eigen::Vector3d by_m =
        place_at(visits, static_cast<double>(before[i].tick), next) - measured_tip(before[i], arm);
    displace(samples[i], arm, by_m, Eigen::Quaterniond::Identity(), document.block);
    figures.max_error_m = std::max(figures.max_error_m, by_m.norm());
    figures.mean_error_m += by_m.norm() / static_cast<double>(before.size());
  }
  return figures;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const SnapToGrid& edit) {
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 2));
  const std::vector<Sample> before = stretch.samples;
  for (const std::size_t arm : indices_of(edit.arms)) {
    const Status snapped = snap_arm(document, edit, before, arm, stretch.samples).map([](const SnapFigures&) {});
    if (!snapped && edit.arms == Arms::kBoth) {
      return fail(snapped.error().code(), fmt::format("the {} arm cannot be snapped, so snap the other one alone: {}",
                                                      arm == 0 ? "left" : "right", snapped.error().text()));
    }
    TROCAR_RETURN_IF_ERROR(snapped);
  }
  return with_stretch(document, std::move(stretch));
}

Result<std::vector<SnapFigures>> snap_figures(const Demonstration& document, const SnapToGrid& edit) {
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 2));
  const std::vector<Sample> before = stretch.samples;
  std::vector<SnapFigures> all;
  for (const std::size_t arm : indices_of(edit.arms)) {
    TROCAR_ASSIGN_OR_RETURN(const SnapFigures figures, snap_arm(document, edit, before, arm, stretch.samples));
    all.push_back(figures);
  }
  return all;
}

std::string sentence_of(const SnapFigures& figures) {
  return fmt::format(
      "{} tool: {} actions, error at most {:.2f} mm, {:.2f} mm on average; cells skipped: {}, repeated: {}",
      figures.arm == 0 ? "left" : "right", figures.actions, 1e3 * figures.max_error_m, 1e3 * figures.mean_error_m,
      figures.skipped_cells, figures.repeated_cells);
}

}  // namespace trocar::demonstration
