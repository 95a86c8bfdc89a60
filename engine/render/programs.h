/// The renderer's linked shader programs and where their uniforms are.
#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/core/result.h"
#include "engine/render/gl_functions.h"
#include "engine/scene/scene.h"

namespace trocar::render {

enum class ShadowKind { kNone, kHard, kSoft };

/// What all programs of a picture share.
struct View {
  Eigen::Matrix4f clip_from_world;
  Eigen::Matrix4f shadow_from_world;  ///< To 0 … 1 in the shadow map.
  Eigen::Matrix4f shadow_clip_from_world;
  Eigen::Vector4f eye;       ///< A point with w = 1, or the direction towards the viewer with w = 0.
  Eigen::Vector3f to_light;  ///< Unit.
  float shadow_texel_m = 0.0F;
  int width = 0;
  int height = 0;
  Eigen::Vector3f background_top;
  Eigen::Vector3f background_bottom;
  Eigen::Vector3f fade;  ///< Begin, 1 / width, 1 / picture height.

  bool operator==(const View&) const = default;
};
/// Row 0 of the frame buffer is the top row of the picture, so that it is read without turning it over; front faces
/// are then clockwise. Precondition: the scene's light direction is not zero.
View make_view(const scene::Scene& scene, const scene::Camera& camera, int width, int height);

/// Threads: that of the context.
class Programs {
 public:
  /// Errors: kUnsupported with the driver's log.
  static Result<Programs> link(const GlFunctions& gl);
  void release(const GlFunctions& gl);

  void use_surface(const GlFunctions& gl, ShadowKind kind, bool matte, const View& view) const;
  void use_shadow(const GlFunctions& gl, const View& view) const;
  void use_background(const GlFunctions& gl, const View& view) const;
  void use_quad(const GlFunctions& gl, const View& view, const scene::Quad& quad) const;

 private:
  std::array<GLuint, 6> surface_{};  ///< By twice the ShadowKind, one more for matte.
  GLuint shadow_ = 0;
  GLuint background_ = 0;
  GLuint quad_ = 0;
};

}  // namespace trocar::render
