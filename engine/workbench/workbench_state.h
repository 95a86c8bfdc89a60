/// All that panels read of the workbench, as one value.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/workbench/batch.h"
#include "engine/workbench/command.h"
#include "engine/workbench/edit_preview.h"
#include "engine/workbench/exporting.h"
#include "engine/workbench/film_preview.h"
#include "engine/workbench/filmstrip.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/job_view.h"
#include "engine/workbench/library.h"
#include "engine/workbench/live_runner.h"
#include "engine/workbench/live_trace.h"
#include "engine/workbench/live_training.h"
#include "engine/workbench/path_sketch.h"
#include "engine/workbench/project.h"
#include "engine/workbench/project_file.h"
#include "engine/workbench/reviewing.h"
#include "engine/workbench/rolling.h"
#include "engine/workbench/seed_insight.h"
#include "engine/workbench/take_view.h"
#include "engine/workbench/trials_view.h"

namespace trocar::workbench {

struct ImportView;

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
  Checkpoints checkpoints;
  Replays replays;
  /// What `SketchHistory` asked for so far, by node; null of a node whose edit left no demonstration to draw.
  std::map<std::int64_t, std::shared_ptr<const PathSketch>> sketches;

  /// While `ShowLibrary` is on: its rows, null until they are there; of an older version, or not all measured yet,
  /// while `library_pending`.
  std::shared_ptr<const LibraryView> library;
  bool library_on = false;
  bool library_pending = false;
  std::shared_ptr<const BatchPlan> batch;  ///< What `PlanBatch` asked for; likewise.
  bool batch_pending = false;

  DemonstrationId demonstration;  ///< Selected, or none.
  ModelId model;
  /// What an edit that is being made would do, null if none is; for the selected demonstration.
  std::shared_ptr<const EditPreview> preview;
  /// The problems of the selected demonstration; null until worked out, of an older version while `review_pending`.
  std::shared_ptr<const ReviewView> review;
  bool review_pending = false;
  /// Likewise of what the edit that is being made would leave; null until worked out.
  std::shared_ptr<const ReviewView> preview_review;
  /// Of the selected demonstration as it is; nothing before it was asked for.
  std::optional<SimulationView> simulation;
  /// What `ShowCurves` asked for, null until worked out; it may be of an older version while `curves_pending`.
  std::shared_ptr<const CurveSet> curves;
  CurveKinds curve_kinds = 0;
  bool curves_pending = false;
  /// What `CompareWith` asked for; likewise.
  std::optional<ComparisonSettings> comparing;
  std::shared_ptr<const ComparisonView> comparison;
  bool comparison_pending = false;
  /// What `ReadImport` found; null until then, of older settings while `import_pending`.
  std::shared_ptr<const ImportView> import;
  bool import_pending = false;
  double import_fraction = 0.0;        ///< 0 … 1, of the reading that is pending.
  std::optional<ExportView> exported;  ///< The last one of this run of the program.
  GizmoSettings gizmo;
  double playhead_s = 0.0;
  double play_speed = 0.0;             ///< 0: paused.
  std::optional<TimeSpan> selection;   ///< In time, of the selected demonstration.
  std::optional<TimeSpan> edges;       ///< What `ShowEdges` asked for.
  std::optional<Clipboard> clipboard;  ///< What can be pasted into any demonstration.
  bool snapping = true;
  Loop loop = Loop::kOff;
  std::string done;  ///< What was last done, as a sentence.

  scene::OrbitCamera orbit;
  std::optional<scene::CameraPreset> camera_preset;  ///< Until the view is orbited.
  FieldSettings field;
  std::vector<FieldSettings> field_layers;  ///< Drawn besides it.
  RolloutSettings rollouts;
  LearningSettings learning;
  std::shared_ptr<const ModelInsight> insight;  ///< Of the selected model; null until worked out.
  bool insight_pending = false;
  std::shared_ptr<const SeedInsight> seeds;  ///< Of `learning.seeds`; null until worked out.
  bool seeds_pending = false;
  std::shared_ptr<const TrainingView> training;  ///< The one that runs, null if none has told anything yet.
  /// The last ones; of another model or other starts than are shown now, if they say so.
  std::shared_ptr<const MonteCarloView> monte_carlo;
  std::shared_ptr<const PhysicsView> physics;
  std::optional<LiveView> live;
  std::optional<TrialsView> trials;             ///< From `StartTrials` to `EndTrials`.
  std::optional<FromCell> trial_start;          ///< As `SetTrialStart` said.
  std::optional<TakeView> take;                 ///< With `live`, if a person drives.
  std::shared_ptr<const LiveTrace> live_trace;  ///< With `live`: what was recorded so far, for the lanes.
  std::int64_t disk_free_bytes = -1;            ///< With `live`: where the project is; −1: unknown.
  /// As it was last armed; what `R` arms again.
  RecordByHand last_take;
  /// Why no SpaceMouse can drive; "" if one can. As `FindDevices` found it.
  std::string space_mouse_missing = "nobody has looked for one yet";

  std::shared_ptr<const Image> picture;  ///< The newest 3-D view; null until the first.
  std::uint64_t picture_number = 0;      ///< Changes with each new picture.
  bool picture_pending = false;
  std::optional<TimeSpan> picture_edges;  ///< The instants that it shows, left and right half; nothing: one alone.
  std::optional<std::array<std::string, 2>> picture_models;  ///< The names of those in its halves; nothing: one alone.
  std::string picture_error;
  bool light_backdrop = false;
  /// What `ShowFilmstrip` asked for; null until then, and while something is recorded.
  std::shared_ptr<const Filmstrip> filmstrip;

  FilmDraft film;                                   ///< As `SetFilm` or a job in a file said.
  std::shared_ptr<const FilmPreview> film_preview;  ///< As `PreviewFilm` last found it; null until then.
  bool film_preview_pending = false;
  std::optional<FilmFile> film_file;  ///< Opened or written in this run of the program.

  std::vector<JobView> jobs;  ///< Newest first.
  std::vector<LogLine> log;   ///< Oldest first, at most 500.
};

}  // namespace trocar::workbench
