#include "ui/panels/models_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/learning/comparison_csv.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/common.h"
#include "ui/panels/comparison_table.h"
#include "ui/panels/model_slice.h"
#include "ui/panels/model_state.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::ModelId;

constexpr double kBlink_s = 0.7;
constexpr int kSeeds = 10;  ///< As many as are studied at first.

}  // namespace

void ModelsPanel::draw_choice(Ui& ui, const WorkbenchState& state, Requests& requests) {
  std::vector<std::string> names;
  std::vector<std::string> others{"None"};
  std::vector<ModelId> ids;
  UniqueNames unique;
  for (const auto& [id, entry] : state.project->models) {
    names.push_back(unique(entry->name));
    others.push_back(names.back());
    ids.push_back(id);
  }
  const auto place = [&ids](ModelId id) {
    return static_cast<int>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  };
  form_label(ui, "Model A");
  int a = place(state.model);
  if (combo(ui, "Model A", a, names, {.help = "The selected model"})) {
    requests.emplace_back(Command{workbench::SelectModel{ids[static_cast<std::size_t>(a)]}});
  }
  form_label(ui, "Beside it");
  static const std::vector<std::string> kBeside{"Another model", "Other seeds"};
  int beside = state.learning.seeds > 0 ? 1 : 0;
  if (segmented(ui, "Beside it", beside, kBeside, {.help = "What the model is compared with"})) {
    workbench::LearningSettings settings = state.learning;
    settings.seeds = beside == 1 ? kSeeds : 0;
    settings.second_in_view = false;
    requests.emplace_back(Command{workbench::SetLearning{settings}});
  }
  if (beside == 1) return;
  form_label(ui, "Model B");
  int b = state.learning.second.value == 0 ? 0 : place(state.learning.second) + 1;
  if (b > static_cast<int>(ids.size())) b = 0;
  if (combo(ui, "Model B", b, others, {.help = "The model that A is compared with"})) {
    workbench::LearningSettings settings = state.learning;
    settings.second = b == 0 ? ModelId{} : ids[static_cast<std::size_t>(b - 1)];
    requests.emplace_back(Command{workbench::SetLearning{settings}});
  }
}

void ModelsPanel::draw_swipe(Ui& ui, const WorkbenchState& state, float side) {
  const bool blink = mode_ == Mode::kBlink;
  const std::string name = blink ? "Blink" : "Swipe";
  const std::string words = blink ? (b_in_front_ ? "B" : "A") : fmt::format("{:.0f} % A", 100.0F * swipe_);
  canvas(ui, name, {side, side}, words,
         {.help = blink ? "A and B in turn" : "Drag the border: A is to its left, B to its right"});
  const Rect rect = item_rect();
  if (!blink && ImGui::IsItemActive()) {
    swipe_ = std::clamp((ImGui::GetIO().MousePos.x - rect.x0) / std::max(rect.width(), 1.0F), 0.0F, 1.0F);
  }
  draw_hatch(ui, rect);
  const float border = blink ? (b_in_front_ ? 0.0F : 1.0F) : swipe_;
  for (std::size_t i = 0; i < 2; ++i) {
    const float from = i == 0 ? 0.0F : border;
    const float to = i == 0 ? border : 1.0F;
    if (to > from) paint_model_slice(ui, state, shadings_[i], i == 0 ? "A" : "B", axis_, rect, from, to);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!blink) {
    const float x = std::round(rect.x0 + swipe_ * rect.width());
    list.AddRectFilled({x - 1.0F, rect.y0}, {x + 1.0F, rect.y1}, to_u32(ui.theme().text));
  }
  const FontScope font(ui.fonts().small);
  const auto letter = [&](const char* text, float x) {
    const ImVec2 at{x, rect.y0 + ui.px(4)};
    list.AddRectFilled({at.x - ui.px(3), at.y}, {at.x + ui.px(11), at.y + ImGui::GetFontSize() + ui.px(2)},
                       to_u32(ui.theme().panel), ui.px(3));
    list.AddText(at, to_u32(ui.theme().text), text);
  };
  if (!blink || !b_in_front_) letter("A", rect.x0 + ui.px(6));
  if (!blink || b_in_front_) letter("B", rect.x1 - ui.px(14));
}

void ModelsPanel::draw_shared_legend(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const auto limits = colour_legend(ui, shadings_[0], NAN, {.stale = false, .limits = state.field.limits});
  if (limits == state.field.limits) return;
  workbench::FieldSettings settings = state.field;
  settings.limits = limits;
  requests.emplace_back(Command{workbench::SetField{settings}});
}

