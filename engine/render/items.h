/// A scene as a list of what can be drawn, each with all that its pixels depend on: to tell what changed since the last
/// picture, and what can be seen in a part of it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/render/mesh_cache.h"
#include "engine/scene/scene.h"

namespace trocar::render {

/// Corners of a box in W, metres.
using Corners = Eigen::Matrix<float, 3, 8>;

/// A node or a quad. `source` is 0 if there is nothing of it to draw.
struct Item {
  std::uint64_t source = 0;  ///< Serial number of the mesh or the texture: content that differs has another one.
  Instance look;             ///< Of a quad: its frame and, as `base_colour.w()`, its opacity.
  bool casts_shadow = false;
  Corners corners = Corners::Zero();

  bool operator==(const Item& other) const;
};

/// All nodes, then all quads, in the scene's order. Puts meshes and textures into the cache.
std::vector<Item> items_of(const scene::Scene& scene, MeshCache& cache);

Instance instance_of(const scene::Node& node);
/// Below it a thing is see-through: closer to opaque than 8 bits can say.
constexpr float kOpaqueFrom = 0.998F;

/// Whole pixels, right and bottom exclusive; rows as in the frame buffer.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  bool empty() const { return right <= left || bottom <= top; }
  std::int64_t area() const { return empty() ? 0 : std::int64_t{1} * (right - left) * (bottom - top); }
  bool meets(const PixelBox& other) const;
  PixelBox with(const PixelBox& other) const;  ///< The smallest box around both.
};

/// Where a box's shadow or image falls: a picture's size and how W gets there.
struct Window {
  Eigen::Matrix4f clip_from_world;
  int width = 0;
  int height = 0;
};

/// The pixels that a body with these corners can touch, some for rounding included; none if a part of it is at or
/// behind the eye, where nothing can be said.
std::optional<PixelBox> bounds(const Corners& corners, const Window& window);

}  // namespace trocar::render
