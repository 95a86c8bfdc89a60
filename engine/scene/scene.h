/// What can be seen: triangle meshes with materials, at poses; labels; a light; and a camera to see them with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/spatial/pose.h"

namespace trocar::scene {

/// Immutable once shared; renderers cache it by its address and keep it alive.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;  ///< Metres.
  std::vector<Eigen::Vector3f> normals;    ///< Unit, one for each position.
  std::vector<std::uint32_t> indices;      ///< Three for each triangle, counter-clockwise from outside.
  std::vector<Rgba> colours;               ///< Multiply the material's colour: one for each position, or none.
};

struct Material {
  Eigen::Vector4f base_colour{0.8F, 0.8F, 0.8F, 1.0F};  ///< sRGB, straight alpha; < 1 is drawn after the rest, sorted.
  float roughness = 0.5F;                               ///< 0 mirror … 1 chalk.
  float metallic = 0.0F;                                ///< 0 or 1.
  float emission = 0.0F;                                ///< 1: shown as its base colour, unlit.
  bool casts_shadow = true;
};

struct Node {
  std::shared_ptr<const Mesh> mesh;
  Material material;
  Eigen::Matrix4f X_WM = Eigen::Matrix4f::Identity();  ///< Mesh in world; scale allowed.
};

/// A textured rectangle (a slice of a field), unlit: `texture` row 0 is at `origin + v`, column 0 at `origin`.
/// Texels have hard edges where they are larger than a pixel and are averaged where they are smaller.
struct Quad {
  Eigen::Vector3f origin{0, 0, 0};  ///< Metres, W.
  Eigen::Vector3f u{1, 0, 0};
  Eigen::Vector3f v{0, 1, 0};
  std::shared_ptr<const Image> texture;
  float opacity = 1.0F;
};

/// Words at a point, drawn over the picture in the size of the screen.
struct Label {
  Eigen::Vector3d p_W{0, 0, 0};
  std::string text;
  Rgba colour{230, 233, 238, 255};
  double lift_em = 0.0;  ///< How far above the point its middle is, in heights of the text.
};

struct Scene {
  std::vector<Node> nodes;
  std::vector<Quad> quads;
  std::vector<Label> labels;
  Eigen::Vector3f light_direction{-0.35F, -0.25F, -1.0F};  ///< Where the light goes, W.
  Rgba background_top{46, 50, 58, 255};
  Rgba background_bottom{24, 26, 31, 255};
  /// Everything fades into the background between these horizontal distances from Wo.
  float fade_begin_m = 0.16F;
  float fade_end_m = 0.42F;
};

/// Frame C: x right, y down, z forward.
struct Camera {
  spatial::Pose X_WC;
  double vertical_fov_rad = 0.7853981633974483;
  double near_m = 0.005;
  double far_m = 2.0;
  bool orthographic = false;
  double orthographic_height_m = 0.2;  ///< Height of the view when orthographic.

  /// Looks from `eye` at `target`, with W's z up as far as it can be.
  static Camera look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

  /// Pixel (from the top left) and depth of a point; depth ≤ 0 is behind the camera.
  Eigen::Vector3d project(const Eigen::Vector3d& p_W, int width, int height) const;
  /// A ray through a pixel: its origin and unit direction, W.
  std::array<Eigen::Vector3d, 2> ray(double x, double y, int width, int height) const;
};

/// The command line's `--camera`: paper, top, side, front.
enum class CameraPreset { kPaper, kTop, kSide, kFront };
Camera camera(CameraPreset preset);

/// A camera that circles a point; for the mouse.
struct OrbitCamera {
  Eigen::Vector3d target{-0.010, 0.0, 0.015};
  double azimuth_rad = 0.5;
  double elevation_rad = 0.6;
  double distance_m = 0.21;

  Camera camera() const;
  void orbit(double d_azimuth_rad, double d_elevation_rad);  ///< Elevation is kept within ±89°.
  void pan(double right_m, double up_m);
  void zoom(double factor);  ///< < 1 comes nearer; kept within 20 mm … 1 m.
  static OrbitCamera from(const Camera& camera, double distance_m);
};

}  // namespace trocar::scene
