// A take by hand, played without a window: what the operator does, and what is recorded of it.
#include "engine/trial/hand_session.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/demonstration/demonstration.h"
#include "engine/peg_board/peg_board.h"
#include "engine/spatial/grid.h"
#include "engine/trial/keyboard_hands.h"
#include "engine/trial/sampling.h"

using namespace trocar;
using namespace trocar::trial;
using demonstration::Sample;
using kinematics::ArmSide;

namespace {

HandOptions still_assistant(HandMode mode = HandMode::kContinuous) {
  HandOptions options;
  options.sources = {ArmSource::kHand, ArmSource::kStill};
  options.mode = mode;
  options.countdown_s = 0.0;
  return options;
}

/// A session, and everything that came out of it.
struct Take {
  explicit Take(const HandOptions& options) : session(HandSession::create(options).value()) { gather(); }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) session->step();
    gather();
  }
  void press(KeyboardHands& keyboard, HandKey key, bool down) {
    for (const HandEvent& event : keyboard.key(key, down)) session->post(event);
  }
  void gather() {
    if (auto world = session->take_initial_world()) recording.initial_world = *world;
    for (const Sample& sample : session->take_samples()) recording.samples.push_back(sample);
    for (const auto& mark : session->take_marks()) recording.hashes.push_back(mark);
    for (const TakeNote& note : session->take_notes()) notes.push_back(note);
  }
  const demonstration::Recording& end() {
    session->post(EndTake{});
    run(demonstration::kTicksPerSample);
    recording.provenance = session->provenance();
    recording.outcome = session->outcome();
    return recording;
  }
  Eigen::Vector3d tip(ArmSide side = ArmSide::kLeft) const { return session->state().arm(side).X_WT.p; }

  std::unique_ptr<HandSession> session;
  demonstration::Recording recording;
  std::vector<TakeNote> notes;
};

bool verifies(const demonstration::Recording& recording) {
  Progress progress;
  return replay(recording, progress).value().verified;
}

/// Where a point is in the picture of the paper's camera: right and down of its middle, and how far away (m).
Eigen::Vector3d in_picture(const Eigen::Vector3d& p_W) {
  const peg_board::PaperCamera camera = peg_board::paper_camera();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d forward{-std::cos(camera.pitch_rad), 0.0, std::sin(camera.pitch_rad)};
  Eigen::Matrix3d R_CW;
  R_CW << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  const Eigen::Vector3d p_C = R_CW * (p_W - camera.eye);
  return {p_C.x() / p_C.z(), p_C.y() / p_C.z(), p_C.z()};
}

/// How the picture of the tool changes while a key is held for half a second.
Eigen::Vector3d moved_in_picture(ArmSide side, HandKey key) {
  HandOptions options = still_assistant();
  if (side == ArmSide::kRight) std::swap(options.sources[0], options.sources[1]);
  Take take(options);
  KeyboardHands keyboard;
  const Eigen::Vector3d before = in_picture(take.tip(side));
  take.press(keyboard, key, true);
  take.run(500);
  return in_picture(take.tip(side)) - before;
}

}  // namespace

TEST_CASE("a push to the right, up and away moves the tool right, up and away in the paper's picture") {
  for (const ArmSide side : kinematics::kArmSides) {
    const bool left = side == ArmSide::kLeft;
    CHECK(moved_in_picture(side, left ? 'D' : 'L').x() > 0.05);
    CHECK(moved_in_picture(side, left ? 'A' : 'J').x() < -0.05);
    // y is down in a picture.
    CHECK(moved_in_picture(side, left ? 'W' : 'I').y() < -0.05);
    CHECK(moved_in_picture(side, left ? 'S' : 'K').y() > 0.05);
    CHECK(moved_in_picture(side, left ? 'E' : 'O').z() > 0.008);
    CHECK(moved_in_picture(side, left ? 'Q' : 'U').z() < -0.008);
  }
}

TEST_CASE("a take by keys is recorded as it was driven and replays to the same hashes") {
  Take take(still_assistant());
  KeyboardHands keyboard;
  take.press(keyboard, 'D', true);
  take.run(700);
  take.press(keyboard, 'D', false);
  take.press(keyboard, 'C', true);
  take.run(600);
  const demonstration::Recording& recording = take.end();
  CHECK(recording.provenance.operator_kind == "person");
  CHECK(recording.provenance.device == "keyboard; right arm still");
  CHECK(recording.samples.size() == 1 + 1300 / demonstration::kTicksPerSample);
  CHECK(demonstration::check_samples(recording.samples));
  CHECK(recording.hashes.size() == 3);  // at the start, after a second and at the end
  CHECK(recording.samples.back().authority == demonstration::Authority::kOperator);
  CHECK(recording.samples.back().arms[0].setpoint_jaw_rad == doctest::Approx(0.30));
  CHECK(verifies(recording));
}

