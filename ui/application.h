/// A session and a workbench together: what the window program, scripts and tests step frame by frame.
#pragma once

#include <functional>
#include <memory>

#include "engine/workbench/workbench.h"
#include "ui/session.h"

namespace trocar::ui {

/// Threads: the main thread. `window` and `workbench` outlive this.
class Application {
 public:
  static Result<std::unique_ptr<Application>> create(Window& window, workbench::Workbench& workbench,
                                                     Settings settings);

  /// One frame: takes in what the threads finished, draws, posts what the user asked for. Waits for input up to
  /// `timeout_s` if nothing moves, and draws nothing if then nothing has happened.
  Status step(double timeout_s);
  bool quit() const { return quit_; }
  Session& session() { return *session_; }
  workbench::Workbench& workbench() { return workbench_; }

 private:
  Application(Window& window, workbench::Workbench& workbench) : window_(window), workbench_(workbench) {}
  /// Between two frames while something moves; input ends it.
  double pause_s() const;

  Window& window_;
  workbench::Workbench& workbench_;
  std::unique_ptr<Session> session_;
  bool quit_ = false;
};

/// Runs until the window closes or `stopped` is true; sleeps while nothing moves.
Status run(Application& application, const std::function<bool()>& stopped);

}  // namespace trocar::ui
