#include "ui/forms/demonstrations_form.h"

#include <fmt/format.h>

#include <array>
#include <system_error>

#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using exchange::Format;

constexpr std::array<Format, 3> kWritten{Format::kCsv, Format::kNpy, Format::kHdf5};
constexpr std::array<const char*, 3> kEndings{".csv", ".npy", ".hdf5"};

std::string named_after(const WorkbenchState& state, std::size_t format) {
  std::filesystem::path path = state.path;
  return path.replace_extension(kEndings[format]).string();
}

}  // namespace

void DemonstrationsForm::prepare(const WorkbenchState& state) {
  choices_.clear();
  choices_[state.demonstration].chosen = true;
  if (path_.empty()) path_ = named_after(state, static_cast<std::size_t>(format_));
  asked_.reset();
}

void DemonstrationsForm::draw_list(Ui& ui, const WorkbenchState& state) {
  const Scope scope(ui, "Demonstrations");
  const bool several = kWritten[static_cast<std::size_t>(format_)] == Format::kHdf5;
  UniqueNames unique;
  for (const auto& [id, shown] : state.project->demonstrations) {
    Choice& choice = choices_[id];
    const std::string name = unique(shown->name);
    const bool clicked = checkbox(ui, name, choice.chosen, {.help = seconds(shown->duration_s())});
    // A table holds one.
    if (clicked && choice.chosen && !several) {
      for (auto& [other, each] : choices_) each.chosen = other == id;
    }
    if (!several || !choice.chosen) continue;
    const Scope of(ui, name);
    form_label(ui, "Filter keys");
    text_field(ui, "Filter keys", choice.keys, "train, valid", {.help = "Under mask/ in the file, by these names"});
  }
}

workbench::ExportDemonstrations DemonstrationsForm::wanted(const WorkbenchState& state) const {
  workbench::ExportDemonstrations wanted;
  wanted.path = path_;
  wanted.format = kWritten[static_cast<std::size_t>(format_)];
  for (const auto& [id, choice] : choices_) {
    if (!choice.chosen || !state.project->demonstrations.contains(id)) continue;
    wanted.demonstrations.push_back(id);
    if (wanted.format != Format::kHdf5) continue;
    std::string key;
    for (const char c : choice.keys + ",") {
      if (c != ',' && c != ' ') {
        key += c;
      } else if (!key.empty()) {
        wanted.masks[std::exchange(key, "")].push_back(wanted.demonstrations.size() - 1);
      }
    }
  }
  return wanted;
}

void DemonstrationsForm::draw_report(Ui& ui, const WorkbenchState& state) {
  const Scope scope(ui, "Before");
  const workbench::ExportDemonstrations asked = wanted(state);
  exchange::Documents documents;
  for (const auto id : asked.demonstrations) documents.push_back(state.project->demonstrations.at(id));
  const auto report = exchange::export_report(documents, asked.format, asked.masks);
  problem_ = report ? "" : report.error().text();
  if (!report) return wrapped_text(ui, problem_, ui.theme().warning);
  fact(ui, "Samples", count(static_cast<std::int64_t>(report->samples)));
  heading(ui, "Comes back as it is");
  sentences(ui, icon::kVerify, report->lossless, ui.theme().good);
  if (report->lossy.empty()) return;
  heading(ui, "Is not carried");
  sentences(ui, icon::kWarning, report->lossy, ui.theme().warning);
}

void DemonstrationsForm::draw_verdict(Ui& ui, const WorkbenchState& state) const {
  if (!asked_ || !state.exported || state.exported->path != *asked_) return;
  const Scope scope(ui, "After");
  if (state.exported->running) {
    spinner(ui, ui.px(7), ui.theme().accent);
    ImGui::SameLine(0.0F, ui.px(8));
    return dim_text(ui, "Writing, and reading it again…");
  }
  if (!state.exported->error.empty()) {
    return sentences(ui, icon::kWarning, std::array{state.exported->error}, ui.theme().danger);
  }
  sentences(ui, icon::kVerify, std::array{state.exported->report.reread}, ui.theme().good);
}

Requests DemonstrationsForm::draw_content(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kNames{"CSV", "NPY", "HDF5 (robomimic)"};
  if (state.project == nullptr) {
    close();
    return {};
  }
  form_label(ui, "Format");
  if (segmented(ui, "Format", format_, kNames, {.help = "Sets the file's ending, too"})) {
    path_ = std::filesystem::path(path_).replace_extension(kEndings[static_cast<std::size_t>(format_)]).string();
  }
  form_label(ui, "File");
  text_field(ui, "File", path_, "out.csv");
  const float below = (asked_ ? 2.0F : 1.0F) * ImGui::GetFrameHeightWithSpacing() + ui.px(4);
  ImGui::BeginChild("what", {0.0F, std::max(ImGui::GetContentRegionAvail().y - below, ui.px(90))});
  draw_list(ui, state);
  draw_report(ui, state);
  ImGui::EndChild();
  draw_verdict(ui, state);
  std::error_code error;
  const bool exists = !path_.empty() && std::filesystem::exists(path_, error);
  const bool running = state.exported && state.exported->running;
  const std::string why = running         ? "The last file is still being written"
                          : path_.empty() ? "Type a file name"
                                          : problem_;
  if (!button(ui, exists ? "Replace the file" : "Export",
              {.icon = icon::kDownload,
               .reason = why,
               .width = -1.0F,
               .style = exists ? ButtonStyle::kDanger : ButtonStyle::kPrimary})) {
    return {};
  }
  asked_ = path_;
  return {workbench::Command{wanted(state)}};
}

}  // namespace trocar::ui
