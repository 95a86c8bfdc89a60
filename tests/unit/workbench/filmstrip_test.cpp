#include "engine/workbench/filmstrip.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "engine/demonstration/edits.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

using Shown = std::shared_ptr<const demonstration::Demonstration>;

/// Two seconds in which the first block rises.
Shown rising() {
  auto recording = std::make_shared<demonstration::Recording>(testing::moving_recording(400));
  for (demonstration::Sample& sample : recording->samples) {
    sample.blocks[0].p = {0.0F, 0.0F, 0.02F * static_cast<float>(sample.t_s())};
  }
  return std::make_shared<const demonstration::Demonstration>(
      demonstration::make_demonstration({1}, "Rising", std::move(recording)).value());
}

std::shared_ptr<const Filmstrip> drawn(FilmstripMaker& maker, const Shown& shown) {
  std::shared_ptr<const Filmstrip> strip;
  do {
    maker.poll(shown, false, strip);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  } while (maker.busy());
  return strip;
}

}  // namespace

TEST_CASE("small pictures are drawn behind the window and kept for other zooms and versions") {
  const Shown shown = rising();
  FilmstripMaker maker;
  maker.ask({0.0, 0.5, 5, 36});
  CHECK(maker.busy());
  const auto strip = drawn(maker, shown);
  REQUIRE(strip);
  REQUIRE(strip->pictures.size() == 5);
  for (int i = 0; i < 4; ++i) {
    REQUIRE(strip->pictures[static_cast<std::size_t>(i)]);
    CHECK(strip->pictures[static_cast<std::size_t>(i)]->width == 64);
    CHECK(strip->pictures[static_cast<std::size_t>(i)]->height == 36);
  }
  // Beyond the last sample there is nothing.
  CHECK(strip->pictures[4] == nullptr);
  CHECK(strip->pictures[0]->rgba != strip->pictures[3]->rgba);
  // Twice as far apart, and under another name: the same pictures, at once.
  const Shown renamed = std::make_shared<const demonstration::Demonstration>(
      demonstration::apply(*shown, demonstration::Rename{"other"}, 1).value());
  maker.ask({0.0, 1.0, 2, 36});
  std::shared_ptr<const Filmstrip> wide;
  CHECK(maker.poll(renamed, false, wide));
  CHECK_FALSE(maker.busy());
  REQUIRE(wide->pictures.size() == 2);
  CHECK(wide->pictures[1] == strip->pictures[2]);
  // A light window has others.
  CHECK(maker.poll(renamed, true, wide));
  CHECK(maker.busy());
  maker.ask({});
  CHECK(maker.poll(nullptr, true, wide));
  CHECK(wide == nullptr);
}
