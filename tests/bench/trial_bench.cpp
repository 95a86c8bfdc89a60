// Trials: what the guard and the control of an arm cost in a millisecond, and how much faster than real time they run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "engine/control/authority.h"
#include "engine/core/check.h"
#include "engine/trial/guarded_arm.h"
#include "engine/trial/shared_control_session.h"
#include "engine/trial/simulated_arm.h"
#include "tests/support/trial_agents.h"

namespace {

using namespace trocar;

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One tick of one arm: authority, guard, mapping, limits and the arm's reach, each tick with a new setpoint, which in
/// a trial is every fifth.
void control_step(benchmark::State& state) {
  simulation::World world;
  trial::SimulatedArm arm(world, kinematics::ArmSide::kLeft);
  trial::GuardedArm guarded(arm, trial::guard_settings(), 0.2);
  control::AuthorityMachine machine;
  guarded.guard().confirm_frame(true);
  control::GuardLook look;
  control::ControlLook seen;
  look.feedback = arm.feedback();
  look.now = look.feedback.stamp;
  TROCAR_CHECK(guarded.guard().arm(look.feedback, look.now).has_value());
  trial::HandSample hand;
  guarded.take_over(hand);
  std::int64_t tick = 1;
  for (auto _ : state) {
    ++tick;
    look.now = look.feedback.stamp = look.dead_man_stamp = seen.now = Tick{tick};
    look.dead_man = tick > 5;
    seen.begin = tick == 2;
    guarded.guard().look(look);
    benchmark::DoNotOptimize(machine.look(seen));
    hand.X_DH.p.x() = 0.01 * std::sin(0.002 * static_cast<double>(tick));
    benchmark::DoNotOptimize(guarded.follow(hand, Tick{tick}, 0.001));
  }
}
BENCHMARK(control_step)->Unit(benchmark::kMicrosecond);

/// One iteration is a whole shared trial; the counter is simulated time by processor time of this one thread.
void trial_realtime_factor(benchmark::State& state) {
  trial::TrialOptions options;
  options.mode = trial::Mode::kShared;
  options.agents = testing::agents_for(0);
  double simulated_s = 0.0;
  double spent_s = 0.0;
  for (auto _ : state) {
    const double begin_s = thread_cpu_s();
    auto session = trial::SharedControlSession::create(options).value();
    while (!session->done()) session->step();
    TROCAR_CHECK(session->outcome() == demonstration::Outcome::kSuccess);
    spent_s += thread_cpu_s() - begin_s;
    simulated_s += session->state().tick.seconds();
    ++options.seed;
  }
  state.counters["realtime"] = simulated_s / spent_s;
}
BENCHMARK(trial_realtime_factor)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
