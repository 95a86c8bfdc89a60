/// How both arms of a trial move: from who has them to setpoints behind the guards, and to a command for every tick.
#pragma once

#include <array>
#include <string>

#include "engine/trial/guarded_arm.h"
#include "engine/trial/segment_agents.h"
#include "engine/trial/simulated_arm.h"
#include "engine/trial/trial_authority.h"
#include "engine/trial/trial_people.h"
#include "engine/trial/trial_recorder.h"

namespace trocar::trial {

/// Hands and agents become setpoints of the tools, in W, behind a guard each ("Shared control", Teleoperation
/// mathematics and Guard). A setpoint is for the end of a sample, 5 ticks, and is interpolated up to there; where the
/// left arm changes hands in between, or both are to halt, what is left of the sample gets new ones, which go on from
/// where the tool is and as it moves. Decides nothing: who has the left arm it is told. Threads: one at a time.
class TrialMotion {
 public:
  /// Arms both guards. `recorder` gets what agents and guards say, and the samples at which setpoints were cut short.
  /// `world` and `recorder` must outlive it.
  TrialMotion(simulation::World& world, const TrialOptions& options, TrialRecorder& recorder);
  TrialMotion(const TrialMotion&) = delete;
  TrialMotion& operator=(const TrialMotion&) = delete;

  /// Every tick, first: each guard sees its arm, and the link to who commands it. `stop`: pressed, in this tick.
  void look(const TrialPeople& people, bool stop);
  /// Every tick, after the authority has looked: tells both arms where to be at its end. The world is not stepped.
  void advance(const TrialAuthority& authority, const TrialPeople& people, demonstration::Segment segment);

  const control::Guard& guard(kinematics::ArmSide side) const;
  /// What the guards have said since the last time goes into the record.
  void log_guards();
  bool homed(kinematics::ArmSide side) const { return arms_[kinematics::index_of(side)].feedback().homed; }
  /// Why no agent can take the left arm where it is now; "" if one can.
  std::string agent_refusal(demonstration::Segment segment) const;
  /// The agent that moves the left arm; null if none does.
  const Agent* agent() const { return agents_.driving(); }

  /// By `kinematics::index_of`: where the arms were told to be in the last tick …
  std::array<control::ToolCommand, 2> told() const { return {arms_[0].setpoint_cp(), arms_[1].setpoint_cp()}; }
  /// … and where they are told to be at the end of the sample.
  const std::array<control::ToolCommand, 2>& planned() const { return to_; }
  /// Writes what it has counted: clutches, the agents' steps, and how often the left arm was limited or out of reach.
  void count(TrialCounts& counts) const;

  /// The arm says FAULT from here on, as a physical one might.
  void play_fault(kinematics::ArmSide side) { arms_[kinematics::index_of(side)].play(control::OperatingState::kFault); }

 private:
  Tick now() const { return world_->state().tick; }
  /// Of the guards' clock, whose first tick is 1.
  Tick stamp() const { return Tick{now().count + 1}; }
  /// Ticks of the sample that are over.
  int sub() const { return static_cast<int>(now().count % demonstration::kTicksPerSample); }
  GuardedArm& guarded(std::size_t i) { return i == 0 ? left_ : right_; }

  void arm(std::size_t i);
  void show(std::size_t i, control::GuardLook look, const LinkState& link);
  void cut(bool both);
  void hand_over(const TrialAuthority& authority, const HandSample& hand);
  void plan(const TrialAuthority& authority, const TrialPeople& people);
  control::ToolCommand left_setpoint(const TrialAuthority& authority, const TrialPeople& people, double period_s);
  void log_agent(Agent::State state);

  simulation::World* world_;
  TrialRecorder* recorder_;
  std::array<SimulatedArm, 2> arms_;  ///< By `kinematics::index_of`, as all pairs here.
  GuardedArm left_;
  GuardedArm right_;
  SegmentAgents agents_;
  demonstration::Segment segment_ = demonstration::Segment::kA;
  std::array<control::ToolCommand, 2> from_;
  std::array<control::ToolCommand, 2> to_;
  int begun_at_ = 0;                           ///< Where in the sample the plan began …
  int span_ = demonstration::kTicksPerSample;  ///< … and how many ticks it is for.
  std::int64_t limit_hits_ = 0;
  std::int64_t unreachable_ = 0;
};

}  // namespace trocar::trial
