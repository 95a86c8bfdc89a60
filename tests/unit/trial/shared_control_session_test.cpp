// Trials in the simulator: manual and shared, to the bit repeatable and replayable, and what the operator can do at any
// time.
#include "engine/trial/shared_control_session.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/trial/transfer_session.h"
#include "tests/support/session_recording.h"
#include "tests/support/trial_agents.h"

using namespace trocar;
using namespace trocar::trial;
using demonstration::Authority;
using demonstration::Outcome;
using demonstration::Segment;

namespace {

const std::vector<AgentModel>& agents() {
  static const std::vector<AgentModel> kAgents = testing::agents_for(0);
  return kAgents;
}

TrialOptions shared(std::uint64_t seed = 1) {
  TrialOptions options;
  options.mode = Mode::kShared;
  options.agents = agents();
  options.seed = seed;
  return options;
}

struct Run {
  demonstration::Recording recording;
  std::vector<TrialEvent> events;
  TrialStatus status;
  std::optional<double> completion_s;
  Outcome outcome = Outcome::kUnfinished;
};

Run run(const TrialOptions& options, std::int64_t stop_at = -1) {
  auto session = SharedControlSession::create(options).value();
  Run result;
  while (!session->done()) {
    if (session->state().tick.count == stop_at) session->stop();
    session->step();
  }
  result.recording = testing::recording_of(*session);
  result.events = session->take_events();
  result.status = *session->trial_status();
  result.completion_s = session->completion_s();
  result.outcome = session->outcome();
  return result;
}

bool told(const Run& run, TrialEventKind kind, const std::string& text) {
  return std::any_of(run.events.begin(), run.events.end(),
                     [&](const TrialEvent& event) { return event.kind == kind && event.text.starts_with(text); });
}

/// A hand at rest whose pedals are pressed by the clock.
class Feet final : public OperatorInput {
 public:
  std::int64_t down_from = 0;
  std::int64_t down_to = 0;
  std::int64_t clutch_from = 0;
  std::int64_t clutch_to = 0;
  HandSample sample(const simulation::WorldState& seen) override {
    HandSample hand;
    const std::int64_t now = seen.tick.count;
    hand.agent_pedal = now >= down_from && now < down_to;
    hand.clutch_pedal = now >= clutch_from && now < clutch_to;
    return hand;
  }
  std::string_view name() const override { return "feet"; }
};

}  // namespace

TEST_CASE("a manual trial of an expert succeeds, and its recording replays to the same hashes") {
  TrialOptions options;
  const Run manual = run(options);
  CHECK(manual.outcome == Outcome::kSuccess);
  REQUIRE(manual.completion_s);
  CHECK(*manual.completion_s > 5.0);
  CHECK(manual.status.counts.agent_s == 0.0);
  CHECK(manual.status.counts.limit_hits == 0);
  Progress progress;
  CHECK(replay(manual.recording, progress).value().verified);
}

TEST_CASE(
    "in a shared trial the agent moves in A and C under the pedal, and the recording replays to the same hashes") {
  const Run both = run(shared());
  CHECK(both.outcome == Outcome::kSuccess);
  CHECK(both.status.counts.agent_s > 1.0);
  CHECK(told(both, TrialEventKind::kAgent, "begins: A exact"));
  CHECK(told(both, TrialEventKind::kAgent, "begins: C exact"));
  CHECK(both.status.counts.hand_overs >= 4);
  Progress progress;
  CHECK(replay(both.recording, progress).value().verified);
  for (const demonstration::Sample& sample : both.recording.samples) {
    if (sample.authority != Authority::kAgent) continue;
    CHECK((sample.flags & demonstration::kAgentPedal) != 0);
    CHECK((sample.segment == Segment::kA || sample.segment == Segment::kC));
  }
}

TEST_CASE("the same options give the same bits, another seed other ones") {
  const Run first = run(shared());
  const Run again = run(shared());
  CHECK(hash_of(first.recording.samples) == hash_of(again.recording.samples));
  CHECK(first.recording.hashes.back().hash == again.recording.hashes.back().hash);
  CHECK(first.events.size() == again.events.size());
  CHECK(hash_of(first.recording.samples) != hash_of(run(shared(2)).recording.samples));
}

