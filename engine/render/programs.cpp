#include "engine/render/programs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/render/frame_target.h"
#include "engine/render/shaders.h"

namespace trocar::render {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

// What the shadow map covers: the board with the arms above it, and what they darken beside it.
const Vector3f kShadowCentre_m(-0.012F, 0.0F, 0.020F);
constexpr float kShadowHalfWidth_m = 0.115F;
constexpr float kShadowHalfDepth_m = 0.25F;

Matrix4f projection(const scene::Camera& camera, int width, int height) {
  const auto near = static_cast<float>(camera.near_m);
  const auto far = static_cast<float>(camera.far_m);
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  Matrix4f clip_from_camera = Matrix4f::Zero();
  if (camera.orthographic) {
    const auto scale = static_cast<float>(2.0 / camera.orthographic_height_m);
    clip_from_camera(0, 0) = scale / aspect;
    clip_from_camera(1, 1) = scale;
    clip_from_camera(2, 2) = 2.0F / (far - near);
    clip_from_camera(2, 3) = -(far + near) / (far - near);
    clip_from_camera(3, 3) = 1.0F;
    return clip_from_camera;
  }
  const auto focal = static_cast<float>(1.0 / std::tan(0.5 * camera.vertical_fov_rad));
  clip_from_camera(0, 0) = focal / aspect;
  clip_from_camera(1, 1) = focal;
  clip_from_camera(2, 2) = (far + near) / (far - near);
  clip_from_camera(2, 3) = -2.0F * far * near / (far - near);
  clip_from_camera(3, 2) = 1.0F;
  return clip_from_camera;
}

Matrix4f light_clip(const Vector3f& along) {
  const Vector3f helper = std::abs(along.x()) < 0.9F ? Vector3f::UnitX() : Vector3f::UnitY();
  const Vector3f u = helper.cross(along).normalized();
  const Vector3f v = along.cross(u);
  Matrix4f clip = Matrix4f::Identity();
  const Vector3f rows[3] = {u / kShadowHalfWidth_m, v / kShadowHalfWidth_m, along / kShadowHalfDepth_m};
  for (int i = 0; i < 3; ++i) {
    clip.block<1, 3>(i, 0) = rows[i].transpose();
    clip(i, 3) = -rows[i].dot(kShadowCentre_m);
  }
  return clip;
}

Vector3f vector(Rgba colour) {
  return Vector3f(static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b)) / 255.0F;
}

struct Uniforms {
  const GlFunctions& gl;
  GLuint program;

  GLint at(const char* name) const { return gl.GetUniformLocation(program, name); }
  void set(const char* name, const Matrix4f& m) const { gl.UniformMatrix4fv(at(name), 1, GL_FALSE, m.data()); }
  void set(const char* name, const Vector3f& v) const { gl.Uniform3fv(at(name), 1, v.data()); }
  void set(const char* name, const Eigen::Vector4f& v) const { gl.Uniform4fv(at(name), 1, v.data()); }
  void set(const char* name, float value) const { gl.Uniform1f(at(name), value); }
  void set(const char* name, int value) const { gl.Uniform1i(at(name), value); }
};

}  // namespace

View make_view(const scene::Scene& scene, const scene::Camera& camera, int width, int height) {
  View view;
  const Matrix4f camera_from_world = camera.X_WC.inverse().matrix().cast<float>();
  view.clip_from_world = projection(camera, width, height) * camera_from_world;
  const Vector3f along = scene.light_direction.normalized();
  view.shadow_clip_from_world = light_clip(along);
  Matrix4f half = Matrix4f::Identity() * 0.5F;
  half.col(3) << 0.5F, 0.5F, 0.5F, 1.0F;
  view.shadow_from_world = half * view.shadow_clip_from_world;
  const Eigen::Vector3d forward = camera.X_WC.q * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d eye = camera.orthographic ? Eigen::Vector3d(-forward) : camera.X_WC.p;
  view.eye << eye.cast<float>(), camera.orthographic ? 0.0F : 1.0F;
  view.to_light = -along;
  view.shadow_texel_m = 2.0F * kShadowHalfWidth_m / static_cast<float>(ShadowMap::kSize);
  view.width = width;
  view.height = height;
  view.background_top = vector(scene.background_top);
  view.background_bottom = vector(scene.background_bottom);
  const float width_m = std::max(scene.fade_end_m - scene.fade_begin_m, 1e-6F);
  view.fade = Vector3f(scene.fade_begin_m, 1.0F / width_m, 1.0F / static_cast<float>(height));
  return view;
}

