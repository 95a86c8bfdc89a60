#include <fmt/format.h>

#include "app/lookup.h"
#include "app/options.h"
#include "engine/core/file.h"
#include "ui/driver/script.h"
#include "ui/headless.h"
#include "ui/manual.h"

namespace trocar::app {
namespace {

struct UiArguments {
  std::string project;
  std::string script;
  std::string screenshot;
  std::string size = "1600x900";
  double scale = 1.0;
  std::string theme = "dark";
  bool light = false;
  std::string out;
};

void bind_common(CLI::App& verb, UiArguments& arguments) {
  verb.add_option("--project", arguments.project, "The project to open");
  verb.add_option("--script", arguments.script, "F.ui: acts by label, one a line");
  verb.footer("A script has one act a line; LABEL is one that `trocar ui dump` lists, in quotes:\n" +
              ui::script_verbs() + "demos/tour/tour.ui is one.");
  verb.add_option("--size", arguments.size, "Width and height in pixels")->capture_default_str();
  verb.add_option("--scale", arguments.scale, "Size of text and controls")
      ->check(CLI::Range(0.75, 3.0))
      ->capture_default_str();
  verb.add_option("--theme", arguments.theme, "Colours of the window")
      ->check(CLI::IsMember({"dark", "light", "high-contrast"}))
      ->capture_default_str();
  verb.add_flag("--light", arguments.light, "The same as --theme light");
}

void bind_window(CLI::App& verb, UiArguments& arguments) {
  bind_common(verb, arguments);
  verb.add_option("--screenshot", arguments.screenshot, "F.png: the window as it is at the end");
}

void bind_dump(CLI::App& verb, UiArguments& arguments) {
  bind_common(verb, arguments);
  verb.add_option("--out", arguments.out, "F.json: write the list into a file");
}

Result<ui::UiRunOptions> options_of(const UiArguments& arguments, const Progress& progress) {
  ui::UiRunOptions options;
  options.progress = &progress;
  TROCAR_ASSIGN_OR_RETURN(const auto size, size_from(arguments.size));
  if (!arguments.out.empty()) TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".json"}));
  if (!arguments.screenshot.empty()) {
    TROCAR_RETURN_IF_ERROR(check_output(arguments.screenshot, arguments.project, {".png"}));
  }
  options.project = arguments.project;
  options.script = arguments.script;
  options.screenshot = arguments.screenshot;
  options.width = size.first;
  options.height = size.second;
  options.scale = arguments.scale;
  options.theme = arguments.light ? ui::ThemeKind::kLight : *ui::theme_from(arguments.theme);
  return options;
}

Result<Answer> run_window(const UiArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const ui::UiRunOptions options, options_of(arguments, console.progress()));
  TROCAR_ASSIGN_OR_RETURN(const ui::UiRunReport report, ui::run_headless(options));
  Answer answer;
  answer.json = {{"lines", report.lines},
                 {"frames", report.frames},
                 {"screenshots", report.screenshots},
                 {"first_frame_s", report.first_frame_s},
                 {"width", options.width},
                 {"height", options.height}};
  answer.summary = fmt::format("{}, {}", counted(static_cast<std::size_t>(report.lines), "act"),
                               counted(static_cast<std::size_t>(report.screenshots), "screenshot"));
  return answer;
}

Result<Answer> run_dump(const UiArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(ui::UiRunOptions options, options_of(arguments, console.progress()));
  options.dump = true;
  TROCAR_ASSIGN_OR_RETURN(const ui::UiRunReport report, ui::run_headless(options));
  Answer answer;
  answer.json = {{"widgets", Json::parse(report.dump, nullptr, false)}};
  answer.summary = counted(answer.json["widgets"].size(), "widget");
  if (arguments.out.empty()) {
    answer.text = report.dump;
    return answer;
  }
  TROCAR_RETURN_IF_ERROR(write_file(arguments.out, report.dump));
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

void bind_manual(CLI::App& verb, UiArguments& arguments) {
  verb.add_option("--out", arguments.out, "DIR: the folder to write the pages into")->required();
  verb.add_option("--project", arguments.project, "The project to show in the pictures; else one is made for them");
}

Result<Answer> run_manual(const UiArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const ui::ManualReport report,
                          ui::write_manual({arguments.out, arguments.project, &console.progress()}));
  Answer answer;
  answer.json = {
      {"commands", report.commands}, {"panels", report.panels}, {"pages", report.pages}, {"pictures", report.pictures}};
  answer.summary = fmt::format("{}, {}, {}", counted(static_cast<std::size_t>(report.pages), "page"),
                               counted(static_cast<std::size_t>(report.commands), "command"),
                               counted(static_cast<std::size_t>(report.panels), "panel"));
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_ui_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("ui", "The workbench without a display")->require_subcommand(1);
  add_verb<UiArguments>(noun, chosen, "run", "Use the window from a script and take pictures of it", bind_window,
                        run_window);
  add_verb<UiArguments>(noun, chosen, "dump", "Print the list of widgets", bind_dump, run_dump);
  add_verb<UiArguments>(noun, chosen, "manual", "Write the manual: commands, keys, panels with their pictures",
                        bind_manual, run_manual);
}

}  // namespace trocar::app