TEST_CASE("a released pedal is in the record and the arm the operator's in that tick, also between two samples") {
  // By 3 ms of delay the release arrives inside of a sample.
  for (const double delay_s : {0.0, 0.003}) {
    Feet feet;
    feet.down_from = 500;
    feet.down_to = 1500;
    TrialOptions options = shared();
    options.delay.mean_s = delay_s;
    options.time_limit_s = 3.0;
    auto session = SharedControlSession::create(options, {&feet, nullptr}).value();
    const auto release = static_cast<std::int64_t>(std::lround(1500 + 1e3 * delay_s));
    while (session->state().tick.count < release) {
      session->step();
    }
    CHECK(session->authority() == Authority::kAgent);
    session->step();
    CHECK(session->authority() == Authority::kOperator);
    const auto events = session->take_events();
    const auto at = [&](TrialEventKind kind, const std::string& text) {
      const auto found = std::find_if(events.rbegin(), events.rend(), [&](const TrialEvent& event) {
        return event.kind == kind && event.text == text;
      });
      return found == events.rend() ? -1 : found->tick;
    };
    CHECK(at(TrialEventKind::kPedal, "agent pedal up") == release);
    CHECK(at(TrialEventKind::kState, "operator") == release);
    // The agent's motion runs out within 40 ms, and then nothing moves: the hand rests.
    while (session->state().tick.count < release + 60) session->step();
    const Eigen::Vector3d rest = session->state().arms[0].X_WT.p;
    while (!session->done()) session->step();
    CHECK((session->state().arms[0].X_WT.p - rest).norm() < 1e-9);
    Progress progress;
    CHECK(replay(testing::recording_of(*session), progress).value().verified);
  }
}

TEST_CASE("a hand-over jumps neither in place nor in speed, either way") {
  Feet feet;
  feet.down_from = 500;
  feet.down_to = 1503;
  TrialOptions options = shared();
  options.time_limit_s = 2.5;
  auto session = SharedControlSession::create(options, {&feet, nullptr}).value();
  Eigen::Vector3d p = session->state().arms[0].setpoint.X_WT.p;
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  double fastest = 0.0;
  double worst_change = 0.0;
  while (!session->done()) {
    session->step();
    const Eigen::Vector3d next = session->state().arms[0].setpoint.X_WT.p;
    const Eigen::Vector3d v_next = (next - p) / 1e-3;
    fastest = std::max(fastest, v_next.norm());
    worst_change = std::max(worst_change, (v_next - v).norm());
    p = next;
    v = v_next;
  }
  CHECK(fastest > 0.03);
  CHECK(fastest < 0.07);
  // 8 m/s² over the 5 ms of a sample are 40 mm/s; the agent and what runs out of it change far more slowly.
  CHECK(worst_change < 0.020);
}

TEST_CASE("both pedals hold the tool, and a tap moves nothing") {
  Feet feet;
  SUBCASE("a tap") {
    feet.down_from = 500;
    feet.down_to = 620;
  }
  SUBCASE("both") {
    feet.down_from = 500;
    feet.down_to = 2000;
    feet.clutch_from = 400;
    feet.clutch_to = 2000;
  }
  TrialOptions options = shared();
  options.time_limit_s = 2.0;
  auto session = SharedControlSession::create(options, {&feet, nullptr}).value();
  const Eigen::Vector3d before = session->state().arms[0].X_WT.p;
  while (!session->done()) session->step();
  CHECK((session->state().arms[0].X_WT.p - before).norm() < 1e-9);
}

TEST_CASE("the clutch holds the tool where the agent has brought it, at once") {
  for (const std::int64_t after : {30, 72, 400}) {
    CAPTURE(after);
    Feet feet;
    feet.down_from = 500;
    feet.down_to = 3000;
    feet.clutch_from = 650 + after;
    feet.clutch_to = 3000;
    TrialOptions options = shared();
    options.time_limit_s = 3.0;
    auto session = SharedControlSession::create(options, {&feet, nullptr}).value();
    while (session->state().tick.count < feet.clutch_from) session->step();
    const Eigen::Vector3d there = session->state().arms[0].X_WT.p;
    double farthest = 0.0;
    while (!session->done()) {
      session->step();
      farthest = std::max(farthest, (session->state().arms[0].X_WT.p - there).norm());
      CHECK(session->trial_status()->state != control::ControlState::kHold);
    }
    // What runs out of 50 mm/s within 40 ms is 1 mm.
    CHECK(farthest < 0.0013);
  }
}

