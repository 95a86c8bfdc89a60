#include "ui/panels/inspector_panel.h"

#include <fmt/format.h>

#include <array>

#include "engine/demonstration/sampling_rate.h"
#include "engine/trial/keyboard_hands.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::ModelEntry;

void draw_provenance(Ui& ui, const demonstration::RecordingInfo& recording) {
  const demonstration::Provenance& origin = recording.provenance;
  const Scope scope(ui, "Origin");
  heading(ui, "Origin");
  fact(ui, "Made by", provenance_words(origin));
  if (!origin.device.empty()) fact(ui, "Device", origin.device);
  fact(ui, "Seed", std::to_string(origin.seed));
  fact(ui, "Block, goal", fmt::format("{}, {}", place_words(origin.block), place_words(origin.goal)));
  if (!origin.created.empty()) fact(ui, "Recorded", shown_time(origin.created));
  if (!origin.software.empty()) fact(ui, "With", origin.software);
  if (!origin.scene_hash.empty()) fact(ui, "Scene", origin.scene_hash);
}

void draw_model(Ui& ui, const WorkbenchState& state, const ModelEntry& entry) {
  const Scope scope(ui, "Model");
  heading(ui, entry.name);
  const learning::TrainOptions& options = entry.model->options;
  if (state.project->stale(entry)) {
    badge(ui, icon::kWarning, "stale: a demonstration was edited since training", ui.theme().warning);
  }
  fact(ui, "Method", learning::to_string(options.method));
  fact(ui, "Segment", std::string(1, demonstration::letter(entry.segment)));
  const bool sampled = learning::is_sampled(options.method);
  if (sampled) {
    fact(ui, "Episodes", count(options.episodes));
    fact(ui, "Exploration ε", number(options.epsilon));
    fact(ui, "Seed", std::to_string(options.seed));
  } else if (options.method == learning::Method::kExact) {
    fact(ui, "Prior reward θ₀", number(options.theta_prior));
    fact(ui, "Regularisation λ", number(options.regularisation));
  }
  fact(ui, "Lattice", fmt::format("{0} × {0} × {0}", entry.model->grid.n));
  const bool imported = options.method == learning::Method::kImported;
  if (!imported) fact(ui, "Trained in", elapsed(entry.model->seconds));
  if (!entry.created.empty()) fact(ui, imported ? "Imported" : "Trained", shown_time(entry.created));
  if (!state.insight || state.insight->entry == nullptr || state.insight->entry->id != entry.id) return;
  if (!sampled) return;  // It knows every move without trying one.
  fact(ui, "Fully explored", count(state.insight->exploration.fully_explored) + " cells");
  fact(ui, "Partly explored", count(state.insight->exploration.partly_explored) + " cells");
  fact(ui, "Unexplored", count(state.insight->exploration.fully_unexplored) + " cells");
}

std::string driver_of(const workbench::RecordByHand& take, kinematics::ArmSide side) {
  switch (take.options.sources[kinematics::index_of(side)]) {
    case trial::ArmSource::kHand:
      return std::string("keyboard and mouse") + (take.gamepad ? ", gamepad" : "") +
             (take.space_mouse ? ", SpaceMouse" : "");
    case trial::ArmSource::kScripted:
      return "scripted " + std::string(trial::to_string(take.options.skill));
    case trial::ArmSource::kReplay:
      return "replay";
    case trial::ArmSource::kStill:
      return "at rest";
  }
  return "";
}

void draw_take(Ui& ui, const workbench::TakeView& take) {
  static constexpr std::array<std::string_view, 3> kModes{"continuous", "step", "waypoint"};
  fact(ui, "Name", take.name);
  fact(ui, "Left arm", driver_of(take.request, kinematics::ArmSide::kLeft));
  fact(ui, "Right arm", driver_of(take.request, kinematics::ArmSide::kRight));
  fact(ui, "Mode", kModes[static_cast<std::size_t>(take.request.options.mode)]);
  fact(ui, "Block", std::to_string(take.request.options.block));
  fact(ui, "Goal peg", std::to_string(take.request.options.goal));
  if (take.request.punch) {
    fact(ui, "Replaces", seconds(take.request.punch->begin_s) + " – " + seconds(take.request.punch->end_s));
  }
}

/// The operator's keys, as long as they are needed.
void draw_hand_keys(Ui& ui) {
  const Scope scope(ui, "Keys");
  heading(ui, "Keys, left and right arm");
  for (const trial::HandKeyRow& row : trial::hand_key_rows()) {
    fact(ui, row.meaning, trial::to_text(row.left) + "   " + trial::to_text(row.right));
  }
  fact(ui, "fine", "Shift");
  fact(ui, "clutch", trial::to_text(trial::kClutchKey));
}

void draw_live(Ui& ui, const WorkbenchState& state) {
  const workbench::LiveView& live = *state.live;
  const Scope scope(ui, "Recording");
  heading(ui, "Recording");
  if (state.take) draw_take(ui, *state.take);
  fact(ui, "Time", time_code(live.elapsed_s));
  fact(ui, "Samples", count(live.samples));
  fact(ui, "Segment", std::string(1, demonstration::letter(live.segment)));
  fact(ui, "Authority", demonstration::to_string(live.authority));
  fact(ui, "Speed", fmt::format("{:.2f}× real time", live.realtime_factor));
  if (state.take) draw_hand_keys(ui);
}

}  // namespace

