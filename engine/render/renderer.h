/// A scene and a camera to a picture, off-screen, with OpenGL 3.3 in software or not.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/scene/scene.h"

namespace trocar::render {

struct RenderOptions {
  int width = 960;
  int height = 540;
  int samples = 1;  ///< 1, 2 or 4.
  bool shadows = true;
  bool soft_shadows = true;  ///< Four hardware taps; else one, while something moves.
};

/// A picture, and how far what it shows is away.
struct DeepPicture {
  Image image;
  /// By pixel, in the picture's order: along the camera's z, metres; of what lets nothing through. Infinite where there
  /// is only background.
  std::vector<float> depth_m;
};

/// Owns one OSMesa context (and its mesh cache). Threads: created, used and destroyed in one thread, and no other GL
/// context may be current in that thread.
class Renderer {
 public:
  /// Errors: kUnsupported when OSMesa is missing or gives no OpenGL 3.3.
  static Result<Renderer> create();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Errors: kInvalidArgument for a size outside of 1 … 8192.
  Result<Image> draw(const scene::Scene& scene, const scene::Camera& camera, const RenderOptions& options);
  /// The same with depth (of several samples in a pixel, that of one). Errors: as `draw`.
  Result<DeepPicture> draw_deep(const scene::Scene& scene, const scene::Camera& camera, const RenderOptions& options);
  /// Compiles the shaders now instead of at the first picture.
  void warm_up();
  /// "llvmpipe (LLVM 15…), OpenGL 3.3 core", for `trocar doctor`.
  std::string description() const;

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::render
