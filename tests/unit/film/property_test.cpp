// The numbers of a film that can have keys: each is where it is said to be, and moves as its keys say.
#include "engine/film/property.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/film/pace.h"

using namespace trocar::film;

namespace {

/// A source that has them all.
Source rich_source() {
  Source source = recording_of("1");
  source.camera.view = View::kOrbit;
  source.field = SceneField{"2"};
  return source;
}

}  // namespace

TEST_CASE("every property of a source is kept where it was set, and has no keys until some are given") {
  Source source = rich_source();
  for (const Property& property : all_source_properties()) {
    CAPTURE(property.name);
    REQUIRE(has_property(source, property));
    CHECK(source_property(property.name) == &property);
    const double between = property.low + 0.25 * (std::min(property.high, property.low + 8.0) - property.low);
    const double wanted = property.name == "slice" ? 7.0 : between;
    set_fixed_value(source, property.name, wanted);
    CHECK(fixed_value(source, property.name) == doctest::Approx(wanted));
    CHECK(keys_of(source, property.name).empty());
    set_keys(source, property.name, {{1.0, property.low}, {3.0, wanted}});
    CHECK(value_of(source, property.name, 0.0) == doctest::Approx(property.low));
    CHECK(value_of(source, property.name, 2.0) == doctest::Approx(0.5 * (property.low + wanted)));
    CHECK(fixed_value(source, property.name) == doctest::Approx(wanted));
    set_keys(source, property.name, {});
  }
  CHECK(source.tracks.empty());
  CHECK(source.field->slice == "z=7");
  CHECK(source.slice == Source().slice);
  CHECK(source_property("hue") == nullptr);
}

TEST_CASE("a property belongs to those sources that it changes, and its keys elsewhere are told to be idle") {
  Composition film;
  film.sources = {recording_of("1")};
  film.sources[0].tracks = {{"orbit.yaw", {{0.0, 1.0}}}, {"slice", {{0.0, 1.0}}}, {"brightness", {{0.0, 1.0}}}};
  film.share_keys = {{0.0, 0.2}};
  CHECK(check(film));
  CHECK(idle_keys(film).size() == 3);
  film.sources[0].camera.view = View::kFollow;
  CHECK(idle_keys(film).size() == 2);
  film.sources[0].field = SceneField{"2"};
  CHECK(idle_keys(film).size() == 1);
  Source curve = recording_of("1");
  curve.kind = SourceKind::kCurve;
  CHECK_FALSE(has_property(curve, *source_property("zoom")));
  CHECK(has_property(curve, *source_property("brightness")));
}

TEST_CASE("the film's own numbers have keys too") {
  Composition film;
  for (const Property* property : {&speed_property(), &share_property()}) {
    set_fixed_value(film, property->name, 0.4);
    CHECK(value_of(film, property->name, 9.0) == 0.4);
    set_keys(film, property->name, {{0.0, 0.2}, {2.0, 0.4}});
    CHECK(value_of(film, property->name, 1.0) == doctest::Approx(0.3));
  }
  CHECK(film.pace.ramps.size() == 2);
  CHECK(film.share_keys.size() == 2);
}

TEST_CASE("a key takes the place of one that is as good as there, and lies between its neighbours in time") {
  std::vector<Key> keys{{0.0, 1.0}, {2.0, 3.0}};
  keys = with_key_at(std::move(keys), {1.0, 5.0, Ease::kHold}, 0.02);
  REQUIRE(keys.size() == 3);
  CHECK(keys[1].value == 5.0);
  keys = with_key_at(std::move(keys), {1.01, 6.0}, 0.02);
  REQUIRE(keys.size() == 3);
  CHECK(keys[1].t_s == 1.01);
  CHECK(with_key_at({}, {1.0, 5.0}, 0.02).size() == 1);
}

TEST_CASE("a spline goes through its keys without a corner and never beyond them, and its area is that below it") {
  const std::vector<Key> keys{{0.0, 1.0, Ease::kSpline},
                              {1.0, 1.5, Ease::kSpline},
                              {1.5, 4.0, Ease::kSpline},
                              {3.0, 0.5, Ease::kSpline},
                              {4.0, 0.5}};
  for (const Key& key : keys) CHECK(value_at(keys, key.t_s, 0.0) == doctest::Approx(key.value));
  constexpr double kStep = 1e-4;
  double area = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const double t = i * kStep;
    const double here = value_at(keys, t, 0.0);
    const double next = value_at(keys, t + kStep, 0.0);
    area += kStep * 0.5 * (here + next);
    REQUIRE(here >= 0.5 - 1e-12);
    REQUIRE(here <= 4.0 + 1e-12);
    // No corner: the slope changes little from step to step.
    const double after = value_at(keys, t + 2.0 * kStep, 0.0);
    if (t + 2.0 * kStep < 4.0) REQUIRE(std::abs(after - 2.0 * next + here) / kStep < 0.02);
  }
  CHECK(area_to(keys, 4.0, 0.0) == doctest::Approx(area).epsilon(1e-6));
  CHECK(area_to(keys, 1.2, 0.0) ==
        doctest::Approx(area_to(keys, 1.0, 0.0) + 0.2 * value_at(keys, 1.1, 0.0)).epsilon(0.05));
}

TEST_CASE("the keys of the speed do not count holds, and between both times one comes and goes") {
  Pace pace;
  pace.speed = 2.0;
  pace.holds = {{1.0, 0.5}, {3.0, 2.0}};
  CHECK(running_at(pace, 3.0) == doctest::Approx(1.5));
  // Before the first hold, within it, after it, within the second, after both.
  for (const auto& [film_s, running_s] :
       std::vector<std::pair<double, double>>{{0.3, 0.3}, {0.7, 0.5}, {1.2, 0.7}, {2.5, 1.5}, {4.5, 2.0}}) {
    CAPTURE(film_s);
    CHECK(running_of(pace, film_s) == doctest::Approx(running_s));
  }
  CHECK(film_time_of(pace, 0.3) == doctest::Approx(0.3));
  CHECK(film_time_of(pace, 0.7) == doctest::Approx(1.2));
  CHECK(film_time_of(pace, 2.0) == doctest::Approx(4.5));
  pace.ramps = {{0.0, 1.0}, {2.0, 3.0}};
  CHECK(area_to(pace.ramps, running_at(pace, 3.0), pace.speed) == doctest::Approx(3.0));
}