Result<Programs> Programs::link(const GlFunctions& gl) {
  Programs programs;
  const char* const defines[3] = {"", "#define HARD_SHADOW\n", "#define SOFT_SHADOW\n"};
  for (std::size_t i = 0; i < programs.surface_.size(); ++i) {
    const std::string fragment =
        std::string("#version 330 core\n") + defines[i / 2] + (i % 2 == 1 ? "#define MATTE\n" : "") + kSurfaceFragment;
    TROCAR_ASSIGN_OR_RETURN(programs.surface_[i], link_program(gl, kSurfaceVertex, fragment.c_str()));
  }
  TROCAR_ASSIGN_OR_RETURN(programs.shadow_, link_program(gl, kShadowVertex, kShadowFragment));
  TROCAR_ASSIGN_OR_RETURN(programs.background_, link_program(gl, kBackgroundVertex, kBackgroundFragment));
  TROCAR_ASSIGN_OR_RETURN(programs.quad_, link_program(gl, kQuadVertex, kQuadFragment));
  return programs;
}

void Programs::release(const GlFunctions& gl) {
  for (const GLuint program : surface_) gl.DeleteProgram(program);
  for (const GLuint program : {shadow_, background_, quad_}) gl.DeleteProgram(program);
  *this = {};
}

void Programs::use_surface(const GlFunctions& gl, ShadowKind kind, bool matte, const View& view) const {
  const Uniforms uniforms{gl, surface_[2 * static_cast<std::size_t>(kind) + (matte ? 1 : 0)]};
  gl.UseProgram(uniforms.program);
  uniforms.set("clip_from_world", view.clip_from_world);
  uniforms.set("shadow_from_world", view.shadow_from_world);
  uniforms.set("shadow_texel_m", view.shadow_texel_m);
  uniforms.set("shadow_texel", 1.0F / static_cast<float>(ShadowMap::kSize));
  uniforms.set("shadow_map", 0);
  uniforms.set("eye", view.eye);
  uniforms.set("to_light", view.to_light);
  uniforms.set("background_top", view.background_top);
  uniforms.set("background_bottom", view.background_bottom);
  uniforms.set("fade", view.fade);
}

void Programs::use_shadow(const GlFunctions& gl, const View& view) const {
  const Uniforms uniforms{gl, shadow_};
  gl.UseProgram(uniforms.program);
  uniforms.set("clip_from_world", view.shadow_clip_from_world);
}

void Programs::use_background(const GlFunctions& gl, const View& view) const {
  const Uniforms uniforms{gl, background_};
  gl.UseProgram(uniforms.program);
  uniforms.set("background_top", view.background_top);
  uniforms.set("background_bottom", view.background_bottom);
  uniforms.set("height_scale", 1.0F / static_cast<float>(view.height));
}

void Programs::use_quad(const GlFunctions& gl, const View& view, const scene::Quad& quad) const {
  const Uniforms uniforms{gl, quad_};
  gl.UseProgram(uniforms.program);
  uniforms.set("clip_from_world", view.clip_from_world);
  uniforms.set("origin", quad.origin);
  uniforms.set("u", quad.u);
  uniforms.set("v", quad.v);
  uniforms.set("picture", 0);
  uniforms.set("opacity", quad.opacity);
}

}  // namespace trocar::render
