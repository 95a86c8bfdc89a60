#include "engine/simulation/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/simulation/pair_loop.h"
#include "engine/simulation/world_memory.h"
#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

namespace trocar::simulation {
namespace {

using kinematics::ArmSide;
using kinematics::index_of;
using kinematics::Joints;
using kinematics::kArmSides;

constexpr double kRestSpeed_mps = 0.001;
constexpr double kRestTurn_rad_s = 0.15;
constexpr double kRestTime_s = 0.1;
constexpr double kWakeDistance_m = 0.025;
/// Nothing on the board moves this fast; what does was squeezed where there is no room.
constexpr double kHighestSpeed_mps = 5.0;
/// Jaws follow commands that jump, but only so fast.
constexpr double kFastestJaw_mps = 90.0;

/// False for numbers that are not finite, too.
bool moves_within(dBodyID body, double speed_mps) {
  constexpr double kHighestTurn_rad_s = 1000.0;
  return from_ode(dBodyGetLinearVel(body)).norm() <= speed_mps &&
         kOdeLength * from_ode(dBodyGetAngularVel(body)).norm() <= kHighestTurn_rad_s;
}

ArmPosture posture_of(const kinematics::PsmModel& model, const spatial::Pose& X_WT, const Joints& joints) {
  return {X_WT, kinematics::skeleton(model, joints)};
}

Status check_jaw(const kinematics::PsmModel& model, double jaw_rad) {
  if (!std::isfinite(jaw_rad)) return fail(ErrorCode::kInvalidArgument, "the jaws' opening is not finite");
  const double beyond = std::max(model.jaw.low - jaw_rad, jaw_rad - model.jaw.high);
  if (beyond <= 0.0) return {};
  return fail(ErrorCode::kOutOfReach,
              fmt::format("the jaws would be {:.1f}° beyond their limit of {:.0f}°", spatial::to_degrees(beyond),
                          spatial::to_degrees(jaw_rad < model.jaw.low ? model.jaw.low : model.jaw.high)));
}

}  // namespace

struct World::Impl {
  explicit Impl(const WorldOptions& world_options);

  void step();
  void drive_arm(std::size_t arm, bool touching);
  PairLoopInput pair_loop_input() const;
  void note(const Touches& touches);
  void wake_near_grippers();
  void rest();
  void hold_back();
  void update_state();
  void update_arm(std::size_t arm);
  WorldMemory remember() const;
  void recall(const WorldMemory& memory);

  WorldOptions options;
  double step_s;
  Random random;
  std::array<kinematics::PsmModel, 2> models{kinematics::psm_model(ArmSide::kLeft),
                                             kinematics::psm_model(ArmSide::kRight)};
  Physics physics = make_physics();
  PairLoop pair_loop;
  std::array<ArmPosture, 2> postures;
  std::array<Joints, 2> setpoint_joints{};
  std::array<std::int32_t, peg_board::kBlockCount> rest_ticks{};
  std::array<bool, peg_board::kBlockCount> near_gripper{};
  std::array<bool, peg_board::kBlockCount> touches_shaft{};
  WorldState state;
};

World::Impl::Impl(const WorldOptions& world_options)
    : options(world_options), step_s(1.0 / world_options.ticks_per_second), random(world_options.seed) {
  TROCAR_CHECK(options.ticks_per_second >= 250 && Tick::kPerSecond % options.ticks_per_second == 0);
  for (std::size_t i = 0; i < physics.blocks.size(); ++i) {
    spatial::Pose X_WK = spatial::Pose::translation(peg_board::start_peg(static_cast<int>(i)));
    X_WK.p.z() = peg_board::kBlockRest_m;
    X_WK.q = spatial::about_z(spatial::from_degrees(random.uniform(-30.0, 30.0)));
    set_pose(physics.blocks[i].body.get(), X_WK);
    state.blocks[i].touches_scene = true;
  }
  for (const ArmSide side : kArmSides) {
    const std::size_t arm = index_of(side);
    spatial::Pose X_WT = kinematics::ready_pose(side);
    if (side == ArmSide::kLeft && options.left_begin_p_WT) X_WT.p = *options.left_begin_p_WT;
    const Result<Joints> joints = kinematics::inverse(models[arm], X_WT);
    TROCAR_CHECK(joints.has_value());
    state.arms[arm].setpoint = {X_WT, 0.0};
    state.arms[arm].X_WT = X_WT;
    state.arms[arm].joints = *joints;
    setpoint_joints[arm] = *joints;
    postures[arm] = posture_of(models[arm], X_WT, *joints);
    place(physics.grippers[arm], postures[arm], 0.0);
  }
  update_state();
}

/// Blocks near a gripper are about to be touched and must not sleep.
void World::Impl::wake_near_grippers() {
  for (std::size_t i = 0; i < physics.blocks.size(); ++i) {
    near_gripper[i] = false;
    for (const ArmPosture& posture : postures) {
      const double distance = distance_to_segment(state.blocks[i].X_WK.p, posture.skeleton[2], posture.skeleton[3]);
      near_gripper[i] = near_gripper[i] || distance < kWakeDistance_m;
    }
    if (!near_gripper[i]) continue;
    rest_ticks[i] = 0;
    dBodyEnable(physics.blocks[i].body.get());
  }
}

/// Puts blocks to sleep that have been at rest for long enough.
void World::Impl::rest() {
  const auto needed = static_cast<std::int32_t>(std::lround(kRestTime_s / step_s));
  for (std::size_t i = 0; i < physics.blocks.size(); ++i) {
    dBodyID body = physics.blocks[i].body.get();
    if (dBodyIsEnabled(body) == 0) continue;
    const bool slow = from_ode(dBodyGetLinearVel(body)).norm() < kRestSpeed_mps &&
                      kOdeLength * from_ode(dBodyGetAngularVel(body)).norm() < kRestTurn_rad_s;
    const bool touched = near_gripper[i] || touches_shaft[i] || !state.blocks[i].touches_scene;
    rest_ticks[i] = slow && !touched ? rest_ticks[i] + 1 : 0;
    if (rest_ticks[i] < needed) continue;
    dBodySetLinearVel(body, 0.0, 0.0, 0.0);
    dBodySetAngularVel(body, 0.0, 0.0, 0.0);
    dBodyDisable(body);
  }
}

/// Stops what the solver threw out of a squeeze, puts jaws that were torn off their hinge back, and counts both.
void World::Impl::hold_back() {
  for (const Block& block : physics.blocks) {
    if (moves_within(block.body.get(), kHighestSpeed_mps)) continue;
    ++state.strained;
    dBodySetLinearVel(block.body.get(), 0.0, 0.0, 0.0);
    dBodySetAngularVel(block.body.get(), 0.0, 0.0, 0.0);
  }
  for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) {
    const Gripper& gripper = physics.grippers[arm];
    const bool sound = std::all_of(gripper.jaws.begin(), gripper.jaws.end(), [&](const Jaw& jaw) {
      const Eigen::Vector3d from_tip = from_ode(dBodyGetPosition(jaw.body.get())) - postures[arm].X_WT.p;
      return moves_within(jaw.body.get(), kFastestJaw_mps) && from_tip.norm() < kJawFromTip_m;
    });
    if (sound) continue;
    ++state.strained;
    place(gripper, postures[arm], 0.0);
  }
}

