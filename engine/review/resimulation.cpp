#include "engine/review/resimulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/world.h"
#include "engine/spatial/units.h"
#include "engine/trial/arm_drive.h"
#include "engine/trial/sampling.h"
#include "engine/trial/task.h"

namespace trocar::review {
namespace {

using namespace demonstration;
using kinematics::ArmSide;

constexpr double kLeadSpeed_m_s = 0.05;
constexpr double kLeadTurn_rad_s = 1.0;
/// From anywhere within reach; what is farther away is refused and not waited for.
constexpr double kLongestLead_s = 20.0;
constexpr int kHoldTicks = 500;

Status check(const Demonstration& document) {
  if (!document.recording || document.recording->initial_world.empty()) {
    return fail(ErrorCode::kInvalidArgument,
                "it cannot be simulated: nobody knows the world in which it began, as in imports");
  }
  const auto exists = [](int place) { return place >= 0 && place < peg_board::kBlockCount; };
  if (!exists(document.block) || !exists(document.goal)) {
    return fail(ErrorCode::kInvalidArgument, "it cannot be simulated: it is not known which block goes to which peg");
  }
  if (document.samples.empty()) return fail(ErrorCode::kInvalidArgument, "it has no samples");
  return {};
}

using Commands = std::array<control::ToolCommand, 2>;

Commands commands_of(const Sample& sample) {
  return {trial::recorded_setpoint(sample.arms[0]), trial::recorded_setpoint(sample.arms[1])};
}

/// Drives one world and watches the block.
class Driver {
 public:
  Driver(const Demonstration& document, simulation::World world)
      : document_(document), world_(std::move(world)), task_(document.block, document.goal) {}

  /// From where the arms are to the first setpoints, so slowly that nothing is thrown about.
  void lead_to(const Commands& first) {
    Commands now;
    double seconds = 0.0;
    for (const ArmSide side : kinematics::kArmSides) {
      const std::size_t i = kinematics::index_of(side);
      const simulation::ArmCommand& setpoint = world_.state().arm(side).setpoint;
      now[i] = {setpoint.X_WT, setpoint.jaw_rad};
      seconds = std::max({seconds, (first[i].X_WT.p - now[i].X_WT.p).norm() / kLeadSpeed_m_s,
                          spatial::angle_between(first[i].X_WT.q, now[i].X_WT.q) / kLeadTurn_rad_s,
                          std::abs(first[i].jaw_rad - now[i].jaw_rad) / kLeadTurn_rad_s});
    }
    const int ticks = static_cast<int>(std::ceil(std::min(seconds, kLongestLead_s) * 1000.0));
    for (int sub = 1; sub <= ticks; ++sub) command(now, first, sub, ticks);
    zero_tick_ = world_.state().tick.count;
    watch();
  }

  /// Stops early when `progress` is cancelled, as gaps may be long.
  void follow(const Sample& from, const Sample& to, const Progress& progress) {
    const Commands before = commands_of(from);
    const Commands after = commands_of(to);
    const int count = static_cast<int>(to.tick - from.tick);
    for (int sub = 1; sub <= count; ++sub) {
      if (sub % 1000 == 0 && progress.cancelled()) return;
      command(before, after, sub, count);
      if ((world_.state().tick.count - zero_tick_) % kTicksPerSample == 0) watch();
    }
    if (refused_now_) ++result_.refused;
    refused_now_ = false;
  }

  Resimulation finish(const Commands& last) {
    for (int i = 1; i <= kHoldTicks; ++i) {
      command(last, last, 1, 1);
      if (i % kTicksPerSample == 0) watch();
    }
    result_.outcome = task_.outcome();
    result_.placed = task_.placed();
    result_.lifted = task_.lift_attempted();
    if (task_.decided_at()) result_.decided_at_s = time_of(task_.decided_at()->count);
    const Eigen::Vector3d p_WK = block().X_WK.p;
    const Eigen::Vector3d goal = peg_board::goal_peg(document_.goal);
    result_.from_goal_m = std::hypot(p_WK.x() - goal.x(), p_WK.y() - goal.y());
    return result_;
  }

