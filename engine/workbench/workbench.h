/// The application without a face: one object that the window and the command line drive alike.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/clock.h"
#include "engine/core/image.h"
#include "engine/demonstration/recording.h"
#include "engine/workbench/command.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/job_view.h"
#include "engine/workbench/live_runner.h"
#include "engine/workbench/project.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

enum class Severity { kInfo, kWarning, kError };
struct LogLine {
  std::string time;  ///< "12:03:41"
  Severity severity = Severity::kInfo;
  std::string text;
};

enum class LoadState { kNone, kLoading, kReady, kFailed };

/// All that panels read. Replaced piecewise in `poll()`; constant while a frame is drawn.
struct WorkbenchState {
  LoadState load = LoadState::kNone;
  std::string load_error;
  std::filesystem::path path;
  std::shared_ptr<const Project> project;  ///< Null unless `kReady`.
  std::vector<HistoryNode> history;
  std::int64_t head = 0;
  bool undoable = false;
  bool redoable = false;

  DemonstrationId demonstration;  ///< Selected, or none.
  ModelId model;
  double playhead_s = 0.0;
  double play_speed = 0.0;  ///< 0: paused.

  scene::OrbitCamera orbit;
  std::optional<scene::CameraPreset> camera_preset;  ///< Until the view is orbited.
  FieldSettings field;
  RolloutSettings rollouts;
  std::shared_ptr<const ModelInsight> insight;  ///< Of the selected model; null until worked out.
  bool insight_pending = false;
  std::optional<LiveView> live;

  std::shared_ptr<const Image> picture;  ///< The newest 3-D view; null until the first.
  std::uint64_t picture_number = 0;      ///< Changes with each new picture.
  bool picture_pending = false;
  std::string picture_error;

  std::vector<JobView> jobs;  ///< Newest first.
  std::vector<LogLine> log;   ///< Oldest first, at most 500.
};

/// Threads: the main thread owns it; a picture thread, a job thread and a simulation thread work behind it.
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

  /// Never waits: edits are done at once, all else starts or queues. Errors go to the log (and to a failed job).
  void post(Command command);
  /// Takes in what the threads finished and moves the playhead; call once a frame. True if the state changed.
  bool poll();
  /// True while something moves or is awaited, so that the window should not sleep.
  bool busy() const;
  /// For scripts and tests: polls until jobs, recording and picture are done, at most `limit_s` of wall time.
  Status wait_idle(double limit_s);
  const WorkbenchState& state() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::workbench
