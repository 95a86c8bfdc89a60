/// A session that runs in the simulation thread while the main thread writes what it records into the project.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/trial/event_operator.h"
#include "engine/trial/shared_control_session.h"
#include "engine/workbench/command.h"
#include "engine/workbench/jobs/trial_job.h"
#include "engine/workbench/live_runner.h"
#include "engine/workbench/live_trace.h"
#include "engine/workbench/project_file.h"
#include "engine/workbench/take_view.h"
#include "engine/workbench/take_writer.h"

namespace trocar::workbench {

/// One transfer of the plan, live.
struct TrialStart {
  TrialPlan plan;
  int transfer = 0;
  bool person = false;          ///< At keyboard, mouse and sticks; else the plan's scripted operator.
  bool person_assists = false;  ///< A second one has the right arm; else the scripted expert.
  /// Who comes from elsewhere, instead of persons here: its left hand is the operator's, with `person_assists` its
  /// right one the assistant's. Must outlive the trial.
  link::HandServer* console = nullptr;
  bool realtime = true;
};

/// Threads: the main thread. The project file must outlive it and stay where it is.
class LiveRecording {
 public:
  /// Errors: those of `TransferSession::create`.
  static Result<std::unique_ptr<LiveRecording>> start(ProjectFile& file, const RecordScripted& request);
  /// What a person drives waits for a verdict when it has ended. Errors: those of `plan_take` and
  /// `HandSession::create`.
  static Result<std::unique_ptr<LiveRecording>> start(ProjectFile& file, const RecordByHand& request);

  /// One transfer of a block of trials. Errors: those of `options_of` and `SharedControlSession::create`.
  static Result<std::unique_ptr<LiveRecording>> start(ProjectFile& file, const TrialStart& request);

  /// What became of it, once it has ended.
  struct End {
    Result<DemonstrationId> demonstration;  ///< kCancelled if it was discarded.
    std::string message;
    std::optional<trial::TrialRecord> trial{};  ///< Of a trial, whose id `demonstration` then is.
  };
  /// Writes what arrived; the end, once.
  std::optional<End> poll();

  /// Of a trial: presses stop, now; marks an instant.
  void stop_trial();
  void mark_incident(std::string text);

  /// What the operator does; no effect on a scripted transfer.
  void post(const HandInput& input);
  /// Ends it early; discarded recordings are not added to the project.
  void stop(bool keep);
  bool stopping() const { return stopping_; }
  /// The verdict that a take by hand waits for.
  void judge(bool keep) { verdict_ = keep; }
  /// Nothing happens until then.
  bool waits() const { return take_ && take_->reviewing && !verdict_; }
  const LiveView& view() const { return runner_.view(); }
  /// What was recorded so far, for lanes over time. The same one until there is more.
  std::shared_ptr<const LiveTrace> trace() { return trace_.trace(); }
  /// Of a take by hand; null else.
  const TakeView* take() const { return take_ ? &*take_ : nullptr; }

 private:
  LiveRecording(TakeWriter writer, std::unique_ptr<trial::LiveSession> session, bool realtime);
  End conclude();
  void ask_for_verdict();
  End conclude_trial();

  /// What a trial needs besides.
  struct Trial {
    TrialStart request;
    trial::SharedControlSession* session = nullptr;  ///< The runner's.
    std::unique_ptr<trial::EventOperator> person;
    std::unique_ptr<trial::EventOperator> assistant;
    std::vector<demonstration::Sample> samples;
    std::vector<trial::TrialEvent> events;
  };

  ProjectFile* file_ = nullptr;
  TakeWriter writer_;
  LiveTracer trace_;
  trial::HandSession* hand_ = nullptr;  ///< The runner's session, if a person drives it.
  std::optional<Trial> trial_;          ///< Outlives the thread that asks its person.
  std::optional<TakeView> take_;
  std::optional<bool> verdict_;  ///< Whether it is kept; none: not said yet.
  std::optional<LiveBatch> last_;
  bool stopping_ = false;
  LiveRunner runner_;
};

}  // namespace trocar::workbench
