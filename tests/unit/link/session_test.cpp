// A trial over the link ("TCP link with delay"): what goes through packets, relay and reader in simulated time, and
// what the guard and the authority make of a link that is late, cut or silent.
#include "engine/trial/shared_control_session.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/link/hand_script.h"
#include "engine/trial/scripted_user.h"
#include "tests/support/session_recording.h"
#include "tests/support/trial_agents.h"
#include "tests/support/virtual_link.h"

using namespace trocar;
using namespace trocar::trial;
using control::ControlState;
using trocar::testing::ScriptedHandInput;
using trocar::testing::VirtualLink;

namespace {

control::DelayOptions constant(double seconds) {
  control::DelayOptions options;
  options.mean_s = seconds;
  return options;
}

ScriptedHandInput hand(std::string_view script) {
  return ScriptedHandInput(link::parse_hand_script(script).value());
}

TrialOptions lasting(double seconds, bool shared = false) {
  static const std::vector<AgentModel> kAgents = trocar::testing::agents_for(0);
  TrialOptions options;
  options.time_limit_s = seconds;
  options.mode = shared ? Mode::kShared : Mode::kManual;
  if (shared) options.agents = kAgents;
  return options;
}

/// What each tick left.
struct Trace {
  std::vector<ControlState> states;
  std::vector<Eigen::Vector3d> p_W;  ///< Of the left tool's setpoint.
  demonstration::Recording recording;
  std::vector<TrialEvent> events;

  Eigen::Vector3d at(std::size_t tick) const { return p_W.at(tick - 1); }
  ControlState state(std::size_t tick) const { return states.at(tick); }
  double fastest_m_s(std::size_t from) const {
    double fastest = 0.0;
    for (std::size_t i = std::max<std::size_t>(from, 1); i < p_W.size(); ++i) {
      fastest = std::max(fastest, (p_W[i] - p_W[i - 1]).norm() * 1e3);
    }
    return fastest;
  }
  bool told(TrialEventKind kind, const std::string& text) const {
    return std::any_of(events.begin(), events.end(), [&](const TrialEvent& event) {
      return event.kind == kind && event.text.find(text) != std::string::npos;
    });
  }
};

Trace run(const TrialOptions& options, OperatorInput& input) {
  auto session = SharedControlSession::create(options, {&input, nullptr}).value();
  Trace trace;
  while (!session->done()) {
    session->step();
    trace.states.push_back(session->trial_status()->state);
    trace.p_W.push_back(session->state().arms[0].setpoint.X_WT.p);
  }
  trace.recording = trocar::testing::recording_of(*session);
  trace.events = session->take_events();
  return trace;
}

/// As the session makes it when it is given no other.
ScriptedUser expert(const TrialOptions& options) {
  Assignment assignment{options.block, options.goal, parameters(options.skill), std::string(to_string(options.skill)),
                        -1.0};
  assignment.shares_control = options.mode == Mode::kShared;
  return ScriptedUser(assignment, Random(options.seed).child(0).child(1));
}

constexpr std::string_view kAround =
    "0.3 move 0.05 0 0 over 0.8\n0.9 move 0 0.04 -0.03 over 0.7\n1.2 turn 0 0 20 over 0.5\n1.4 grip 20 over 0.2\n";

}  // namespace

TEST_CASE("without a delay the link is the direct path, sample for sample") {
  for (const bool shared : {false, true}) {
    const TrialOptions options = lasting(60.0, shared);
    ScriptedUser at_the_arm = expert(options);
    ScriptedUser far_away = expert(options);
    VirtualLink link(far_away, constant(0.0));
    const Trace direct = run(options, at_the_arm);
    const Trace over = run(options, link);
    CHECK(direct.told(TrialEventKind::kOutcome, "success"));
    if (shared) CHECK(direct.told(TrialEventKind::kState, "agent"));
    REQUIRE(over.recording.samples.size() == direct.recording.samples.size());
    CHECK(std::memcmp(over.recording.samples.data(), direct.recording.samples.data(),
                      direct.recording.samples.size() * sizeof(demonstration::Sample)) == 0);
    REQUIRE(over.recording.hashes.size() == direct.recording.hashes.size());
    for (std::size_t i = 0; i < over.recording.hashes.size(); ++i) {
      CHECK(over.recording.hashes[i].hash == direct.recording.hashes[i].hash);
    }
  }
}

