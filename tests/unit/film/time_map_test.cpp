#include "engine/film/time_map.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/film/keyframes.h"

using namespace trocar;
using namespace trocar::film;

namespace {

/// A source whose stages last so many milliseconds each, from an instant on.
Stages source_of(const std::vector<int>& lasts_ms, double from_s) {
  Stages stages;
  double t_s = from_s;
  for (const int ms : lasts_ms) {
    stages.begins_s.push_back(t_s);
    t_s += ms / 1000.0;
  }
  stages.end_s = t_s;
  return stages;
}

std::vector<int> any_lengths(std::size_t count) {
  std::vector<int> lengths;
  for (std::size_t i = 0; i < count; ++i) lengths.push_back(*rc::gen::inRange(0, 4000));
  return lengths;
}

TimeMap map_of(std::vector<Stages> sources, const Pace& pace = {}, double fps = 30.0) {
  auto map = TimeMap::create(std::move(sources), pace, fps);
  REQUIRE(map);
  return std::move(*map);
}

demonstration::Demonstration labelled(const std::vector<demonstration::SegmentSpan>& segments, double end_s) {
  demonstration::Demonstration shown;
  shown.end_s = end_s;
  shown.segments = segments;
  return shown;
}

}  // namespace

TEST_CASE("the area below keys is what small steps add up to") {
  CHECK(rc::check([] {
    std::vector<Key> keys;
    double t_s = 0.0;
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
      t_s += *rc::gen::inRange(1, 300) / 100.0;
      keys.push_back({t_s, *rc::gen::inRange(10, 400) / 100.0, static_cast<Ease>(*rc::gen::inRange(0, 3))});
    }
    const double end_s = *rc::gen::inRange(0, 2000) / 100.0;
    constexpr int kSteps = 20000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) sum += value_at(keys, end_s * (i + 0.5) / kSteps, 1.5) * end_s / kSteps;
    RC_ASSERT(std::abs(sum - area_to(keys, end_s, 1.5)) < 1e-2);
  }));
}

TEST_CASE("keys that hold jump, and smooth ones leave and arrive slowly") {
  const std::vector<Key> keys{{1.0, 2.0, Ease::kHold}, {2.0, 4.0, Ease::kSmooth}, {4.0, 8.0, Ease::kLinear}};
  CHECK(value_at(keys, 0.0, 9.0) == 2.0);
  CHECK(value_at(keys, 1.999, 9.0) == 2.0);
  CHECK(value_at(keys, 2.0, 9.0) == 4.0);
  CHECK(value_at(keys, 3.0, 9.0) == doctest::Approx(6.0));
  CHECK(value_at(keys, 2.1, 9.0) < 4.0 + 4.0 * 0.05);
  CHECK(value_at(keys, 50.0, 9.0) == 8.0);
  CHECK(value_at({}, 3.0, 9.0) == 9.0);
}

TEST_CASE("synchronised by stages: all begin in one frame, nobody runs backwards, the longest of each add up") {
  CHECK(rc::check([] {
    const auto stages = static_cast<std::size_t>(*rc::gen::inRange(1, 7));
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(1, 5));
    std::vector<std::vector<int>> lengths;
    std::vector<Stages> sources;
    for (std::size_t i = 0; i < count; ++i) {
      lengths.push_back(any_lengths(stages));
      sources.push_back(source_of(lengths.back(), 0.1 * static_cast<double>(i)));
    }
    double sum_s = 0.0;
    for (std::size_t stage = 0; stage < stages; ++stage) {
      int longest = 0;
      for (const auto& own : lengths) longest = std::max(longest, own[stage]);
      sum_s += longest / 1000.0;
    }
    Pace pace;
    pace.speed = *rc::gen::inRange(1, 40) / 10.0;
    const auto map = TimeMap::create(sources, pace, 30.0);
    RC_ASSERT(map.has_value());
    RC_ASSERT(std::abs(map->duration_s() - sum_s) < 1e-9);
    RC_ASSERT(std::abs(map->frame_count() - 1 - sum_s / pace.speed * 30.0) <= 1.0);

    std::vector<double> before(count, -1.0);
    std::size_t stage_before = 0;
    for (int frame = 0; frame < map->frame_count(); ++frame) {
      const Moment moment = map->at(frame);
      RC_ASSERT(moment.stage >= stage_before);
      for (std::size_t i = 0; i < count; ++i) {
        const Instant& instant = moment.sources[i];
        RC_ASSERT(instant.at_s >= before[i] - 1e-9);
        before[i] = std::max(before[i], instant.at_s);
        // Nobody is ahead of the stage that the film is in, and nobody is still in an earlier one.
        const double begin_s = sources[i].begins_s[moment.stage];
        const double end_s = begin_s + sources[i].duration_s(moment.stage);
        RC_ASSERT(instant.at_s <= end_s + 1e-9);
        RC_ASSERT(instant.waiting || instant.over || instant.at_s >= begin_s - 0.0025 - 1e-9);
        if (moment.stage != stage_before && sources[i].duration_s(moment.stage) > 0.04 * pace.speed) {
          // It has just begun: not more than a frame of it is over, and it does not wait.
          RC_ASSERT(!instant.waiting);
          RC_ASSERT(instant.at_s - begin_s <= pace.speed / 30.0 + 1e-9);
        }
      }
      stage_before = moment.stage;
    }
  }));
}

