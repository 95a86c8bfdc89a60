#include "engine/stage/iso_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/core/check.h"

namespace trocar::stage {
namespace {

using Eigen::Vector3d;

/// The six tetrahedra of a cube around its diagonal, by its corners (bit 0 x, 1 y, 2 z): neighbouring cubes share the
/// diagonals of their faces.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

class Marching {
 public:
  Marching(const learning::Field& field, double level) : field_(field), level_(level), n_(field.grid.n) {}

  scene::Mesh run() {
    for (int x = -1; x < n_; ++x) {
      for (int y = -1; y < n_; ++y) {
        for (int z = -1; z < n_; ++z) take_cube(x, y, z);
      }
    }
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      // A triangle of no area, between cells exactly on the level, may face nowhere.
      Vector3d normal = normals_[i].isZero(0.0) ? facing_[i] : normals_[i];
      if (normal.isZero(0.0)) normal = Vector3d::UnitZ();
      mesh_.normals.emplace_back(normal.normalized().cast<float>());
    }
    return std::move(mesh_);
  }

 private:
  /// A corner of the tetrahedra: the middle of a cell, or of one just beyond the lattice.
  struct Corner {
    int x, y, z;
  };

  bool is_known(const Corner& c) const { return std::isfinite(value(c)); }
  double value(const Corner& c) const {
    const spatial::CellCoordinates cell{c.x, c.y, c.z};
    if (!field_.grid.contains(cell)) return std::numeric_limits<double>::quiet_NaN();
    return field_.values[static_cast<std::size_t>(field_.grid.index(cell).value)];
  }
  bool above(const Corner& c) const { return is_known(c) && value(c) >= level_; }
  int number(const Corner& c) const { return ((c.x + 1) * (n_ + 2) + c.y + 1) * (n_ + 2) + c.z + 1; }
  Vector3d middle(const Corner& c) const {
    return field_.grid.p_WGo + field_.grid.cell_m * (Vector3d(c.x, c.y, c.z) + Vector3d::Constant(0.5));
  }

  /// By central differences, on one side only where the other is unknown.
  Vector3d gradient(const Corner& c) const {
    Vector3d slope = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const auto beside = [&](int by) {
        return Corner{c.x + (axis == 0 ? by : 0), c.y + (axis == 1 ? by : 0), c.z + (axis == 2 ? by : 0)};
      };
      const Corner low = is_known(beside(-1)) ? beside(-1) : c;
      const Corner high = is_known(beside(1)) ? beside(1) : c;
      const int apart = high.x - low.x + high.y - low.y + high.z - low.z;
      if (apart > 0) slope[axis] = (value(high) - value(low)) / apart;
    }
    return slope;
  }

  std::uint32_t vertex(const Corner& in, const Corner& out) {
    const std::pair<int, int> ends = std::minmax({number(in), number(out)});
    const std::uint64_t edge = static_cast<std::uint64_t>(ends.first) << 32U | static_cast<std::uint64_t>(ends.second);
    const auto [found, fresh] = vertices_.try_emplace(edge, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (!fresh) return found->second;
    double t = 0.5;
    Vector3d normal = Vector3d::Zero();
    if (is_known(out)) {
      t = (value(in) - level_) / (value(in) - value(out));
      normal = -((1.0 - t) * gradient(in) + t * gradient(out));
    }
    mesh_.positions.push_back(((1.0 - t) * middle(in) + t * middle(out)).cast<float>());
    normals_.push_back(normal);
    facing_.emplace_back(Vector3d::Zero());
    return found->second;
  }

  void take_cube(int x, int y, int z) {
    std::array<Corner, 8> corners{};
    int inside = 0;
    for (int i = 0; i < 8; ++i) {
      corners[static_cast<std::size_t>(i)] = {x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)};
      inside += above(corners[static_cast<std::size_t>(i)]) ? 1 : 0;
    }
    if (inside == 0 || inside == 8) return;
    for (const std::array<int, 4>& tetrahedron : kTetrahedra) {
      std::vector<Corner> in;
      std::vector<Corner> out;
      for (const int i : tetrahedron) {
        const Corner& corner = corners[static_cast<std::size_t>(i)];
        (above(corner) ? in : out).push_back(corner);
      }
      take(in, out);
    }
  }

  void take(const std::vector<Corner>& in, const std::vector<Corner>& out) {
    if (in.empty() || out.empty()) return;
    Vector3d outwards = Vector3d::Zero();
    for (const Corner& corner : out) outwards += middle(corner) / static_cast<double>(out.size());
    for (const Corner& corner : in) outwards -= middle(corner) / static_cast<double>(in.size());
    if (in.size() == 2) {
      const std::array<std::uint32_t, 4> around{vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[1], out[1]),
                                                vertex(in[1], out[0])};
      add(around[0], around[1], around[2], outwards);
      add(around[0], around[2], around[3], outwards);
    } else if (in.size() == 1) {
      add(vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2]), outwards);
    } else {
      add(vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0]), outwards);
    }
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vector3d& outwards) {
    const auto at = [&](std::uint32_t i) -> Vector3d { return mesh_.positions[i].cast<double>(); };
    Vector3d facing = (at(b) - at(a)).cross(at(c) - at(a));
    if (facing.dot(outwards) < 0.0) {
      std::swap(b, c);
      facing = -facing;
    }
    for (const std::uint32_t i : {a, b, c}) {
      facing_[i] += facing;
      mesh_.indices.push_back(i);
    }
  }

  const learning::Field& field_;
  double level_;
  int n_;
  scene::Mesh mesh_;
  std::vector<Vector3d> normals_;  ///< Zero where the gradient says nothing.
  std::vector<Vector3d> facing_;   ///< Of the triangles around, by area.
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
};

}  // namespace

scene::Mesh iso_surface(const learning::Field& field, double level) {
  TROCAR_CHECK(field.values.size() == static_cast<std::size_t>(field.grid.cell_count()));
  return Marching(field, level).run();
}

}  // namespace trocar::stage