/// Lets an arm that stands still and touches nothing out of the step; sets all others in motion.
void World::Impl::drive_arm(std::size_t arm, bool touching) {
  const Gripper& gripper = physics.grippers[arm];
  const ArmCommand& setpoint = state.arms[arm].setpoint;
  if (setpoint.X_WT == postures[arm].X_WT) {
    if (!touching && jaws_settled(gripper, setpoint.jaw_rad)) return pause(gripper);
    set_motion(gripper, postures[arm], postures[arm], step_s);
  } else {
    const ArmPosture next = posture_of(models[arm], setpoint.X_WT, setpoint_joints[arm]);
    set_motion(gripper, postures[arm], next, step_s);
    postures[arm] = next;
    state.arms[arm].joints = setpoint_joints[arm];
  }
  drive_jaws(gripper, setpoint.jaw_rad, options.grip_torque_nm, step_s);
}

void World::Impl::step() {
  prepare_ode_for_this_thread();
  const std::int64_t complaints = ode_complaints_in_this_thread();
  for (const Gripper& gripper : physics.grippers) resume(gripper);
  wake_near_grippers();
  const Touches touches = pair_loop.connect(physics, pair_loop_input());
  for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) drive_arm(arm, touches.arms[arm]);
  dWorldStep(physics.world(), step_s);
  dJointGroupEmpty(physics.contacts.get());
  for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) settle(physics.grippers[arm], postures[arm]);
  note(touches);
  hold_back();
  rest();
  state.strained += ode_complaints_in_this_thread() - complaints;
  state.tick.count += Tick::kPerSecond / options.ticks_per_second;
  update_state();
}

PairLoopInput World::Impl::pair_loop_input() const {
  PairLoopInput input;
  input.postures = postures;
  input.jaw_friction = options.jaw_friction;
  input.scene_friction = options.scene_friction;
  input.step_s = step_s;
  for (std::size_t arm = 0; arm < state.arms.size(); ++arm) input.openings_rad[arm] = state.arms[arm].jaw_rad;
  for (std::size_t i = 0; i < rest_ticks.size(); ++i) input.fast[i] = !state.blocks[i].asleep && rest_ticks[i] == 0;
  return input;
}

/// Takes the contacts of this tick over into the state; a block that sleeps keeps what it touched.
void World::Impl::note(const Touches& touches) {
  for (std::size_t i = 0; i < touches.blocks.size(); ++i) {
    BlockState& block = state.blocks[i];
    touches_shaft[i] = touches.blocks[i].shaft;
    if (dBodyIsEnabled(physics.blocks[i].body.get()) == 0) continue;
    block.jaw_contact = touches.blocks[i].jaws;
    block.touches_scene = touches.blocks[i].scene;
  }
}

