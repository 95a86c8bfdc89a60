#include "ui/panels/field_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/spatial/units.h"
#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

struct ProbeRow {
  std::string name;
  std::string value;
};

std::string value_words(const learning::Field& field, double value) {
  if (!std::isfinite(value)) return "unknown";
  if (!field.categorical) return number(value) + (field.unit.empty() ? "" : " " + field.unit);
  const auto i = static_cast<std::size_t>(std::lround(value));
  return i < field.categories.size() ? field.categories[i] : number(value);
}

std::string explored_words(learning::Method method, std::uint8_t tried, bool goal) {
  if (method == learning::Method::kImported) return "unknown";
  if (!learning::is_sampled(method)) return "exact: nothing is tried";
  if (goal) return "the goal, where episodes end";
  if (tried == 0x3F) return "all 6 actions tried";
  return tried == 0 ? "no action tried" : fmt::format("{} of 6 actions tried", std::popcount(tried));
}

// Layers that the probe always shows.
bool has_own_row(learning::Layer layer) {
  using enum learning::Layer;
  constexpr std::array<learning::Layer, 10> kRows{kReward,  kValue,  kQPlusX,  kQMinusX, kQPlusY,
                                                  kQMinusY, kQPlusZ, kQMinusZ, kMargin,  kVisits};
  return std::find(kRows.begin(), kRows.end(), layer) != kRows.end();
}

// The exact method keeps expectations, in thousandths.
std::string visits_words(const learning::Model& model, std::size_t cell) {
  if (!learning::knows_visits(model)) return "unknown";
  const std::uint32_t visits = model.visits[cell];
  if (model.options.method != learning::Method::kExact) return count(visits);
  return number(1e-3 * visits) + " expected";
}

std::string cell_words(const spatial::CellCoordinates& at) {
  return fmt::format("{}, {}, {}", at.x, at.y, at.z);
}

std::uint8_t best_of(const WorkbenchState& state, std::size_t cell) {
  return state.insight->policy == nullptr ? learning::kNoAction : (*state.insight->policy)[cell];
}

std::string_view action_words(std::uint8_t action) {
  return action == learning::kNoAction ? "none" : spatial::to_string(static_cast<spatial::Action>(action));
}

std::string known_words(const learning::Model& model, learning::Layer layer, spatial::CellIndex cell) {
  const std::optional<double> value = learning::known_value(model, layer, cell);
  return value ? number(*value) : "unknown";
}

learning::Layer layer_of(int action) {
  return static_cast<learning::Layer>(static_cast<int>(learning::Layer::kQPlusX) + action);
}

std::vector<ProbeRow> rows_of(const WorkbenchState& state, const learning::Field& margin,
                              const spatial::CellCoordinates& at) {
  const learning::Model& model = *state.insight->entry->model;
  const learning::Field& field = *state.insight->field;
  const spatial::CellIndex cell = model.grid.index(at);
  const auto flat = static_cast<std::size_t>(cell.value);
  const Eigen::Vector3d p = model.grid.centre(cell);
  const auto mm = [](double m) { return number(spatial::to_mm(m)); };
  std::vector<ProbeRow> rows{{"Position", fmt::format("{}, {}, {} mm", mm(p.x()), mm(p.y()), mm(p.z()))},
                             {"Index", count(cell.value)}};
  if (!has_own_row(field.layer)) rows.push_back({field.title, value_words(field, field.values[flat])});
  rows.push_back({"Reward θ", known_words(model, learning::Layer::kReward, cell)});
  rows.push_back({"Value V", known_words(model, learning::Layer::kValue, cell)});
  const std::uint8_t best = best_of(state, flat);
  for (int a = 0; a < spatial::kActionCount; ++a) {
    const auto action = static_cast<spatial::Action>(a);
    const std::string sign = a == static_cast<int>(best) ? std::string(icon::kVerify) + " " : "";
    rows.push_back({fmt::format("Q {}", direction_words(action)), sign + known_words(model, layer_of(a), cell)});
  }
  const bool any = best != learning::kNoAction;
  rows.push_back({"Best action", any ? std::string(direction_words(static_cast<spatial::Action>(best))) : "none"});
  rows.push_back({"Margin", value_words(margin, margin.values[flat])});
  rows.push_back({field.layer == learning::Layer::kVisits ? field.title : "Visits", visits_words(model, flat)});
  rows.push_back({"Explored", explored_words(model.options.method, model.tried[flat], cell == model.goal)});
  return rows;
}

// Shortest text that is the same number; nothing for what is none.
std::string plain_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string plain_value(const learning::Model& model, learning::Layer layer, spatial::CellIndex cell) {
  return plain_number(learning::known_value(model, layer, cell).value_or(NAN));
}

}  // namespace

void FieldProbe::pin(const spatial::CellCoordinates& cell) {
  const auto found = std::find(pinned_.begin(), pinned_.end(), cell);
  if (found == pinned_.end()) {
    pinned_.push_back(cell);
  } else {
    pinned_.erase(found);
  }
}

void FieldProbe::follow(const WorkbenchState& state) {
  const auto& model = state.insight->entry->model;
  if (margin_ && margin_of_ == model) return;
  margin_of_ = model;
  margin_ = std::make_shared<const learning::Field>(learning::field(*model, learning::Layer::kMargin));
}

