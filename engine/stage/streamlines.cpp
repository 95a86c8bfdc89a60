#include "engine/stage/streamlines.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/learning/policy.h"
#include "engine/scene/primitives.h"
#include "engine/stage/mesh_parts.h"

namespace trocar::stage {
namespace {

using learning::RolloutEnd;

constexpr Rgba kArrives{70, 160, 245, 255};
constexpr Rgba kLoops{235, 64, 52, 255};
constexpr Rgba kDeadEnd{240, 150, 40, 255};
constexpr Rgba kOutside{150, 156, 164, 255};
/// In cells.
constexpr double kRadius = 0.07;
constexpr double kHeadRadius = 0.24;
constexpr double kHeadLength = 0.55;
constexpr double kDash = 0.55;
constexpr double kEndCube = 0.5;
constexpr std::size_t kHeadEvery = 4;
constexpr int kTubeSides = 6;
constexpr int kHeadSides = 8;

Rgba line_colour(RolloutEnd end) {
  switch (end) {
    case RolloutEnd::kArrives:
      return kArrives;
    case RolloutEnd::kLoops:
      return kLoops;
    case RolloutEnd::kDeadEnd:
      return kDeadEnd;
    default:
      return kOutside;
  }
}

/// Follows the policy until a cell where a line has been.
class Lines {
 public:
  Lines(const learning::Model& model, const std::vector<std::uint8_t>& policy)
      : policy_(policy), strides_(learning::strides(model.grid)), basin_(learning::basin(model, policy)) {
    passed_.assign(policy.size(), 0);
  }

  void begin_at(spatial::CellIndex start) {
    if (passed_[at(start)] != 0) return;
    const std::size_t first = cells_.size();
    learning::CellSequence cells{start};
    while (policy_[at(cells.back())] != learning::kNoAction && passed_[at(cells.back())] == 0) {
      passed_[at(cells.back())] = 1;
      cells.push_back({cells.back().value + strides_[policy_[at(cells.back())]]});
    }
    if (cells.size() == 1) passed_[at(start)] = 1;
    add(std::move(cells), basin_.end[at(start)]);
    TROCAR_ASSERT(cells_.size() > first);
  }

  std::vector<Streamline> take() { return std::move(cells_); }

 private:
  static std::size_t at(spatial::CellIndex cell) { return static_cast<std::size_t>(cell.value); }

  void add(learning::CellSequence cells, RolloutEnd end) {
    // The way to a loop and the loop are two lines: the last cell is on its own line only if the loop closes here.
    const auto again = std::find(cells.begin(), cells.end() - 1, cells.back());
    if (end == RolloutEnd::kLoops && again != cells.end() - 1) {
      learning::CellSequence loop(again, cells.end());
      cells.erase(again + 1, cells.end());
      if (cells.size() > 1) cells_.push_back({end, false, std::move(cells)});
      cells_.push_back({end, true, std::move(loop)});
      return;
    }
    cells_.push_back({end, false, std::move(cells)});
  }

  const std::vector<std::uint8_t>& policy_;
  std::array<std::int32_t, spatial::kActionCount> strides_;
  learning::Basin basin_;
  std::vector<std::uint8_t> passed_;
  std::vector<Streamline> cells_;
};

void add_tube_part(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Rgba colour,
                   scene::Mesh& whole) {
  const std::array<Eigen::Vector3d, 2> ends{from, to};
  add_part(scene::tube(ends, {}, radius, kTubeSides), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Ones(),
           Eigen::Vector3d::Zero(), colour, whole);
}

void add_line(const spatial::Grid& grid, const Streamline& line, const scene::Mesh& head, const scene::Mesh& cube,
              scene::Mesh& whole) {
  const Rgba colour = line_colour(line.end);
  const bool dashed = line.end == RolloutEnd::kLoops;
  std::vector<Eigen::Vector3d> points;
  for (const spatial::CellIndex cell : line.cells) points.push_back(grid.centre(cell));
  if (dashed) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Eigen::Vector3d rest = 0.5 * (1.0 - kDash) * (points[i + 1] - points[i]);
      add_tube_part(points[i] + rest, points[i + 1] - rest, kRadius * grid.cell_m, colour, whole);
    }
  } else if (points.size() > 1) {
    add_part(scene::tube(points, {}, kRadius * grid.cell_m, kTubeSides), Eigen::Matrix3d::Identity(),
             Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero(), colour, whole);
  }
  const double radius = kHeadRadius * grid.cell_m;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    // One in the middle of every so many steps, and where the line is short, one at all.
    const bool last = i + 2 == points.size() && i < kHeadEvery;
    if (i % kHeadEvery != kHeadEvery / 2 && !last) continue;
    const Eigen::Vector3d along = (points[i + 1] - points[i]).normalized();
    const Eigen::Vector3d foot = 0.5 * (points[i] + points[i + 1]) - 0.5 * kHeadLength * grid.cell_m * along;
    add_part(head, z_towards(along), {radius, radius, kHeadLength * grid.cell_m}, foot, colour, whole);
  }
  if (line.end == RolloutEnd::kDeadEnd || line.end == RolloutEnd::kOutsideSafeSet) {
    add_part(cube, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(kEndCube * grid.cell_m), points.back(),
             colour, whole);
  }
}

}  // namespace

std::vector<Streamline> streamlines(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                                    const std::vector<spatial::CellIndex>& starts) {
  TROCAR_CHECK(policy.size() == static_cast<std::size_t>(model.grid.cell_count()));
  Lines lines(model, policy);
  for (const spatial::CellIndex start : starts) lines.begin_at(start);
  return lines.take();
}

void add_streamlines(const spatial::Grid& grid, const std::vector<Streamline>& lines, scene::Scene& scene) {
  scene::Mesh whole;
  const scene::Mesh head = cone(kHeadSides);
  const scene::Mesh cube = scene::unit_cube();
  for (const Streamline& line : lines) add_line(grid, line, head, cube, whole);
  add_drawn(std::move(whole), 1.0F, scene);
}

}  // namespace trocar::stage
