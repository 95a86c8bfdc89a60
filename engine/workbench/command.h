/// Everything a person can ask of the workbench, as data: edits, actions and changes of view, in one variant.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/film/composition.h"
#include "engine/learning/field.h"
#include "engine/learning/imported_model.h"
#include "engine/learning/model.h"
#include "engine/learning/monte_carlo.h"
#include "engine/learning/rollout_table.h"
#include "engine/media/video_writer.h"
#include "engine/plot/colour_map.h"
#include "engine/scene/scene.h"
#include "engine/trial/hand_session.h"
#include "engine/trial/physics_rollout.h"
#include "engine/trial/transfer_session.h"
#include "engine/workbench/clipboard.h"
#include "engine/workbench/comparing.h"
#include "engine/workbench/curves.h"
#include "engine/workbench/edit.h"
#include "engine/workbench/field_settings.h"
#include "engine/workbench/film_draft.h"
#include "engine/workbench/import_settings.h"
#include "engine/workbench/job_view.h"
#include "engine/workbench/plot_settings.h"
#include "engine/workbench/trial_plan.h"

namespace trocar::workbench {

struct OpenProject {
  std::filesystem::path path;
  bool create = false;
};
struct CommitEdit {
  Edit edit;
};
struct Undo {};
struct Redo {};
struct GoToHistory {
  std::int64_t node = 0;
};

/// Shows the selected demonstration as an edit would make it, without committing it.
struct PreviewEdit {
  demonstration::Edit edit;
  std::int64_t entry = 0;  ///< Not 0: the edit replaces this one of the stack.
};
struct EndPreview {};

/// What the handles in the 3-D view do to a surgical tool at the playhead, and how far in time it reaches.
enum class GizmoKind : std::uint8_t { kNone, kMove, kTurn };
struct GizmoSettings {
  GizmoKind kind = GizmoKind::kNone;
  demonstration::Arms arms = demonstration::Arms::kLeft;
  int axis = -1;          ///< Only along or about x, y or z (0, 1, 2); −1: any.
  double radius_s = 0.5;  ///< For a new waypoint; one that exists keeps its own.
  demonstration::Falloff falloff = demonstration::Falloff::kSmooth;
  demonstration::TurnFrame frame = demonstration::TurnFrame::kTool;
  bool operator==(const GizmoSettings&) const = default;
};
struct SetGizmo {
  GizmoSettings settings;
};

struct SelectDemonstration {
  DemonstrationId id;
};
struct SelectModel {
  ModelId id;
};

/// Works out curves of the selected demonstration, or of what an edit that is being made would leave of it.
struct ShowCurves {
  CurveKinds kinds = 0;  ///< 0: none.
};
/// Compares the selected demonstration (as previewed) from now on, until the end or another comparison.
struct CompareWith {
  ComparisonSettings settings;
};
struct EndComparison {};

/// Works out the rows of the library from now on, or no longer.
struct ShowLibrary {
  bool on = true;
};
/// Works out what an act (`act_from_words`) would do to each of several demonstrations. No words: no more of it.
struct PlanBatch {
  std::vector<DemonstrationId> demonstrations;
  std::vector<std::string> words;
};
/// Gives a point of the history a name that stays: "" takes it away, none at all is "Checkpoint 3".
struct NameCheckpoint {
  std::int64_t node = 0;
  std::optional<std::string> name;
};
/// Makes small pictures of what the edits of these points left, a few at a time; they are kept.
struct SketchHistory {
  std::vector<std::int64_t> nodes;
};

struct SetPlayhead {
  double t_s = 0.0;
};  ///< Of the selected demonstration; kept within its gates.
struct Play {
  double speed = 1.0;
};  ///< 0 pauses.

/// Of the selected demonstration; kept within its gates.
struct SetSelection {
  std::optional<TimeSpan> span;
};
/// Puts a run into the clipboard as it is now.
struct CopyRun {
  DemonstrationId demonstration;
  TimeSpan span;
};
/// Shows two instants side by side in the 3-D view, as while an edge in time is dragged; nothing: one again. Beyond the
/// gates too.
struct ShowEdges {
  std::optional<TimeSpan> edges;
};
/// Whether what is dragged in time goes to the events near it.
struct SetSnapping {
  bool on = true;
};
/// What is played again and again: the selection, or what lies between the gates if nothing is selected; or the
/// segment that the playhead is in.
enum class Loop : std::uint8_t { kOff, kSpan, kSegment };
struct SetLoop {
  Loop loop = Loop::kOff;
};

/// The 3-D view: where from, how large, what over it.
struct SetCamera {
  scene::OrbitCamera orbit;
};
struct SetCameraPreset {
  scene::CameraPreset preset = scene::CameraPreset::kPaper;
};
struct SetViewSize {
  int width = 960;
  int height = 540;
};
/// A light ground behind the 3-D view, for a light window; films and rendered views keep theirs.
struct SetBackdrop {
  bool light = false;
};
/// Small pictures of the selected demonstration along time from now on, at `first_s`, `first_s + step_s` and so on; in
/// a worker, one after the other, kept as long as there is room. `count` 0: no more of it.
struct ShowFilmstrip {
  double first_s = 0.0;
  double step_s = 1.0;
  int count = 0;       ///< Cut to `kFilmstripPictures`.
  int height_px = 54;  ///< Of each; they are 16 to 9.
  bool operator==(const ShowFilmstrip&) const = default;
};
constexpr int kFilmstripPictures = 64;
struct SetField {
  FieldSettings settings;
};
/// Fields of the selected model that are drawn in the 3-D view besides the one that `SetField` means, in this order.
struct SetFieldLayers {
  std::vector<FieldSettings> layers;
};
/// What all rollouts have in common at an instant of their play: so many steps, or the same share of the way of each.
/// A model is of one segment: the share of the way is that of the segment.
enum class GhostPace : std::uint8_t { kStep, kLength };
struct RolloutSettings {
  std::string starts = "around:3";  ///< As `learning::read_starts` reads it.
  bool ghosts = true;               ///< Draw them in the 3-D view.
  int ghost_count = 60;
  /// The start whose rollout stands out; it need not be one of `starts`.
  std::optional<spatial::CellIndex> selected;
  GhostPace pace = GhostPace::kStep;
  /// How far the rollouts have come where they are drawn: steps, or the share of its way, 0 … 1. None: to their ends.
  std::optional<double> reach;
  std::vector<learning::RolloutRange> brushed;  ///< Rollouts outside of one of them are grey and thin in the 3-D view.
  bool operator==(const RolloutSettings&) const = default;
};
struct SetRollouts {
  RolloutSettings settings;
};
/// Lets the agent err at random, from the chosen starts; what is finished of a cancelled one is kept.
struct RunMonteCarlo {
  learning::MonteCarloOptions options;
};
/// Drives the selected model's policy through the simulator, from the chosen starts. Asked for again after it was
/// cancelled, it goes on where it stopped.
struct RunPhysics {
  trial::PhysicsOptions options;
};
/// Which rows of rollouts are written: of the greedy ones, these with what erring at random found, the simulator's, or
/// the band of the deviations of the greedy ones, step by step.
enum class RolloutRows : std::uint8_t { kGreedy, kErring, kSimulated, kBand };
/// Writes the rows of the chosen starts. What was found of another model or of other starts is not written.
struct ExportRollouts {
  std::filesystem::path path;  ///< .csv, .json or .h5.
  RolloutRows rows = RolloutRows::kGreedy;
};
/// Draws the selected model, and the second one beside it, from the chosen starts; or their learning curves.
struct ExportPlot {
  PlotSettings settings;
  std::filesystem::path path;
};
/// How models are looked at: beside which other one, at which epoch, and whether a model of the method `exact` follows
/// its demonstrations while they are edited.
struct LearningSettings {
  ModelId second;  ///< None: the selected model alone.
  int epoch = -1;  ///< Of the training; −1: its end.
  bool follow = true;
  bool second_in_view = false;  ///< The second model, too, in the right half of the 3-D view.
  int seeds = 0;                ///< So many trainings with other seeds are studied (at least 2); 0: none.
  bool operator==(const LearningSettings&) const = default;
};
struct SetLearning {
  LearningSettings settings;
};

/// Runs the scripted operators live at 1 kHz in the simulation thread and records; `realtime` false: as fast as it
/// goes.
struct RecordScripted {
  trial::TransferOptions options;
  std::string name;
  bool realtime = true;
};
struct StopRecording {
  bool keep = true;
};
/// A cell of the cube of `grid` cells a side.
struct FromCell {
  spatial::CellCoordinates cell;
  int grid = 22;
  /// Whose beginning the world is at: in C the block is in the jaws, as a scripted expert took it.
  demonstration::Segment segment = demonstration::Segment::kA;
  bool operator==(const FromCell&) const = default;
};
/// A person drives live: the simulator runs at once, recording begins after the countdown.
struct RecordByHand {
  trial::HandOptions options;     ///< World, lead-in and replay are found from what follows.
  std::string name;               ///< Empty: "By hand 1" and so on.
  DemonstrationId replayed;       ///< What replayed arms do, and what is replaced; none: neither.
  bool gamepad = false;           ///< Drives too.
  bool space_mouse = false;       ///< Likewise; a take without it is armed if it has gone.
  std::optional<TimeSpan> punch;  ///< Of `replayed`: only that is recorded, and replaces it.
  std::optional<FromCell> from;   ///< Where the left tool is led before it begins; not with `punch`.
};
/// Looks which devices can drive; `WorkbenchState::space_mouse_missing` tells.
struct FindDevices {};
/// What the operator did since the last one, in order.
struct HandInput {
  std::vector<trial::HandEvent> events;
};
/// What becomes of a take by hand that has ended.
enum class TakeVerdict : std::uint8_t { kKeep, kKeepAndNext, kAgain, kDiscard };
struct JudgeTake {
  TakeVerdict verdict = TakeVerdict::kKeep;
};

/// The blocks of a protocol, one after the other, each started by the operator; without a protocol one block of
/// `plan.transfers`.
struct StartTrials {
  TrialPlan plan;               ///< Of every block; mode and delay are the block's.
  std::string protocol;         ///< As `trial::find_protocol` takes it; "": none.
  int subject_number = 0;       ///< For the order of blocks, with the plan's seed.
  bool person = false;          ///< At keys, mouse and sticks; else the scripted operator of the plan's skill.
  bool person_assists = false;  ///< A second one has the right arm; else the scripted expert.
  bool gamepad = false;         ///< Drives too, with the pedals on its bumpers and buttons.
  bool space_mouse = false;     ///< Likewise; trials without it are begun if it has gone.
  /// Instead of keys and mouse a console over TCP that comes to this port (0: any that is free), for the left arm, and
  /// with `person_assists` its right hand for the right one.
  std::optional<std::uint16_t> console_port;
  bool realtime = true;
  std::optional<FromCell> from;  ///< The left tool begins there; of segment A.
};
/// What the next trials are to begin with: a start of a rollout, or nothing special.
struct SetTrialStart {
  std::optional<FromCell> from;
};
/// The next block of those that were prepared.
struct StartBlock {};
/// Between two transfers; false goes on.
struct PauseTrials {
  bool paused = true;
};
/// Presses stop: the tool holds, the transfer is over as aborted, and the block pauses.
struct StopTrial {};
/// Gives the rest of the blocks up; a transfer that runs is kept as interrupted.
struct EndTrials {};
struct MarkIncident {
  std::string text;
};
/// Writes the trials: a row for each as .csv, both modes compared as .html.
struct ExportTrials {
  std::filesystem::path path;
};

struct TrainModel {
  std::vector<DemonstrationId> demonstrations;
  demonstration::Segment segment = demonstration::Segment::kA;
  learning::TrainOptions options;
  int grid = 22;
  std::string name;  ///< Empty: made from method and segment.
};
/// Drives the simulator with it, as it is now: is the block still transferred?
struct SimulateDemonstration {
  DemonstrationId demonstration;
};
/// Makes the quick fixes of all its problems that help, together one step of the history.
struct FixProblems {
  DemonstrationId demonstration;
};
struct VerifyReplay {
  DemonstrationId demonstration;
};
struct ExportVideo {
  std::vector<DemonstrationId> demonstrations;  ///< One, or two side by side.
  std::filesystem::path path;
  int width = 1280;
  int height = 720;
  double fps = 30.0;
  double speed = 1.0;  ///< Demonstration seconds for each second of film.
  scene::CameraPreset camera = scene::CameraPreset::kPaper;
  media::Codec codec = media::Codec::kAuto;
  bool captions = true;
  bool all_overlays = false;  ///< Metrics, tally, trail, ghost and captions in a file too; not without `captions`.
  film::Sync sync = film::Sync::kClock;
  film::Layout two = film::Layout::kSideBySide;  ///< How two lie.
};
/// The film that is being made, from now on.
struct SetFilm {
  FilmDraft draft;
};
/// Draws the film that is being made at its instant, behind the window.
struct PreviewFilm {};
/// Queues a film, as it is in the composition.
struct RenderFilm {
  film::Composition film;
};
/// The film that is being made is that of a job in a file, or is written as one.
struct OpenFilmJob {
  std::filesystem::path path;
};
struct SaveFilmJob {
  std::filesystem::path path;
};
/// Of the job that runs, if it is a film; false goes on.
struct PauseJob {
  JobId id;
  bool paused = true;
};
struct ExportField {
  ModelId model;
  learning::Layer layer = learning::Layer::kReward;
  std::string slice;  ///< "z=11"; empty: montage.
  FieldFileLook look;
  std::filesystem::path path;
  learning::FieldMask mask = learning::FieldMask::kNone;
  ModelId against;  ///< None: the field itself; else what this model (B) changes, and which of it.
  FieldContrast contrast = FieldContrast::kDifference;
  int slab = 1;  ///< Cells that the slice is thick.
  learning::Through through = learning::Through::kLargest;
};
/// Makes a model of a table that another program learned.
struct ImportTable {
  std::filesystem::path path;
  learning::TableKind kind = learning::TableKind::kQ;
  std::vector<DemonstrationId> demonstrations;  ///< They give start, goal, expert's cells and safe set.
  demonstration::Segment segment = demonstration::Segment::kA;
  int grid = 22;
  int safe_radius = 4;  ///< In cells.
  std::string name;     ///< Empty: that of the file.
};
/// Reads a file of another program and shows what would come of it; nothing is changed yet.
struct ReadImport {
  ImportSettings settings;
};
struct EndImport {};
/// Puts what was last read into the project, as one step.
struct MakeImport {};
/// Writes them for other programs, and reads them again.
struct ExportDemonstrations {
  std::vector<DemonstrationId> demonstrations;
  std::filesystem::path path;
  exchange::Format format = exchange::Format::kCsv;
  exchange::Masks masks;  ///< Places in `demonstrations` for each filter key.
};
struct CancelJob {
  JobId id;
};
/// A warning of whoever drives the workbench, for its log.
struct Report {
  std::string sentence;
};

using Command =
    std::variant<OpenProject, CommitEdit, Undo, Redo, GoToHistory, PreviewEdit, EndPreview, SetGizmo,
                 SelectDemonstration, SelectModel, ShowCurves, CompareWith, EndComparison, ShowLibrary, PlanBatch,
                 NameCheckpoint, SketchHistory, SetPlayhead, Play, SetSelection, ShowEdges, CopyRun, SetSnapping,
                 SetLoop, SetCamera, SetCameraPreset, SetViewSize, SetBackdrop, ShowFilmstrip, SetField, SetFieldLayers,
                 SetRollouts, SetLearning, RunMonteCarlo, RunPhysics, ExportRollouts, ExportPlot, RecordScripted,
                 StopRecording, RecordByHand, FindDevices, HandInput, JudgeTake, TrainModel, VerifyReplay,
                 SimulateDemonstration, FixProblems, ExportVideo, ExportField, ImportTable, ReadImport, EndImport,
                 MakeImport, ExportDemonstrations, CancelJob, Report, StartTrials, SetTrialStart, StartBlock,
                 PauseTrials, StopTrial, EndTrials, MarkIncident, ExportTrials, SetFilm, PreviewFilm, RenderFilm,
                 OpenFilmJob, SaveFilmJob, PauseJob>;

}  // namespace trocar::workbench
