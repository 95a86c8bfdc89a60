#include "ui/headless.h"

#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include "engine/core/clock.h"
#include "engine/core/file.h"
#include "engine/media/picture_file.h"
#include "ui/application.h"
#include "ui/driver/driver.h"
#include "ui/driver/script.h"
#include "ui/window/osmesa_window.h"

namespace trocar::ui {
namespace {

class Runner {
 public:
  Runner(Application& application, const UiRunOptions& options, UiRunReport& report)
      : application_(application),
        progress_(options.progress),
        folder_(options.script.parent_path()),
        report_(report),
        driver_(application.session(), [this] { return step(); }) {}

  Status step() {
    if (progress_ != nullptr && progress_->cancelled()) return fail(ErrorCode::kCancelled, "stopped by the user");
    ++report_.frames;
    return application_.step(0.0);
  }

  Status settle(double limit_s);
  /// As `settle`, but what goes on of itself, such as a take or playing, is shown as it is.
  Status settle_or_go_on();
  Status run(const ScriptLine& line);
  Status screenshot(const std::filesystem::path& path);

 private:
  Status expect(const ScriptLine& line);
  Status wait(const ScriptLine& line);
  /// Until `met` succeeds; its error if it does not in time.
  Status wait_until(const std::function<Status()>& met, double limit_s);

