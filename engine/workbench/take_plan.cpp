#include "engine/workbench/take_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/trial/arm_drive.h"
#include "engine/trial/sampling.h"

namespace trocar::workbench {
namespace {

using demonstration::Demonstration;
using demonstration::kTicksPerSample;

/// What both arms were told from one instant to another, every 5 ticks; where edits left gaps, interpolated as a replay
/// would.
trial::Setpoints setpoints_of(const Demonstration& shown, std::int64_t from_tick, std::int64_t to_tick) {
  trial::Setpoints setpoints;
  const demonstration::SampleTrack& track = shown.samples;
  for (std::int64_t tick = from_tick; tick <= to_tick; tick += kTicksPerSample) {
    const std::size_t after = std::min(track.lower_bound(tick), track.size() - 1);
    const demonstration::Sample next = track[after];
    const demonstration::Sample last = after > 0 && next.tick > tick ? track[after - 1] : next;
    const int count = static_cast<int>(std::max<std::int64_t>(next.tick - last.tick, 1));
    const int sub = std::clamp(static_cast<int>(tick - last.tick), 0, count);
    std::array<control::ToolCommand, 2> both;
    for (std::size_t i = 0; i < 2; ++i) {
      const control::ToolCommand from = trial::recorded_setpoint(last.arms[i]);
      both[i] = sub == 0 ? from : trial::between(from, trial::recorded_setpoint(next.arms[i]), sub, count);
    }
    setpoints.push_back(both);
  }
  return setpoints;
}

Result<std::shared_ptr<const Demonstration>> find(const Project& project, DemonstrationId id) {
  const auto found = project.demonstrations.find(id);
  if (found != project.demonstrations.end()) return found->second;
  return fail(ErrorCode::kNotFound, fmt::format("there is no demonstration {}", id.value));
}

/// Those that do not replay what is there.
Result<demonstration::Arms> recorded_arms(const std::array<trial::ArmSource, 2>& sources) {
  const bool left = sources[0] != trial::ArmSource::kReplay;
  const bool right = sources[1] != trial::ArmSource::kReplay;
  if (left && right) return demonstration::Arms::kBoth;
  if (left) return demonstration::Arms::kLeft;
  if (right) return demonstration::Arms::kRight;
  return fail(ErrorCode::kInvalidArgument, "both arms replay what is there: nothing would be replaced");
}

}  // namespace

Result<Eigen::Vector3d> place_of(const FromCell& from) {
  if (from.grid < 1 || from.grid > 176) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a lattice has 1 to 176 cells a side, not {}", from.grid));
  }
  const spatial::Grid grid = spatial::Grid::with_cells(from.grid);
  const spatial::CellCoordinates& c = from.cell;
  if (!grid.contains(c)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("there is no cell {}, {}, {} in a lattice of {} a side", c.x, c.y, c.z, from.grid));
  }
  spatial::Pose X_WT = kinematics::ready_pose(kinematics::ArmSide::kLeft);
  X_WT.p = grid.centre(grid.index(c));
  const auto joints = kinematics::inverse(kinematics::psm_model(kinematics::ArmSide::kLeft), X_WT);
  if (joints) return X_WT.p;
  return tl::unexpected<Error>(Error(joints.error()).in(fmt::format("begin in cell {}, {}, {}", c.x, c.y, c.z)));
}

RecordByHand another_take(RecordByHand request) {
  const auto& sources = request.options.sources;
  request.name.clear();
  request.punch.reset();
  if (std::find(sources.begin(), sources.end(), trial::ArmSource::kReplay) == sources.end()) request.replayed = {};
  return request;
}

std::string take_name(const Project& project, const std::string& word) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{} {}", word, number);
    const auto& all = project.demonstrations;
    if (std::none_of(all.begin(), all.end(), [&name](const auto& entry) { return entry.second->name == name; })) {
      return name;
    }
  }
}

Result<TakePlan> plan_take(const Project& project, const RecordByHand& request) {
  TakePlan plan;
  plan.options = request.options;
  plan.options.device = "keyboard and mouse";
  if (request.gamepad) plan.options.device += ", gamepad";
  if (request.space_mouse) plan.options.device += ", SpaceMouse";
  plan.name = request.name.empty() ? take_name(project, request.from ? "Corrective" : "By hand") : request.name;
  if (request.from) {
    if (request.punch) return fail(ErrorCode::kInvalidArgument, "a punch-in begins where the span does, not in a cell");
    TROCAR_ASSIGN_OR_RETURN(plan.options.begin_p_WT[0], place_of(*request.from));
    if (request.from->segment != demonstration::Segment::kA) plan.options.begin_segment = request.from->segment;
  }
  if (!request.replayed.value) {
    if (request.punch) return fail(ErrorCode::kInvalidArgument, "a punch-in needs a demonstration to go into");
    return plan;
  }
  TROCAR_ASSIGN_OR_RETURN(const auto shown, find(project, request.replayed));
  std::optional<TimeSpan> span = TimeSpan{shown->begin_s, shown->end_s};
  if (request.punch) span = kept_within(*shown, *request.punch);
  if (!span || shown->samples.empty()) return fail(ErrorCode::kInvalidArgument, "there is nothing in that span");

  const std::int64_t first = shown->samples.tick(0);
  const std::int64_t begin = std::max(first, shown->tick_from(span->begin_s));
  // The sample at the end of a span is not in it, unless it is the last there is.
  const bool to_the_gate = span->end_s >= shown->end_s;
  const std::int64_t after = to_the_gate ? shown->tick_after(span->end_s) : shown->tick_from(span->end_s);
  const std::int64_t end = std::max(begin, after - (to_the_gate ? 1 : kTicksPerSample));
  plan.options.block = std::max(shown->block, 0);
  plan.options.goal = std::max(shown->goal, 0);
  plan.options.replay = setpoints_of(*shown, begin, end);
  plan.options.replay_of = shown->name;
  if (!shown->recording->initial_world.empty()) {
    plan.options.seed = shown->recording->provenance.seed;
    plan.options.initial_world = shown->recording->initial_world;
    // The world is at the first sample already.
    plan.options.lead_in = setpoints_of(*shown, first + kTicksPerSample, begin);
  }
  if (request.punch) {
    const double length_s = std::max(Tick{end - begin}.seconds(), 0.005);
    plan.options.pre_roll = false;  // what comes before the span is there already
    plan.options.time_limit_s = std::min(length_s, request.options.time_limit_s);
    TROCAR_ASSIGN_OR_RETURN(const demonstration::Arms arms, recorded_arms(request.options.sources));
    plan.target = TakeTarget{request.replayed, *span, arms};
    if (request.name.empty()) plan.name = take_name(project, shown->name + ", take");
  }
  return plan;
}

}  // namespace trocar::workbench
