#include "engine/trial/scripted_operator.h"

#include "engine/control/tool_mapping.h"
#include "engine/demonstration/recording.h"

namespace trocar::trial {
namespace {

// Nobody misjudges by more: the jaw would be seen to stand over the peg, past the wall's end or on the board.
const Eigen::Vector3d kSeen_m{0.0030, 0.0013, 0.0060};

}  // namespace

ScriptedOperator::ScriptedOperator(kinematics::ArmSide side, const Assignment& assignment, const Random& random)
    : side_(side),
      assignment_(assignment),
      name_("scripted " + assignment.skill_name),
      random_(random),
      eyes_(assignment.block, assignment.skill.visual_delay_s),
      hand_(assignment.skill, random.child(2), control::display_rotation(), assignment.scale) {}

HandSample ScriptedOperator::sample(const simulation::WorldState& seen) {
  ++now_;
  if (hand_.busy()) still_since_ = now_;
  think(eyes_.look(seen));
  HandSample hand = hand_.step();
  hand.agent_pedal = agent_pedal_;
  return hand;
}

double ScriptedOperator::step_time_s() const {
  return static_cast<double>(now_ - step_began_) / demonstration::kSampleRate_hz;
}

void ScriptedOperator::begin_step() {
  step_began_ = now_;
  moved_ = false;
}

bool ScriptedOperator::reach(const Glimpse& seen, const Aim& aim) {
  if (hand_.busy()) return false;
  const double still_s = static_cast<double>(now_ - still_since_) / demonstration::kSampleRate_hz;
  // After a movement of this step its result must first be seen; the first movement may follow at once.
  if (moved_ && still_s < loop_s()) return false;
  const spatial::Pose& tool = seen.tool(side_);
  const Eigen::Vector3d error = aim.X_WT.p - tool.p;
  const Eigen::Quaterniond turn = (aim.X_WT.q * tool.q.conjugate()).normalized();
  const double turn_rad = spatial::angle_between(aim.X_WT.q, tool.q);
  if (error.norm() <= aim.tolerance_m && turn_rad <= aim.tolerance_rad) return true;

  Intention intention;
  if (error.norm() > 0.5 * aim.tolerance_m) intention.way_W = error;
  if (turn_rad > 0.5 * aim.tolerance_rad) intention.turn_W = turn;
  intention.width_m = 2.0 * aim.tolerance_m;
  intention.care = aim.care;
  hand_.move(intention);
  moved_ = true;
  return false;
}

void ScriptedOperator::judge_anew() {
  ++attempts_;
  if (assignment_.aim_jitter_m >= 0.0) {
    const double j = assignment_.aim_jitter_m;
    const double x = random_.uniform(-j, j);
    const double y = random_.uniform(-j, j);
    misjudged_T_ = {x, y, random_.uniform(-j, j)};
    return;
  }
  const double x = random_.normal();
  const double y = random_.normal();
  const double z = random_.normal();
  const Eigen::Vector3d error{skill().judgement_m * x, skill().judgement_m * y, skill().depth_judgement_m * z};
  misjudged_T_ = error.cwiseMax(-kSeen_m).cwiseMin(kSeen_m);
}

spatial::Pose shifted(const spatial::Pose& pose, const Eigen::Vector3d& way_W) {
  return {pose.p + way_W, pose.q};
}

}  // namespace trocar::trial
