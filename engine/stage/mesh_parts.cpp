#include "engine/stage/mesh_parts.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/stage/palette.h"

namespace trocar::stage {

void add_part(const scene::Mesh& part, const Eigen::Matrix3d& R_WM, const Eigen::Vector3d& scale,
              const Eigen::Vector3d& p_W, Rgba colour, scene::Mesh& whole) {
  const auto first = static_cast<std::uint32_t>(whole.positions.size());
  const Eigen::Matrix3f placed = (R_WM * scale.asDiagonal()).cast<float>();
  const Eigen::Matrix3f turned = (R_WM * scale.cwiseInverse().asDiagonal()).cast<float>();
  const Eigen::Vector3f moved = p_W.cast<float>();
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    whole.positions.emplace_back(placed * part.positions[i] + moved);
    whole.normals.emplace_back((turned * part.normals[i]).normalized());
    whole.colours.push_back(colour);
  }
  for (const std::uint32_t i : part.indices) whole.indices.push_back(first + i);
}

Eigen::Matrix3d z_towards(const Eigen::Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction).toRotationMatrix();
}

scene::Mesh cone(int sides) {
  scene::Mesh made;
  const auto at = [&](int side) {
    const double angle = 2.0 * std::numbers::pi * side / sides;
    return Eigen::Vector3f(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F);
  };
  const auto triangle = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                            const std::array<Eigen::Vector3f, 3>& normals) {
    for (const Eigen::Vector3f& p : {a, b, c}) {
      made.indices.push_back(static_cast<std::uint32_t>(made.positions.size()));
      made.positions.push_back(p);
    }
    for (const Eigen::Vector3f& normal : normals) made.normals.push_back(normal.normalized());
  };
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  for (int side = 0; side < sides; ++side) {
    const Eigen::Vector3f a = at(side);
    const Eigen::Vector3f b = at(side + 1);
    triangle(a, b, up, {a + up, b + up, a + b + 2.0F * up});
    triangle(b, a, Eigen::Vector3f::Zero(), {-up, -up, -up});
  }
  return made;
}

Eigen::Vector3d direction_of(int action) {
  return Eigen::Vector3d::Unit(action / 2) * (action % 2 == 0 ? 1.0 : -1.0);
}

void add_drawn(scene::Mesh whole, float opacity, scene::Scene& scene) {
  if (whole.indices.empty()) return;
  scene::Node node;
  node.mesh = std::make_shared<const scene::Mesh>(std::move(whole));
  node.material = palette::material({255, 255, 255, 255}, 0.8F, 0.0F);
  node.material.base_colour.w() = opacity;
  node.material.emission = 0.7F;
  node.material.casts_shadow = false;
  scene.nodes.push_back(std::move(node));
}

}  // namespace trocar::stage
