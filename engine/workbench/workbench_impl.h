/// The inside of `Workbench`: what each command does. Private to the module.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/device/space_mouse.h"
#include "engine/link/hand_server.h"
#include "engine/trial/stick_hands.h"
#include "engine/workbench/film_preview_maker.h"
#include "engine/workbench/job_runner.h"
#include "engine/workbench/latest_worker.h"
#include "engine/workbench/live_recording.h"
#include "engine/workbench/view_director.h"
#include "engine/workbench/workbench.h"

namespace trocar::workbench {

struct Workbench::Impl {
  explicit Impl(Options options_in);

  // One overload for each command.
  void on(const OpenProject& command);
  void on(const CommitEdit& command);
  void on(const Undo& command);
  void on(const Redo& command);
  void on(const GoToHistory& command);
  void on(const PreviewEdit& command);
  void on(const EndPreview& command);
  void on(const SetGizmo& command);
  void on(const SelectDemonstration& command);
  void on(const SelectModel& command);
  void on(const ShowCurves& command);
  void on(const CompareWith& command);
  void on(const EndComparison& command);
  void on(const ShowLibrary& command);
  void on(const PlanBatch& command);
  void on(const NameCheckpoint& command);
  void on(const SketchHistory& command);
  void on(const SetPlayhead& command);
  void on(const Play& command);
  void on(const SetSelection& command);
  void on(const ShowEdges& command);
  void on(const CopyRun& command);
  void on(const SetSnapping& command);
  void on(const SetLoop& command);
  void on(const SetCamera& command);
  void on(const SetCameraPreset& command);
  void on(const SetViewSize& command);
  void on(const SetBackdrop& command);
  void on(const ShowFilmstrip& command);
  void on(const SetField& command);
  void on(const SetFieldLayers& command);
  void on(const SetRollouts& command);
  void on(const SetLearning& command);
  void on(const RunMonteCarlo& command);
  void on(const RunPhysics& command);
  void on(const ExportRollouts& command);
  void on(const ExportPlot& command);
  void on(const RecordScripted& command);
  void on(const StopRecording& command);
  void on(const RecordByHand& command);
  void on(const FindDevices& command);
  void on(const HandInput& command);
  void on(const JudgeTake& command);
  void on(const TrainModel& command);
  void on(const VerifyReplay& command);
  void on(const SimulateDemonstration& command);
  void on(const FixProblems& command);
  void on(const ExportVideo& command);
  void on(const SetFilm& command);
  void on(const PreviewFilm& command);
  void on(const RenderFilm& command);
  void on(const OpenFilmJob& command);
  void on(const SaveFilmJob& command);
  void on(const PauseJob& command);
  void on(const ExportField& command);
  void on(const ImportTable& command);
  void on(const ReadImport& command);
  void on(const EndImport& command);
  void on(const MakeImport& command);
  void on(const ExportDemonstrations& command);
  void on(const StartTrials& command);
  void on(const SetTrialStart& command);
  void on(const StartBlock& command);
  void on(const PauseTrials& command);
  void on(const StopTrial& command);
  void on(const EndTrials& command);
  void on(const MarkIncident& command);
  void on(const ExportTrials& command);
  void on(const CancelJob& command);
  void on(const Report& command);

