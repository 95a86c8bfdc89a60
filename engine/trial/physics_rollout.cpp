#include "engine/trial/physics_rollout.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "engine/core/check.h"
#include "engine/core/random.h"
#include "engine/demonstration/recording.h"
#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"
#include "engine/simulation/world.h"
#include "engine/trial/arm_drive.h"
#include "engine/trial/sampling.h"
#include "engine/trial/segment_world.h"

namespace trocar::trial {
namespace {

using control::ToolCommand;
using kinematics::ArmSide;
using spatial::CellIndex;

constexpr int kSamplesPerCell = 25;  // 1/8 s: 20 mm/s on the lattice of 2.5 mm
constexpr double kLead_m_s = 0.060;  // while the tool is led to its start
constexpr double kAbove_m = 0.055;   // over the pegs and what stands on them
constexpr double kNear_m = 0.0002;   // of a place that the tool was to reach
constexpr int kMostWaits = 200;      // samples for the limits to let it get there
constexpr int kAfterwards = 100;     // samples in which who watches sees how it ended
constexpr double kMostDelay_s = 5.0;
constexpr double kMostNoise_m = 0.05;
constexpr double kSamplePeriod_s = 1.0 / demonstration::kSampleRate_hz;

/// The world with the left tool in it, one sample at a time.
class Driven {
 public:
  Driven(const PhysicsOptions& options, const std::string& world) : world_(world_options(options)) {
    if (!world.empty()) {
      const Status restored = world_.restore({world});
      TROCAR_CHECK(restored.has_value());
      carried_ = options.block;
    }
    setpoint_ = setpoint();
    drive_.emplace(ArmSide::kLeft, setpoint_);
    wish_ = setpoint_;
  }

  const simulation::WorldState& state() const { return world_.state(); }
  /// Nothing was in the jaws, or it still is.
  bool holds() const {
    return !carried_ || state().blocks[static_cast<std::size_t>(*carried_)].held_by(ArmSide::kLeft);
  }
  std::optional<int> carried() const { return carried_; }
  Eigen::Vector3d tip() const { return state().arm(ArmSide::kLeft).X_WT.p; }
  /// Where it was so many samples ago, or first.
  Eigen::Vector3d tip_before(std::size_t samples) const {
    return tips_.empty() ? tip() : tips_[tips_.size() - 1 - std::min(samples, tips_.size() - 1)];
  }
  double seconds() const { return state().tick.seconds(); }
  double length_m() const { return length_m_; }
  std::uint64_t hash() const { return world_.state_hash(); }
  void measure_from_here() {
    length_m_ = 0.0;
    tips_.assign(1, tip());
  }
  void show_to(const RolloutWatcher& watch) {
    watch_ = watch;
    if (watch_) watch_(state());
  }
  /// Rests for so many samples.
  void wait(int samples) {
    for (int i = 0; i < samples; ++i) sample();
  }

  /// Evenly over so many samples, then until the tool is there. False if it cannot get there.
  bool go(const Eigen::Vector3d& p_WT, int samples) {
    const Eigen::Vector3d from = wish_.X_WT.p;
    for (int i = 1; i <= samples; ++i) {
      wish_.X_WT.p = i == samples ? p_WT : Eigen::Vector3d(from + (p_WT - from) * (static_cast<double>(i) / samples));
      sample();
    }
    for (int i = 0; i < kMostWaits && (tip() - p_WT).norm() > kNear_m; ++i) {
      if (!drive_->refusal().empty() || !holds()) return false;
      sample();
    }
    return (tip() - p_WT).norm() <= kNear_m;
  }

 private:
  static simulation::WorldOptions world_options(const PhysicsOptions& options) {
    simulation::WorldOptions world;
    world.seed = options.seed;
    return world;
  }
  ToolCommand setpoint() const { return setpoint_of(world_.state(), ArmSide::kLeft); }

  void sample() {
    const ToolCommand from = setpoint_;
    setpoint_ = drive_->approach(wish_);
    const Eigen::Vector3d before = tip();
    for (int sub = 1; sub <= demonstration::kTicksPerSample; ++sub) {
      const ToolCommand command = between(from, setpoint_, sub, demonstration::kTicksPerSample);
      // Both ends are within reach; at a point between them that is not the arm stays.
      static_cast<void>(world_.command(ArmSide::kLeft, {command.X_WT, command.jaw_rad}));
      world_.step();
    }
    length_m_ += (tip() - before).norm();
    tips_.push_back(tip());
    if (watch_) watch_(state());
  }