void ModelsPanel::draw_pictures(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const workbench::ModelInsight& insight = *state.insight;
  const workbench::SecondModel& second = *insight.second;
  const plot::Colouring shared = workbench::shared_colouring(*insight.field, *second.field, state.field);
  shadings_[0].update(insight.field, state.field, shared);
  shadings_[1].update(second.field, state.field, shared);
  workbench::FieldSettings of_change = state.field;
  of_change.limits.reset();
  of_change.map.reset();
  std::shared_ptr<const learning::Field> change = second.difference;
  if (mode_ == Mode::kPolicy) {
    change = std::shared_ptr<const learning::Field>(second.comparison, &second.comparison->policy_change);
  }
  if (mode_ == Mode::kOutcomes) change = second.outcomes;
  if (!change->categorical) of_change.map = plot::ColourMap::kDiverging;
  shadings_[2].update(change, of_change);
  const float room = ImGui::GetContentRegionAvail().x;
  const float gap = ui.px(10);
  const float most = ui.px(340);
  if (mode_ == Mode::kSideBySide) {
    const float side = std::min(0.5F * (room - gap), most);
    const std::string title_a = "A  " + insight.entry->name;
    const std::string title_b = "B  " + second.entry->name;
    draw_model_slice(ui, state, shadings_[0], {"A", title_a, axis_, side}, requests);
    ImGui::SameLine(0.0F, gap);
    draw_model_slice(ui, state, shadings_[1], {"B", title_b, axis_, side}, requests);
    draw_shared_legend(ui, state, requests);
    return;
  }
  const float side = std::min(room, most);
  if (mode_ == Mode::kSwipe || mode_ == Mode::kBlink) {
    draw_swipe(ui, state, side);
    draw_shared_legend(ui, state, requests);
    return;
  }
  draw_model_slice(ui, state, shadings_[2], {"B against A", "B against A", axis_, side}, requests);
  colour_legend(ui, shadings_[2], NAN, {});
}

void ModelsPanel::draw_axis(Ui& ui, const WorkbenchState& state, Requests& requests) {
  static const std::vector<std::string> kAxes{"x", "y", "z"};
  form_label(ui, "Across");
  segmented(ui, "Across", axis_, kAxes, {.help = "Which axis the slices are cut across"});
  form_label(ui, "Slice");
  const auto axis = static_cast<std::size_t>(axis_);
  const std::string format = kAxes[axis] + " = %d";
  int index = model_slice_index(state, axis_);
  if (!slider_int(ui, "Slice", index, 0, state.insight->field->grid.n - 1, format.c_str(),
                  {.help = "Of both pictures, and of the view if it shows this slice"})) {
    return;
  }
  workbench::FieldSettings settings = state.field;
  settings.slices[axis] = index;
  requests.emplace_back(Command{workbench::SetField{settings}});
}

Requests ModelsPanel::draw(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kModes{"Side by side", "Swipe", "Blink", "Difference", "Policy", "Outcomes"};
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.project->models.empty() || !state.insight || state.insight->entry == nullptr) {
    const std::string reason = command("model.train").reason_now(state);
    const std::array<EmptyStateAction, 2> actions{
        {{"Train a model…", icon::kTrain, reason, "Learn from demonstrations"},
         {"Import Q-table…", icon::kPlus, reason, "Take in what another program learned"}}};
    const int chosen =
        empty_state(ui, icon::kThLarge, "No models to compare", "Train two, as with ε = 0 and ε = 0.1", actions);
    if (chosen == 0) requests.emplace_back(ShowPanel{PanelId::kTrain});
    if (chosen == 1) requests.emplace_back(UiAction::kShowImportTable);
    return requests;
  }
  draw_choice(ui, state, requests);
  draw_model_state(ui, state, requests);
  if (state.learning.seeds > 0) {
    draw_axis(ui, state, requests);
    seed_page_.draw(ui, state, axis_, requests);
    return requests;
  }
  if (!state.insight->second_error.empty()) {
    wrapped_text(ui, state.insight->second_error, ui.theme().warning);
    return requests;
  }
  if (!state.insight->second) {
    empty_state(ui, icon::kThLarge, "One model only", "Choose a second one above to see what differs", {});
    return requests;
  }
  const workbench::ModelEntry& a = *state.insight->entry;
  const workbench::ModelEntry& b = *state.insight->second->entry;
  if (a.segment != b.segment) {
    wrapped_text(ui,
                 fmt::format("A serves segment {} and B segment {}: they do different tasks, so that their numbers say "
                             "little about each other",
                             demonstration::letter(a.segment), demonstration::letter(b.segment)),
                 ui.theme().warning);
  }
  int mode = static_cast<int>(mode_);
  if (segmented(ui, "Mode", mode, kModes, {.help = "How the two are laid beside or over each other"})) {
    mode_ = static_cast<Mode>(mode);
  }
  draw_axis(ui, state, requests);
  form_label(ui, "3-D view");
  bool in_view = state.learning.second_in_view;
  if (checkbox(ui, "Both models", in_view,
               {.help = "A in the left half of the view, B in the right one, seen alike"})) {
    workbench::LearningSettings settings = state.learning;
    settings.second_in_view = in_view;
    requests.emplace_back(Command{workbench::SetLearning{settings}});
    // There is something to compare, then.
    if (in_view && !shows_field(state.field)) append(requests, command("view.field").run(state));
  }
  if (mode_ == Mode::kBlink) {
    ui.animate();
    const double now_s = ImGui::GetTime();
    if (now_s - blinked_s_ > kBlink_s) {
      b_in_front_ = !b_in_front_;
      blinked_s_ = now_s;
    }
  }
  draw_pictures(ui, state, requests);
  const learning::ModelComparison& comparison = *state.insight->second->comparison;
  wrapped_text(ui, policy_change_words(comparison, state.insight->field->grid.cell_count()), ui.theme().text);
  const std::string changed = policy_change_words(comparison, state.insight->field->grid.cell_count());
  note_item(ui, "text", "Policy change", changed, {});
  if (button(ui, "Copy measures",
             {.icon = icon::kCopy, .help = "As CSV, with all digits", .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(CopyText{
        learning::comparison_csv(*state.insight->entry->model, *state.insight->second->entry->model, comparison)});
  }
  comparison_table(ui, *state.insight);
  return requests;
}

}  // namespace trocar::ui
