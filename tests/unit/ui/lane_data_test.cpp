// What the timeline's lanes show, before anything is drawn.
#include "ui/panels/lane_data.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/spatial/grid.h"
#include "tests/support/ui_take.h"
#include "ui/settings.h"

namespace trocar::ui {
namespace {

using demonstration::Sample;

/// One of `count` samples, `ticks` apart; `fill` says what each is.
template <typename Fill>
demonstration::Demonstration made_of(int count, std::int64_t ticks, Fill fill) {
  auto recording = std::make_shared<demonstration::Recording>();
  for (int i = 0; i < count; ++i) {
    Sample sample;
    sample.tick = i * ticks;
    fill(i, sample);
    recording->samples.push_back(sample);
  }
  return demonstration::make_demonstration({1}, "Made", recording).value();
}

int empty_columns(const std::vector<Extent>& columns) {
  return static_cast<int>(
      std::count_if(columns.begin(), columns.end(), [](const Extent& e) { return e.low > e.high; }));
}

}  // namespace

TEST_CASE("a jaw that is sampled five times a second is a line, and not a row of dots or gaps") {
  const auto slow =
      made_of(11, 200, [](int i, Sample& sample) { sample.arms[0].jaw_rad = 0.1F * static_cast<float>(i); });
  LaneData data;
  data.update(slow, {0.0, 2.0}, 200);
  CHECK(data.gaps().empty());
  CHECK(empty_columns(data.jaw(0)) == 0);
  // Half way between the third and the fourth sample.
  CHECK(data.jaw(0)[50].low == doctest::Approx(0.25).epsilon(0.05));
  // Seen closely, between two samples.
  data.update(slow, {0.45, 0.55}, 20);
  CHECK(empty_columns(data.jaw(0)) == 0);
}

TEST_CASE("a second that is missing is a gap, and nothing is drawn there") {
  const auto torn = made_of(400, 5, [](int i, Sample& sample) {
    if (i >= 200) sample.tick += 1000;
    sample.arms[0].jaw_rad = 0.5F;
  });
  LaneData data;
  data.update(torn, {0.0, 3.0}, 300);
  REQUIRE(data.gaps().size() == 1);
  CHECK(data.gaps()[0].begin_s == doctest::Approx(0.995));
  CHECK(data.gaps()[0].end_s == doctest::Approx(2.0));
  CHECK(empty_columns(data.jaw(0)) == 100);
}

TEST_CASE("grid steps are counted by whole cells, and trembling makes none") {
  const double cell_m = spatial::Grid{}.cell_m;
  const auto walked = made_of(100, 5, [cell_m](int i, Sample& sample) {
    // Four cells along x in the first half of a second, then it trembles by a third of one.
    const double cells = i < 50 ? 0.09 * i : 4.41 + (i % 2 == 0 ? 0.3 : 0.0);
    sample.arms[0].measured.p = {static_cast<float>(cells * cell_m), 0.0F, 0.0F};
  });
  LaneData data;
  data.update(walked, {0.0, 0.5}, 10);
  REQUIRE(data.grid_steps().size() == 4);
  CHECK(std::is_sorted(data.grid_steps().begin(), data.grid_steps().end()));
  CHECK(data.grid_steps()[0] == doctest::Approx(0.06));
}

TEST_CASE("a recording that goes on has lanes of what was recorded so far") {
  LaneData data;
  data.update(testing::made_trace(), {0.0, 10.0}, 100);
  REQUIRE(data.segments().size() == 4);
  CHECK(data.segments()[1].begin_s == doctest::Approx(2.0));
  CHECK(data.authority().size() == 4);
  CHECK(data.flag(demonstration::kLeftHolds).size() == 1);
  CHECK(empty_columns(data.jaw(0)) == doctest::Approx(50).epsilon(0.03));
  // 1 cm a second once it moves.
  CHECK(data.speed(0).value_at(3.0).value() == doctest::Approx(10.0).epsilon(0.02));
}

TEST_CASE("what lanes are shown and what the ruler counts is remembered, and curves are hidden at first") {
  Settings settings;
  CHECK(settings.hidden_lanes == kLanesHiddenAtFirst);
  settings.hidden_lanes = (kLanesHiddenAtFirst & ~(1U << 14U)) | 1U << 2U;
  settings.ruler = RulerUnit::kGridStep;
  Diagnostics odd;
  const Settings again = settings_from_json(to_json(settings), odd).value();
  CHECK(again.hidden_lanes == settings.hidden_lanes);
  CHECK(again.ruler == RulerUnit::kGridStep);
  CHECK(settings_from_json("{}", odd).value().hidden_lanes == kLanesHiddenAtFirst);
}

}  // namespace trocar::ui
