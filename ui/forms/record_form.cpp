#include "ui/forms/record_form.h"

#include <array>
#include <vector>

#include "ui/command_table.h"
#include "ui/icons.h"

namespace trocar::ui {

Requests RecordForm::draw_content(Ui& ui, const WorkbenchState& state) {
  constexpr std::array<trial::Skill, 3> kSkills{trial::Skill::kExpert, trial::Skill::kTrained, trial::Skill::kNovice};
  static const std::vector<std::string> kSkillNames{"Expert", "Trained", "Novice"};
  wrapped_text(ui,
               "Two scripted operators carry a block from its peg to a goal peg in the simulator. What they make is "
               "marked as scripted.",
               ui.theme().text_dim);
  ImGui::Dummy({0.0F, ui.px(4)});
  form_label(ui, "Skill");
  segmented(ui, "Skill", skill_, kSkillNames, {.help = "How steady the scripted hands are"});
  form_label(ui, "Seed");
  number_field(ui, "Seed", seed_, 0, 1'000'000'000, {.help = "The same seed gives the same recording"});
  form_label(ui, "Block");
  slider_int(ui, "Block", block_, 0, 5, "%d", {.help = "Which of the six blocks is carried"});
  form_label(ui, "Goal peg");
  slider_int(ui, "Goal", goal_, 0, 5, "%d", {.help = "Which of the six goal pegs it is put on"});
  form_label(ui, "Name");
  text_field(ui, "Name", name_, "From skill and seed");
  form_label(ui, "Speed");
  checkbox(ui, "In real time", realtime_, {.help = "Off: as fast as this machine can"});
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string reason = command("demo.record").reason_now(state);
  if (!button(ui, "Start recording",
              {.icon = icon::kRecord, .reason = reason, .width = -1.0F, .style = ButtonStyle::kDanger})) {
    return {};
  }
  workbench::RecordScripted record;
  record.options.skill = kSkills[static_cast<std::size_t>(skill_)];
  record.options.seed = static_cast<std::uint64_t>(seed_);
  record.options.block = block_;
  record.options.goal = goal_;
  record.name = name_;
  record.realtime = realtime_;
  ++seed_;  // The next recording is another one.
  close();
  return {workbench::Command{record}};
}

}  // namespace trocar::ui
