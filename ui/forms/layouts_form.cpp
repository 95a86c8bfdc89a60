#include "ui/forms/layouts_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ui/icons.h"

namespace trocar::ui {
namespace {

bool has(const std::vector<NamedLayout>& layouts, const std::string& name) {
  return std::any_of(layouts.begin(), layouts.end(), [&](const NamedLayout& one) { return one.name == name; });
}

std::vector<NamedLayout> without(std::vector<NamedLayout> layouts, const std::string& name) {
  std::erase_if(layouts, [&](const NamedLayout& one) { return one.name == name; });
  return layouts;
}

float square(const Ui& ui) {
  return ImGui::GetFrameHeight() + ui.px(4);
}

}  // namespace

void LayoutsForm::prepare(const WorkbenchState&) {
  name_.clear();
  renamed_.clear();
  deleted_.reset();
}

void LayoutsForm::draw_layout(Ui& ui, const NamedLayout& layout, Requests& requests) {
  const Scope scope(ui, layout.name);
  const bool shown = same_places(layout.tree, settings_.layouts[static_cast<std::size_t>(settings_.workspace)]);
  const float room = ImGui::GetContentRegionAvail().x - 2.0F * (square(ui) + ui.px(4));
  const std::string words = fitted(layout.name, room - ui.px(24));
  if (toggle_shown_as(ui, "Show", words, shown, {.help = "Put the panels as this layout has them", .width = room})) {
    requests.emplace_back(Arrange{layout.tree});
  }
  ImGui::SameLine(0.0F, ui.px(4));
  if (icon_button(ui, "Rename", {.icon = icon::kPencil, .style = ButtonStyle::kQuiet})) {
    renamed_ = new_name_ = layout.name;
  }
  ImGui::SameLine(0.0F, ui.px(4));
  if (icon_button(ui, "Delete", {.icon = icon::kTrash, .style = ButtonStyle::kQuiet})) {
    deleted_ = layout;
    requests.emplace_back(KeepLayouts{without(settings_.named_layouts(), layout.name)});
  }
}

void LayoutsForm::draw_renaming(Ui& ui, Requests& requests) {
  const Scope scope(ui, "Rename layout");
  std::vector<NamedLayout> layouts = settings_.named_layouts();
  form_label(ui, "New name");
  text_field(ui, "New name", new_name_, "Name");
  const bool taken = new_name_ != renamed_ && has(layouts, new_name_);
  const std::string reason = new_name_.empty() ? "Type a name" : taken ? "Another layout is called that" : "";
  if (button(ui, "Rename", {.reason = reason, .style = ButtonStyle::kPrimary})) {
    for (NamedLayout& one : layouts) {
      if (one.name == renamed_) one.name = new_name_;
    }
    requests.emplace_back(KeepLayouts{std::move(layouts)});
    renamed_.clear();
  }
  ImGui::SameLine();
  if (button(ui, "Leave it", {.style = ButtonStyle::kQuiet})) renamed_.clear();
}

void LayoutsForm::draw_saving(Ui& ui, Requests& requests) {
  std::vector<NamedLayout> layouts = settings_.named_layouts();
  form_label(ui, "Save as");
  text_field(ui, "Name", name_, "A name for the layout as it is");
  const std::string reason = name_.empty() ? "Type a name" : "";
  const char* words = has(layouts, name_) ? "Replace" : "Save";
  if (!button(ui, words, {.help = "Keep the panels as they are now", .reason = reason, .style = ButtonStyle::kPrimary}))
    return;
  layouts = without(std::move(layouts), name_);
  layouts.push_back({std::exchange(name_, {}), settings_.layouts[static_cast<std::size_t>(settings_.workspace)]});
  requests.emplace_back(KeepLayouts{std::move(layouts)});
}

Requests LayoutsForm::draw_content(Ui& ui, const WorkbenchState&) {
  Requests requests;
  const std::string workspace(ui::title(settings_.workspace));
  const std::vector<NamedLayout>& layouts = settings_.named_layouts();
  if (layouts.empty()) {
    wrapped_text(ui, fmt::format("The workspace {} has no layouts with a name yet", workspace), ui.theme().text_dim);
  }
  {
    const Scope scope(ui, "Named");
    for (const NamedLayout& layout : layouts) draw_layout(ui, layout, requests);
  }
  if (deleted_ && !has(layouts, deleted_->name)) {
    wrapped_text(ui, fmt::format("“{}” was deleted", deleted_->name), ui.theme().text_dim);
    if (button(ui, "Bring it back", {.icon = icon::kUndo})) {
      std::vector<NamedLayout> all = layouts;
      all.push_back(*std::exchange(deleted_, {}));
      requests.emplace_back(KeepLayouts{std::move(all)});
    }
  }
  ImGui::Dummy({0.0F, ui.px(4)});
  if (!renamed_.empty()) {
    draw_renaming(ui, requests);
  } else {
    draw_saving(ui, requests);
  }
  return requests;
}

}  // namespace trocar::ui
