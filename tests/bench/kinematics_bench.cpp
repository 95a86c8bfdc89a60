#include "engine/kinematics/psm.h"

#include <benchmark/benchmark.h>

#include <vector>

#include "engine/core/random.h"

namespace {

using namespace trocar;

void inverse_of_random_poses(benchmark::State& state) {
  const kinematics::PsmModel model = kinematics::psm_model(kinematics::ArmSide::kLeft);
  Random random(1);
  std::vector<spatial::Pose> poses(4096);
  for (spatial::Pose& pose : poses) {
    kinematics::Joints q{};
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = random.uniform(model.limits[i].low, model.limits[i].high);
    pose = kinematics::forward(model, q);
  }
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(kinematics::inverse(model, poses[next]));
    next = (next + 1) % poses.size();
  }
}
BENCHMARK(inverse_of_random_poses)->Name("ik");

}  // namespace