TEST_CASE("in step mode each key is one cell of the lattice along one axis") {
  Take take(still_assistant(HandMode::kStep));
  KeyboardHands keyboard({HandMode::kStep});
  take.run(400);
  const spatial::Grid grid;
  const auto cell = [&] { return grid.coordinates(grid.cell_at(take.tip()).value()); };
  const spatial::CellCoordinates start = cell();
  for (const HandKey key : {'D', 'W', 'E', 'E', 'S'}) {
    take.press(keyboard, key, true);
    take.press(keyboard, key, false);
  }
  take.run(1000);
  CHECK(cell() == spatial::CellCoordinates{start.x - 2, start.y + 1, start.z});
  // In the middle of the cell, to the rounding of the kinematics.
  CHECK((take.tip() - grid.centre(grid.cell_at(take.tip()).value())).norm() < 1e-9);
  // Never diagonally: from sample to sample the setpoint moves along one axis.
  const demonstration::Recording& recording = take.end();
  for (std::size_t i = 1; i < recording.samples.size(); ++i) {
    int axes = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double by = recording.samples[i].arms[0].setpoint_p[k] - recording.samples[i - 1].arms[0].setpoint_p[k];
      axes += std::abs(by) > 1e-9 ? 1 : 0;
    }
    CHECK(axes <= 1);
  }
}

TEST_CASE("a waypoint moves nothing until it is gone to, and then the tool comes to rest there") {
  Take take(still_assistant(HandMode::kWaypoint));
  KeyboardHands keyboard({HandMode::kWaypoint});
  const Eigen::Vector3d start = take.tip();
  take.press(keyboard, 'S', true);
  take.run(500);
  take.press(keyboard, 'S', false);
  take.run(200);
  CHECK((take.tip() - start).norm() < 1e-12);
  const auto waypoint = take.session->status().arms[0].waypoint;
  REQUIRE(waypoint.has_value());
  CHECK((waypoint->p - start).z() < -0.01);
  take.press(keyboard, kEnterKey, true);
  take.run(2000);
  CHECK((take.tip() - waypoint->p).norm() < 1e-9);
  CHECK_FALSE(take.session->status().arms[0].waypoint.has_value());
}

TEST_CASE("while the clutch is held the tool stands and the samples say so") {
  Take take(still_assistant());
  KeyboardHands keyboard;
  take.press(keyboard, kClutchKey, true);
  take.press(keyboard, 'D', true);
  const Eigen::Vector3d start = take.tip();
  take.run(300);
  CHECK((take.tip() - start).norm() < 1e-12);
  CHECK((take.recording.samples.back().flags & demonstration::kClutchPedal) != 0);
  take.press(keyboard, kClutchKey, false);
  take.run(300);
  CHECK(take.tip().y() > start.y() + 0.005);
  CHECK((take.recording.samples.back().flags & demonstration::kClutchPedal) == 0);
}

TEST_CASE("what is out of reach is held, said and counted") {
  Take take(still_assistant());
  take.session->post(PlaceTool{ArmSide::kLeft, {{0.0, -0.02, 0.4}, kinematics::pointing_down(0.0)}});
  take.run(2000);
  const ArmReport arm = take.session->status().arms[0];
  CHECK(arm.refused_count > 0);
  CHECK(arm.limited_count > 0);
  CHECK(verifies(take.end()));
}

TEST_CASE("no wish goes below the board") {
  Take take(still_assistant());
  KeyboardHands keyboard;
  take.press(keyboard, 'S', true);
  take.run(2500);
  CHECK(take.recording.samples.back().arms[0].setpoint_p[2] >= 0.0005 - 1e-12);
  CHECK(take.session->status().arms[0].limited);
}

TEST_CASE("what is not finite moves nothing") {
  Take take(still_assistant());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d bad{nan, 0.0, 0.0};
  take.session->post(DriveTool{ArmSide::kLeft, bad, bad});
  take.session->post(ShiftTool{ArmSide::kLeft, bad});
  take.session->post(PlaceTool{ArmSide::kLeft, {bad, Eigen::Quaterniond::Identity()}});
  const Eigen::Vector3d start = take.tip();
  take.run(100);
  CHECK((take.tip() - start).norm() < 1e-12);
}

TEST_CASE("the countdown runs before anything is recorded and can be cut short") {
  HandOptions options = still_assistant();
  options.countdown_s = 3.0;
  Take take(options);
  take.run(2000);
  CHECK(take.recording.samples.empty());
  CHECK(take.session->status().phase == Phase::kCountdown);
  CHECK(take.session->status().countdown_s == doctest::Approx(1.0));
  take.session->post(BeginTake{});
  take.run(10);
  CHECK(take.session->status().phase == Phase::kRecording);
  CHECK(take.recording.samples.size() == 2);
  take.run(1000);
  CHECK(verifies(take.end()));
}

TEST_CASE("the pre-roll keeps the last five seconds before the recording, and they replay") {
  HandOptions options = still_assistant();
  options.countdown_s = 8.0;
  options.pre_roll = true;
  Take take(options);
  KeyboardHands keyboard;
  take.press(keyboard, 'A', true);
  take.run(500);
  take.press(keyboard, 'A', false);
  take.run(7000);
  CHECK(take.session->status().pre_roll_s >= 5.0);
  take.run(1000);
  const demonstration::Recording& recording = take.end();
  const double kept_s = Tick{recording.samples.back().tick - recording.samples.front().tick}.seconds();
  CHECK(kept_s >= 5.0);
  CHECK(kept_s < 5.25 + 0.6);
  CHECK(demonstration::check_samples(recording.samples));
  CHECK(verifies(recording));
}

