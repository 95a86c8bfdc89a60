#include "engine/volume/volume.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace trocar;
using Eigen::Vector3d;

namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 90;

std::shared_ptr<learning::Field> all_of(double value) {
  auto field = std::make_shared<learning::Field>();
  field->values.assign(static_cast<std::size_t>(field->grid.cell_count()), value);
  return field;
}

Vector3d middle() {
  const spatial::Grid grid;
  return grid.p_WGo + Vector3d::Constant(0.5 * grid.n * grid.cell_m);
}

/// Along x, at the middle of the lattice.
scene::Camera camera() {
  scene::Camera made = scene::Camera::look_at(middle() - Vector3d(0.2, 0.0, 0.0), middle());
  made.orthographic = true;
  made.orthographic_height_m = 0.08;
  return made;
}

Image drawn(const std::shared_ptr<const learning::Field>& field, const volume::MarchOptions& options,
            float depth_m = std::numeric_limits<float>::infinity()) {
  Image picture(kWidth, kHeight, {0, 0, 0, 255});
  volume::Marcher marcher;
  marcher.draw(picture, std::vector<float>(std::size_t{kWidth} * kHeight, depth_m), camera(), field, {}, options);
  return picture;
}

}  // namespace

TEST_CASE("a cloud of one value hides as much as its thickness says") {
  volume::MarchOptions options;
  options.opacity = 0.02F;
  const auto field = all_of(1.0);
  const Rgba full = plot::Colouring{}.colour(1.0);
  // 22 cells, each of which hides 0.75 · 0.02.
  const double expected = (1.0 - std::pow(1.0 - 0.75 * 0.02, 22.0)) * full.r;
  const Image picture = drawn(field, options);
  CHECK(picture.at(kWidth / 2, kHeight / 2).r == doctest::Approx(expected).epsilon(0.04));
  CHECK(picture.at(2, 2) == Rgba{0, 0, 0, 255});
  // Half of it lies behind what is in the middle.
  const double half = (1.0 - std::pow(1.0 - 0.75 * 0.02, 11.0)) * full.r;
  CHECK(drawn(field, options, 0.2F).at(kWidth / 2, kHeight / 2).r == doctest::Approx(half).epsilon(0.06));
  CHECK(drawn(field, options, 0.1F) == Image(kWidth, kHeight, {0, 0, 0, 255}));
}

TEST_CASE("what is unknown, or at the quiet end of the scale, is not seen") {
  const Image black(kWidth, kHeight, {0, 0, 0, 255});
  CHECK(drawn(all_of(std::numeric_limits<double>::quiet_NaN()), {}) == black);
  CHECK(drawn(all_of(0.0), {}) == black);
  const auto field = all_of(std::numeric_limits<double>::quiet_NaN());
  const spatial::CellIndex cell = field->grid.index({11, 4, 16});
  field->values[static_cast<std::size_t>(cell.value)] = 1.0;
  const Image picture = drawn(field, {});
  const Vector3d at = camera().project(field->grid.centre(cell), kWidth, kHeight);
  const auto seen = [&](int dx) { return picture.at(static_cast<int>(at.x()) + dx, static_cast<int>(at.y())); };
  CHECK(seen(0).r > 60);
  CHECK(seen(-8) == Rgba{0, 0, 0, 255});
  CHECK(seen(8) == Rgba{0, 0, 0, 255});
}

TEST_CASE("a slice hides what is behind it, where it knows something") {
  volume::MarchOptions options;
  options.opacity = 0.02F;
  const auto field = all_of(1.0);
  const Image whole = drawn(field, options);
  options.slices = {11, -1, -1};
  const Image cut = drawn(field, options);
  CHECK(cut.at(kWidth / 2, kHeight / 2).r < whole.at(kWidth / 2, kHeight / 2).r * 2 / 3);
  for (int y = 0; y < 22; ++y) {
    for (int z = 0; z < 22; ++z) {
      field->values[static_cast<std::size_t>(field->grid.index({11, y, z}).value)] =
          std::numeric_limits<double>::quiet_NaN();
    }
  }
  CHECK(drawn(field, options).at(kWidth / 2, kHeight / 2).r > cut.at(kWidth / 2, kHeight / 2).r * 5 / 4);
}