TEST_CASE("a frame depends on its number alone") {
  CHECK(rc::check([] {
    Pace pace;
    pace.loops = *rc::gen::inRange(1, 4);
    pace.holds = {{0.5, 0.7}, {1.5, 0.2}};
    pace.ramps = {{0.0, 1.0, Ease::kSmooth}, {1.0, *rc::gen::inRange(1, 50) / 10.0, Ease::kLinear}, {2.0, 0.5, {}}};
    const std::vector<Stages> sources{source_of(any_lengths(3), 0.0), source_of(any_lengths(3), 1.0)};
    const auto map = TimeMap::create(sources, pace, 25.0);
    const auto again = TimeMap::create(sources, pace, 25.0);
    RC_ASSERT(map.has_value() && again.has_value());
    const int pass = map->frame_count() / pace.loops;
    for (int frame = map->frame_count() - 1; frame >= 0; --frame) {
      const Moment moment = map->at(frame);
      const Moment other = again->at(frame % pass);
      RC_ASSERT(moment.common_s == other.common_s);
      for (std::size_t i = 0; i < 2; ++i) RC_ASSERT(moment.sources[i].at_s == other.sources[i].at_s);
    }
    RC_ASSERT(map->at(0).common_s == 0.0);
    RC_ASSERT(map->at(pass - 1).common_s <= map->duration_s());
    double before = 0.0;
    for (int frame = 0; frame < pass; ++frame) {
      RC_ASSERT(map->at(frame).common_s >= before);
      before = map->at(frame).common_s;
    }
    // A frame later all would have been shown.
    RC_ASSERT(map->duration_s() - before < 5.0 / 25.0 + 1e-6);
  }));
}

TEST_CASE("a hold stands still for as long as it says, and the film is longer by it") {
  Pace pace;
  pace.holds = {{1.0, 2.0}};
  const TimeMap plain = map_of({source_of({3000}, 0.0)}, {}, 10.0);
  const TimeMap held = map_of({source_of({3000}, 0.0)}, pace, 10.0);
  CHECK(plain.frame_count() == 31);
  CHECK(held.frame_count() == 51);
  for (int frame = 10; frame < 30; ++frame) {
    CHECK(held.at(frame).common_s == doctest::Approx(1.0));
    CHECK(held.at(frame).speed == 0.0);
  }
  CHECK(held.at(31).common_s == doctest::Approx(1.1));
  CHECK(held.at(50).common_s == doctest::Approx(3.0));
}

TEST_CASE("the faster side waits at the end of a segment, and is finished at its end") {
  const TimeMap map = map_of({source_of({1000, 500}, 0.0), source_of({2000, 3000}, 0.0)}, {}, 10.0);
  CHECK_FALSE(map.at(9).sources[0].waiting);
  CHECK(map.at(15).sources[0].waiting);
  CHECK_FALSE(map.at(15).sources[1].waiting);
  CHECK(map.at(15).sources[0].at_s == doctest::Approx(0.9975));  // The last sample of the segment, not the next one's.
  CHECK(map.at(20).stage == 1);
  CHECK_FALSE(map.at(20).sources[0].waiting);
  CHECK(map.at(20).sources[0].at_s == doctest::Approx(1.0));
  CHECK(map.at(20).sources[1].at_s == doctest::Approx(2.0));
  CHECK(map.at(30).sources[0].over);
  CHECK(map.at(30).sources[0].at_s == doctest::Approx(1.5));
  CHECK_FALSE(map.at(50).sources[1].over);
}

TEST_CASE("stages are where the labels first come one after the other, whatever comes again or is missing") {
  using demonstration::Segment;
  const auto shown = labelled({{Segment::kA, 0.5, 2.0},
                               {Segment::kB, 2.0, 3.0},
                               {Segment::kA, 3.0, 4.0},
                               {Segment::kB, 4.0, 5.0},
                               {Segment::kD, 5.0, 6.0}},
                              7.0);
  const Stages stages = stages_of(shown, 0.0, 7.0, Sync::kSegment);
  CHECK(stages.begins_s == std::vector<double>{0.0, 0.5, 2.0, 5.0, 5.0, 7.0});
  CHECK(stages.duration_s(2) == 3.0);
  CHECK(stages.duration_s(3) == 0.0);
  CHECK(stages.duration_s(4) == 2.0);
  const Stages cut = stages_of(shown, 2.5, 4.5, Sync::kSegment);
  CHECK(cut.begins_s.front() == 2.5);
  CHECK(std::is_sorted(cut.begins_s.begin(), cut.begins_s.end()));
  CHECK(cut.begins_s.back() == 4.5);
  CHECK(stages_of(shown, 1.0, 2.0, Sync::kClock).begins_s == std::vector<double>{1.0});
}

TEST_CASE("a film without an end is refused") {
  CHECK_FALSE(TimeMap::create({source_of({2'000'000'000}, 0.0)}, {}, 240.0));
}
