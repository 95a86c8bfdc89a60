#include "ui/panels/models_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/field_figure.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/common.h"
#include "ui/panels/comparison_table.h"
#include "ui/panels/model_state.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::ModelId;

constexpr double kBlink_s = 0.7;

/// Both fields on the scale of the two together, so that a colour means one value.
plot::Colouring shared_colouring(const learning::Field& a, const learning::Field& b,
                                 const workbench::FieldSettings& settings) {
  learning::Field both = a;
  both.values.insert(both.values.end(), b.values.begin(), b.values.end());
  return workbench::colouring_of(both, settings);
}

void draw_square(Ui& ui, const std::string& key, const Image& picture, std::uint64_t version, const Rect& rect,
                 float from = 0.0F, float to = 1.0F) {
  const ImTextureID texture = ui.textures().texture(key, picture, version, Sampling::kNearest);
  const float x0 = rect.x0 + from * rect.width();
  const float x1 = rect.x0 + to * rect.width();
  ImGui::GetWindowDrawList()->AddImage(texture, {x0, rect.y0}, {x1, rect.y1}, {from, 0.0F}, {to, 1.0F});
}

}  // namespace

int ModelsPanel::index(const WorkbenchState& state) const {
  const spatial::Grid& grid = state.insight->field->grid;
  const int chosen = state.field.slices[static_cast<std::size_t>(axis_)];
  const spatial::CellCoordinates goal = grid.coordinates(state.insight->entry->model->goal);
  const int of_goal = axis_ == 0 ? goal.x : axis_ == 1 ? goal.y : goal.z;
  return std::clamp(chosen >= 0 ? chosen : of_goal, 0, grid.n - 1);
}

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
  form_label(ui, "Model B");
  int b = state.learning.second.value == 0 ? 0 : place(state.learning.second) + 1;
  if (b > static_cast<int>(ids.size())) b = 0;
  if (combo(ui, "Model B", b, others, {.help = "The model that A is compared with"})) {
    workbench::LearningSettings settings = state.learning;
    settings.second = b == 0 ? ModelId{} : ids[static_cast<std::size_t>(b - 1)];
    requests.emplace_back(Command{workbench::SetLearning{settings}});
  }
}

void ModelsPanel::take_wheel(const WorkbenchState& state, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0F) return;
  workbench::FieldSettings settings = state.field;
  const int n = state.insight->field->grid.n;
  settings.slices[static_cast<std::size_t>(axis_)] =
      std::clamp(index(state) + (io.MouseWheel > 0.0F ? 1 : -1), 0, n - 1);
  requests.emplace_back(Command{workbench::SetField{settings}});
}

void ModelsPanel::draw_slice(Ui& ui, const WorkbenchState& state, std::string_view label, const FieldShading& shading,
                             Image& picture, float side, Requests& requests) {
  ImGui::BeginGroup();
  small_text(ui, label, ui.theme().text_dim);
  const std::string words = fmt::format("{} = {}", "xyz"[axis_], index(state));
  canvas(ui, label, {side, side}, words, {.help = "The wheel steps through the slices of both"});
  const Rect rect = item_rect();
  take_wheel(state, requests);
  draw_hatch(ui, rect);
  picture = figure::slice_pixels(shading.field(), figure::Slice{axis_, index(state)}, shading.colouring());
  // Told apart by what they show, not by a number of versions: the two are made anew for one scale.
  draw_square(
      ui, fmt::format("model {}", label), picture,
      shading.revision() * 1000 + static_cast<std::uint64_t>(index(state)) * 3 + static_cast<std::uint64_t>(axis_),
      rect);
  ImGui::EndGroup();
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
  const figure::Slice slice{axis_, index(state)};
  const float border = blink ? (b_in_front_ ? 0.0F : 1.0F) : swipe_;
  for (std::size_t i = 0; i < 2; ++i) {
    const FieldShading& shading = shadings_[i];
    const Image picture = figure::slice_pixels(shading.field(), slice, shading.colouring());
    const std::uint64_t version =
        shading.revision() * 1000 + static_cast<std::uint64_t>(slice.index) * 3 + static_cast<std::uint64_t>(axis_);
    const float from = i == 0 ? 0.0F : border;
    const float to = i == 0 ? border : 1.0F;
    if (to > from) draw_square(ui, fmt::format("swipe {}", i), picture, version, rect, from, to);
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
  const plot::Colouring shared = shared_colouring(*insight.field, *second.field, state.field);
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
  Image picture;
  if (mode_ == Mode::kSideBySide) {
    const float side = std::min(0.5F * (room - gap), most);
    draw_slice(ui, state, "A", shadings_[0], picture, side, requests);
    ImGui::SameLine(0.0F, gap);
    draw_slice(ui, state, "B", shadings_[1], picture, side, requests);
    draw_shared_legend(ui, state, requests);
    return;
  }
  const float side = std::min(room, most);
  if (mode_ == Mode::kSwipe || mode_ == Mode::kBlink) {
    draw_swipe(ui, state, side);
    draw_shared_legend(ui, state, requests);
    return;
  }
  draw_slice(ui, state, "B against A", shadings_[2], picture, side, requests);
  colour_legend(ui, shadings_[2], NAN, {});
}

Requests ModelsPanel::draw(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kModes{"Side by side", "Swipe", "Blink", "Difference", "Policy", "Outcomes"};
  static const std::vector<std::string> kAxes{"x", "y", "z"};
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.project->models.empty() || !state.insight || state.insight->entry == nullptr) {
    const std::string reason = command("model.train").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{
        {{"Train a model…", icon::kTrain, reason, "Learn from demonstrations"}}};
    if (empty_state(ui, icon::kThLarge, "No models to compare", "Train two, as with ε = 0 and ε = 0.1", actions) == 0) {
      requests.emplace_back(ShowPanel{PanelId::kTrain});
    }
    return requests;
  }
  draw_choice(ui, state, requests);
  draw_model_state(ui, state, requests);
  if (!state.insight->second_error.empty()) {
    wrapped_text(ui, state.insight->second_error, ui.theme().warning);
    return requests;
  }
  if (!state.insight->second) {
    empty_state(ui, icon::kThLarge, "One model only", "Choose a second one above to see what differs", {});
    return requests;
  }
  int mode = static_cast<int>(mode_);
  if (segmented(ui, "Mode", mode, kModes, {.help = "How the two are laid beside or over each other"})) {
    mode_ = static_cast<Mode>(mode);
  }
  form_label(ui, "Across");
  segmented(ui, "Across", axis_, kAxes, {.help = "Which axis the slices are cut across"});
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
  comparison_table(ui, *state.insight);
  return requests;
}

}  // namespace trocar::ui