TEST_CASE("the picture does not depend on the threads, and a coarse one is nearly the fine one") {
  auto field = std::make_shared<learning::Field>();
  for (int s = 0; s < field->grid.cell_count(); ++s) {
    field->values.push_back(std::exp(-(field->grid.centre({s}) - middle()).squaredNorm() / 2e-4));
  }
  volume::MarchOptions one;
  one.threads = 1;
  volume::MarchOptions three;
  three.threads = 3;
  const Image fine = drawn(field, one);
  CHECK(fine == drawn(field, three));
  one.divisor = three.divisor = 3;
  const Image coarse = drawn(field, one);
  CHECK(coarse == drawn(field, three));
  CHECK(difference(fine, coarse).mean < 1.5);
  CHECK(difference(fine, Image(kWidth, kHeight, {0, 0, 0, 255})).mean > 5.0);
}

TEST_CASE("the curve says which values hide, also those between two cells that do not") {
  auto field = all_of(0.0);
  // The near half at one end of the scale, the far half at the other: the middle of it lies between two cells only.
  for (int s = 0; s < field->grid.cell_count(); ++s) {
    if (field->grid.coordinates({s}).x >= 11) field->values[static_cast<std::size_t>(s)] = 1.0;
  }
  const Image black(kWidth, kHeight, {0, 0, 0, 255});
  volume::MarchOptions options;
  const auto centre = [&]() { return drawn(field, options).at(kWidth / 2, kHeight / 2); };
  const auto light = [](const Rgba& colour) { return colour.r + colour.g + colour.b; };
  options.curve = plot::OpacityCurve{{{0.0, 0.0}, {1.0, 0.0}}};
  CHECK(drawn(field, options) == black);
  options.curve = plot::OpacityCurve{{{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}}};
  const Rgba between = centre();
  CHECK(light(between) > 30);
  options.curve = plot::opacity_curve(plot::OpacityPreset::kHighest);
  const Rgba highest = centre();
  options.curve = plot::opacity_curve(plot::OpacityPreset::kLowest);
  const Rgba lowest = centre();
  const Rgba yellow = plot::Colouring{}.colour(1.0);
  const Rgba violet = plot::Colouring{}.colour(0.0);
  CHECK(std::abs(highest.r - yellow.r) < 12);
  CHECK(std::abs(lowest.r - violet.r) < 12);
  options.curve = plot::OpacityCurve{{{0.0, 0.1}}};
  options.opacity = 1.0F;
  // Level: 22 cells, each of which hides 0.75 · 0.1².
  CHECK(light(centre()) < light(highest) / 2);
  CHECK(light(centre()) > 0);
}

TEST_CASE("another curve than before is heeded by one that has drawn before") {
  const auto field = all_of(1.0);
  volume::Marcher marcher;
  const auto again = [&](const std::optional<plot::OpacityCurve>& curve) {
    Image picture(kWidth, kHeight, {0, 0, 0, 255});
    volume::MarchOptions options;
    options.curve = curve;
    marcher.draw(picture, std::vector<float>(std::size_t{kWidth} * kHeight, 1e9F), camera(), field, {}, options);
    return picture;
  };
  const Image black(kWidth, kHeight, {0, 0, 0, 255});
  CHECK(again(plot::opacity_curve(plot::OpacityPreset::kLowest)) == black);
  CHECK(again(plot::opacity_curve(plot::OpacityPreset::kHighest)) != black);
  CHECK(again(plot::opacity_curve(plot::OpacityPreset::kLowest)) == black);
}
