#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/canvas/canvas.h"
#include "engine/stage/stage.h"

namespace trocar::stage {
namespace {

struct Rectangle {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;

  bool meets(const Rectangle& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

struct Placed {
  const scene::Label* label = nullptr;
  double x = 0.0;  ///< Middle of the text.
  double y = 0.0;
  double depth = 0.0;
};

/// The labels inside of the picture, nearest first: they get the best places.
std::vector<Placed> visible(const scene::Scene& scene, const scene::Camera& camera, const Image& picture,
                            double size_px) {
  std::vector<Placed> found;
  for (const scene::Label& label : scene.labels) {
    const Eigen::Vector3d at = camera.project(label.p_W, picture.width, picture.height);
    if (at.z() <= camera.near_m || at.x() < 0.0 || at.y() < 0.0 || at.x() > picture.width || at.y() > picture.height) {
      continue;
    }
    found.push_back({&label, at.x(), at.y() - label.lift_em * size_px, at.z()});
  }
  std::stable_sort(found.begin(), found.end(), [](const Placed& a, const Placed& b) { return a.depth < b.depth; });
  return found;
}

void draw_with_halo(canvas::Canvas& canvas, canvas::Point at, const scene::Label& label, canvas::TextStyle style) {
  const Rgba colour = label.colour;
  const double reach = std::max(1.0, style.size_px / 12.0);
  style.colour = {12, 14, 18, static_cast<std::uint8_t>(colour.a * 5 / 8)};
  constexpr std::array<std::array<double, 2>, 8> kAround{
      {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
  for (const auto& [dx, dy] : kAround) canvas.text({at.x + reach * dx, at.y + reach * dy}, label.text, style);
  style.colour = colour;
  canvas.text(at, label.text, style);
}

}  // namespace

Image with_labels(const Image& picture, const scene::Scene& scene, const scene::Camera& camera) {
  if (picture.empty() || scene.labels.empty()) return picture;
  canvas::Canvas canvas(picture);
  canvas::TextStyle style;
  style.size_px = std::clamp(picture.height / 42.0, 10.0, 40.0);
  style.weight = canvas::Weight::kSemiBold;
  style.align = canvas::Align::kCentre;
  const double half_height = 0.5 * style.size_px;
  std::vector<Rectangle> taken;
  for (const Placed& placed : visible(scene, camera, picture, style.size_px)) {
    const double half_width = 0.5 * canvas.text_width(placed.label->text, style) + 1.0;
    const double x = std::clamp(placed.x, half_width, std::max(half_width, picture.width - half_width));
    for (const double step : {0.0, -1.0, 1.0, -2.0}) {
      const double y = placed.y + step * 2.0 * half_height;
      const Rectangle box{x - half_width, y - half_height, x + half_width, y + half_height};
      const bool free =
          std::none_of(taken.begin(), taken.end(), [&box](const Rectangle& other) { return box.meets(other); });
      if (!free || box.top < 0.0 || box.bottom > picture.height) continue;
      taken.push_back(box);
      // Capitals and digits are about 0.72 em high.
      draw_with_halo(canvas, {x, y + 0.36 * style.size_px}, *placed.label, style);
      break;
    }
  }
  return canvas.picture();
}

}  // namespace trocar::stage
