#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "engine/core/check.h"
#include "tests/unit/simulation/transfer_motion.h"

namespace {

using namespace trocar::simulation;
/// Processor time of this thread: what the step costs, whatever else the machine does meanwhile.
double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One iteration is a whole bimanual transfer; the time is that of `World::step` alone, for one step.
void step_of_a_transfer(benchmark::State& state) {
  std::vector<double> steps_s;
  for (auto _ : state) {
    World world;
    double total_s = 0.0;
    const std::size_t before = steps_s.size();
    const auto timed = [&](World& stepped) {
      const double begin_s = thread_cpu_s();
      stepped.step();
      steps_s.push_back(thread_cpu_s() - begin_s);
      total_s += steps_s.back();
    };
    TROCAR_CHECK(transfer(world, 1, 4, timed).has_value());
    TROCAR_CHECK(placed(world, 1, 4));
    state.SetIterationTime(total_s / static_cast<double>(steps_s.size() - before));
  }
  const auto at = [&](double share) {
    const auto nth = steps_s.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(steps_s.size() - 1));
    std::nth_element(steps_s.begin(), nth, steps_s.end());
    return *nth * 1e6;
  };
  state.counters["p50_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["p99.9_us"] = at(0.999);
  state.counters["max_us"] = at(1.0);
}
BENCHMARK(step_of_a_transfer)
    ->Name("physics_step_transfer")
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(5);

/// One iteration is a whole transfer with its commands; the counter is simulated time by processor time.
void transfer_by_real_time(benchmark::State& state) {
  double simulated_s = 0.0;
  double spent_s = 0.0;
  for (auto _ : state) {
    World world;
    const double begin_s = thread_cpu_s();
    TROCAR_CHECK(transfer(world, 1, 4).has_value());
    spent_s += thread_cpu_s() - begin_s;
    simulated_s += world.state().tick.seconds();
  }
  state.counters["realtime_factor"] = simulated_s / spent_s;
}
BENCHMARK(transfer_by_real_time)
    ->Name("physics_transfer_realtime_factor")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(5);

void save(benchmark::State& state) {
  const World world;
  for (auto _ : state) benchmark::DoNotOptimize(world.snapshot());
  state.counters["bytes"] = static_cast<double>(world.snapshot().bytes.size());
}
BENCHMARK(save)->Name("snapshot_save");

void load(benchmark::State& state) {
  World world;
  const WorldSnapshot snapshot = world.snapshot();
  for (auto _ : state) TROCAR_CHECK(world.restore(snapshot).has_value());
}
BENCHMARK(load)->Name("snapshot_load");

void hash(benchmark::State& state) {
  const World world;
  for (auto _ : state) benchmark::DoNotOptimize(world.state_hash());
}
BENCHMARK(hash)->Name("state_hash");

}  // namespace
