#include "ui/panels/library_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;

constexpr std::string_view kHelp =
    "length>10, jerk<0.3, idle>20, clearance<0.5, segment:ABC, tag:WORD, flag:bad, outcome:success, duplicate, odd; "
    "name=X is just X, "
    "name~X has it somewhere; "
    "and, or, not, parentheses; any other word is looked for in names, tags and notes";

/// What is asked most often, one click each.
constexpr std::array<std::string_view, 7> kOfferedTerms{
    "flag:good", "flag:bad", "flag:none", "duplicate", "odd", "outcome:success", "not replay:verified"};

}  // namespace

void LibraryFilter::take(std::string text) {
  text_ = std::move(text);
  if (text_ == parsed_) return;
  parsed_ = text_;
  auto parsed = workbench::LibraryQuery::parse(text_);
  error_ = parsed ? "" : parsed.error().text();
  if (!parsed) return;
  query_ = std::move(*parsed);
  ++version_;
}

void LibraryFilter::clear() {
  take("");
}

void LibraryFilter::draw_saved(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const auto& saved = state.project->filters;
  const float width = ui.px(150);
  if (!saved.empty()) {
    std::vector<std::string> names{"Saved filters"};
    int chosen = 0;
    for (const auto& [name, query] : saved) {
      if (query == text_ && !text_.empty()) chosen = static_cast<int>(names.size());
      names.push_back(name);
    }
    flow(width, ui.px(6));
    if (combo(ui, "Saved filter", chosen, names, {.help = "Filters that are kept in the project", .width = width})) {
      const auto found = saved.find(names[static_cast<std::size_t>(chosen)]);
      take(found == saved.end() ? "" : found->second);
    }
  }
  const bool known = std::any_of(saved.begin(), saved.end(), [&](const auto& each) { return each.second == text_; });
  if (text_.empty() || !error_.empty()) return;
  if (known) {
    flow(button_width(ui, "Forget", icon::kTrash), ui.px(6));
    if (button(
            ui, "Forget",
            {.icon = icon::kTrash, .help = "Take this filter out of the project", .reason = being_recorded(state)})) {
      const auto found =
          std::find_if(saved.begin(), saved.end(), [&](const auto& each) { return each.second == text_; });
      requests.emplace_back(Command{workbench::CommitEdit{workbench::RemoveFilter{found->first}}});
    }
    return;
  }
  flow(width, ui.px(6));
  text_field(ui, "Filter name", name_, "Name to save it by", {.width = width});
  flow(button_width(ui, "Save", nullptr), ui.px(6));
  std::string_view reason = being_recorded(state);
  if (reason.empty() && name_.empty()) reason = "Give it a name first";
  if (button(ui, "Save",
             {.help = "Keep this filter in the project; HDF5 exports hold it as a mask", .reason = reason})) {
    requests.emplace_back(Command{workbench::CommitEdit{workbench::SaveFilter{name_, text_}}});
    name_.clear();
  }
}

void LibraryFilter::draw_chips(Ui& ui) {
  const Scope scope(ui, "Chips");
  std::vector<std::string> chips;
  if (error_.empty()) chips = query_.terms();
  const std::size_t asked = chips.size();
  for (const std::string_view offered : kOfferedTerms) {
    if (std::find(chips.begin(), chips.end(), offered) == chips.end()) chips.emplace_back(offered);
  }
  std::string toggled;
  UniqueNames unique;
  for (std::size_t i = 0; i < chips.size(); ++i) {
    const std::string words = fitted(chips[i], ui.px(220));
    if (i > 0) flow(ImGui::CalcTextSize(words.c_str()).x + ui.px(16), ui.px(4));
    const std::string help = i < asked ? "Take this out of the filter" : "Show only what answers this too";
    if (toggle_shown_as(ui, unique(chips[i]), words, i < asked, {.help = help})) toggled = chips[i];
  }
  if (!toggled.empty()) take(workbench::with_term_toggled(error_.empty() ? text_ : "", toggled));
}

void LibraryFilter::draw(Ui& ui, const WorkbenchState& state, std::size_t shown, std::size_t all, std::size_t undecided,
                         Requests& requests) {
  const Scope scope(ui, "Filter");
  const std::uint64_t before = version_;
  const float width = std::min(ui.px(320), ImGui::GetContentRegionAvail().x);
  text_field(ui, "Query", text_, "Filter: jerk>0.3 and not tag:bad", {.help = kHelp, .width = width});
  take(text_);
  if (!text_.empty()) {
    flow(button_width(ui, "Clear", icon::kCross), ui.px(6));
    if (button(ui, "Clear", {.icon = icon::kCross, .help = "Show every demonstration", .style = ButtonStyle::kQuiet})) {
      take("");
    }
  }
  draw_saved(ui, state, requests);
  draw_chips(ui);
  // The rows follow in the next frame.
  if (version_ != before) ui.animate();
  if (!error_.empty()) return wrapped_text(ui, error_, ui.theme().danger);
  std::string words = shown == all ? fmt::format("{} demonstration{}", all, all == 1 ? "" : "s")
                                   : fmt::format("{} of {} demonstrations", shown, all);
  if (undecided > 0) words += fmt::format(", {} not measured yet", undecided);
  ImGui::AlignTextToFramePadding();  // A button follows on the same line.
  small_text(ui, words, ui.theme().text_dim);
}

}  // namespace trocar::ui
