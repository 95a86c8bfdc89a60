// Random people at the console: pedals that stick, tap and go down together, links that are cut and go stale, clocks
// that jump, faults and stops, while the hand moves without a break. Whatever they do, the arm has one owner, the agent
// moves it only under a held pedal, and nothing jumps.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "engine/control/setpoint_limiter.h"
#include "engine/core/random.h"
#include "engine/trial/shared_control_session.h"
#include "tests/support/session_recording.h"
#include "tests/support/trial_agents.h"

using namespace trocar;
using namespace trocar::trial;
using control::ControlState;
using demonstration::Authority;
using demonstration::Outcome;

namespace {

/// A level that changes now and then, in any tick.
class Switch {
 public:
  Switch(double up_s, double down_s) : mean_s_{up_s, down_s} {}
  bool at(Tick now, Random& random) {
    while (now.count >= until_) {
      down_ = until_ != 0 && !down_;
      // Some of them are taps.
      const double mean_s = down_ && random.uniform() < 0.25 ? 0.05 : mean_s_[down_ ? 1 : 0];
      until_ = now.count + 1 + static_cast<std::int64_t>(-1e3 * mean_s * std::log(1.0 - random.uniform()));
    }
    return down_;
  }

 private:
  std::array<double, 2> mean_s_;
  bool down_ = false;
  std::int64_t until_ = 0;
};

/// Sways about where the tool begins, in and out of what the agent knows.
class RestlessPerson final : public OperatorInput {
 public:
  explicit RestlessPerson(std::uint64_t seed) : random_(seed) {
    for (Wave& wave : waves_) {
      for (int i = 0; i < 3; ++i) wave.way_m[i] = random_.uniform(-0.08, 0.08);
      wave.rate_rad_s = random_.uniform(0.3, 1.6);
    }
  }
  /// What it does to its feet and its link while its hand moves as it will.
  HandSample sample(const simulation::WorldState& seen) override {
    HandSample hand = pedals(seen.tick);
    for (const Wave& wave : waves_) hand.X_DH.p += wave.way_m * std::sin(wave.rate_rad_s * seen.tick.seconds());
    hand.X_DH.q = Eigen::AngleAxisd(0.3 * std::sin(seen.tick.seconds()), Eigen::Vector3d::UnitX());
    last_ = hand;
    return hand;
  }
  std::optional<HandSample> news(Tick now) override {
    HandSample hand = last_;
    const HandSample feet = pedals(now);
    hand.agent_pedal = feet.agent_pedal;
    hand.clutch_pedal = feet.clutch_pedal;
    if (hand.agent_pedal == last_.agent_pedal && hand.clutch_pedal == last_.clutch_pedal) return std::nullopt;
    last_ = hand;
    return hand;
  }
  LinkState link(Tick now) override {
    LinkState link{!cut_.at(now, random_), !away_.at(now, random_), now};
    // What was heard is old, or says that it is of the future.
    if (stale_.at(now, random_)) link.stamp = Tick{std::max<std::int64_t>(0, now.count - 500)};
    if (jumps_.at(now, random_)) link.stamp = Tick{now.count + 10'000};
    return link;
  }
  std::string_view name() const override { return "restless person"; }

 private:
  struct Wave {
    Eigen::Vector3d way_m{0.0, 0.0, 0.0};
    double rate_rad_s = 1.0;
  };
  HandSample pedals(Tick now) {
    HandSample feet;
    feet.agent_pedal = agent_.at(now, random_);
    feet.clutch_pedal = clutch_.at(now, random_);
    return feet;
  }

  Random random_;
  std::array<Wave, 3> waves_;
  HandSample last_;
  Switch agent_{0.4, 1.5};
  Switch clutch_{3.0, 0.4};
  Switch cut_{6.0, 0.3};
  Switch away_{6.0, 0.3};
  Switch stale_{6.0, 0.3};
  Switch jumps_{8.0, 0.2};
};

/// How often each state was seen, over all of them.
std::array<int, control::kControlStates> times_seen{};

void watch(SharedControlSession& session, std::int64_t stop_at, std::int64_t fault_at) {
  const control::MotionLimits limits;
  const double largest_change_m_s = 5e-3 * limits.acceleration_m_s2 * 1.001;
  std::array<Eigen::Vector3d, 2> p;
  std::array<Eigen::Vector3d, 2> v{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (std::size_t i = 0; i < 2; ++i) p[i] = session.state().arms[i].setpoint.X_WT.p;
  std::int64_t stopped_since = -1;
  while (!session.done()) {
    const std::int64_t tick = session.state().tick.count;
    if (tick == stop_at) session.stop();
    if (tick == fault_at) session.play_fault(tick % 2 == 0 ? kinematics::ArmSide::kLeft : kinematics::ArmSide::kRight);
    session.step();
    const TrialStatus status = *session.trial_status();
    ++times_seen[static_cast<std::size_t>(status.state)];
    CAPTURE(tick);
    if (session.authority() == Authority::kAgent) {
      REQUIRE(status.state == ControlState::kAgent);
      REQUIRE(status.agent_pedal);
      REQUIRE_FALSE(status.clutch_pedal);
    }
    if (status.state == ControlState::kStopped && stopped_since < 0) stopped_since = tick;
    for (std::size_t i = 0; i < 2; ++i) {
      const Eigen::Vector3d next = session.state().arms[i].setpoint.X_WT.p;
      const Eigen::Vector3d v_next = (next - p[i]) / 1e-3;
      CAPTURE(i);
      REQUIRE(v_next.norm() < limits.speed_m_s * 1.001);
      REQUIRE((v_next - v[i]).norm() < largest_change_m_s);
      if (stopped_since >= 0 && tick > stopped_since + 60) REQUIRE(v_next.norm() == 0.0);
      p[i] = next;
      v[i] = v_next;
    }
  }
}

}  // namespace

TEST_CASE("whatever a person does at the console: one owner, no agent without its pedal, no jump") {
  const std::vector<AgentModel> agents = testing::agents_for(0);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    TrialOptions options;
    options.mode = Mode::kShared;
    options.agents = agents;
    options.seed = seed;
    options.time_limit_s = 12.0;
    // Delays that differ let what was sent arrive in any tick.
    if (seed % 3 == 0) options.delay = control::delay_from("normal:12:5").value();
    RestlessPerson person(seed);
    RestlessPerson second(100 + seed);
    auto session = SharedControlSession::create(options, {&person, seed % 2 == 0 ? &second : nullptr}).value();
    const bool stops = seed % 4 == 1;
    const bool breaks = seed % 4 == 3;
    watch(*session, stops ? 7003 + static_cast<std::int64_t>(seed) : -1,
          breaks ? 6001 + static_cast<std::int64_t>(seed) : -1);
    CHECK(session->outcome() == (stops ? Outcome::kAborted : breaks ? Outcome::kFault : Outcome::kUnfinished));
    // What was recorded is what the arms were told, however often it was cut short.
    Progress progress;
    CHECK(replay(testing::recording_of(*session), progress).value().verified);
  }
  // All that can happen did happen.
  for (const ControlState state : {ControlState::kOperator, ControlState::kAgent, ControlState::kClutch,
                                   ControlState::kHold, ControlState::kStopped}) {
    CAPTURE(control::to_string(state));
    CHECK(times_seen[static_cast<std::size_t>(state)] > 200);
  }
}

namespace {

/// A pedal by the clock, and a hand that rests or shakes while it is down.
class ShakingHand final : public OperatorInput {
 public:
  ShakingHand(double amplitude_m, std::int64_t down_from, std::int64_t down_to)
      : amplitude_m_(amplitude_m), down_from_(down_from), down_to_(down_to) {}
  HandSample sample(const simulation::WorldState& seen) override {
    HandSample hand;
    hand.agent_pedal = seen.tick.count >= down_from_ && seen.tick.count < down_to_;
    const bool shakes = seen.tick.count >= down_from_ + 200 && seen.tick.count < down_to_;
    if (shakes) hand.X_DH.p.x() = amplitude_m_ * std::sin(20.0 * seen.tick.seconds());
    return hand;
  }
  std::string_view name() const override { return "shaking hand"; }

