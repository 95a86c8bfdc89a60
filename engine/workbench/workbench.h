/// The application without a face: one object that the window and the command line drive alike.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/clock.h"
#include "engine/core/image.h"
#include "engine/demonstration/recording.h"
#include "engine/learning/field.h"
#include "engine/learning/rollout.h"
#include "engine/simulation/world_state.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

enum class JobState { kQueued, kRunning, kDone, kFailed, kCancelled };
struct JobView {
  JobId id;
  std::string title;  ///< "Train exact on segment A"
  JobState state = JobState::kQueued;
  double fraction = 0.0;
  std::string message;  ///< What it found, or the error.
};

enum class Severity { kInfo, kWarning, kError };
struct LogLine {
  std::string time;  ///< "12:03:41"
  Severity severity = Severity::kInfo;
  std::string text;
};

/// What the selected model says, worked out once when it is selected or trained.
struct ModelInsight {
  std::shared_ptr<const ModelEntry> entry;
  bool stale = false;
  learning::Exploration exploration;
  std::shared_ptr<const learning::Field> field;  ///< Of the layer in `FieldSettings`.
  std::shared_ptr<const std::vector<std::uint8_t>> policy;
  std::shared_ptr<const learning::Basin> basin;
  std::array<learning::RolloutSummary, 5> around;  ///< k = 1 … 5.
  learning::RolloutSummary all;
  std::vector<learning::Rollout> ghosts;  ///< For `RolloutSettings`.
};

/// A transfer that is being recorded now.
struct LiveView {
  simulation::WorldState world;
  demonstration::Segment segment = demonstration::Segment::kA;
  double elapsed_s = 0.0;
  std::int64_t samples = 0;
  double realtime_factor = 0.0;
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
  std::optional<ModelInsight> insight;
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