std::string outcome_reason(const demonstration::Demonstration& shown) {
  const demonstration::Outcome recorded = shown.recording->outcome;
  if (recorded == demonstration::Outcome::kUnknown) {
    return shown.recording->provenance.operator_kind == "imported"
               ? "How it ends is unknown: the file that it was imported from does not tell"
               : "How it ends is unknown: the recording does not tell";
  }
  if (shown.outcome_doubt().empty()) return "";
  return fmt::format("How it ends is unknown: what was recorded ended as {}, and {}; simulate it to know",
                     demonstration::to_string(recorded), shown.outcome_doubt());
}

void InspectorPanel::draw_segments(Ui& ui, const WorkbenchState&, const demonstration::Demonstration& shown,
                                   Requests& requests) {
  const Scope scope(ui, "Segments");
  heading(ui, "Segments");
  for (int i = 0; i < demonstration::kSegmentCount; ++i) {
    const auto segment = static_cast<demonstration::Segment>(i);
    const auto span = shown.segment(segment);
    const std::string label(1, demonstration::letter(segment));
    const std::string value = span ? fmt::format("{:.2f}–{:.2f} s", span->begin_s, span->end_s) : "missing";
    const ImVec2 at = ImGui::GetCursorPos();
    const WidgetOptions options{.help = span ? "Click to go to its beginning" : "", .height = ui.px(24)};
    if (selectable_row(ui, label, false, value, options) && span) {
      requests.emplace_back(Command{workbench::SetPlayhead{span->begin_s}});
    }
    const ImVec2 next = ImGui::GetCursorPos();
    ImGui::SetCursorPos({at.x + ui.px(2), at.y + ui.px(3)});
    segment_chip(ui, segment, span.has_value(), ui.px(17));
    ImGui::SetCursorPos({at.x + ui.px(30), at.y + ui.px(2)});
    const ColourScope colour(ImGuiCol_Text, span ? ui.theme().text : ui.theme().text_disabled);
    ImGui::TextUnformatted(value.c_str());
    const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8);
    if (span && used + ui.px(50) < ImGui::GetWindowContentRegionMax().x) {
      const std::string length = seconds(span->end_s - span->begin_s);
      ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(length.c_str()).x);
      const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
      ImGui::TextUnformatted(length.c_str());
    }
    ImGui::SetCursorPos(next);
  }
}

void InspectorPanel::draw_demonstration(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const auto shown = selected_demonstration(state);
  const Scope scope(ui, "Demonstration");
  if (named_ != shown->id || last_name_ != shown->name) {
    named_ = shown->id;
    name_ = last_name_ = shown->name;
  }
  form_label(ui, "Name");
  if (text_field(ui, "Name", name_, "Name", {.reason = being_recorded(state)}) && !name_.empty() &&
      name_ != shown->name) {
    requests.emplace_back(
        Command{workbench::CommitEdit{workbench::EditDemonstration{shown->id, demonstration::Rename{name_}}}});
  }
  const demonstration::Outcome outcome = shown->outcome();
  const std::string why = outcome_reason(*shown);
  badge(ui, outcome_sign(outcome), outcome_words(*shown), outcome_colour(ui.theme(), outcome), why);
  if (shown->recording->recovered) {
    flow(badge_width(ui, icon::kWarning, "recovered"), ui.px(8));
    badge(ui, icon::kWarning, "recovered", ui.theme().warning, "Salvaged after a crash");
  }
  fact(ui, "Duration", seconds(shown->duration_s()));
  fact(ui, "Gates", fmt::format("{:.2f}–{:.2f} s", shown->begin_s, shown->end_s));
  const auto samples = static_cast<std::int64_t>(shown->gated().size());
  const double rate_hz = samples > 1 ? demonstration::usual_rate_hz(shown->gated()) : demonstration::kSampleRate_hz;
  fact(ui, "Samples", count(samples) + " at " + number(rate_hz) + " Hz");
  fact(ui, "Version", short_hash(shown->hash()));
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_segments(ui, state, *shown, requests);
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_provenance(ui, *shown->recording);
}

Requests InspectorPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.live) {
    draw_live(ui, state);
    return requests;
  }
  const auto shown = selected_demonstration(state);
  const auto model = selected_model(state);
  if (shown == nullptr && model == nullptr) {
    empty_state(ui, icon::kInfo, "Nothing is selected", "Select a demonstration or a model in the library", {});
    return requests;
  }
  if (shown != nullptr) draw_demonstration(ui, state, requests);
  if (model != nullptr) {
    if (shown != nullptr) {
      ImGui::Dummy({0.0F, ui.px(4)});
      ImGui::Separator();
      ImGui::Dummy({0.0F, ui.px(2)});
    }
    draw_model(ui, state, *model);
  }
  return requests;
}

}  // namespace trocar::ui