  simulation::World world_;
  std::optional<int> carried_;
  ToolCommand setpoint_;
  ToolCommand wish_;
  std::optional<ArmDrive> drive_;
  double length_m_ = 0.0;
  std::vector<Eigen::Vector3d> tips_;  ///< After each sample.
  RolloutWatcher watch_;               ///< May be empty.
};

int samples_for(double way_m) {
  return std::max(1, static_cast<int>(std::ceil(way_m / kLead_m_s / kSamplePeriod_s)));
}

/// Up, across and down again.
bool lead(Driven& driven, const Eigen::Vector3d& start) {
  const Eigen::Vector3d here = driven.tip();
  const double above = std::max({here.z(), start.z(), kAbove_m});
  Eigen::Vector3d last = here;
  for (const Eigen::Vector3d& next :
       {Eigen::Vector3d(here.x(), here.y(), above), Eigen::Vector3d(start.x(), start.y(), above), start}) {
    if ((next - last).norm() > 0.0 && !driven.go(next, samples_for((next - last).norm()))) return false;
    last = next;
  }
  return true;
}

Eigen::Vector3d place_of(const learning::Model& model, CellIndex start, const PhysicsOptions& options) {
  Eigen::Vector3d place = model.grid.centre(start);
  if (!options.continuous) return place;
  Random random = Random(options.seed).child(static_cast<std::uint64_t>(start.value));
  for (int axis = 0; axis < 3; ++axis) place[axis] += model.grid.cell_m * (random.uniform() - 0.5);
  return place;
}

using Places = std::array<Eigen::Vector3d, peg_board::kBlockCount>;
Places blocks_of(const simulation::WorldState& state) {
  Places places;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = state.blocks[i].X_WK.p;
  return places;
}

/// Where the agent takes the tool to be, and what it makes of it. The same for a seed and a start.
class Perturbed {
 public:
  Perturbed(const learning::Model& model, const std::vector<std::uint8_t>& policy, const PhysicsOptions& options,
            CellIndex start)
      : grid_(model.grid),
        policy_(policy),
        how_(options.perturbed),
        allowed_(learning::allowed_moves(model.grid, model.safe)),
        random_(Random(options.seed).child(static_cast<std::uint64_t>(start.value)).child(1)) {}

  bool any() const { return how_ != Perturbation{}; }

  Eigen::Vector3d seen(const Driven& driven) {
    const auto late = static_cast<std::size_t>(std::lround(how_.delay_s / kSamplePeriod_s));
    Eigen::Vector3d place = driven.tip_before(late);
    if (how_.noise_m <= 0.0) return place;
    // The agent knows that it is on the lattice: what is read beside it is read as its edge.
    const double edge_m = grid_.n * grid_.cell_m * (1.0 - 1e-9);
    for (int axis = 0; axis < 3; ++axis) {
      const double read = place[axis] + how_.noise_m * random_.normal();
      place[axis] = std::clamp(read, grid_.p_WGo[axis], grid_.p_WGo[axis] + edge_m);
    }
    return place;
  }

  std::uint8_t action(CellIndex cell) {
    const auto s = static_cast<std::size_t>(cell.value);
    if (how_.epsilon <= 0.0 || policy_[s] == learning::kNoAction || random_.uniform() >= how_.epsilon)
      return policy_[s];
    std::vector<std::uint8_t> allowed;
    for (std::uint8_t a = 0; a < spatial::kActionCount; ++a) {
      if ((allowed_[s] >> a & 1) != 0) allowed.push_back(a);
    }
    return allowed.empty() ? policy_[s] : allowed[random_.below(static_cast<std::uint32_t>(allowed.size()))];
  }

