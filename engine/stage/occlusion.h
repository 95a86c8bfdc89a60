/// Whether a point of the scene is hidden from an eye, worked out from the meshes: for what is drawn over the picture.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/scene/scene.h"

namespace trocar::stage {

/// See-through things hide nothing; a slice of a field hides where its cells are known. Threads: any; holds pointers
/// into the scene.
class Occlusion {
 public:
  explicit Occlusion(const scene::Scene& scene);

  /// True if something is between the eye and the point, W, and not just at the point.
  bool hides(const Eigen::Vector3d& p_WEye, const Eigen::Vector3d& p_WPoint) const;

 private:
  struct Body {
    const scene::Mesh* mesh = nullptr;
    Eigen::Matrix4f X_WM;
    Eigen::Vector3f centre_W;
    float radius_m = 0.0F;
  };
  std::vector<Body> bodies_;
  std::vector<const scene::Quad*> sheets_;
};

}  // namespace trocar::stage
