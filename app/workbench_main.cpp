// The window: opens it on a project and runs until it is closed.
#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

#include "engine/workbench/workbench.h"
#include "ui/application.h"
#include "ui/settings.h"
#include "ui/window/glfw_window.h"

namespace {

using namespace trocar;

constexpr std::string_view kUsage =
    "usage: trocar-workbench [PROJECT.trocar]\n"
    "Opens the workbench, on a project if one is named. Everything else is done in the window, or by `trocar`.\n";

int complain(const Error& error) {
  fmt::print(stderr, "trocar-workbench: {}\n", error.text());
  return 3;
}

int run_window(const char* project) {
  const std::filesystem::path settings_file = ui::settings_path();
  ui::Settings settings = ui::load_settings(settings_file);
  Result<std::unique_ptr<ui::Window>> window = ui::open_glfw_window(settings.window, "Trocar");
  if (!window) return complain(window.error());
  workbench::Workbench workbench({});
  if (project != nullptr) {
    workbench.post(workbench::OpenProject{project, false});
    ui::add_recent(settings, project);
  }
  auto application = ui::Application::create(**window, workbench, std::move(settings));
  if (!application) return complain(application.error());
  (*application)->session().show_frame_rate(true);
  if (const Status done = ui::run(**application); !done) return complain(done.error());
  ui::Settings kept = (*application)->session().settings();
  kept.window = (*window)->size();
  // A disk that cannot keep the layout is no reason to fail on the way out.
  if (const Status saved = ui::save_settings(kept, settings_file); !saved) {
    fmt::print(stderr, "trocar-workbench: {}\n", saved.error().text());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first == "--help" || first == "-h") {
    fmt::print("{}", kUsage);
    return 0;
  }
  if (argc > 2 || first.starts_with("-")) {
    fmt::print(stderr, "{}", kUsage);
    return 2;
  }
  return run_window(argc > 1 ? argv[1] : nullptr);
}
