#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/canvas/canvas.h"
#include "engine/stage/label_painter.h"
#include "engine/stage/occlusion.h"
#include "engine/stage/stage.h"

namespace trocar::stage {
namespace {

/// Forgotten all at once when there are more: a zoom makes no new ones, a resize does.
constexpr std::size_t kMostSprites = 256;

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

/// Where the label's middle is in space: at its point's depth.
Eigen::Vector3d place_of(const Placed& placed, const scene::Camera& camera, const Image& picture) {
  const auto [from, way] = camera.ray(placed.x, placed.y, picture.width, picture.height);
  const Eigen::Vector3d forward = camera.X_WC.q * Eigen::Vector3d::UnitZ();
  const double ahead_m = forward.dot(from - camera.X_WC.p);
  return from + way * ((placed.depth - ahead_m) / way.dot(forward));
}

bool hidden(const Occlusion& occlusion, const Placed& placed, const scene::Camera& camera, const Image& picture) {
  const auto seen_from = [&](const Eigen::Vector3d& p_W) {
    if (!camera.orthographic) return Eigen::Vector3d(camera.X_WC.p);
    const Eigen::Vector3d forward = camera.X_WC.q * Eigen::Vector3d::UnitZ();
    return Eigen::Vector3d(p_W - forward * forward.dot(p_W - camera.X_WC.p));
  };
  const Eigen::Vector3d p_WPlace = place_of(placed, camera, picture);
  return occlusion.hides(seen_from(placed.label->p_W), placed.label->p_W) ||
         occlusion.hides(seen_from(p_WPlace), p_WPlace);
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

void blend(Image& picture, const Image& sprite, int left, int top) {
  const int x0 = std::max(0, left);
  const int x1 = std::min(picture.width, left + sprite.width);
  for (int y = std::max(0, top); y < std::min(picture.height, top + sprite.height); ++y) {
    for (int x = x0; x < x1; ++x) {
      const Rgba over = sprite.at(x - left, y - top);
      if (over.a == 0) continue;
      const Rgba under = picture.at(x, y);
      const auto mixed = [&over](int above, int below) {
        return static_cast<std::uint8_t>((above * over.a + below * (255 - over.a) + 127) / 255);
      };
      picture.set(x, y, {mixed(over.r, under.r), mixed(over.g, under.g), mixed(over.b, under.b), under.a});
    }
  }
}

}  // namespace

const LabelPainter::Sprite& LabelPainter::sprite(const scene::Label& label, double size_px) {
  const Rgba c = label.colour;
  const std::uint32_t colour = static_cast<std::uint32_t>(c.r) << 24U | static_cast<std::uint32_t>(c.g) << 16U |
                               static_cast<std::uint32_t>(c.b) << 8U | c.a;
  const auto found = sprites_.find({label.text, size_px, colour});
  if (found != sprites_.end()) return found->second;
  if (sprites_.size() >= kMostSprites) sprites_.clear();
  canvas::TextStyle style;
  style.size_px = size_px;
  style.weight = canvas::Weight::kSemiBold;
  style.align = canvas::Align::kCentre;
  Sprite made;
  made.text_width = canvas::Canvas(Image(1, 1)).text_width(label.text, style);
  const int width = 2 * static_cast<int>(std::ceil(0.5 * made.text_width + 0.2 * size_px + 2.0));
  const int height = 2 * static_cast<int>(std::ceil(0.9 * size_px));
  canvas::Canvas canvas(Image(width, height, {0, 0, 0, 0}));
  // Capitals and digits are about 0.72 em high.
  draw_with_halo(canvas, {0.5 * width, 0.5 * height + 0.36 * size_px}, label, style);
  made.image = canvas.picture();
  return sprites_.emplace(Key{label.text, size_px, colour}, std::move(made)).first->second;
}

void LabelPainter::draw(Image& picture, const scene::Scene& scene, const scene::Camera& camera) {
  if (picture.empty() || scene.labels.empty()) return;
  const double size_px = std::clamp(picture.height / 42.0, 10.0, 40.0);
  const double half_height = 0.5 * size_px;
  const Occlusion occlusion(scene);
  std::vector<Rectangle> taken;
  for (const Placed& placed : visible(scene, camera, picture, size_px)) {
    if (hidden(occlusion, placed, camera, picture)) continue;
    const Sprite& words = sprite(*placed.label, size_px);
    const double half_width = 0.5 * words.text_width + 1.0;
    const double x = std::clamp(placed.x, half_width, std::max(half_width, picture.width - half_width));
    for (const double step : {0.0, -1.0, 1.0, -2.0}) {
      const double y = placed.y + step * 2.0 * half_height;
      const Rectangle box{x - half_width, y - half_height, x + half_width, y + half_height};
      const bool free =
          std::none_of(taken.begin(), taken.end(), [&box](const Rectangle& other) { return box.meets(other); });
      if (!free || box.top < 0.0 || box.bottom > picture.height) continue;
      taken.push_back(box);
      blend(picture, words.image, static_cast<int>(std::lround(x)) - words.image.width / 2,
            static_cast<int>(std::lround(y)) - words.image.height / 2);
      break;
    }
  }
}

Image with_labels(const Image& picture, const scene::Scene& scene, const scene::Camera& camera) {
  Image labelled = picture;
  LabelPainter().draw(labelled, scene, camera);
  return labelled;
}

}  // namespace trocar::stage
