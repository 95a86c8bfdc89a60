// SnapToGrid: a path as single actions of the agent, each along one axis by one cell.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/demonstration/discretise.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/spatial/grid.h"

namespace trocar::demonstration {
namespace {

/// When the tool reaches the centre of which cell.
struct Visit {
  double tick = 0.0;
  Eigen::Vector3d p_WT{0.0, 0.0, 0.0};
};

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
                  fmt::format("the tool leaves the agent's lattice at {:.2f} s", document.time_of(sample)));
    }
    const auto tick = static_cast<double>(sample.tick);
    if (visits.empty()) {
      visits.push_back({tick, grid.centre(*now)});
    } else if (*now != cell) {
      const std::vector<spatial::CellIndex> path = steps_between(grid, cell, *now);
      for (std::size_t i = 0; i < path.size(); ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(path.size());
        visits.push_back({entered + share * (tick - entered), grid.centre(path[i])});
      }
    }
    if (visits.size() == 1 || *now != cell) entered = tick;
    cell = *now;
  }
  return visits;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const SnapToGrid& edit) {
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 2));
  const std::vector<Sample> before = stretch.samples;
  for (const std::size_t arm : indices_of(edit.arms)) {
    spatial::Grid grid;
    if (edit.keep_offset) {
      // The lattice moves so that the first sample is in the middle of a cell.
      TROCAR_ASSIGN_OR_RETURN(const spatial::CellIndex first, grid.cell_at(measured_tip(before.front(), arm)));
      grid.p_WGo += measured_tip(before.front(), arm) - grid.centre(first);
    }
    TROCAR_ASSIGN_OR_RETURN(const std::vector<Visit> visits, visits_of(document, before, arm, grid));
    std::size_t next = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto tick = static_cast<double>(before[i].tick);
      while (next + 1 < visits.size() && visits[next + 1].tick <= tick) ++next;
      Eigen::Vector3d p_WT = visits[next].p_WT;
      if (next + 1 < visits.size()) {
        const double share = (tick - visits[next].tick) / (visits[next + 1].tick - visits[next].tick);
        p_WT += share * (visits[next + 1].p_WT - p_WT);
      }
      displace(stretch.samples[i], arm, p_WT - measured_tip(before[i], arm), Eigen::Quaterniond::Identity(),
               document.block);
    }
  }
  return with_stretch(document, std::move(stretch));
}

}  // namespace trocar::demonstration