std::string FieldProbe::csv(const WorkbenchState& state, const spatial::CellCoordinates& at) {
  follow(state);
  const learning::Model& model = *state.insight->entry->model;
  const learning::Field& field = *state.insight->field;
  std::string text = "i,j,k,index,x_mm,y_mm,z_mm," + std::string(learning::to_string(field.layer)) +
                     ",theta,v,q+x,q-x,q+y,q-y,q+z,q-z,best,margin,visits,tried\n";
  const std::vector<spatial::CellCoordinates> cells = pinned_.empty() ? std::vector{at} : pinned_;
  for (const spatial::CellCoordinates& c : cells) {
    const spatial::CellIndex cell = model.grid.index(c);
    const auto flat = static_cast<std::size_t>(cell.value);
    const Eigen::Vector3d p = model.grid.centre(cell);
    text += fmt::format("{},{},{},{},{:.4f},{:.4f},{:.4f},{},{},{}", c.x, c.y, c.z, cell.value, spatial::to_mm(p.x()),
                        spatial::to_mm(p.y()), spatial::to_mm(p.z()), plain_number(field.values[flat]),
                        plain_value(model, learning::Layer::kReward, cell),
                        plain_value(model, learning::Layer::kValue, cell));
    for (int a = 0; a < spatial::kActionCount; ++a) {
      text += "," + plain_value(model, layer_of(a), cell);
    }
    const bool sampled = learning::is_sampled(model.options.method);
    text += fmt::format(",{},{},{},{}\n", action_words(best_of(state, flat)), plain_number(margin_->values[flat]),
                        learning::knows_visits(model) ? std::to_string(model.visits[flat]) : "",
                        sampled ? std::to_string(std::popcount(model.tried[flat])) : "");
  }
  return text;
}

void FieldProbe::draw(Ui& ui, const WorkbenchState& state, const spatial::CellCoordinates& at, Requests& requests) {
  const Scope scope(ui, "Probe");
  follow(state);
  std::erase_if(pinned_, [&](const auto& cell) { return !state.insight->entry->model->grid.contains(cell); });
  heading(ui, "Cell " + cell_words(at));
  const bool is_pinned = std::find(pinned_.begin(), pinned_.end(), at) != pinned_.end();
  if (toggle_shown_as(ui, "Pin", is_pinned ? "Pinned" : "Pin", is_pinned,
                      {.icon = icon::kMagnet, .help = "Keep this cell in the table below; Shift+click in a slice"})) {
    pin(at);
  }
  ImGui::SameLine(0.0F, ui.px(4));
  if (button(ui, "Copy",
             {.icon = icon::kCopy,
              .help = "Copy the pinned cells, or this one, as rows of CSV",
              .shortcut = "Ctrl+C",
              .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(CopyText{csv(state, at)});
  }
  const FontScope font(ui.fonts().small);
  if (!pinned_.empty()) return draw_table(ui, state, at);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  for (const ProbeRow& row : rows_of(state, *margin_, at)) fact(ui, row.name, row.value);
  ImGui::PopStyleVar();
}

void FieldProbe::draw_table(Ui& ui, const WorkbenchState& state, const spatial::CellCoordinates& at) {
  const Scope scope(ui, "Pinned");
  dim_text(ui, counted(pinned_.size(), "pinned cell"));
  std::optional<spatial::CellCoordinates> taken_off;
  // The cell under the mouse first, then what it is to be compared with.
  std::vector<spatial::CellCoordinates> cells = pinned_;
  const bool loose = std::find(cells.begin(), cells.end(), at) == cells.end();
  if (loose) cells.insert(cells.begin(), at);
  const std::vector<ProbeRow> names = rows_of(state, *margin_, cells.front());
  const float line = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
  const float height = line * static_cast<float>(names.size() + 1) + ImGui::GetFrameHeight() +
                       ImGui::GetStyle().ScrollbarSize + ui.px(8);
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("pinned", static_cast<int>(cells.size()) + 1, kFlags, {0.0F, height})) return;
  ImGui::TableSetupScrollFreeze(1, 0);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  dim_text(ui, "Cell");
  for (const spatial::CellCoordinates& cell : cells) {
    ImGui::TableNextColumn();
    const std::string words = cell_words(cell);
    if (loose && cell == at) {
      dim_text(ui, words);
    } else if (button(ui, words, {.icon = icon::kCross, .help = "Take it off", .style = ButtonStyle::kQuiet})) {
      taken_off = cell;
    }
  }
  std::vector<std::vector<ProbeRow>> columns;
  for (const spatial::CellCoordinates& cell : cells) columns.push_back(rows_of(state, *margin_, cell));
  for (std::size_t row = 0; row < names.size(); ++row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    dim_text(ui, names[row].name);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      ImGui::TableNextColumn();
      text(ui, columns[i][row].value);
      note_item(ui, "text", names[row].name + " of " + cell_words(cells[i]), columns[i][row].value, {});
    }
  }
  ImGui::EndTable();
  if (taken_off) pin(*taken_off);
}

}  // namespace trocar::ui