 private:
  const simulation::BlockState& block() const {
    return world_.state().blocks[static_cast<std::size_t>(document_.block)];
  }
  double time_of(std::int64_t tick) const {
    return Tick{tick - zero_tick_ + document_.samples.tick(0) - document_.first_tick()}.seconds();
  }
  void command(const Commands& from, const Commands& to, int sub, int count) {
    for (const ArmSide side : kinematics::kArmSides) {
      const std::size_t i = kinematics::index_of(side);
      const control::ToolCommand wanted = trial::between(from[i], to[i], sub, count);
      if (!world_.command(side, {wanted.X_WT, wanted.jaw_rad})) refused_now_ = true;
    }
    world_.step();
  }
  void watch() {
    task_.update(world_.state());
    // What is touched after it fell says nothing of the fall.
    if (task_.outcome() == Outcome::kDropped) return;
    for (const ArmSide side : kinematics::kArmSides) {
      if (!block().touched_by(side)) continue;
      result_.last_touch_s = time_of(world_.state().tick.count);
      result_.last_arm = static_cast<int>(kinematics::index_of(side));
      result_.last_p_WK = block().X_WK.p;
    }
  }

  const Demonstration& document_;
  simulation::World world_;
  trial::Task task_;
  std::int64_t zero_tick_ = 0;
  bool refused_now_ = false;
  Resimulation result_;
};

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("({:.0f}, {:.0f}, {:.0f}) mm", spatial::to_mm(p.x()), spatial::to_mm(p.y()),
                     spatial::to_mm(p.z()));
}

std::string sentence(const Demonstration& document, const Resimulation& found) {
  const char* arm = found.last_arm == 0 ? "left" : "right";
  const double decided_s = found.decided_at_s.value_or(0.0);
  std::string text;
  if (found.transferred()) {
    text = fmt::format("block {} is transferred: handed over at {:.2f} s, seated on goal peg {} at the end",
                       document.block, decided_s, document.goal);
  } else if (found.outcome == Outcome::kSuccess) {
    text = fmt::format(
        "block {} is handed over at {:.2f} s but does not get onto goal peg {}: the {} arm touches it "
        "last at {:.2f} s at {}, and it ends {:.1f} mm from the peg",
        document.block, decided_s, document.goal, arm, found.last_touch_s, place(found.last_p_WK),
        spatial::to_mm(found.from_goal_m));
  } else if (found.outcome == Outcome::kDropped) {
    text = fmt::format("block {} is dropped: the {} arm loses it at {:.2f} s at {}", document.block, arm,
                       found.last_touch_s, place(found.last_p_WK));
  } else if (found.lifted) {
    text = fmt::format("block {} is lifted but not handed over by the end", document.block);
  } else if (found.last_arm >= 0) {
    text = fmt::format("block {} is touched by the {} arm, the last time at {:.2f} s, but never lifted", document.block,
                       arm, found.last_touch_s);
  } else {
    text = fmt::format("block {} is never touched", document.block);
  }
  if (found.refused > 0) text += fmt::format("; {} setpoints are out of reach and were not followed", found.refused);
  return text;
}

}  // namespace

Result<Resimulation> resimulate(const Demonstration& document, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(document));
  simulation::WorldOptions options;
  options.seed = document.recording->provenance.seed;
  simulation::World world(options);
  if (Status restored = world.restore({document.recording->initial_world}); !restored) {
    return tl::unexpected(std::move(restored).error().in("restore the recording's initial world"));
  }
  const SampleTrack samples =
      document.samples_within(Tick{document.samples.tick(0) - document.first_tick()}.seconds(), document.end_s);
  if (samples.empty()) return fail(ErrorCode::kInvalidArgument, "it has no samples");
  Driver driver(document, std::move(world));
  Sample before = samples.front();
  driver.lead_to(commands_of(before));
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the simulation was stopped");
    const Sample sample = samples[i];
    driver.follow(before, sample, progress);
    before = sample;
    if (i % 20 == 0) progress.set(static_cast<double>(i) / static_cast<double>(samples.size()));
  }
  Resimulation result = driver.finish(commands_of(before));
  result.sentence = sentence(document, result);
  progress.set(1.0);
  return result;
}

}  // namespace trocar::review
