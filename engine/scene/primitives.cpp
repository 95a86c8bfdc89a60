#include "engine/scene/primitives.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "engine/core/check.h"

namespace trocar::scene {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

struct Ring {
  Vector3d centre{0, 0, 0};
  Vector3d u{1, 0, 0};
  Vector3d v{0, 1, 0};
  std::optional<Rgba> colour;
};

void add_vertex(Mesh& mesh, const Vector3d& position, const Vector3d& normal, const std::optional<Rgba>& colour) {
  mesh.positions.emplace_back(position.cast<float>());
  mesh.normals.emplace_back(normal.cast<float>());
  if (colour) mesh.colours.push_back(*colour);
}

void add_ring(Mesh& mesh, const Ring& ring, double radius_m, int sides) {
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    const Vector3d out = std::cos(angle) * ring.u + std::sin(angle) * ring.v;
    add_vertex(mesh, ring.centre + radius_m * out, out, ring.colour);
  }
}

void join_rings(Mesh& mesh, std::uint32_t low, std::uint32_t high, int sides) {
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.indices.insert(mesh.indices.end(), {low + i, low + j, high + j, low + i, high + j, high + i});
  }
}

void add_cap(Mesh& mesh, const Ring& ring, double radius_m, int sides, bool last) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Vector3d along = ring.u.cross(ring.v) * (last ? 1.0 : -1.0);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    add_vertex(mesh, ring.centre + radius_m * (std::cos(angle) * ring.u + std::sin(angle) * ring.v), along,
               ring.colour);
  }
  for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(sides); ++i) {
    if (last) {
      mesh.indices.insert(mesh.indices.end(), {first, first + i, first + i + 1});
    } else {
      mesh.indices.insert(mesh.indices.end(), {first, first + i + 1, first + i});
    }
  }
}

std::vector<Ring> distinct(std::span<const Vector3d> points, std::span<const Rgba> colours) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!rings.empty() && (points[i] - rings.back().centre).norm() < 1e-7) continue;
    Ring ring;
    ring.centre = points[i];
    if (!colours.empty()) ring.colour = colours[i];
    rings.push_back(ring);
  }
  return rings;
}

/// Turns each ring's axes with the path, by the least rotation from the one before.
void transport(std::vector<Ring>& rings) {
  Vector3d previous = (rings[1].centre - rings[0].centre).normalized();
  Vector3d u = previous.unitOrthogonal();
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Vector3d before = i == 0 ? previous : Vector3d((rings[i].centre - rings[i - 1].centre).normalized());
    const Vector3d after =
        i + 1 == rings.size() ? before : Vector3d((rings[i + 1].centre - rings[i].centre).normalized());
    // A path that turns straight back has no middle direction; it keeps the old one.
    const Vector3d along = (before + after).norm() > 1e-6 ? Vector3d((before + after).normalized()) : before;
    u = Eigen::Quaterniond::FromTwoVectors(previous, along) * u;
    u = (u - along * along.dot(u)).normalized();
    rings[i].u = u;
    rings[i].v = along.cross(u);
    previous = along;
  }
}

}  // namespace

Mesh unit_cube() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      Vector3f n = Vector3f::Zero();
      n[axis] = sign;
      const Vector3f a = Vector3f::Unit((axis + 1) % 3) * sign;
      const Vector3f b = Vector3f::Unit((axis + 2) % 3);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const Vector3f& corner : {Vector3f(-a - b), Vector3f(a - b), Vector3f(a + b), Vector3f(-a + b)}) {
        mesh.positions.emplace_back(0.5F * (n + corner));
        mesh.normals.push_back(n);
      }
      mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
  }
  return mesh;
}

Mesh arrow(float length_m, float radius_m, float head_m, float head_radius_m) {
  TROCAR_CHECK(radius_m > 0.0F && head_m > 0.0F && head_radius_m > 0.0F && head_m < length_m);
  constexpr int kSides = 16;
  Mesh mesh;
  Ring foot;
  Ring neck = foot;
  neck.centre.z() = static_cast<double>(length_m - head_m);
  add_ring(mesh, foot, radius_m, kSides);
  add_ring(mesh, neck, radius_m, kSides);
  join_rings(mesh, 0, kSides, kSides);
  add_cap(mesh, foot, radius_m, kSides, false);
  add_cap(mesh, neck, head_radius_m, kSides, false);
  const double rise = std::atan2(head_radius_m, head_m);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    const Vector3d normal = std::cos(rise) * out + std::sin(rise) * Vector3d::UnitZ();
    add_vertex(mesh, neck.centre + static_cast<double>(head_radius_m) * out, normal, {});
    add_vertex(mesh, {0.0, 0.0, static_cast<double>(length_m)}, normal, {});
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t j = (i + 1) % kSides;
    mesh.indices.insert(mesh.indices.end(), {first + 2 * i, first + 2 * j, first + 2 * i + 1});
  }
  return mesh;
}

Mesh tube(std::span<const Vector3d> points, std::span<const Rgba> colours, double radius_m, int sides) {
  TROCAR_CHECK(radius_m > 0.0 && sides >= 3 && (colours.empty() || colours.size() == points.size()));
  Mesh mesh;
  std::vector<Ring> rings = distinct(points, colours);
  if (rings.size() < 2) return mesh;
  transport(rings);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    add_ring(mesh, rings[i], radius_m, sides);
    if (i == 0) continue;
    const auto high = static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(sides);
    join_rings(mesh, high - static_cast<std::uint32_t>(sides), high, sides);
  }
  add_cap(mesh, rings.front(), radius_m, sides, false);
  add_cap(mesh, rings.back(), radius_m, sides, true);
  return mesh;
}

Eigen::Matrix4f node_pose(const spatial::Pose& X_WM, const Eigen::Vector3f& scale) {
  Eigen::Matrix4f matrix = X_WM.matrix().cast<float>();
  for (int axis = 0; axis < 3; ++axis) matrix.col(axis) *= scale[axis];
  return matrix;
}

}  // namespace trocar::scene