 private:
  double amplitude_m_;
  std::int64_t down_from_;
  std::int64_t down_to_;
};

std::vector<Eigen::Vector3d> path_of(const TrialOptions& options, OperatorInput& person, std::int64_t ticks) {
  auto session = SharedControlSession::create(options, {&person, nullptr}).value();
  std::vector<Eigen::Vector3d> path;
  while (session->state().tick.count < ticks) {
    session->step();
    path.push_back(session->state().arms[0].setpoint.X_WT.p);
  }
  return path;
}

}  // namespace

TEST_CASE("while the agent has the arm the hand moves nothing of it, to the bit; and while it has not, no model does") {
  TrialOptions options;
  options.mode = Mode::kShared;
  options.agents = testing::agents_for(0);
  ShakingHand still(0.0, 500, 1800);
  ShakingHand shaking(0.03, 500, 1800);
  CHECK(path_of(options, still, 1700) == path_of(options, shaking, 1700));
  // The agent's path is its own: without its pedal it is another, and that is the same with any model.
  ShakingHand nobody(0.0, 100'000, 100'000);
  const std::vector<Eigen::Vector3d> rest = path_of(options, nobody, 1700);
  CHECK(rest != path_of(options, still, 1700));
  options.agents = testing::agents_for(3);
  CHECK(rest == path_of(options, nobody, 1700));
}
