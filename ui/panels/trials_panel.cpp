#include "ui/panels/trials_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/control/delay_model.h"
#include "engine/workbench/jobs/trial_job.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/authority_band.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using trial::Mode;
using workbench::Command;
using workbench::TrialsPhase;

const std::vector<std::string>& protocol_names() {
  static const std::vector<std::string> kNames{"One block", "Simulation study (paper, IV-C1)",
                                               "Study on the dVRK (paper, IV-C2)", "From a file"};
  return kNames;
}
/// As `trial::find_protocol` takes them; after them that of a file.
constexpr std::array<const char*, 3> kProtocols{"", "sim", "dvrk"};
constexpr int kFromFile = 3;

std::string limit_words(const trial::ProtocolBlock& block) {
  std::string words;
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : " or ") + more; };
  if (block.time_s) add(fmt::format("{:.0f} min", *block.time_s / 60.0));
  if (block.transfers) add(counted(static_cast<std::size_t>(*block.transfers), "transfer"));
  if (block.successes) add(fmt::format("{} that succeed", *block.successes));
  return words;
}

void text_setting(Ui& ui, std::string_view shown, std::string_view name, std::string& value,
                  const WidgetOptions& options) {
  form_label(ui, shown);
  text_field(ui, name, value, "", options);
}

}  // namespace

workbench::StartTrials TrialsPanel::request(const WorkbenchState& state) const {
  workbench::StartTrials start;
  start.from = state.trial_start;
  if (start.from && state.project->models.count(start_model_) != 0) start.plan.models = {start_model_};
  workbench::TrialPlan& plan = start.plan;
  plan.options.mode = mode_ == 0 ? Mode::kManual : Mode::kShared;
  plan.options.skill = static_cast<trial::Skill>(skill_);
  plan.options.anchor = static_cast<trial::Anchor>(anchor_);
  plan.options.agent_rate_hz = static_cast<double>(rate_);
  if (const auto delay = control::delay_from(delay_)) plan.options.delay = *delay;
  plan.transfers = static_cast<int>(transfers_);
  plan.seed = static_cast<std::uint64_t>(seed_);
  plan.first_block = static_cast<int>(block_);
  plan.same_block = !in_turn_;
  start.protocol = protocol_ == kFromFile ? protocol_file_ : kProtocols[static_cast<std::size_t>(protocol_)];
  start.person = operator_ == 1;
  if (operator_ != 0) plan.subject = fmt::format("S{}", subject_);
  start.subject_number = static_cast<int>(subject_ - 1);
  start.person_assists = assistant_ == 1;
  if (operator_ == 2) start.console_port = static_cast<std::uint16_t>(port_);
  const bool here = anybody() && operator_ != 2;
  start.gamepad = here && gamepad_;
  start.space_mouse = here && space_mouse_;
  start.realtime = anybody() || realtime_;
  return start;
}

void TrialsPanel::take_start(const WorkbenchState& state) {
  if (start_ == state.trial_start) return;
  start_ = state.trial_start;
  start_model_ = {};
  const auto model = start_ ? selected_model(state) : nullptr;
  if (model == nullptr) return;
  start_model_ = model->id;
  protocol_ = 0;
  transfers_ = 1;
  in_turn_ = false;
  if (model->demonstrations.empty()) return;
  const auto shown = state.project->demonstrations.find(model->demonstrations.front());
  if (shown != state.project->demonstrations.end()) block_ = std::max(shown->second->block, 0);
}

std::string TrialsPanel::reason(const WorkbenchState& state) const {
  if (std::string why = command("trials.start").reason_now(state); !why.empty()) return why;
  if (const auto delay = control::delay_from(delay_); !delay) return delay.error().text();
  if (protocol_ == kFromFile && protocol_file_.empty()) return "Type the file of a protocol";
  // What the blocks of a file need is known when it is read.
  const bool shared = protocol_ == 0 ? mode_ == 1 : protocol_ != kFromFile;
  const bool any = std::any_of(state.project->models.begin(), state.project->models.end(), [](const auto& each) {
    return each.second->segment == demonstration::Segment::kA || each.second->segment == demonstration::Segment::kC;
  });
  if (shared && !any) return "Shared control needs a model: train one of segment A or C";
  const workbench::StartTrials asked = request(state);
  if (protocol_ != 0) return "";
  const Status can = workbench::check_blocks(*state.project, asked.plan, asked.plan.transfers);
  return can ? "" : can.error().text();
}

