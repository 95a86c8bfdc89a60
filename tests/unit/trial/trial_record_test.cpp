// Records go to JSON and back; smoothness and economy are what they say.
#include "engine/trial/trial_record.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace trocar;
using namespace trocar::trial;

TEST_CASE("a record goes to JSON and back") {
  TrialRecord record;
  record.mode = Mode::kShared;
  record.operator_kind = "scripted";
  record.skill = "novice";
  record.session = "one \"two\"";
  record.seed = 18446744073709551615ULL;
  record.block = 4;
  record.delay = "ar1:20:5";
  record.models = {{"A exact", demonstration::Segment::kA, 0xFEDCBA9876543210ULL}};
  record.outcome = demonstration::Outcome::kSuccess;
  record.completion_s = 12.25;
  record.begin_p_W = Eigen::Vector3d(0.01, -0.02, 0.03);
  record.counts.clutches = 3;
  record.counts.segment_s[2] = 1.5;
  record.metrics.smoothness = -2.5;
  record.events = {{1234, TrialEventKind::kPedal, "agent pedal up"}};
  const std::string json = to_json(record);
  const TrialRecord again = record_from_json(json).value();
  CHECK(to_json(again) == json);
  CHECK(again.seed == record.seed);
  CHECK(again.models.front().hash == record.models.front().hash);
  CHECK(again.events.front().tick == 1234);
  CHECK(again.completion_s == 12.25);
  // What was dropped was never completed, whatever an older record says.
  record.outcome = demonstration::Outcome::kDropped;
  CHECK_FALSE(record_from_json(to_json(record))->completion_s);
}

TEST_CASE("a record that makes no sense is refused") {
  for (const char* text : {"", "[]", R"({"mode":"XX"})", R"({"completion_s":"soon"})", R"({"events":[[1,"pedal"]]})",
                           R"({"events":[[1,"song","x"]]})", R"({"models":[{"hash":"xyz"}]})", R"({"seed":1.5})",
                           R"({"begin_m":[1,2]})", R"({"begin_m":[1,2,"x"]})"}) {
    CAPTURE(text);
    CHECK_FALSE(record_from_json(text));
  }
  CHECK(record_from_json("{}"));
}

TEST_CASE("a smooth movement has a shorter spectral arc than one that stops and starts") {
  std::vector<double> smooth;
  std::vector<double> jerky;
  for (int i = 0; i <= 400; ++i) {
    const double s = i / 400.0;
    smooth.push_back(30.0 * s * s * (1.0 - s) * (1.0 - s));
    jerky.push_back(smooth.back() * (1.0 + std::cos(40.0 * s)));
  }
  const double one = spectral_arc_length(smooth, 200.0);
  CHECK(one == doctest::Approx(-1.41).epsilon(0.02));  // of one minimum-jerk movement
  CHECK(spectral_arc_length(jerky, 200.0) < one);
  CHECK(spectral_arc_length({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 200.0) == 0.0);
}

TEST_CASE("a straight way has an economy of 1, a detour less") {
  std::vector<demonstration::Sample> samples(101);
  for (int i = 0; i <= 100; ++i) {
    auto& sample = samples[static_cast<std::size_t>(i)];
    sample.tick = 5 * i;
    sample.arms[0].measured.p = {0.001F * static_cast<float>(i), 0.0F, 0.0F};
  }
  CHECK(trial_metrics(samples, std::nullopt, 0.0).economy == doctest::Approx(1.0).epsilon(1e-4));
  CHECK(trial_metrics(samples, std::nullopt, 0.25).agent_share == doctest::Approx(0.5));
  CHECK(trial_metrics(samples, 0.25, 0.0).path_length_m == doctest::Approx(0.050).epsilon(1e-3));
  for (int i = 40; i <= 60; ++i) samples[static_cast<std::size_t>(i)].arms[0].measured.p[1] = 0.02F;
  CHECK(trial_metrics(samples, std::nullopt, 0.0).economy < 0.8);
}