TEST_CASE("stop ends it in any segment as aborted, and the arms rest") {
  for (const std::int64_t tick : {100, 2003, 8000, 12001}) {
    const Run stopped = run(shared(), tick);
    CHECK(stopped.outcome == Outcome::kAborted);
    CHECK(told(stopped, TrialEventKind::kState, "stopped"));
    CHECK(stopped.recording.samples.back().tick <= tick + 1010);
    const auto& last = stopped.recording.samples;
    CHECK(last[last.size() - 1].arms[0].setpoint_p == last[last.size() - 100].arms[0].setpoint_p);
    Progress progress;
    const ReplayResult replayed = replay(stopped.recording, progress).value();
    CAPTURE(tick);
    CAPTURE(replayed.diverged_at_s.value_or(-1.0));
    CHECK(replayed.verified);
  }
}

TEST_CASE("a fault of the arm ends the trial as a fault, and nothing moves it again") {
  for (const std::int64_t tick : {2003, 8000}) {
    auto session = SharedControlSession::create(shared()).value();
    while (!session->done()) {
      if (session->state().tick.count == tick) session->play_fault();
      session->step();
    }
    CHECK(session->outcome() == Outcome::kFault);
    CHECK(session->trial_status()->state == control::ControlState::kStopped);
    CHECK(session->state().tick.count <= tick + 1010);
    const auto samples = session->take_samples();
    CHECK(samples[samples.size() - 1].arms[0].setpoint_p == samples[samples.size() - 100].arms[0].setpoint_p);
    const auto events = session->take_events();
    CHECK(std::any_of(events.begin(), events.end(), [](const TrialEvent& event) {
      return event.kind == TrialEventKind::kOutcome && event.text.starts_with("fault");
    }));
  }
}

namespace {

/// An assistant who moves to the right without a break, and whose link is cut for a while.
class CutAssistant final : public OperatorInput {
 public:
  std::int64_t cut_from = 0;
  std::int64_t cut_to = 0;
  HandSample sample(const simulation::WorldState& seen) override {
    HandSample hand;
    hand.X_DH.p.x() = 0.05 * seen.tick.seconds();
    return hand;
  }
  LinkState link(Tick now) override { return {now.count < cut_from || now.count >= cut_to, true, now}; }
  std::string_view name() const override { return "second console"; }
};

}  // namespace

TEST_CASE("a second person has the right arm, which holds while their link is cut and does not jump when it is back") {
  Feet feet;
  CutAssistant second;
  second.cut_from = 1000;
  second.cut_to = 1500;
  auto session = SharedControlSession::create({}, {&feet, &second}).value();
  CHECK(session->assistant_kind() == "person");
  Eigen::Vector3d before = session->state().arms[1].X_WT.p;
  double moved_while_cut_m = 0.0;
  double moved_after_m = 0.0;
  for (std::int64_t tick = 0; tick < 2500; ++tick) {
    session->step();
    const Eigen::Vector3d now = session->state().arms[1].X_WT.p;
    const double step_m = (now - before).norm();
    // 10 mm/s by the scale, and never more than the limits let it brake and begin.
    CHECK(step_m < 0.0001);
    if (tick > 1100 && tick < 1500) moved_while_cut_m += step_m;
    if (tick > 1600) moved_after_m += step_m;
    before = now;
  }
  CHECK(moved_while_cut_m < 1e-6);
  CHECK(moved_after_m > 0.005);
}

TEST_CASE("hands that say that no person moves them are never called a person's") {
  Feet feet;
  CutAssistant second;
  auto session = SharedControlSession::create({}, {&feet, &second, true}).value();
  CHECK(session->provenance().operator_kind == "scripted");
  CHECK(session->assistant_kind() == "scripted");
}

TEST_CASE("a constant delay shifts what the arm does by exactly that") {
  TrialOptions options;
  options.time_limit_s = 4.0;
  const Run direct = run(options);
  options.delay.mean_s = 0.050;
  const Run late = run(options);
  CHECK(late.status.counts.delay_mean_s == doctest::Approx(0.050));
  // Until the operator sees the first effect, which comes later.
  const std::size_t shift = 10;
  for (std::size_t i = 0; i < 100; ++i) {
    CHECK(late.recording.samples[i + shift].arms[0].setpoint_p == direct.recording.samples[i].arms[0].setpoint_p);
  }
}

TEST_CASE("what cannot be run is refused in a sentence") {
  TrialOptions options;
  options.mode = Mode::kShared;
  CHECK(SharedControlSession::create(options).error().text().find("needs a model") != std::string::npos);
  options = {};
  options.block = 6;
  CHECK_FALSE(SharedControlSession::create(options));
  options = {};
  options.scale = 1.0;
  CHECK_FALSE(SharedControlSession::create(options));
  options = {};
  options.time_limit_s = 0.0;
  CHECK_FALSE(SharedControlSession::create(options));
}
