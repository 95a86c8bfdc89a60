/// The scene's labels, drawn over its picture.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "engine/core/image.h"
#include "engine/scene/scene.h"

namespace trocar::stage {

/// Keeps the drawn words from picture to picture. What is drawn depends on the arguments alone. Threads: one at a time.
class LabelPainter {
 public:
  /// Writes the labels over the picture that `camera` made of the scene: nearest first; one that would cover another
  /// gives way, one whose point or place is behind something is left out.
  void draw(Image& picture, const scene::Scene& scene, const scene::Camera& camera);

 private:
  /// Words with a dark rim, on nothing, straight alpha.
  struct Sprite {
    Image image;
    double text_width = 0.0;
  };
  using Key = std::tuple<std::string, double, std::uint32_t>;
  const Sprite& sprite(const scene::Label& label, double size_px);

  std::map<Key, Sprite> sprites_;
};

}  // namespace trocar::stage
