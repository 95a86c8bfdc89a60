/// The application without a face: one object that the window and the command line drive alike.
#pragma once

#include <memory>

#include "engine/core/clock.h"
#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/workbench/command.h"
#include "engine/workbench/workbench_state.h"

namespace trocar::workbench {

/// Threads: the main thread owns it; a picture thread, two job threads and a simulation thread work behind it.
class Workbench {
 public:
  struct Options {
    std::shared_ptr<const Clock> clock;  ///< Null: the system's.
    bool picture = true;                 ///< False: no renderer (logic tests).
  };
  explicit Workbench(Options options);
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// Never waits: edits are done at once, but for those of all of a long demonstration; all else starts or queues.
  /// Errors go to the log (and to a failed job).
  void post(Command command);
  /// Takes in what the threads finished and moves the playhead; call once a frame. True if the state changed.
  bool poll();
  /// True while something moves or is awaited, so that the window should not sleep.
  bool busy() const;
  /// For scripts and tests: polls until jobs, recording and picture are done, at most `limit_s` of wall time.
  /// Errors: kCancelled when that time is over, or `progress` (if any) is cancelled; the work goes on then.
  Status wait_idle(double limit_s, const Progress* progress = nullptr);
  /// Ends what is under way, before the program does: jobs are cancelled and leave nothing behind, a recording is kept
  /// as aborted. Errors: kCancelled if that takes longer than `limit_s` of wall time.
  Status finish(double limit_s);
  const WorkbenchState& state() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::workbench
