#include "ui/forms/table_form.h"

#include <array>
#include <filesystem>
#include <system_error>

#include "engine/exchange/lattice_table.h"
#include "ui/command_table.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

constexpr std::array<learning::TableKind, 2> kTables{learning::TableKind::kQ, learning::TableKind::kTheta};
// The agent's segments (paper, Fig. 1).
constexpr std::array<demonstration::Segment, 2> kAgentSegments{demonstration::Segment::kA, demonstration::Segment::kC};

}  // namespace

void TableForm::prepare(const WorkbenchState& state) {
  typed_.clear();
  name_.clear();
  left_out_.clear();
  list_.go_to(first_folder(state));
}

void TableForm::draw_demonstrations(Ui& ui, const WorkbenchState& state) {
  const Scope scope(ui, "Demonstrations");
  form_label(ui, "Demonstrations");
  UniqueNames unique;
  const demonstration::Segment segment = kAgentSegments[static_cast<std::size_t>(segment_)];
  ImGui::BeginGroup();
  for (const auto& [id, shown] : state.project->demonstrations) {
    const bool has = shown->segment(segment).has_value();
    bool chosen = has && !left_out_.contains(id);
    const std::string why = has ? "" : std::string("It has no segment ") + demonstration::letter(segment);
    ImGui::PushID(static_cast<int>(id.value));
    if (checkbox(ui, unique(shown->name), chosen,
                 {.help = "The first gives start and goal, all of them the safe set", .reason = why})) {
      chosen ? void(left_out_.erase(id)) : void(left_out_.insert(id));
    }
    ImGui::PopID();
  }
  ImGui::EndGroup();
}

std::string TableForm::reason(const WorkbenchState& state) const {
  if (std::string why = command("model.import").reason_now(state); !why.empty()) return why;
  std::error_code error;
  if (typed_.empty()) return "Choose a file";
  if (!std::filesystem::is_regular_file(list_.chosen(typed_), error)) return "There is no such file";
  return wanted(state).demonstrations.empty() ? "No demonstration is chosen" : "";
}

workbench::ImportTable TableForm::wanted(const WorkbenchState& state) const {
  workbench::ImportTable table;
  table.path = list_.chosen(typed_);
  table.kind = kTables[static_cast<std::size_t>(kind_)];
  table.segment = kAgentSegments[static_cast<std::size_t>(segment_)];
  table.grid = static_cast<int>(grid_);
  table.name = name_;
  for (const auto& [id, shown] : state.project->demonstrations) {
    if (!left_out_.contains(id) && shown->segment(table.segment)) table.demonstrations.push_back(id);
  }
  return table;
}

Requests TableForm::draw_content(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kKinds{"Q-table", "Reward θ"};
  static const std::vector<std::string> kSegmentNames{"A  approach", "C  transfer"};
  if (!state.project) {
    wrapped_text(ui, "No project is open", ui.theme().text_dim);
    return {};
  }
  list_.draw(ui, typed_, "No folder, no .npy and no .csv in here", ui.px(320));
  form_label(ui, "File");
  text_field(ui, "File", typed_, "Name or path");
  form_label(ui, "What");
  segmented(ui, "What", kind_, kKinds, {.help = "Q of each cell and action, or the reward of each cell"});
  wrapped_text(ui, "In the order " + exchange::table_order(kTables[static_cast<std::size_t>(kind_)]),
               ui.theme().text_dim);
  form_label(ui, "Segment");
  segmented(ui, "Segment", segment_, kSegmentNames, {.help = "What the agent does"});
  form_label(ui, "Cells a side");
  number_field(ui, "Cells a side", grid_, 4, 176, {.help = "Of the table; 22 is the paper's lattice"});
  draw_demonstrations(ui, state);
  form_label(ui, "Name");
  text_field(ui, "Name", name_, "That of the file", {});
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string why = reason(state);
  if (!button(ui, "Import", {.icon = icon::kPlus, .reason = why, .width = -1.0F, .style = ButtonStyle::kPrimary})) {
    return {};
  }
  close();
  return {workbench::Command{wanted(state)}, ShowPanel{PanelId::kJobs}};
}

}  // namespace trocar::ui