void TrialsPanel::draw_who(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kOperators{"Script", "Person", "Console"};
  static const std::vector<std::string> kAssistants{"Script", "Person"};
  static const std::vector<std::string> kAtConsole{"Script", "Right hand"};
  static const std::vector<std::string> kSkills{"expert", "trained", "novice"};
  form_label(ui, "Operator");
  segmented(ui, "Operator", operator_, kOperators,
            {.help = "A script, whose trials are marked as scripted everywhere; a person here; or a console over TCP"});
  if (operator_ == 0) {
    form_label(ui, "Skill");
    combo(ui, "Skill", skill_, kSkills, {.help = "How well the script sees, aims and holds"});
  } else {
    form_label(ui, "Subject");
    number_field(ui, "Subject", subject_, 1, 9999,
                 {.help = "A number, never a name; it decides the order of blocks too"});
  }
  form_label(ui, "Assistant");
  segmented(ui, "Assistant", assistant_, operator_ == 2 ? kAtConsole : kAssistants,
            {.help = "Who has the right arm, takes the block over and places it"});
  if (operator_ == 0 && assistant_ == 0) {
    checkbox(ui, "In real time", realtime_, {.help = "To be watched; else as fast as it goes"});
    return;
  }
  if (operator_ == 2) {
    form_label(ui, "Port");
    number_field(ui, "Port", port_, 0, 65535, {.help = "Where a console may come to; 0: any that is free"});
    wrapped_text(ui,
                 fmt::format("trocar-console --connect 127.0.0.1:{} sends a hand controller's poses and pedals; from "
                             "elsewhere through ssh -L",
                             port_),
                 ui.theme().text_dim);
    return;
  }
  draw_devices(ui, state);
}

void TrialsPanel::draw_devices(Ui& ui, const WorkbenchState& state) {
  form_label(ui, "Drive by");
  checkbox(ui, "Gamepad", gamepad_,
           {.help = "Left stick, right stick; A jaws, B clutch, left bumper the agent, Y the other arm",
            .reason = ui.gamepad() ? "" : "No gamepad is connected"});
  flow(ui.px(110), ui.px(14));
  checkbox(ui, "SpaceMouse", space_mouse_,
           {.help = "Push and turn; its first button is the jaws", .reason = state.space_mouse_missing});
  std::string keys;
  if (operator_ == 1) {
    keys =
        "W S, A D, Q E move the left tool, Z X turn it, C opens and shuts its jaws, V is the clutch; the mouse drags "
        "it "
        "in the view. Hold Space for the agent.";
  }
  if (assistant_ == 1) {
    if (!keys.empty()) keys += " ";
    keys += "I K, J L, U O move the right tool, M and comma turn it, N opens and shuts its jaws.";
  }
  wrapped_text(ui, keys, ui.theme().text_dim);
}

void TrialsPanel::draw_how(Ui& ui, const WorkbenchState& state, Requests& requests) {
  static const std::vector<std::string> kAnchors{"Board", "Target"};
  if (state.trial_start) {
    const spatial::CellCoordinates& c = state.trial_start->cell;
    fact(ui, "Tool begins in", fmt::format("cell {}, {}, {}", c.x, c.y, c.z));
    if (const auto model = state.project->models.find(start_model_); model != state.project->models.end()) {
      fact(ui, "Agent in A", model->second->name);
    }
    if (button(ui, "Begin where it is ready",
               {.icon = icon::kCross,
                .help = "Forget the start that came from a rollout",
                .style = ButtonStyle::kQuiet})) {
      requests.emplace_back(Command{workbench::SetTrialStart{}});
    }
  }
  form_label(ui, "First block");
  number_field(ui, "First block", block_, 0, 5, {.help = "The block of the first transfer; its goal has its number"});
  checkbox(ui, "Blocks in turn", in_turn_, {.help = "Each transfer takes the next block; else the same one"});
  form_label(ui, "Seed");
  number_field(ui, "Seed", seed_, 0, 1'000'000'000,
               {.help = "Of the first transfer, the next count up; the same seeds give both modes the same scenes"});
  form_label(ui, "Lattice at");
  segmented(ui, "Anchor", anchor_, kAnchors,
            {.help = "The agent's lattice lies on the board, as in the paper, or with its goal at the block"});
  form_label(ui, "Cells a second");
  number_field(ui, "Agent rate", rate_, 1, 40, {.help = "How fast the agent steps; 20 is 50 mm/s"});
  text_setting(ui, "Delay, ms", "Delay", delay_,
               {.help = "From hand to arm: 40, normal:20:5, lognormal:20:5, ar1:20:5, and ,stall:0.01:200"});
}

