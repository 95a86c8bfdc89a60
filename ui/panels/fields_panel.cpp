#include "ui/panels/fields_panel.h"
#include "ui/panels/field_lines.h"

#include <algorithm>
#include <array>

#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/common.h"
#include "ui/panels/field_controls.h"

namespace trocar::ui {
namespace {

constexpr std::array<Chord, 3> kFocusKeys{Chord{key_of('X'), {}}, Chord{key_of('Y'), {}}, Chord{key_of('Z'), {}}};

Chord copy_chord() {
  Chord chord;
  chord.key = key_of('C');
  chord.modifiers.control = true;
  return chord;
}

bool has_field(const WorkbenchState& state) {
  return state.insight && state.insight->entry != nullptr && state.insight->field != nullptr;
}

void draw_nothing(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const std::string reason = command("model.train").reason_now(state);
  const std::array<EmptyStateAction, 2> actions{
      {{"Train a model…", icon::kTrain, reason, "Learn from demonstrations"},
       {"Import Q-table…", icon::kPlus, reason, "Take in what another program learned"}}};
  const bool waiting = selected_model(state) != nullptr;
  if (waiting) ui.animate();
  const int chosen =
      empty_state(ui, icon::kThLarge, waiting ? "Working out the field" : "No model is selected",
                  waiting ? "This takes a moment" : "Reward, value and policy of a model are shown here, cell by cell",
                  waiting ? std::span<const EmptyStateAction>{} : std::span<const EmptyStateAction>{actions});
  if (chosen == 0) requests.emplace_back(ShowPanel{PanelId::kTrain});
  if (chosen == 1) requests.emplace_back(UiAction::kShowImportTable);
}

}  // namespace

bool FieldsPanel::claims(const Ui&, const Chord& chord, const WorkbenchState& state) const {
  if (!has_field(state)) return false;
  return chord == copy_chord() || std::find(kFocusKeys.begin(), kFocusKeys.end(), chord) != kFocusKeys.end();
}

void FieldsPanel::take_keys(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (ImGui::GetIO().WantTextInput || !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) return;
  for (std::size_t axis = 0; axis < kFocusKeys.size(); ++axis) {
    if (!pressed(ui.input(), kFocusKeys[axis])) continue;
    montage_ = false;
    slices_.focus(static_cast<int>(axis));
  }
  if (pressed(ui.input(), copy_chord())) {
    requests.emplace_back(CopyText{probe_.csv(state, slices_.hovered().value_or(slices_.at()))});
  }
}

void FieldsPanel::draw_slices(Ui& ui, const WorkbenchState& state, Requests& requests) {
  slices_.draw(ui, state, shading_, requests);
  if (slices_.pinned()) probe_.pin(*slices_.pinned());
  const spatial::CellCoordinates probed = slices_.hovered().value_or(slices_.at());
  if (!slices_.beside()) {
    probe_.draw(ui, state, probed, requests);
    draw_field_lines(ui, shading_, probed);
    return;
  }
  ImGui::BeginGroup();
  probe_.draw(ui, state, probed, requests);
  draw_field_lines(ui, shading_, probed);
  ImGui::EndGroup();
}

Requests FieldsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (!has_field(state)) {
    draw_nothing(ui, state, requests);
    return requests;
  }
  shading_.update(state.insight->field, state.field);
  slices_.update(state);
  if (pinned_of_ != state.model) probe_.forget();
  pinned_of_ = state.model;
  take_keys(ui, state, requests);
  draw_field_controls(ui, state, shading_, opacity_, montage_, requests);
  const spatial::CellCoordinates at = slices_.hovered().value_or(slices_.at());
  const spatial::CellIndex cell = shading_.field().grid.index(at);
  ImGui::Dummy({0.0F, ui.px(2)});
  const std::optional<std::array<double, 2>> limits = state.field.limits;
  workbench::FieldSettings settings = state.field;
  settings.limits = colour_legend(ui, shading_, shading_.field().values[static_cast<std::size_t>(cell.value)],
                                  {.stale = state.insight->stale, .limits = limits});
  if (settings.limits != limits) requests.emplace_back(workbench::Command{workbench::SetField{settings}});
  ImGui::Dummy({0.0F, ui.px(2)});
  if (!montage_) {
    draw_slices(ui, state, requests);
  } else if (slices_.draw_montage(ui, state, shading_, requests)) {
    montage_ = false;
  }
  return requests;
}

}  // namespace trocar::ui
