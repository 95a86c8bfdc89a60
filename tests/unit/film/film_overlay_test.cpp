#include "engine/film/film_overlay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace trocar;
using namespace trocar::film;
using demonstration::Authority;
using demonstration::Segment;

namespace {

FrameCaption full() {
  FrameCaption caption;
  caption.title = "Block 0 to peg 3";
  caption.time_s = 4.2;
  caption.duration_s = 18.0;
  caption.segment = Segment::kC;
  caption.segment_progress = 0.4;
  caption.authority = Authority::kAgent;
  caption.agent_pedal = true;
  caption.jaw_rad = {0.6, 0.0};
  caption.provenance = "scripted expert, seed 1";
  caption.speed = 4.0;
  caption.caption = "The agent carries the block";
  return caption;
}

Image drawn(int width, int height, Rgba ground, const FrameCaption& caption) {
  Image frame(width, height, ground);
  FilmOverlay(width, height).draw(frame, caption);
  return frame;
}

constexpr Rgba kGrey{120, 130, 140, 255};

double luminance(Rgba c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

}  // namespace

TEST_CASE("the same frame and caption give the same pixels, whatever was drawn before") {
  Image first(640, 360, kGrey);
  Image again(640, 360, kGrey);
  FilmOverlay overlay(640, 360);
  overlay.draw(first, full());
  FrameCaption other = full();
  other.title = "Something else";
  other.authority = Authority::kHold;
  Image between(640, 360, kGrey);
  overlay.draw(between, other);
  overlay.draw(again, full());
  CHECK(first == again);
  CHECK_FALSE(first == between);
}

TEST_CASE("every part of the caption changes the picture") {
  const FrameCaption whole = full();
  std::vector<FrameCaption> changed(11, whole);
  changed[0].title = "";
  changed[1].time_s = 9.0;
  changed[2].segment = Segment::kD;
  changed[3].segment_progress = 0.9;
  changed[4].authority = Authority::kOperator;
  changed[5].agent_pedal = false;
  changed[6].clutch_pedal = true;
  changed[7].jaw_rad[1] = 0.5;
  changed[8].provenance = "";
  changed[9].speed = 1.0;
  changed[10].caption = "";
  const Image before = drawn(960, 540, kGrey, whole);
  for (std::size_t i = 0; i < changed.size(); ++i) {
    CAPTURE(i);
    CHECK_FALSE(drawn(960, 540, kGrey, changed[i]) == before);
  }
}

TEST_CASE("the four authorities differ in shape, not in colour alone") {
  // Compared as grey pictures: who cannot tell the colours apart still sees shape and word.
  std::vector<Image> pictures;
  for (const Authority who : {Authority::kOperator, Authority::kAgent, Authority::kAssistant, Authority::kHold}) {
    FrameCaption caption = full();
    caption.authority = who;
    Image grey = drawn(640, 360, kGrey, caption);
    for (int y = 0; y < grey.height; ++y) {
      for (int x = 0; x < grey.width; ++x) {
        const auto l = static_cast<std::uint8_t>(luminance(grey.at(x, y)) > 110.0 ? 255 : 0);
        grey.set(x, y, {l, l, l, 255});
      }
    }
    for (const Image& other : pictures) CHECK(difference(grey, other).mean > 0.05);
    pictures.push_back(std::move(grey));
  }
}

TEST_CASE("the middle of the picture and its margins stay free") {
  for (const auto& [width, height] : {std::array{640, 360}, std::array{1280, 720}, std::array{640, 720}}) {
    const Image frame = drawn(width, height, kGrey, full());
    for (int x = 0; x < width; ++x) {
      CHECK(frame.at(x, height / 2) == kGrey);
      CHECK(frame.at(x, 2) == kGrey);
    }
    for (int y = 0; y < height / 2; ++y) {
      CHECK(frame.at(2, y) == kGrey);
      CHECK(frame.at(width - 3, y) == kGrey);
    }
  }
}

TEST_CASE("letters are lighter than their ground by 4.5 to 1 on black, grey and white frames") {
  const auto linear = [](double v) {
    const double s = v / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  const auto relative = [&](Rgba c) { return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b); };
  for (const Rgba ground : {Rgba{0, 0, 0, 255}, kGrey, Rgba{255, 255, 255, 255}}) {
    const Image frame = drawn(1280, 720, ground, full());
    // The provenance line: the lightest pixel is a letter, the darkest its ground.
    double lightest = 0.0;
    double darkest = 1.0;
    for (int y = 690; y < 712; ++y) {
      for (int x = 36; x < 190; ++x) {
        lightest = std::max(lightest, relative(frame.at(x, y)));
        darkest = std::min(darkest, relative(frame.at(x, y)));
      }
    }
    CHECK((lightest + 0.05) / (darkest + 0.05) > 4.5);
  }
}

TEST_CASE("twice the size gives the same picture, twice as large") {
  const Image small = drawn(640, 360, kGrey, full());
  const Image large = drawn(1280, 720, kGrey, full());
  Image halved(640, 360);
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 640; ++x) {
      std::array<int, 3> sum{};
      for (int k = 0; k < 4; ++k) {
        const Rgba c = large.at(2 * x + k % 2, 2 * y + k / 2);
        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
      }
      halved.set(x, y,
                 {static_cast<std::uint8_t>(sum[0] / 4), static_cast<std::uint8_t>(sum[1] / 4),
                  static_cast<std::uint8_t>(sum[2] / 4), 255});
    }
  }
  // Letters are hinted to whole pixels at each size; everything else falls on the same places.
  CHECK(difference(small, halved).mean < 2.5);
}

TEST_CASE("long texts are shortened and odd numbers survive") {
  FrameCaption caption = full();
  caption.title = std::string(400, 'W') + "ö";
  caption.provenance = std::string(400, 'm');
  caption.caption = std::string(400, 'W');
  caption.time_s = -1.0;
  caption.segment_progress = 7.0;
  caption.jaw_rad = {-0.2, 9.0};
  const Image frame = drawn(640, 360, kGrey, caption);
  for (int y = 0; y < 300; ++y) CHECK(frame.at(638, y) == kGrey);
  CHECK_FALSE(drawn(20, 12, kGrey, caption).empty());
}
