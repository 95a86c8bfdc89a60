#include "ui/forms/record_form.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

constexpr std::array<trial::Skill, 3> kSkills{trial::Skill::kExpert, trial::Skill::kTrained, trial::Skill::kNovice};

const std::vector<std::string>& skill_names() {
  static const std::vector<std::string> kNames{"Expert", "Trained", "Novice"};
  return kNames;
}

}  // namespace

void RecordForm::prepare(const WorkbenchState& state) {
  demonstrations_.clear();
  replayed_ = 0;
  looked_ = false;
  if (state.project == nullptr) return;
  for (const auto& [id, shown] : state.project->demonstrations) {
    if (id == state.demonstration) replayed_ = static_cast<int>(demonstrations_.size());
    demonstrations_.push_back(id);
  }
  punch_ = punch_ && state.selection.has_value();
}

bool RecordForm::replays() const {
  return std::find(sources_.begin(), sources_.end(), static_cast<int>(trial::ArmSource::kReplay)) != sources_.end();
}

void RecordForm::draw_task(Ui& ui, const std::string& reason) {
  form_label(ui, "Seed");
  number_field(ui, "Seed", seed_, 0, 1'000'000'000,
               {.help = "The same seed gives the same world, and the same script", .reason = reason});
  form_label(ui, "Block");
  slider_int(ui, "Block", block_, 0, 5, "%d", {.help = "Which of the six blocks is carried", .reason = reason});
  form_label(ui, "Goal peg");
  slider_int(ui, "Goal", goal_, 0, 5, "%d", {.help = "Which of the six goal pegs it is put on", .reason = reason});
}

void RecordForm::draw_arms(Ui& ui) {
  // In the order of `trial::ArmSource`.
  static const std::vector<std::string> kSources{"Keys and mouse", "Script", "Replay", "Rest"};
  form_label(ui, "Left arm");
  segmented(ui, "Left arm", sources_[0], kSources,
            {.help = "Keys: W S up and down, A D left and right, E Q away and back, Z X turn, C jaws"});
  form_label(ui, "Right arm");
  segmented(ui, "Right arm", sources_[1], kSources,
            {.help = "Keys: I K up and down, J L left and right, O U away and back, M and comma turn, N jaws"});
}

void RecordForm::draw_replayed(Ui& ui, const WorkbenchState& state) {
  if (!replays() && !state.selection) return;
  std::vector<std::string> names;
  for (const workbench::DemonstrationId id : demonstrations_) {
    const auto found = state.project->demonstrations.find(id);
    names.push_back(found == state.project->demonstrations.end() ? "" : found->second->name);
  }
  if (names.empty()) return;
  replayed_ = std::clamp(replayed_, 0, static_cast<int>(names.size()) - 1);
  if (state.selection) {
    form_label(ui, "Punch in");
    const std::string label =
        fmt::format("Replace {} – {}", seconds(state.selection->begin_s), seconds(state.selection->end_s));
    constexpr std::string_view kHelp =
        "Record only what is selected, in place of what an arm did there. An arm that replays keeps what it did; "
        "nothing moves in time; one step to undo";
    if (checkbox(ui, label, punch_, {.help = kHelp}) && punch_) {
      // Who mends what one arm did wants the other as it was.
      std::replace(sources_.begin(), sources_.end(), static_cast<int>(trial::ArmSource::kScripted),
                   static_cast<int>(trial::ArmSource::kReplay));
    }
  }
  form_label(ui, "Replay of");
  const char* reason = punch_ ? "What is selected is a part of this one" : replays() ? "" : "No arm is replayed";
  combo(ui, "Replay of", replayed_, names,
        {.help = "Its world, and what the replayed arm does in it", .reason = reason});
}

void RecordForm::draw_way(Ui& ui) {
  static const std::vector<std::string> kModes{"Continuous", "Step", "Waypoint"};
  form_label(ui, "Mode");
  segmented(ui, "Mode", mode_, kModes,
            {.help = "Move while a key is held; one cell of 2.5 mm for each press; or set a place, and Enter goes "
                     "there. Shift is fine, V the clutch"});
  form_label(ui, "Countdown, s");
  number_field(ui, "Countdown", countdown_s_, 0, 60, {.help = "0: recording begins at once"});
  form_label(ui, "Pre-roll");
  checkbox(ui, "Keep the last 5 s before it", pre_roll_, {.help = "Of what was done during the countdown"});
}

