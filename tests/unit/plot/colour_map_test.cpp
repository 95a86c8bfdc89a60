#include "engine/plot/colour_map.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/plot/colour_vision.h"
#include "engine/plot/oklab.h"

using namespace trocar::plot;
using trocar::Rgba;

namespace {

constexpr std::array kSequential{ColourMap::kViridis, ColourMap::kCividis, ColourMap::kMagma, ColourMap::kGrey};
constexpr std::array kVisions{ColourVision::kProtan, ColourVision::kDeutan, ColourVision::kTritan};

int worst_byte(Rgba a, Rgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

TEST_CASE("black, white and every grey go through Oklab and come back") {
  CHECK(to_oklab({255, 255, 255, 255}).lightness == doctest::Approx(1.0).epsilon(1e-6));
  CHECK(to_oklab({0, 0, 0, 255}).lightness == doctest::Approx(0.0));
  for (int v = 0; v < 256; v += 5) {
    const Rgba c{static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(255 - v), 77, 255};
    CHECK(from_oklab(to_oklab(c)) == c);
  }
}

TEST_CASE("sequential maps get lighter at every step") {
  for (const ColourMap map : kSequential) {
    CAPTURE(to_string(map));
    double before = -1.0;
    for (int i = 0; i <= 64; ++i) {
      const double lightness = to_oklab(colour(map, i / 64.0)).lightness;
      CHECK(lightness > before);
      before = lightness;
    }
  }
}

TEST_CASE("sequential maps stay readable without one kind of cone") {
  for (const ColourMap map : kSequential) {
    for (const ColourVision vision : kVisions) {
      CAPTURE(to_string(map));
      // A quarter of the map apart is far more than just noticeable (0.02) for every reader.
      for (int i = 0; i <= 12; ++i) {
        const Oklab a = to_oklab(seen_with(vision, colour(map, i / 16.0)));
        const Oklab b = to_oklab(seen_with(vision, colour(map, i / 16.0 + 0.25)));
        CHECK(distance(a, b) > 0.08);
      }
    }
  }
}

TEST_CASE("steps of the sequential maps are even to a factor of four") {
  for (const ColourMap map : kSequential) {
    CAPTURE(to_string(map));
    double least = 1.0;
    double most = 0.0;
    for (int i = 0; i < 16; ++i) {
      const double d = distance(to_oklab(colour(map, i / 16.0)), to_oklab(colour(map, (i + 1) / 16.0)));
      least = std::min(least, d);
      most = std::max(most, d);
    }
    CHECK(most < 4.0 * least);
  }
}

TEST_CASE("viridis and magma agree with published colours between the keys") {
  // viridis and magma at quarters and tenths, as their authors publish them; none of these is a key of ours.
  CHECK(worst_byte(colour(ColourMap::kViridis, 0.5), {33, 145, 140, 255}) <= 2);
  CHECK(worst_byte(colour(ColourMap::kViridis, 0.25), {59, 82, 139, 255}) <= 2);
  CHECK(worst_byte(colour(ColourMap::kViridis, 0.75), {94, 201, 98, 255}) <= 3);
  CHECK(worst_byte(colour(ColourMap::kMagma, 0.25), {81, 18, 124, 255}) <= 5);
  CHECK(worst_byte(colour(ColourMap::kMagma, 0.75), {252, 137, 97, 255}) <= 5);
  CHECK(worst_byte(colour(ColourMap::kCividis, 0.5), {124, 123, 120, 255}) <= 3);
}

TEST_CASE("the diverging map is palest in the middle, equally dark on both sides, and told apart by everyone") {
  const auto at = [](double t) { return to_oklab(colour(ColourMap::kDiverging, t)); };
  for (int i = 1; i <= 32; ++i) {
    const double far = i / 64.0;
    CHECK(at(0.5 + far).lightness < at(0.5 + far - 1.0 / 64.0).lightness);
    CHECK(at(0.5 + far).lightness == doctest::Approx(at(0.5 - far).lightness).epsilon(0.03));
  }
  CHECK(std::hypot(at(0.5).a, at(0.5).b) < 0.01);
  for (const ColourVision vision : kVisions) {
    for (const double far : {0.2, 0.35, 0.5}) {
      CHECK(distance(to_oklab(seen_with(vision, colour(ColourMap::kDiverging, 0.5 - far))),
                     to_oklab(seen_with(vision, colour(ColourMap::kDiverging, 0.5 + far)))) > 0.06);
    }
  }
}

TEST_CASE("any two of the first eight categories differ for readers without red or green cones") {
  for (const ColourVision vision : {ColourVision::kProtan, ColourVision::kDeutan}) {
    for (int i = 0; i < kCategoryCount; ++i) {
      for (int j = 0; j < i; ++j) {
        CAPTURE(i);
        CAPTURE(j);
        CHECK(distance(to_oklab(seen_with(vision, category(i))), to_oklab(seen_with(vision, category(j)))) > 0.05);
      }
    }
  }
  CHECK(category(8) == category(0));
  CHECK(category(-1) == category(7));
}

TEST_CASE("positions outside of the map and NaN are clamped") {
  CHECK(colour(ColourMap::kViridis, -3.0) == colour(ColourMap::kViridis, 0.0));
  CHECK(colour(ColourMap::kViridis, 7.0) == colour(ColourMap::kViridis, 1.0));
  CHECK(colour(ColourMap::kViridis, std::numeric_limits<double>::quiet_NaN()) == colour(ColourMap::kViridis, 0.0));
}

TEST_CASE("names of maps and scales are read back, and others refused by name") {
  for (int i = 0; i < 6; ++i) {
    const auto map = static_cast<ColourMap>(i);
    CHECK(colour_map_from(to_string(map)).value() == map);
  }
  for (const ScaleKind kind : all_scale_kinds()) CHECK(scale_kind_from(to_string(kind)).value() == kind);
  for (const ColourVision vision : all_colour_visions()) {
    CHECK(colour_vision_from(to_string(vision)).value() == vision);
  }
  CHECK_FALSE(colour_vision_from("eagle"));
  const auto jet = colour_map_from("jet");
  REQUIRE_FALSE(jet);
  CHECK(jet.error().text().find("\"jet\"") != std::string::npos);
}

TEST_CASE("full vision changes nothing, grey keeps lightness alone, and greys look grey to everyone") {
  const Rgba orange{230, 159, 0, 90};
  CHECK(seen_with(ColourVision::kFull, orange) == orange);
  const Rgba grey = seen_with(ColourVision::kGrey, orange);
  CHECK(grey.r == grey.g);
  CHECK(grey.g == grey.b);
  CHECK(grey.a == 90);
  for (const ColourVision vision : all_colour_visions()) {
    CHECK(worst_byte(seen_with(vision, {128, 128, 128, 255}), {128, 128, 128, 255}) <= 1);
  }
}