void TrialsPanel::draw_setup(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Setup");
  take_start(state);
  if (anybody() && !looked_) requests.emplace_back(Command{workbench::FindDevices{}});
  looked_ = anybody();
  static const std::vector<std::string> kModes{"MT  manual", "SC  shared"};
  heading(ui, "What is run");
  form_label(ui, "Protocol");
  combo(ui, "Protocol", protocol_, protocol_names(), {.help = "Blocks with their limits and rests, in balanced order"});
  if (protocol_ == kFromFile) {
    form_label(ui, "File");
    text_field(ui, "Protocol file", protocol_file_, "protocol.json",
               {.help = "Blocks as JSON; assets/protocols/sim.json is an example"});
  }
  if (protocol_ == 0) {
    form_label(ui, "Mode");
    segmented(ui, "Mode", mode_, kModes, {.help = "MT: the operator does A to D; SC: the agent moves in A and C"});
    form_label(ui, "Transfers");
    number_field(ui, "Transfers", transfers_, 1, 1000, {.help = "One after the other"});
  }
  heading(ui, "By whom");
  draw_who(ui, state);
  heading(ui, "How");
  draw_how(ui, state, requests);
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string why = reason(state);
  if (button(ui, "Start",
             {.icon = icon::kPlay,
              .help = "Begins with the first block",
              .reason = why,
              .width = -1.0F,
              .style = ButtonStyle::kPrimary})) {
    requests.emplace_back(Command{request(state)});
    requests.emplace_back(ShowPanel{PanelId::kView});
  }
  if (!why.empty()) wrapped_text(ui, why, ui.theme().text_dim);
}

void TrialsPanel::draw_live(Ui& ui, const WorkbenchState& state) {
  const workbench::LiveView& live = *state.live;
  const trial::TrialStatus& status = *live.trial;
  const workbench::TrialsView& view = *state.trials;
  const auto& block = view.blocks[static_cast<std::size_t>(view.block)];
  authority_band(ui, status, live.segment, block.mode);
  ImGui::Dummy({0.0F, ui.px(2)});
  pedal_lamps(ui, status);
  if (!status.agent_refusal.empty() && block.mode == Mode::kShared)
    small_text(ui, status.agent_refusal, ui.theme().text_dim);
  if (!status.guard.empty()) badge(ui, icon::kWarning, status.guard, ui.theme().warning, "The guard holds the arm");
  fact(ui, "Trial", time_code(live.world.tick.seconds()));
  fact(ui, "Segment", time_code(status.segment_s));
  fact(ui, "Tool speed", fmt::format("{:.0f} mm/s", 1e3 * status.tool_speed_m_s));
  fact(ui, "To the block", millimetres(status.to_block_m));
  fact(ui, "Command to measured", fmt::format("{:.2f} mm", 1e3 * status.error_m));
  fact(ui, "Delay applied",
       fmt::format("{:.0f} ms, mean {:.1f}, worst {:.0f}", 1e3 * status.delay_s, 1e3 * status.counts.delay_mean_s,
                   1e3 * status.counts.delay_worst_s));
  if (live.lateness.ticks() > 0) {
    fact(ui, "Ticks late by 1 ms or more",
         fmt::format("{} of {}, worst {:.1f} ms", count(live.lateness.missed()), count(live.lateness.ticks()),
                     1e-6 * static_cast<double>(live.lateness.worst_ns())));
  }
  fact(ui, "Attempts, misses", fmt::format("{}, {}", status.counts.attempts, status.counts.misses));
  control_states(ui, status.state);
  ui.animate();
}

void TrialsPanel::draw_console(Ui& ui, const workbench::ConsoleView& console) {
  const Scope scope(ui, "Console");
  if (!console.there) {
    badge(ui, icon::kClock, fmt::format("waiting for a console at port {}", console.port), ui.theme().warning,
          "trocar-console --connect HOST:PORT");
    return;
  }
  fact(ui, "Console", console.peer + (console.scripted ? ", scripted" : ""));
  if (console.one_clock) fact(ui, "Latency, p95", fmt::format("{:.1f} ms", 1e3 * console.delay_p95_s));
  fact(ui, "There and back, p95", fmt::format("{:.1f} ms", 1e3 * console.rtt_p95_s));
  fact(ui, "Frames, lost, malformed",
       fmt::format("{}, {}, {}", count(console.frames), count(console.lost), count(console.malformed)));
}