 private:
  spatial::Grid grid_;
  const std::vector<std::uint8_t>& policy_;
  Perturbation how_;
  std::vector<std::uint8_t> allowed_;
  Random random_;
};

/// From cell to cell until it ends. It arrives and leaves the lattice where it is, and goes by where it is taken to be.
PhysicsEnd follow(const learning::Model& model, Perturbed& agent, double end_s, Driven& driven,
                  PhysicsRollout& result) {
  spatial::CellSet asked(model.grid);
  for (;;) {
    const Result<CellIndex> here = model.grid.cell_at(driven.tip());
    if (!here) return PhysicsEnd::kOutsideSafeSet;
    if (*here == model.goal) return PhysicsEnd::kArrives;
    if (!agent.any() && asked.contains(*here)) return PhysicsEnd::kLoops;
    asked.insert(*here);
    const Result<CellIndex> cell = model.grid.cell_at(agent.seen(driven));
    if (!cell) return PhysicsEnd::kOutsideSafeSet;
    if (driven.seconds() >= end_s) return PhysicsEnd::kTimeUp;
    if (*cell == model.goal) {
      // It takes itself to be there: it rests, and looks again.
      driven.wait(kSamplesPerCell);
      continue;
    }
    const std::uint8_t action = agent.action(*cell);
    if (action == learning::kNoAction) {
      return model.safe.contains(*cell) ? PhysicsEnd::kDeadEnd : PhysicsEnd::kOutsideSafeSet;
    }
    const auto next = model.grid.neighbour(*cell, static_cast<spatial::Action>(action));
    const bool reached = driven.go(model.grid.centre(*next), kSamplesPerCell);
    if (!driven.holds()) return PhysicsEnd::kDrops;
    if (!reached) return PhysicsEnd::kOutOfReach;
    ++result.steps;
    const Result<CellIndex> after = model.grid.cell_at(driven.tip());
    result.outside_steps += after && model.safe.contains(*after) ? 0 : 1;
  }
}

Status check(const learning::Model& model, const std::vector<CellIndex>& starts, const PhysicsOptions& options,
             const PhysicsRollouts& rollouts) {
  if (options.threads < 1 || options.threads > 64) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} threads were asked for; 1 … 64 are possible", options.threads));
  }
  if (!std::isfinite(options.time_limit_s) || options.time_limit_s <= 0.0) {
    return fail(ErrorCode::kInvalidArgument, "the time limit is not positive");
  }
  const Perturbation& how = options.perturbed;
  const auto within = [](double value, double most) { return value >= 0.0 && value <= most; };
  if (!within(how.epsilon, 1.0) || !within(how.delay_s, kMostDelay_s) || !within(how.noise_m, kMostNoise_m)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("ε must lie in 0 … 1, the delay in 0 … {} s and the noise in 0 … {} mm", kMostDelay_s,
                            1e3 * kMostNoise_m));
  }
  if (rollouts.size() != starts.size()) {
    return fail(ErrorCode::kInvalidArgument, "there are other rollouts kept than there are starts");
  }
  const auto outside = [&model](CellIndex c) { return c.value < 0 || c.value >= model.grid.cell_count(); };
  if (std::any_of(starts.begin(), starts.end(), outside)) {
    return fail(ErrorCode::kInvalidArgument, "a start is outside of the lattice");
  }
  return {};
}

}  // namespace

std::string_view to_string(PhysicsEnd end) {
  constexpr std::array<std::string_view, kPhysicsEnds> kNames{
      "arrives", "loops", "dead end", "outside the safe set", "out of reach", "time up", "drops the block"};
  return kNames[static_cast<std::size_t>(end)];
}

PhysicsRollout physics_rollout(const learning::Model& model, const std::vector<std::uint8_t>& policy, CellIndex start,
                               const PhysicsOptions& options, const std::string& world, const RolloutWatcher& watch) {
  Driven driven(options, world);
  PhysicsRollout result;
  if (!lead(driven, place_of(model, start, options)) || !driven.holds()) {
    result.end = driven.holds() ? PhysicsEnd::kOutOfReach : PhysicsEnd::kDrops;
    result.state_hash = driven.hash();
    return result;
  }
  const double begin_s = driven.seconds();
  const Places before = blocks_of(driven.state());
  driven.measure_from_here();
  driven.show_to(watch);
  Perturbed agent(model, policy, options, start);
  result.end = follow(model, agent, begin_s + options.time_limit_s, driven, result);
  result.duration_s = driven.seconds() - begin_s;
  result.length_m = driven.length_m();
  const Places after = blocks_of(driven.state());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (driven.carried() == static_cast<int>(i)) continue;
    result.pushed_m = std::max(result.pushed_m, (after[i] - before[i]).norm());
  }
  result.state_hash = driven.hash();
  if (watch) driven.wait(kAfterwards);
  return result;
}

bool same_runs(const PhysicsOptions& a, const PhysicsOptions& b) {
  return a.seed == b.seed && a.segment == b.segment && a.block == b.block && a.goal == b.goal &&
         a.perturbed == b.perturbed && a.continuous == b.continuous && a.time_limit_s == b.time_limit_s;
}

int finished(const PhysicsRollouts& rollouts) {
  return static_cast<int>(std::count_if(rollouts.begin(), rollouts.end(), [](const auto& one) { return one; }));
}

Status run_physics(const learning::Model& model, const std::vector<CellIndex>& starts, const PhysicsOptions& options,
                   PhysicsRollouts& rollouts, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(model, starts, options, rollouts));
  TransferOptions transfer;
  transfer.seed = options.seed;
  transfer.block = options.block;
  transfer.goal = options.goal;
  const Result<std::string> world = segment_world(options.segment, transfer, progress);
  // Stopped before the first: nothing was run, which is no error.
  if (!world && world.error().code() == ErrorCode::kCancelled) return {};
  if (!world) return tl::unexpected(world.error());
  const std::vector<std::uint8_t> policy = learning::greedy_policy(model);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < rollouts.size(); ++i) {
    if (!rollouts[i]) missing.push_back(i);
  }
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{rollouts.size() - missing.size()};
  const auto work = [&] {
    while (!progress.cancelled()) {
      const std::size_t at = next.fetch_add(1);
      if (at >= missing.size()) return;
      rollouts[missing[at]] = physics_rollout(model, policy, starts[missing[at]], options, *world);
      progress.set(static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(rollouts.size()));
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < options.threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return {};
}

}  // namespace trocar::trial