TEST_CASE("a pause stops simulated time and leaves a note") {
  Take take(still_assistant());
  take.run(500);
  take.session->post(PauseTake{true});
  take.run(1500);
  CHECK(take.session->status().phase == Phase::kPaused);
  CHECK(take.session->state().tick.count == 500);
  take.session->post(PauseTake{false});
  take.run(500);
  REQUIRE(take.notes.size() == 1);
  CHECK(take.notes[0].tick == 500);
  CHECK(take.notes[0].text == "Paused for 1.5 s");
  CHECK(verifies(take.end()));
}

TEST_CASE("one arm replays a demonstration bit for bit while the other is driven") {
  Take first(still_assistant());
  KeyboardHands keyboard;
  first.press(keyboard, 'W', true);
  first.run(400);
  first.press(keyboard, 'C', true);
  first.run(600);
  const demonstration::Recording source = first.end();

  HandOptions options;
  options.sources = {ArmSource::kReplay, ArmSource::kHand};
  options.countdown_s = 0.0;
  options.initial_world = source.initial_world;
  for (const Sample& sample : source.samples) {
    options.replay.push_back({recorded_setpoint(sample.arms[0]), recorded_setpoint(sample.arms[1])});
  }
  Take overdub(options);
  KeyboardHands other;
  overdub.press(other, 'J', true);
  overdub.run(900);
  const demonstration::Recording& recording = overdub.end();
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    CHECK(recording.samples[i].arms[0].setpoint() == source.samples[i].arms[0].setpoint());
    CHECK(recording.samples[i].arms[0].setpoint_jaw_rad == source.samples[i].arms[0].setpoint_jaw_rad);
  }
  CHECK(recording.samples.back().arms[1].setpoint_p[1] < recording.samples.front().arms[1].setpoint_p[1] - 0.02);
  CHECK(verifies(recording));
}

TEST_CASE("a lead-in brings the world to where another recording was at that time") {
  Take first(still_assistant());
  KeyboardHands keyboard;
  first.press(keyboard, 'S', true);
  first.run(900);
  const demonstration::Recording source = first.end();
  HandOptions options = still_assistant();
  options.initial_world = source.initial_world;
  for (std::size_t i = 1; i <= 120; ++i) {
    options.lead_in.push_back(
        {recorded_setpoint(source.samples[i].arms[0]), recorded_setpoint(source.samples[i].arms[1])});
  }
  Take second(options);
  second.run(20);
  CHECK(second.session->status().phase == Phase::kRecording);
  REQUIRE_FALSE(second.recording.samples.empty());
  CHECK(second.recording.samples.front().tick == source.samples[120].tick);
  CHECK(second.recording.samples.front().arms[0].setpoint() == source.samples[120].arms[0].setpoint());
  CHECK(verifies(second.end()));
}

TEST_CASE("a take that nobody drives, or of a block that there is not, is refused") {
  HandOptions nobody;
  nobody.sources = {ArmSource::kScripted, ArmSource::kStill};
  CHECK(HandSession::create(nobody).error().code() == ErrorCode::kInvalidArgument);
  HandOptions nothing_to_replay;
  nothing_to_replay.sources = {ArmSource::kReplay, ArmSource::kHand};
  CHECK(HandSession::create(nothing_to_replay).error().code() == ErrorCode::kInvalidArgument);
  HandOptions no_block;
  no_block.block = 6;
  CHECK(HandSession::create(no_block).error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("what a full queue cannot take is counted as dropped") {
  Take take(still_assistant());
  int taken = 0;
  while (taken < 100'000 && take.session->post(ToggleJaw{})) ++taken;
  CHECK(taken == 1024);
  CHECK(take.session->status().dropped_input == 1);
}

TEST_CASE("a take that begins in a cell is recorded from there on, turned as the tool was") {
  HandOptions options = still_assistant();
  const Take elsewhere(options);
  const Eigen::Vector3d place = spatial::Grid{}.centre(spatial::Grid{}.index({10, 9, 18}));
  options.begin_p_WT[0] = place;
  Take take(options);
  for (int i = 0; i < 20'000 && take.session->status().phase != Phase::kRecording; ++i) take.run(1);
  REQUIRE(take.session->status().phase == Phase::kRecording);
  CHECK((take.tip() - place).norm() < 1e-4);
  REQUIRE_FALSE(take.recording.samples.empty());
  CHECK((take.recording.samples.front().arms[0].setpoint().p - place).norm() < 1e-6);
  const auto& before = elsewhere.session->state().arm(ArmSide::kLeft).X_WT.q;
  CHECK(take.session->state().arm(ArmSide::kLeft).X_WT.q.angularDistance(before) < 1e-3);
  CHECK((elsewhere.tip() - place).norm() > 0.005);
}