  Application& application_;
  const Progress* progress_;
  std::filesystem::path folder_;  ///< Of the script.
  UiRunReport& report_;
  Driver driver_;
};

float word_number(const std::string& word) {
  return std::strtof(word.c_str(), nullptr);
}

// Commands that a frame asks for may start work, whose end may ask for another picture; two rounds see it through.
Status Runner::settle(double limit_s) {
  for (int round = 0; round < 3; ++round) {
    TROCAR_RETURN_IF_ERROR(driver_.frames(4));
    TROCAR_RETURN_IF_ERROR(application_.workbench().wait_idle(limit_s, progress_));
  }
  return driver_.frames(3);
}

Status Runner::settle_or_go_on() {
  const workbench::WorkbenchState& state = application_.workbench().state();
  if (!state.live && state.play_speed == 0.0) return settle(60.0);
  // The newest picture is a moment behind.
  for (int i = 0; i < 10; ++i) {
    TROCAR_RETURN_IF_ERROR(step());
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {};
}

Status Runner::wait_until(const std::function<Status()>& met, double limit_s) {
  const SystemClock clock;
  const double end_s = clock.now_s() + limit_s;
  while (true) {
    Status now = met();
    if (now) return {};
    if (clock.now_s() > end_s) return now;
    TROCAR_RETURN_IF_ERROR(step());
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

Status Runner::wait(const ScriptLine& line) {
  const auto& words = line.words;
  constexpr double kPatience_s = 60.0;
  const auto limit_s = [&](std::size_t place) {
    return words.size() > place ? static_cast<double>(word_number(words[place])) : kPatience_s;
  };
  if (words[1] == "idle") return settle(limit_s(2));
  if (words[1] == "for") return wait_until([&] { return driver_.expect_present(words[2], true); }, limit_s(3));
  return wait_until([&] { return driver_.expect_contains(words[2], words[3]); }, limit_s(4));
}

Status Runner::expect(const ScriptLine& line) {
  const std::string& path = line.words[1];
  const std::string& what = line.words[2];
  if (what == "value") return driver_.expect_value(path, line.words[3]);
  if (what == "contains") return driver_.expect_contains(path, line.words[3]);
  if (what == "enabled" || what == "disabled") return driver_.expect_enabled(path, what == "enabled");
  return driver_.expect_present(path, what == "present");
}

Status Runner::run(const ScriptLine& line) {
  const auto& words = line.words;
  const std::string& verb = words[0];
  if (verb == "click") return driver_.click(words[1]);
  if (verb == "right_click") return driver_.right_click(words[1]);
  if (verb == "double_click") return driver_.double_click(words[1]);
  if (verb == "hover") return driver_.hover(words[1]);
  if (verb == "drag") {
    const int which = words.size() > 4 ? static_cast<int>(word_number(words[4])) : 0;
    if (which < 0 || which > 2) return fail(ErrorCode::kInvalidArgument, "a mouse button is 0, 1 or 2");
    return driver_.drag(words[1], word_number(words[2]), word_number(words[3]), which);
  }
  if (verb == "hold") return driver_.hold(words[1], word_number(words[2]), word_number(words[3]));
  if (verb == "wheel") return driver_.wheel(words[1], word_number(words[2]));
  if (verb == "type") return driver_.type(words[1], words[2]);
  if (verb == "key") return driver_.key(words[1]);
  if (verb == "key_down" || verb == "key_up") return driver_.held(words[1], verb == "key_down");
  if (verb == "drop") return driver_.drop((folder_ / words[1]).string());
  if (verb == "expect") return expect(line);
  if (verb == "wait") return wait(line);
  if (verb == "screenshot") return screenshot(words[1]);
  if (verb == "dump") return write_file(words[1], application_.session().items().to_json());
  return driver_.frames(static_cast<int>(word_number(words[1])));
}

Status Runner::screenshot(const std::filesystem::path& path) {
  TROCAR_RETURN_IF_ERROR(driver_.frames(2));
  TROCAR_ASSIGN_OR_RETURN(const Image image, application_.session().window().capture());
  TROCAR_RETURN_IF_ERROR(media::write_png(path, image));
  ++report_.screenshots;
  return {};
}

Status run_script(Runner& runner, const UiRunOptions& options, UiRunReport& report) {
  if (options.script.empty()) return {};
  TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(options.script));
  Result<std::vector<ScriptLine>> lines = parse_script(text);
  if (!lines) return tl::unexpected(std::move(lines).error().at(options.script.string()));
  for (const ScriptLine& line : *lines) {
    if (Status done = runner.run(line); !done) {
      const Error& why = done.error();
      Error error(why.code(), "line " + std::to_string(line.number) + ": " + why.text());
      return tl::unexpected(std::move(error).at(options.script.string()));
    }
    ++report.lines;
  }
  return {};
}

}  // namespace

Result<UiRunReport> run_headless(const UiRunOptions& options) {
  if (!(options.scale >= 0.75) || options.scale > 3.0) {
    return fail(ErrorCode::kInvalidArgument, "the scale is 0.75 to 3");
  }
  const SystemClock clock;
  const double begin_s = clock.now_s();
  TROCAR_ASSIGN_OR_RETURN(const std::unique_ptr<OsmesaWindow> window,
                          OsmesaWindow::create({options.width, options.height}));
  workbench::Workbench workbench({});
  if (!options.project.empty()) workbench.post(workbench::OpenProject{options.project, false});
  Settings settings;
  settings.scale = static_cast<float>(options.scale);
  settings.theme = options.theme;
  if (options.panel) {
    Tile alone;
    alone.panels = {*options.panel};
    settings.layout() = std::move(alone);
  }
  TROCAR_ASSIGN_OR_RETURN(const std::unique_ptr<Application> application,
                          Application::create(*window, workbench, std::move(settings)));
  UiRunReport report;
  Runner runner(*application, options, report);
  TROCAR_RETURN_IF_ERROR(runner.step());
  report.first_frame_s = clock.now_s() - begin_s;
  TROCAR_RETURN_IF_ERROR(runner.settle(60.0));
  if (!options.project.empty() && workbench.state().load != workbench::LoadState::kReady) {
    return fail(ErrorCode::kIo, workbench.state().load_error);
  }
  TROCAR_RETURN_IF_ERROR(run_script(runner, options, report));
  if (!options.screenshot.empty() || options.dump) TROCAR_RETURN_IF_ERROR(runner.settle_or_go_on());
  if (!options.screenshot.empty()) TROCAR_RETURN_IF_ERROR(runner.screenshot(options.screenshot));
  if (options.dump) report.dump = application->session().items().to_json();
  return report;
}

}  // namespace trocar::ui
