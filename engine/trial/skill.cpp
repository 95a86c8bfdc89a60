#include "engine/trial/skill.h"

#include <array>
#include <string>
#include <utility>

namespace trocar::trial {
namespace {

constexpr std::array<std::pair<Skill, std::string_view>, 3> kNames{
    {{Skill::kExpert, "expert"}, {Skill::kTrained, "trained"}, {Skill::kNovice, "novice"}}};

SkillParameters trained() {
  SkillParameters p;
  p.reaction_s = 0.18;
  p.visual_delay_s = 0.12;
  p.hesitation_s = 0.45;
  p.fitts_a_s = 0.22;
  p.fitts_b_s = 0.22;
  p.aim_noise = 0.035;
  p.depth_weakness = 2.0;
  p.turn_noise_rad = 0.03;
  p.judgement_m = 0.45e-3;
  p.depth_judgement_m = 1.00e-3;
  p.tolerance_m = 0.50e-3;
  p.tremor_m = 0.14e-3;
  p.open_noise_rad = 0.02;
  p.grip_rad = -0.12;
  p.grip_noise_rad = 0.05;
  p.relaxing_rad = 0.06;
  p.haste = 0.03;
  return p;
}

SkillParameters novice() {
  SkillParameters p;
  p.reaction_s = 0.25;
  p.visual_delay_s = 0.15;
  p.hesitation_s = 1.00;
  p.fitts_a_s = 0.28;
  p.fitts_b_s = 0.38;
  p.aim_noise = 0.08;
  p.depth_weakness = 2.5;
  p.turn_noise_rad = 0.05;
  p.judgement_m = 1.20e-3;
  p.depth_judgement_m = 2.60e-3;
  p.tolerance_m = 1.00e-3;
  p.tremor_m = 0.25e-3;
  p.open_noise_rad = 0.04;
  p.grip_rad = 0.01;
  p.grip_noise_rad = 0.03;
  p.relaxing_rad = 0.06;
  p.haste = 0.15;
  return p;
}

}  // namespace

std::string_view to_string(Skill skill) {
  for (const auto& [value, name] : kNames) {
    if (value == skill) return name;
  }
  return "unknown";
}

Result<Skill> skill_from(std::string_view text) {
  for (const auto& [value, name] : kNames) {
    if (name == text) return value;
  }
  return fail(ErrorCode::kInvalidArgument, "the skill is expert, trained or novice, not \"" + std::string(text) + "\"");
}

SkillParameters parameters(Skill skill) {
  switch (skill) {
    case Skill::kTrained:
      return trained();
    case Skill::kNovice:
      return novice();
    case Skill::kExpert:
      break;
  }
  return {};
}

}  // namespace trocar::trial