TEST_CASE("a constant delay shifts what the arm is told by exactly that") {
  const TrialOptions options = lasting(2.5);
  ScriptedHandInput at_the_arm = hand(kAround);
  const Trace direct = run(options, at_the_arm);
  CHECK((direct.at(2400) - direct.at(1)).norm() > 0.01);
  for (const std::size_t late : {5U, 40U, 150U}) {
    ScriptedHandInput far_away = hand(kAround);
    VirtualLink link(far_away, constant(0.001 * static_cast<double>(late)));
    const Trace over = run(options, link);
    int different = 0;
    for (std::size_t tick = 1; tick + late <= 2500; ++tick)
      different += over.at(tick + late) != direct.at(tick) ? 1 : 0;
    CHECK(different == 0);
  }
}

TEST_CASE("on release the remote is the operator's within the delay applied and a tick") {
  for (const std::size_t late : {0U, 1U, 7U, 37U, 60U}) {
    ScriptedHandInput foot = hand("0.5 agent down\n1.5 agent up\n");
    VirtualLink link(foot, constant(0.001 * static_cast<double>(late)));
    const Trace trace = run(lasting(2.0, true), link);
    CAPTURE(late);
    CHECK(trace.state(1500 + late - 1) == ControlState::kAgent);
    CHECK(trace.state(1500 + late) == ControlState::kOperator);
    for (std::size_t tick = 1500 + late; tick < 2000; ++tick) REQUIRE(trace.state(tick) == ControlState::kOperator);
  }
}

TEST_CASE("a tap is not lost, however the network bunches its frames") {
  // Everything sent between 1.0 and 1.06 s arrives at once.
  control::DelayOptions bunch;
  bunch.kind = control::DelayKind::kTrace;
  bunch.trace_s.assign(1000, 0.0);
  bunch.trace_s[200] = 0.060;
  ScriptedHandInput foot = hand("1.01 agent down\n1.04 agent up\n");
  VirtualLink link(foot, bunch);
  const Trace trace = run(lasting(1.5, true), link);
  CHECK(trace.told(TrialEventKind::kPedal, "agent pedal down"));
  CHECK(trace.told(TrialEventKind::kPedal, "agent pedal up"));
  CHECK_FALSE(trace.told(TrialEventKind::kState, "agent"));
  CHECK(link.inbox().unseen_presses() == 0);
}

TEST_CASE("a cut link holds within the watchdog, and does not jump on return") {
  for (const bool silent : {false, true}) {
    // The hand moves on while it is cut: by 20 mm, that is 4 mm of the tool.
    ScriptedHandInput far_away = hand("0.2 move 0.06 0 0 over 1.2\n2.0 move 0 0.05 0 over 0.6\n");
    VirtualLink link(far_away, constant(0.0));
    link.cut = {Tick{702}, Tick{1700}, silent};
    const Trace trace = run(lasting(3.0), link);
    CAPTURE(silent);
    const std::size_t within = silent ? 101 : 0;
    CHECK(trace.state(701) == ControlState::kOperator);
    CHECK(trace.state(702 + within) == ControlState::kHold);
    for (std::size_t tick = 702 + within; tick < 1700; ++tick) REQUIRE(trace.state(tick) == ControlState::kHold);
    CHECK(trace.told(TrialEventKind::kGuard, silent ? "not confirmed" : "has gone"));
    // It brakes, stands, and stands after its return until the hand moves again: what the hand did meanwhile is
    // nothing.
    const Eigen::Vector3d held = trace.at(702 + within + 60);
    CHECK(trace.at(1700) == held);
    CHECK(trace.state(1720) == ControlState::kOperator);
    CHECK((trace.at(1999) - held).norm() < 1e-12);
    CHECK((trace.at(2990) - held).norm() == doctest::Approx(0.01).epsilon(1e-6));
    CHECK(trace.fastest_m_s(0) <= 0.25 + 1e-9);
    Progress progress;
    CHECK(replay(trace.recording, progress).value().verified);
  }
}

