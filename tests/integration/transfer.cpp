// Whole transfers by scripted operators. The long run (a few minutes) is a CTest of its own, label `long`:
//   tools/test --long
#include <doctest/doctest.h>

#include <array>
#include <cstring>

#include "engine/spatial/grid.h"
#include "engine/trial/skill.h"
#include "engine/trial/transfer_session.h"
#include "tests/support/session_recording.h"

using namespace trocar;
using demonstration::Outcome;
using demonstration::Recording;
using demonstration::Segment;
using trial::Skill;
using trial::TransferOptions;
using trial::TransferSession;

namespace {

Recording record(const TransferOptions& options) {
  auto session = TransferSession::create(options);
  REQUIRE(session.has_value());
  while (!session->done()) session->step();
  return testing::recording_of(*session);
}

trial::ReplayResult replayed(const Recording& recording) {
  Progress progress;
  const auto result = trial::replay(recording, progress);
  REQUIRE(result.has_value());
  return *result;
}

/// Block and goal vary with the seed.
TransferOptions varied(std::uint64_t seed) {
  TransferOptions options;
  options.seed = seed;
  options.block = static_cast<int>(seed % 6);
  options.goal = static_cast<int>((seed / 6 + seed) % 6);
  return options;
}

bool same(const demonstration::ArmSample& a, const demonstration::ArmSample& b) {
  return a.setpoint_p == b.setpoint_p && a.setpoint_q_wxyz == b.setpoint_q_wxyz &&
         a.setpoint_jaw_rad == b.setpoint_jaw_rad && a.measured.p == b.measured.p && a.joints == b.joints;
}

int count_placed(Skill skill, int from, int to, double jitter_m, bool vary) {
  int placed = 0;
  for (int seed = from; seed <= to; ++seed) {
    TransferOptions options = vary ? varied(static_cast<std::uint64_t>(seed)) : TransferOptions{};
    options.seed = static_cast<std::uint64_t>(seed);
    options.skill = skill;
    options.aim_jitter_m = jitter_m;
    const Recording recording = record(options);
    CHECK(replayed(recording).verified);
    if (recording.placed) ++placed;
  }
  return placed;
}

}  // namespace

TEST_CASE("an expert places any block on any goal, and each recording replays to the same hashes") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Recording recording = record(varied(seed));
    CHECK(recording.placed);
    CHECK(recording.outcome == Outcome::kSuccess);
    const trial::ReplayResult result = replayed(recording);
    CHECK(result.verified);
    CHECK(result.placed);
    CHECK_FALSE(result.diverged_at_s.has_value());
  }
}

TEST_CASE("an expert places the default block for seeds 1 to 10") {
  CHECK(count_placed(Skill::kExpert, 1, 10, -1.0, false) == 10);
}

TEST_CASE("a scripted recording says so") {
  const Recording recording = record({.skill = Skill::kNovice, .seed = 3, .time_limit_s = 0.1});
  CHECK(recording.provenance.operator_kind == "scripted");
  CHECK(recording.provenance.skill == "novice");
  CHECK(recording.provenance.seed == 3);
  CHECK(recording.outcome == Outcome::kUnfinished);
}

TEST_CASE("the same options give the same samples and hashes, another seed does not") {
  const TransferOptions options{.seed = 7, .time_limit_s = 8.0};
  const Recording a = record(options);
  const Recording b = record(options);
  REQUIRE(a.samples.size() == b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    REQUIRE(a.samples[i].tick == b.samples[i].tick);
    REQUIRE(same(a.samples[i].arms[0], b.samples[i].arms[0]));
    REQUIRE(same(a.samples[i].arms[1], b.samples[i].arms[1]));
  }
  REQUIRE(a.hashes.size() == b.hashes.size());
  for (std::size_t i = 0; i < a.hashes.size(); ++i) CHECK(a.hashes[i].hash == b.hashes[i].hash);
  const Recording c = record({.seed = 8, .time_limit_s = 8.0});
  CHECK(a.hashes.back().hash != c.hashes.back().hash);
}

TEST_CASE("samples come at 200 Hz, hashes each second and at the end, segments in order") {
  const Recording recording = record({.seed = 2});
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    REQUIRE(recording.samples[i].tick == static_cast<std::int64_t>(5 * i));
    if (i > 0) REQUIRE(recording.samples[i].segment >= recording.samples[i - 1].segment);
  }
  REQUIRE(recording.hashes.size() >= 2);
  for (std::size_t i = 0; i + 1 < recording.hashes.size(); ++i) {
    CHECK(recording.hashes[i].tick == static_cast<std::int64_t>(1000 * i));
  }
  CHECK(recording.hashes.back().tick == recording.samples.back().tick);
  CHECK(recording.samples.back().segment == Segment::kE);
}

TEST_CASE("an expert takes 15 to 35 s and stays inside the learning lattice in segments A and C") {
  const spatial::Grid grid;
  for (const std::uint64_t seed : {11, 13, 16}) {
    CAPTURE(seed);
    const Recording recording = record(varied(seed));
    const double duration_s = recording.samples.back().t_s();
    CHECK(duration_s > 15.0);
    CHECK(duration_s < 35.0);
    for (const demonstration::Sample& sample : recording.samples) {
      if (sample.segment != Segment::kA && sample.segment != Segment::kC) continue;
      REQUIRE(grid.cell_at(sample.arms[0].setpoint().p).has_value());
    }
  }
}

TEST_CASE("a corrupted sample makes the replay diverge at the next mark") {
  Recording recording = record({.seed = 4, .time_limit_s = 6.0});
  REQUIRE(recording.samples.size() > 700);
  recording.samples[700].arms[0].setpoint_p[0] += 1e-9;  // At 3.5 s.
  const trial::ReplayResult result = replayed(recording);
  CHECK_FALSE(result.verified);
  REQUIRE(result.diverged_at_s.has_value());
  CHECK(*result.diverged_at_s == 4.0);
}

TEST_CASE("what cannot be replayed is refused with the reason") {
  const Recording whole = record({.seed = 5, .time_limit_s = 0.5});
  Progress progress;
  Recording recording = whole;
  recording.initial_world.clear();
  CHECK(trial::replay(recording, progress).error().code() == ErrorCode::kInvalidArgument);
  recording = whole;
  recording.hashes.clear();
  CHECK(trial::replay(recording, progress).error().code() == ErrorCode::kInvalidArgument);
  recording = whole;
  std::swap(recording.samples[1], recording.samples[2]);
  CHECK(trial::replay(recording, progress).error().code() == ErrorCode::kInvalidArgument);
  progress.cancel();
  CHECK(trial::replay(whole, progress).error().code() == ErrorCode::kCancelled);
}

TEST_CASE("long: an expert places the default block for seeds 1 to 50" * doctest::skip()) {
  CHECK(count_placed(Skill::kExpert, 1, 50, -1.0, false) == 50);
}

TEST_CASE("long: an expert places every block on every goal for seeds 1 to 50" * doctest::skip()) {
  CHECK(count_placed(Skill::kExpert, 1, 50, -1.0, true) == 50);
}

TEST_CASE("long: with an aim jitter of 0.5 mm 100 of 100 are placed" * doctest::skip()) {
  CHECK(count_placed(Skill::kExpert, 1, 100, 0.5e-3, false) == 100);
}

TEST_CASE("long: with an aim jitter of 1 mm at least 98 of 100 are placed" * doctest::skip()) {
  CHECK(count_placed(Skill::kExpert, 1, 100, 1.0e-3, false) >= 98);
}
