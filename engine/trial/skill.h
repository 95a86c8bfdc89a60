/// How well a scripted operator sees, aims and moves: the numbers behind expert, trained and novice.
#pragma once

#include <string_view>

#include "engine/core/result.h"

namespace trocar::trial {

enum class Skill { kExpert, kTrained, kNovice };
std::string_view to_string(Skill skill);
/// Errors: kInvalidArgument with the names that there are.
Result<Skill> skill_from(std::string_view text);

/// Hand quantities are at the hand controller, all others at the tool. σ is a standard deviation.
struct SkillParameters {
  double reaction_s = 0.12;            ///< From seeing to beginning to act.
  double visual_delay_s = 0.10;        ///< Age of what is seen.
  double hesitation_s = 0.15;          ///< Mean pause between steps of the task.
  double fitts_a_s = 0.18;             ///< Movement time = a + b log2(distance / width + 1).
  double fitts_b_s = 0.16;             ///< Seconds for each bit.
  double aim_noise = 0.02;             ///< σ of a submovement's end along its way, as a share of its length.
  double cross_noise = 0.5;            ///< The same across its way, relative to `aim_noise`.
  double depth_weakness = 1.6;         ///< Noise towards and away from the viewer, relative to the picture's plane.
  double turn_noise_rad = 0.02;        ///< σ of a turn's end about each axis.
  double judgement_m = 0.10e-3;        ///< σ of the grasp as judged against the true one, across.
  double depth_judgement_m = 0.20e-3;  ///< The same along the tool.
  double tolerance_m = 0.35e-3;        ///< Aim error that is accepted before the tool goes in.
  double tremor_m = 0.08e-3;           ///< RMS tremor of the hand on each axis, 8–12 Hz.
  double open_rad = 0.30;              ///< Opening to straddle a wall.
  double open_noise_rad = 0.01;        ///< σ of the opening.
  double grip_rad = -0.20;             ///< Jaw command that grips; below contact, the more the firmer.
  double grip_noise_rad = 0.03;        ///< σ of the grip command.
  double relaxing_rad = 0.01;          ///< σ of how far the grip slackens while the mind is on the way.
  double haste = 0.0;                  ///< Chance to let go as soon as the other gripper touches the block.
};

SkillParameters parameters(Skill skill);

}  // namespace trocar::trial
