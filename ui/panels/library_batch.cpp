#include "ui/panels/library_batch.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "engine/demonstration/edit_words.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;

struct Offered {
  const char* label;
  const char* words;
  const char* icon;
  const char* help;
};
constexpr std::array<Offered, 7> kOffered{{
    {"Good", "flag good", icon::kVerify, "Flag them good"},
    {"Bad", "flag bad", icon::kCross, "Flag them bad"},
    {"Unsure", "flag unsure", icon::kHelp, "Flag them unsure"},
    {"No flag", "flag none", nullptr, "Take their flags away"},
    {"Trim idle", "trim-idle", icon::kCut, "Leave out the ends where nothing moves"},
    {"Label", "propose-labels", icon::kPencil, "Label segments A to E from what was recorded"},
    {"Remove", "remove", icon::kTrash, "Put them into the trash"},
}};

}  // namespace

void LibraryBatch::plan(std::string words, const std::set<workbench::DemonstrationId>& chosen, Requests& requests) {
  const auto split = demonstration::split_words(words);
  const auto act = split ? workbench::act_from_words(*split) : tl::unexpected(split.error());
  error_ = act ? "" : act.error().text();
  if (!act) return;
  planned_ = std::move(words);
  of_ = chosen;
  requests.emplace_back(Command{workbench::PlanBatch{{chosen.begin(), chosen.end()}, *split}});
}

void LibraryBatch::end(Requests& requests) {
  planned_.clear();
  error_.clear();
  requests.emplace_back(Command{workbench::PlanBatch{}});
}

void LibraryBatch::draw_acts(Ui& ui, const std::set<workbench::DemonstrationId>& chosen, Requests& requests) {
  for (const Offered& offered : kOffered) {
    flow(button_width(ui, offered.label, offered.icon), ui.px(4));
    if (button(ui, offered.label, {.icon = offered.icon, .help = offered.help})) plan(offered.words, chosen, requests);
  }
  const float width = ui.px(190);
  flow(width, ui.px(8));
  text_field(ui, "Act", words_, "tag slow, rate 4, smooth …",
             {.help = "tag WORD, untag WORD, flag, rate, verdict, note, remove, or any edit with its parameters",
              .width = width});
  flow(button_width(ui, "Preview", nullptr), ui.px(4));
  const char* reason = words_.empty() ? "Say what to do to them first" : "";
  if (button(ui, "Preview", {.help = "See what it does to each before it is done", .reason = reason})) {
    plan(words_, chosen, requests);
  }
}

void LibraryBatch::draw_plan(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const bool ready = state.batch && !state.batch_pending;
  if (!ready) {
    dim_text(ui, "Working out what it does…");
    ui.animate();
  } else if (!state.batch->error.empty()) {
    wrapped_text(ui, state.batch->error, ui.theme().danger);
  }
  const std::size_t count = ready ? state.batch->edit.edits.size() : 0;
  const std::size_t all = ready ? state.batch->lines.size() : of_.size();
  const std::string label = fmt::format("Apply to {} of {}", count, all);
  const char* reason = !ready ? "It is being worked out" : count == 0 ? "It changes none of them" : "";
  if (button(ui, "Apply",
             {.icon = icon::kVerify,
              .help = "One step of the history; undo takes all of it back",
              .reason = reason,
              .style = ButtonStyle::kPrimary})) {
    requests.emplace_back(Command{workbench::CommitEdit{state.batch->edit}});
    return end(requests);
  }
  flow(button_width(ui, "Cancel", nullptr), ui.px(8));
  if (button(ui, "Cancel", {.help = "Leave everything as it is", .style = ButtonStyle::kQuiet}) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    return end(requests);
  }
  flow(ImGui::CalcTextSize(label.c_str()).x, ui.px(8));
  ImGui::AlignTextToFramePadding();
  dim_text(ui, planned_ + ": " + (ready ? label : "…"));
  if (!ready) return;
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = line * static_cast<float>(std::min<std::size_t>(state.batch->lines.size(), 6)) + ui.px(8);
  ImGui::BeginChild("lines", {0.0F, height}, true);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(state.batch->lines.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const workbench::BatchLine& planned = state.batch->lines[static_cast<std::size_t>(i)];
      const bool left_out = !planned.problem.empty();
      const std::string words = fmt::format("{} {}: {}", left_out ? icon::kCross : icon::kVerify, planned.name,
                                            left_out ? "left out, " + planned.problem : planned.change);
      const ColourScope colour(ImGuiCol_Text, left_out ? ui.theme().text_dim : ui.theme().text);
      ImGui::TextUnformatted(fitted(words, ImGui::GetContentRegionAvail().x).c_str());
      note_item(ui, "text", fmt::format("{} {}", planned.name, planned.id.value),
                left_out ? planned.problem : planned.change, {.help = words});
    }
  }
  ImGui::EndChild();
}

void LibraryBatch::draw(Ui& ui, const WorkbenchState& state, const std::set<workbench::DemonstrationId>& chosen,
                        Requests& requests) {
  const Scope scope(ui, "Batch");
  // Whoever chooses others means another batch.
  if (!idle() && of_ != chosen) end(requests);
  if (chosen.empty()) return;
  ImGui::AlignTextToFramePadding();
  text(ui, fmt::format("{} chosen", chosen.size()));
  if (state.live) return dim_text(ui, "A transfer is being recorded");
  if (idle()) {
    draw_acts(ui, chosen, requests);
    if (!error_.empty()) wrapped_text(ui, error_, ui.theme().danger);
  } else {
    draw_plan(ui, state, requests);
  }
}

}  // namespace trocar::ui