void RecordForm::draw_devices(Ui& ui, const WorkbenchState& state) {
  form_label(ui, "Also with");
  checkbox(ui, "Gamepad", gamepad_,
           {.help = "Left stick: left, right, away, back; right stick: up, down, turn; A jaws, B clutch, Y other arm, "
                    "right bumper fine",
            .reason = ui.gamepad() ? "" : "No gamepad is connected"});
  form_label(ui, "And with");
  checkbox(ui, "SpaceMouse", space_mouse_,
           {.help = "Push and turn it as the tool shall move; first button jaws, second the other arm",
            .reason = state.space_mouse_missing});
}

workbench::RecordByHand RecordForm::take(const WorkbenchState& state) const {
  workbench::RecordByHand take;
  take.options.sources = {static_cast<trial::ArmSource>(sources_[0]), static_cast<trial::ArmSource>(sources_[1])};
  take.options.mode = static_cast<trial::HandMode>(mode_);
  take.options.skill = kSkills[static_cast<std::size_t>(skill_)];
  take.options.seed = static_cast<std::uint64_t>(seed_);
  take.options.block = block_;
  take.options.goal = goal_;
  take.options.countdown_s = static_cast<double>(countdown_s_);
  take.options.pre_roll = pre_roll_;
  take.gamepad = gamepad_;
  take.space_mouse = space_mouse_ && state.space_mouse_missing.empty();
  take.name = name_;
  if (punch_ && state.selection) {
    take.replayed = state.demonstration;
    take.punch = state.selection;
  } else if (replays() && !demonstrations_.empty()) {
    take.replayed = demonstrations_[static_cast<std::size_t>(replayed_)];
  }
  return take;
}

void RecordForm::draw_by_hand(Ui& ui, const WorkbenchState& state) {
  const bool in_a_world = punch_ || replays();
  draw_arms(ui);
  draw_replayed(ui, state);
  draw_way(ui);
  draw_devices(ui, state);
  draw_task(ui, in_a_world ? "As in the demonstration that is replayed" : "");
  form_label(ui, "Name");
  text_field(ui, "Name", name_, "By hand, and a number");
}

void RecordForm::draw_scripted(Ui& ui) {
  wrapped_text(ui,
               "Two scripted operators carry a block from its peg to a goal peg in the simulator. What they make is "
               "marked as scripted.",
               ui.theme().text_dim);
  ImGui::Dummy({0.0F, ui.px(4)});
  form_label(ui, "Skill");
  segmented(ui, "Skill", skill_, skill_names(), {.help = "How steady the scripted hands are"});
  draw_task(ui, "");
  form_label(ui, "Name");
  text_field(ui, "Name", name_, "From skill and seed");
  form_label(ui, "Speed");
  checkbox(ui, "In real time", realtime_, {.help = "Off: as fast as this machine can"});
}

Requests RecordForm::draw_content(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kWho{"By hand", "Scripted"};
  form_label(ui, "Who");
  segmented(ui, "Who", who_, kWho, {.help = "You, with one arm or both; or two scripted operators"});
  gamepad_ = gamepad_ && ui.gamepad().has_value();
  Requests requests;
  if (who_ == 0) draw_by_hand(ui, state);
  if (who_ != 0) draw_scripted(ui);
  if (!looked_) requests.emplace_back(workbench::Command{workbench::FindDevices{}});
  looked_ = true;
  return requests;
}

Requests RecordForm::draw_arm(Ui& ui, const WorkbenchState& state) {
  const bool in_a_world = punch_ || replays();
  std::string reason = command("record.arm").reason_now(state);
  const auto hand = static_cast<int>(trial::ArmSource::kHand);
  if (reason.empty() && sources_[0] != hand && sources_[1] != hand) reason = "Drive one arm at least";
  if (reason.empty() && in_a_world && demonstrations_.empty()) reason = "There is nothing to replay";
  if (!button(ui, "Arm",
              {.icon = icon::kKeyboard,
               .help = "The countdown runs, then it records; R ends it",
               .reason = reason,
               .width = -1.0F,
               .style = ButtonStyle::kDanger})) {
    return {};
  }
  close();
  return {workbench::Command{take(state)}, ShowPanel{PanelId::kView}};
}

Requests RecordForm::draw_start(Ui& ui, const WorkbenchState& state) {
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

Requests RecordForm::draw_footer(Ui& ui, const WorkbenchState& state) {
  return who_ == 0 ? draw_arm(ui, state) : draw_start(ui, state);
}

}  // namespace trocar::ui