void World::Impl::update_arm(std::size_t arm) {
  ArmState& shown = state.arms[arm];
  shown.X_WT = postures[arm].X_WT;
  shown.jaw_rad = opening(physics.grippers[arm]);
}

void World::Impl::update_state() {
  for (std::size_t arm = 0; arm < state.arms.size(); ++arm) update_arm(arm);
  for (std::size_t i = 0; i < physics.blocks.size(); ++i) {
    dBodyID body = physics.blocks[i].body.get();
    BlockState& block = state.blocks[i];
    block.X_WK = pose_of(body);
    block.v_WK = from_ode(dBodyGetLinearVel(body));
    block.w_WK = kOdeLength * from_ode(dBodyGetAngularVel(body));
    block.asleep = dBodyIsEnabled(body) == 0;
  }
}

WorldMemory World::Impl::remember() const {
  WorldMemory memory;
  memory.tick = state.tick.count;
  memory.strained = state.strained;
  memory.random = random.state();
  for (std::size_t arm = 0; arm < state.arms.size(); ++arm) {
    ArmMemory& stored = memory.arms[arm];
    stored.setpoint = state.arms[arm].setpoint;
    stored.setpoint_joints = setpoint_joints[arm];
    stored.X_WT = state.arms[arm].X_WT;
    stored.joints = state.arms[arm].joints;
    for (std::size_t i = 0; i < 2; ++i) stored.jaws[i] = read_bits(physics.grippers[arm].jaws[i].body.get());
  }
  for (std::size_t i = 0; i < physics.blocks.size(); ++i) {
    const BlockState& block = state.blocks[i];
    memory.blocks[i] = {read_bits(physics.blocks[i].body.get()), rest_ticks[i], block.asleep, block.touches_scene,
                        block.jaw_contact};
  }
  return memory;
}

void World::Impl::recall(const WorldMemory& memory) {
  state.tick.count = memory.tick;
  state.strained = memory.strained;
  random = Random(memory.random);
  for (std::size_t arm = 0; arm < state.arms.size(); ++arm) {
    const ArmMemory& stored = memory.arms[arm];
    state.arms[arm].setpoint = stored.setpoint;
    state.arms[arm].joints = stored.joints;
    setpoint_joints[arm] = stored.setpoint_joints;
    postures[arm] = posture_of(models[arm], stored.X_WT, stored.joints);
    settle(physics.grippers[arm], postures[arm]);
    for (std::size_t i = 0; i < 2; ++i) write_bits(physics.grippers[arm].jaws[i].body.get(), stored.jaws[i]);
  }
  for (std::size_t i = 0; i < physics.blocks.size(); ++i) {
    const BlockMemory& stored = memory.blocks[i];
    dBodyID body = physics.blocks[i].body.get();
    write_bits(body, stored.body);
    stored.asleep ? dBodyDisable(body) : dBodyEnable(body);
    rest_ticks[i] = stored.rest_ticks;
    state.blocks[i].touches_scene = stored.touches_scene;
    state.blocks[i].jaw_contact = stored.jaw_contact;
  }
  update_state();
}

World::World(const WorldOptions& options) : impl_(std::make_unique<Impl>(options)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Status World::command(kinematics::ArmSide side, const ArmCommand& command) {
  const std::size_t arm = index_of(side);
  const kinematics::PsmModel& model = impl_->models[arm];
  TROCAR_RETURN_IF_ERROR(check_jaw(model, command.jaw_rad));
  TROCAR_ASSIGN_OR_RETURN(impl_->setpoint_joints[arm], kinematics::inverse(model, command.X_WT));
  impl_->state.arms[arm].setpoint = command;
  return {};
}

void World::step() {
  impl_->step();
}

const WorldState& World::state() const {
  return impl_->state;
}

const WorldOptions& World::options() const {
  return impl_->options;
}

WorldSnapshot World::snapshot() const {
  return {encode(impl_->options, impl_->remember())};
}

Status World::restore(const WorldSnapshot& snapshot) {
  prepare_ode_for_this_thread();
  TROCAR_ASSIGN_OR_RETURN(const StoredWorld stored, decode(snapshot.bytes));
  const WorldOptions& mine = impl_->options;
  const WorldOptions& theirs = stored.options;
  if (mine.jaw_friction != theirs.jaw_friction || mine.scene_friction != theirs.scene_friction ||
      mine.grip_torque_nm != theirs.grip_torque_nm || mine.ticks_per_second != theirs.ticks_per_second) {
    return fail(ErrorCode::kInvalidArgument, "the snapshot is of a world with other physics options");
  }
  impl_->options.seed = theirs.seed;
  impl_->recall(stored.memory);
  return {};
}

std::uint64_t World::state_hash() const {
  const std::string bytes = encode(impl_->options, impl_->remember());
  return Hasher().text(std::string_view(bytes).substr(memory_offset())).digest();
}

}  // namespace trocar::simulation
