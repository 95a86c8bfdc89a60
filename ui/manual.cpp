#include "ui/manual.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "engine/core/file.h"
#include "engine/workbench/workbench.h"
#include "ui/command_cli.h"
#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/headless.h"
#include "ui/keymap.h"
#include "ui/panel_pages.h"

namespace trocar::ui {
namespace {

/// Words in a cell of a table.
std::string cell(std::string_view words) {
  std::string text;
  for (const char c : words) text += c == '|' ? std::string("\\|") : std::string(1, c);
  return text;
}

std::string code(std::string_view words) {
  if (words.empty()) return "–";
  // A backtick is told from the end of the code by two around it.
  const bool ticks = words.find('`') != std::string_view::npos;
  return ticks ? fmt::format("`` {} ``", cell(words)) : fmt::format("`{}`", cell(words));
}

std::string keys_of(const Keymap& keymap, std::string_view id) {
  std::string words;
  for (const Chord& chord : keymap.chords(id)) words += (words.empty() ? "" : ", ") + code(to_text(chord));
  return words.empty() ? "–" : words;
}

std::string picture_name(PanelId panel) {
  return fmt::format("panels/{}.png", lower_case(title(panel)));
}

std::string command_rows(const std::vector<const CommandRow*>& rows) {
  const Keymap keymap;
  std::string text = "| command | keys | what it does | command line | id |\n| --- | --- | --- | --- | --- |\n";
  for (const CommandRow* row : rows) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", cell(row->title), keys_of(keymap, row->id), cell(row->help),
                        code(cli_of(row->id)), code(row->id));
  }
  return text;
}

std::string panel_section(PanelId panel) {
  const PanelPage& page = page_of(panel);
  std::string text = fmt::format("## {}\n\n{}. {}\n\n![The panel {}]({})\n", title(panel), page.summary, page.more,
                                 title(panel), picture_name(panel));
  if (!page.mouse.front().act.empty()) text += "\n| mouse | |\n| --- | --- |\n";
  for (const MouseHelp& help : page.mouse) {
    if (!help.act.empty()) text += fmt::format("| {} | {} |\n", cell(help.act), cell(help.how));
  }
  const auto commands = commands_of(page);
  if (!commands.empty()) text += fmt::format("\n{}", command_rows(commands));
  return text + "\n";
}

constexpr std::string_view kIndex =
    "# Trocar\n\n"
    "A workbench for people who teach surgical robots by demonstration.\n\n"
    "- [Commands](commands.md): everything that the window does, by menu\n"
    "- [Keys](keys.md): every key, as it is and in the presets, and the mouse\n"
    "- [Panels](panels.md): what each part of the window is for\n\n"
    "All of it is made by `trocar ui manual` from the tables that menus, palette and tooltips are made of.\n";

class TemporaryProject {
 public:
  TemporaryProject() : folder_(std::filesystem::temp_directory_path() / fmt::format("trocar-manual-{}", ::getpid())) {}
  TemporaryProject(const TemporaryProject&) = delete;
  TemporaryProject& operator=(const TemporaryProject&) = delete;
  ~TemporaryProject() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }
  /// A recording and a model, so that no panel is empty.
  Result<std::filesystem::path> make(const Progress* progress) const {
    constexpr double kLimit_s = 600.0;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    const std::filesystem::path path = folder_ / "manual.trocar";
    workbench::Workbench bench({.clock = nullptr, .picture = false});
    bench.post(workbench::OpenProject{path, true});
    TROCAR_RETURN_IF_ERROR(bench.wait_idle(kLimit_s, progress));
    workbench::RecordScripted record;
    record.options.seed = 1;
    record.realtime = false;
    bench.post(record);
    TROCAR_RETURN_IF_ERROR(bench.wait_idle(kLimit_s, progress));
    workbench::TrainModel train;
    train.demonstrations = {bench.state().demonstration};
    train.options.method = learning::Method::kExact;
    bench.post(train);
    TROCAR_RETURN_IF_ERROR(bench.wait_idle(kLimit_s, progress));
    if (bench.state().project == nullptr) return fail(ErrorCode::kIo, bench.state().load_error);
    return path;
  }

 private:
  std::filesystem::path folder_;
};

