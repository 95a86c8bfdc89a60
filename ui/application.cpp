#include "ui/application.h"

#include "ui/format.h"

namespace trocar::ui {

Result<std::unique_ptr<Application>> Application::create(Window& window, workbench::Workbench& workbench,
                                                         Settings settings) {
  std::unique_ptr<Application> application(new Application(window, workbench));
  TROCAR_ASSIGN_OR_RETURN(application->session_, Session::create(window, std::move(settings)));
  return application;
}

double Application::pause_s() const {
  constexpr double kWatched_s = 1.0 / 30.0;  // Something plays, which may be looked at beside another window.
  constexpr double kElsewhere_s = 0.1;
  if (window_.focused()) return 0.0;
  const workbench::WorkbenchState& state = workbench_.state();
  return state.live || state.play_speed != 0.0 ? kWatched_s : kElsewhere_s;
}

Status Application::step(double timeout_s) {
  const bool moving = workbench_.busy() || session_->restless();
  window_.poll(moving ? pause_s() : timeout_s);
  const bool changed = workbench_.poll();
  const bool close_asked = window_.take_close_request();
  if (!moving && !changed && !close_asked && !window_.wants_frame()) return {};
  const workbench::WorkbenchState& state = workbench_.state();
  const std::string project = state.project == nullptr ? "" : state.path.filename().string() + " – ";
  window_.set_title(project + "Trocar");
  TROCAR_ASSIGN_OR_RETURN(ShellResult result, session_->frame(state, close_asked));
  for (workbench::Command& command : result.commands) workbench_.post(std::move(command));
  quit_ = quit_ || result.quit;
  return {};
}

Status run(Application& application, const std::function<bool()>& stopped) {
  // A job's progress and a picture that arrives late are looked for this often while nothing else happens.
  constexpr double kRest_s = 0.25;
  while (!application.quit() && !stopped()) TROCAR_RETURN_IF_ERROR(application.step(kRest_s));
  return {};
}

}  // namespace trocar::ui
