// The window: opens it on a project and runs until it is closed.
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string_view>
#include <utility>

#include "app/crash_report.h"
#include "engine/workbench/workbench.h"
#include "ui/application.h"
#include "ui/settings.h"
#include "ui/window/glfw_window.h"

namespace {

using namespace trocar;

constexpr std::string_view kUsage =
    "usage: trocar-workbench [PROJECT.trocar]\n"
    "Opens the workbench, on a project if one is named. Everything else is done in the window, or by `trocar`.\n";

volatile sig_atomic_t stop_signal = 0;

// The second one does not wait for a tidy end.
void on_signal(int signal) {
  if (stop_signal != 0) _exit(128 + signal);
  stop_signal = signal;
}

void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

int complain(const Error& error) {
  fmt::print(stderr, "trocar-workbench: {}\n", error.text());
  return 3;
}

int run_window(const char* project) {
  const std::filesystem::path settings_file = ui::settings_path();
  Diagnostics odd;
  ui::Settings settings = ui::load_settings(settings_file, odd);
  Result<std::unique_ptr<ui::Window>> window = ui::open_glfw_window(settings.window, "Trocar");
  if (!window) return complain(window.error());
  workbench::Workbench workbench({});
  for (const std::string& sentence : odd.warnings()) workbench.post(workbench::Report{sentence});
  if (project != nullptr) {
    workbench.post(workbench::OpenProject{project, false});
    ui::add_recent(settings, project);
  }
  auto application = ui::Application::create(**window, workbench, std::move(settings));
  if (!application) return complain(application.error());
  (*application)->session().show_frame_rate(true);
  listen_to_signals();
  const Status done = ui::run(**application, [] { return stop_signal != 0; });
  // A film that is being written must not stay as half a file, a recording not as something to be recovered.
  constexpr double kPatience_s = 20.0;
  const Status finished = workbench.finish(kPatience_s);
  if (!done) return complain(done.error());
  if (!finished) fmt::print(stderr, "trocar-workbench: {}\n", finished.error().text());
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
  trocar::app::report_crashes("trocar-workbench");
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