Status take_pictures(const ManualOptions& options, const std::filesystem::path& project) {
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    UiRunOptions run;
    run.project = project;
    run.panel = static_cast<PanelId>(i);
    run.screenshot = options.folder / picture_name(*run.panel);
    run.width = 960;
    run.height = 640;
    run.progress = options.progress;
    TROCAR_RETURN_IF_ERROR(run_headless(run));
  }
  return {};
}

}  // namespace

std::string commands_page() {
  std::string text =
      "# Commands\n\nEvery command can be found by its name in the palette (`Ctrl+P`). P is the project, DEMO and "
      "MODEL "
      "are what is selected, S is a time in seconds.\n\n";
  for (const std::string_view menu : command_menus()) {
    std::vector<const CommandRow*> rows;
    for (const CommandRow& row : command_table()) {
      if (row.menu == menu) rows.push_back(&row);
    }
    const std::string_view above = menu_above(menu);
    const std::string heading = above.empty() ? std::string(menu) : fmt::format("{} > {}", above, menu);
    text += fmt::format("## {}\n\n{}\n", heading, command_rows(rows));
  }
  return text;
}

std::string keys_page() {
  std::string text = "# Keys\n\nThey are changed, or taken from a preset, in *Help > Change keys…*\n\n| command |";
  std::string rule = "| --- |";
  std::vector<Keymap> keymaps;
  for (const KeyPreset preset : kKeyPresets) {
    text += fmt::format(" {} |", title_of(preset));
    rule += " --- |";
    keymaps.emplace_back(KeyChoices{preset, {}});
  }
  text += "\n" + rule + "\n";
  for (const CommandRow& row : command_table()) {
    const bool any = std::any_of(keymaps.begin(), keymaps.end(),
                                 [&](const Keymap& keymap) { return !keymap.chords(row.id).empty(); });
    if (!any) continue;
    text += fmt::format("| {}{} |", cell(row.title), row.context.empty() ? "" : fmt::format(" ({})", row.context));
    for (const Keymap& keymap : keymaps) text += fmt::format(" {} |", keys_of(keymap, row.id));
    text += "\n";
  }
  text += "\n## Mouse\n\n| act | how |\n| --- | --- |\n";
  for (const MouseHelp& help : all_mouse_help()) text += fmt::format("| {} | {} |\n", cell(help.act), cell(help.how));
  return text;
}

std::string panels_page() {
  std::string text = "# Panels\n\n`F1` shows the page of the panel under the pointer.\n\n";
  for (std::size_t i = 0; i < kPanelCount; ++i) text += panel_section(static_cast<PanelId>(i));
  return text;
}

Result<ManualReport> write_manual(const ManualOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(options.folder / "panels", error);
  if (error) {
    return tl::unexpected(Error(ErrorCode::kIo, "the folder for the manual cannot be made (" + error.message() + ")")
                              .at(options.folder.string()));
  }
  const TemporaryProject made;
  std::filesystem::path project = options.project;
  if (project.empty()) {
    TROCAR_ASSIGN_OR_RETURN(project, made.make(options.progress));
  }
  TROCAR_RETURN_IF_ERROR(take_pictures(options, project));
  TROCAR_RETURN_IF_ERROR(write_file(options.folder / "index.md", std::string(kIndex)));
  TROCAR_RETURN_IF_ERROR(write_file(options.folder / "commands.md", commands_page()));
  TROCAR_RETURN_IF_ERROR(write_file(options.folder / "keys.md", keys_page()));
  TROCAR_RETURN_IF_ERROR(write_file(options.folder / "panels.md", panels_page()));
  constexpr int kPages = 4;
  return ManualReport{static_cast<int>(command_table().size()), static_cast<int>(kPanelCount), kPages,
                      static_cast<int>(kPanelCount)};
}

}  // namespace trocar::ui