void TrialsPanel::draw_runner(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Runner");
  const workbench::TrialsView& view = *state.trials;
  const bool over = view.block >= static_cast<int>(view.blocks.size());
  if (!over) {
    const auto& block = view.blocks[static_cast<std::size_t>(view.block)];
    heading(ui, fmt::format("Block {} of {}: {}", view.block + 1, view.blocks.size(), block.name));
    if (!block.instructions.empty()) wrapped_text(ui, block.instructions, ui.theme().text);
    fact(ui, "Ends after", limit_words(block));
    const double block_s = view.block_s + (state.live && state.live->trial ? state.live->world.tick.seconds() : 0.0);
    fact(ui, "Block",
         block.time_s
             ? fmt::format("{}, {} left", time_code(block_s), time_code(std::max(0.0, *block.time_s - block_s)))
             : time_code(block_s));
  } else {
    heading(ui, "All blocks are over");
  }
  fact(ui, "Transfers", fmt::format("{}: {} succeed, {} dropped", view.transfer, view.successes, view.drops));
  if (view.console) draw_console(ui, *view.console);
  if (state.live && state.live->trial && !over) draw_live(ui, state);
  if (view.phase == TrialsPhase::kResting) {
    fact(ui, "Rest",
         view.rest_left_s > 0.0 ? fmt::format("{:.0f} s left of {:.0f}", std::ceil(view.rest_left_s), view.rest_s)
                                : "over: the next block can begin");
  }
  ImGui::Dummy({0.0F, ui.px(4)});
  // The soft stop is always there, and says what it is not.
  command_button(ui, state, "trials.stop", "Stop", ButtonStyle::kDanger, requests);
  ImGui::SameLine();
  command_button(ui, state, "trials.block", "Start block", ButtonStyle::kPrimary, requests);
  flow(button_width(ui, "Pause", icon::kPause), ui.px(6));
  command_button(ui, state, "trials.pause", view.paused ? "Go on" : "Pause", ButtonStyle::kNormal, requests);
  flow(button_width(ui, "Mark", icon::kPencil), ui.px(6));
  command_button(ui, state, "trials.mark", "Mark", ButtonStyle::kNormal, requests);
  flow(button_width(ui, "End", icon::kCross), ui.px(6));
  command_button(ui, state, "trials.end", "End", ButtonStyle::kQuiet, requests);
  small_text(ui, "Stop is a soft stop, not an emergency stop", ui.theme().text_dim);
}

void TrialsPanel::draw_results(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Results");
  if (of_ != state.project) {
    results_ = workbench::results_of(workbench::counted_trials(*state.project, ""));
    of_ = state.project;
  }
  if (results_.modes[0].trials + results_.modes[1].trials == 0) {
    empty_state(ui, icon::kChart, "No results yet", "Run trials by both modes with the same seeds to compare them", {},
                ui.px(160));
    return;
  }
  if (results_.scripted) {
    badge(ui, icon::kChip, "scripted", ui.theme().warning, "Made by a script: no person took part");
  }
  dim_text(ui, workbench::operators_label(results_));
  if (ImGui::BeginTable("##results", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("");
    ImGui::TableSetupColumn("MT");
    ImGui::TableSetupColumn("SC");
    ImGui::TableHeadersRow();
    for (const workbench::ResultRow& row : workbench::result_rows(results_)) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(row.name.c_str());
      for (std::size_t i = 0; i < 2; ++i) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.values[i].c_str());
        note_item(ui, "text", fmt::format("{} {}", i == 0 ? "MT" : "SC", row.name), row.values[i], {});
      }
    }
    ImGui::EndTable();
  }
  for (const std::string& line : workbench::paired_lines(results_.paired)) wrapped_text(ui, line, ui.theme().text);
  for (const std::string& line : workbench::participant_lines(results_)) wrapped_text(ui, line, ui.theme().text);
  ImGui::Dummy({0.0F, ui.px(4)});
  form_label(ui, "File");
  text_field(ui, "File", file_, "trials.csv");
  constexpr std::array<std::string_view, 5> kEndings{".csv", ".html", ".png", ".svg", ".pdf"};
  const bool known = std::any_of(kEndings.begin(), kEndings.end(), [this](auto e) { return file_.ends_with(e); });
  if (button(ui, "Export",
             {.icon = icon::kDownload,
              .help = "A row for each trial as .csv, the comparison as a page (.html) or as bars (.png, .svg, .pdf)",
              .reason = known ? "" : "The name must end in .csv, .html, .png, .svg or .pdf"})) {
    requests.emplace_back(Command{workbench::ExportTrials{file_}});
  }
}

Requests TrialsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  static const std::vector<std::string> kPages{"Run", "Trials", "Results"};
  segmented(ui, "Page", page_, kPages, {.help = "Run them, look at each, or at all together"});
  ImGui::Dummy({0.0F, ui.px(4)});
  if (page_ == 0) {
    if (state.trials) {
      draw_runner(ui, state, requests);
    } else {
      draw_setup(ui, state, requests);
    }
  } else if (page_ == 1) {
    list_.draw(ui, state, requests);
  } else {
    draw_results(ui, state, requests);
  }
  return requests;
}

}  // namespace trocar::ui