TEST_CASE("a cut link stops the agent, and after it only another press moves it") {
  for (const bool silent : {false, true}) {
    ScriptedHandInput foot = hand("0.5 agent down\n2.0 agent up\n2.1 agent down\n");
    VirtualLink link(foot, constant(0.010));
    link.cut = {Tick{900}, Tick{1300}, silent};
    const Trace trace = run(lasting(2.5, true), link);
    CAPTURE(silent);
    CHECK(trace.state(899) == ControlState::kAgent);
    const std::size_t within = silent ? 101 : 0;
    for (std::size_t tick = 900 + within; tick < 1300; ++tick) REQUIRE(trace.state(tick) == ControlState::kHold);
    for (std::size_t tick = 1300; tick < 2200; ++tick) REQUIRE(trace.state(tick) != ControlState::kAgent);
    CHECK(trace.state(1400) == ControlState::kOperator);
    // Pressed at 2.1 s; 10 ms on the way, and long enough to be no tap.
    CHECK(trace.state(2110 + 150) == ControlState::kAgent);
  }
}

TEST_CASE("who leaves the controller is held") {
  class Present final : public OperatorInput {
   public:
    HandSample sample(const simulation::WorldState& seen) override { return script.at(seen.tick.seconds()).sample(); }
    LinkState link(Tick now) override { return {true, script.at(now.seconds()).present, now}; }
    std::string_view name() const override { return "present"; }
    link::HandScript script = link::parse_hand_script("0.2 move 0.06 0 0 over 1.2\n0.7 away\n1.0 back\n").value();
  } input;
  const Trace trace = run(lasting(1.5), input);
  CHECK(trace.state(699) == ControlState::kOperator);
  for (std::size_t tick = 700; tick < 1000; ++tick) REQUIRE(trace.state(tick) == ControlState::kHold);
  CHECK(trace.state(1010) == ControlState::kOperator);
}

TEST_CASE("a burst after a stall stays under the speed limit") {
  // A hand as fast as the tool may just follow; stalls shorter and longer than the watchdog.
  for (const double stall_s : {0.03, 0.08, 0.15, 0.6}) {
    control::DelayOptions stalls;
    stalls.kind = control::DelayKind::kTrace;
    stalls.trace_s.assign(1000, 0.010);
    stalls.trace_s[130] = stalls.trace_s[150] = stall_s;
    ScriptedHandInput far_away = hand("0.3 move 0.4 0 0 over 0.9\n");
    VirtualLink link(far_away, stalls);
    const Trace trace = run(lasting(2.5), link);
    CAPTURE(stall_s);
    CHECK(link.relay().applied().worst_s() == doctest::Approx(stall_s));
    CHECK((trace.at(600) - trace.at(1)).norm() > 0.002);
    CHECK(trace.fastest_m_s(0) <= 0.25 + 1e-9);
    CHECK(trace.fastest_m_s(0) > 0.1);
    // Between two ticks the speed changes by no more than the acceleration allows over the sample of 5 ms.
    double worst_m_s = 0.0;
    for (std::size_t i = 2; i < trace.p_W.size(); ++i) {
      worst_m_s = std::max(worst_m_s, (trace.p_W[i] - 2.0 * trace.p_W[i - 1] + trace.p_W[i - 2]).norm() * 1e3);
    }
    CHECK(worst_m_s <= 8.0 * 0.005 + 1e-9);
    if (stall_s > 0.11) CHECK(trace.told(TrialEventKind::kState, "hold"));
  }
}

TEST_CASE("the same seed gives the same trial over the link, to the bit") {
  const auto once = [](std::uint64_t seed) {
    const TrialOptions options = lasting(6.0, true);
    control::DelayOptions delay;
    delay.kind = control::DelayKind::kAutoregressive;
    delay.mean_s = 0.020;
    delay.deviation_s = 0.005;
    delay.stall_chance = 0.002;
    delay.seed = seed;
    ScriptedUser far_away = expert(options);
    VirtualLink link(far_away, delay);
    return run(options, link).recording.hashes.back().hash;
  };
  const std::uint64_t first = once(1);
  CHECK(once(1) == first);
  CHECK(once(2) != first);
}