  void log(Severity severity, std::string text);
  /// Logs an error; false if there was one.
  bool succeeded(const Status& status);
  /// False, with a word in the log, unless a project is open and stays so.
  bool project_open();
  /// False, and said, while something is recorded: an edit would land on the line that the recording does not know of.
  bool document_free();
  /// False, with a word in the log, for a path that is the project's own.
  bool is_output(const std::filesystem::path& path);
  void take_project(std::shared_ptr<ProjectFile> opened);
  /// The project that was open stays; why another could not be opened is shown.
  void keep_project(const std::string& why);
  /// After every change of the document: selection, gates and insight follow it.
  void refresh_document();
  void request_insight();
  std::shared_ptr<const demonstration::Demonstration> demonstration(DemonstrationId id) const;
  std::shared_ptr<const ModelEntry> model(ModelId id) const;
  /// Of a node of the history; "" for its root.
  std::string description_of(std::int64_t node) const;
  /// Asks for the problems of what is selected, and takes in what was found.
  void follow_review();
  void follow_preview_review();
  /// The selected one, as an edit that is being made would leave it, if one is.
  std::shared_ptr<const demonstration::Demonstration> shown() const;
  /// Ask for what the state has come to need, and take in what is ready.
  void follow_curves();
  void follow_comparison();
  void follow_seeds();
  void follow_library();
  void follow_batch();
  /// What a replay found is kept with the project that it is of, even if another is open by now.
  void keep_replay(const std::shared_ptr<ProjectFile>& owner, demonstration::RecordingId id, const ReplayFound& found);
  /// Makes a few of the small pictures that are still missing.
  void sketch_history();
  void advance_playhead(double elapsed_s);
  /// What is played again and again; none: playing ends at the gate.
  std::optional<TimeSpan> looped() const;
  /// Says what was done, in the log and in the state.
  void tell(std::string sentence);
  /// Playhead and selection after an edit that took something out or put something in.
  void follow(const demonstration::Edit& edit, const demonstration::Demonstration& before,
              const demonstration::Demonstration& after);
  /// Changes the document now, or once other programs have finished writing to it, in order: the interface does not
  /// wait for them. `attempt` is false if it was held up.
  void write(std::function<bool()> attempt);
  bool attempt_now(const std::function<bool()>& attempt);
  void retry_writes();
  bool commit(const CommitEdit& command);
  /// An edit that rewrites all of a long demonstration is made beside the window, and then committed. True if that has
  /// begun; false if the edit is quick, or made already.
  bool make_beside(const CommitEdit& command);
  /// Undo, redo and their like.
  bool move(const std::function<Status()>& step);
  /// Into the project that it was learned from, even if another is open by now.
  Status keep_model(const std::shared_ptr<ProjectFile>& owner, const std::shared_ptr<const ModelEntry>& entry);
  void follow_filmstrip();
  void follow_film();
  /// Queues it; `film.path` says where it goes.
  void start_film(film::Composition film);
  void poll_recording();
  /// The next transfer of the block, or its end.
  void go_on_with_trials();
  /// Why no trials can be begun for want of disk; "" if they can.
  std::string no_room() const;
  void begin_transfer();
  /// What is told of the console, and the transfer that waits for it.
  void poll_rest();
  void poll_console();
  void conclude_transfer(const LiveRecording::End& end);
  /// A take can begin: a project is open, none goes on, and nothing is on its way into the document; else it is said.
  bool can_record();
  /// How much room is left where the project is, now and then.
  void look_at_disk();
  /// What the SpaceMouse does to the tools, if it drives.
  /// The arms that a person drives now, by `kinematics::index_of`.
  std::array<bool, 2> driven_by_hand() const;
  void follow_space_mouse();
  bool poll();
  void poll_jobs();
  void poll_import();
  Status finish(double limit_s);

  Options options;
  WorkbenchState state;
  std::shared_ptr<ProjectFile> file;              ///< Shared with jobs that will commit to it.
  double rest_begins_s = 0.0;                     ///< After a block, by the options' clock.
  double console_heard_s = 0.0;                   ///< When the console was, by the options' clock.
  std::unique_ptr<link::HandServer> hand_server;  ///< Of trials by a console; outlives `recording`.
  std::unique_ptr<LiveRecording> recording;
  std::optional<device::SpaceMouse> space_mouse;
  trial::StickHands space_mouse_hand;
  std::optional<RecordByHand> next_take;  ///< Armed when the verdict on this one has been carried out.
  double disk_looked_s = -1e9;
  std::optional<ViewDirector> view;
  FilmstripMaker filmstrip;
  using FilmPreviewWorker = LatestWorker<FilmPreviewRequest, std::shared_ptr<const FilmPreview>>;
  std::unique_ptr<FilmPreviewWorker> film_preview;  ///< Begins with the first film that is looked at.
  /// What review, its preview, curves and library work out once for all of them.
  std::shared_ptr<review::ClearanceStore> distances = std::make_shared<review::ClearanceStore>();
  std::shared_ptr<Progress> insight_wanted;  ///< Of the newest request.
  LatestWorker<InsightRequest, std::shared_ptr<const ModelInsight>> insight;
  LatestWorker<SeedRequest, std::shared_ptr<const SeedInsight>> seeds;
  SeedRequest seeds_wanted;
  LatestWorker<PreviewRequest, std::shared_ptr<const EditPreview>> preview;
  LatestWorker<ReviewRequest, std::shared_ptr<const ReviewView>> review;
  ReviewRequest review_wanted;
  LatestWorker<ReviewRequest, std::shared_ptr<const ReviewView>> preview_review;
  ReviewRequest preview_review_wanted;
  LatestWorker<CurvesRequest, std::shared_ptr<const CurveSet>> curves;
  LatestWorker<ComparisonRequest, std::shared_ptr<const ComparisonView>> comparison;
  CurvesRequest curves_wanted;
  ComparisonRequest comparison_wanted;
  std::shared_ptr<const Project> compared_in;
  std::deque<std::function<bool()>> waiting_writes;
  double waiting_since_s = 0.0;  ///< The first of them.
  LatestWorker<LibraryRequest, std::shared_ptr<const LibraryView>> library;
  LibraryRequest library_wanted;
  LatestWorker<BatchRequest, std::shared_ptr<const BatchPlan>> batch;
  BatchRequest batch_wanted;
  std::vector<std::int64_t> sketches_wanted;  ///< By falling id; those that are there already are gone.
  double last_poll_s = 0.0;
  bool dirty = false;
  LiveTrainings trainings;
  bool trials_end_asked = false;
  JobId importing;    // the last import that was asked for
  JobRunner jobs;     // their threads end first
  JobRunner opening;  // a project opens at once, whatever else runs
  JobRunner reading;  // so does a file that is to be imported
  JobRunner editing;  // so does what takes a while of an edit
};

}  // namespace trocar::workbench
