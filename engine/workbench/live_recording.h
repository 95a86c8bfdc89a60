/// A session that runs in the simulation thread while the main thread writes what it records into the project.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/workbench/command.h"
#include "engine/workbench/live_runner.h"
#include "engine/workbench/live_trace.h"
#include "engine/workbench/project_file.h"
#include "engine/workbench/take_view.h"
#include "engine/workbench/take_writer.h"

namespace trocar::workbench {

/// Threads: the main thread. The project file must outlive it and stay where it is.
class LiveRecording {
 public:
  /// Errors: those of `TransferSession::create`.
  static Result<std::unique_ptr<LiveRecording>> start(ProjectFile& file, const RecordScripted& request);
  /// What a person drives waits for a verdict when it has ended. Errors: those of `plan_take` and
  /// `HandSession::create`.
  static Result<std::unique_ptr<LiveRecording>> start(ProjectFile& file, const RecordByHand& request);

  /// What became of it, once it has ended.
  struct End {
    Result<DemonstrationId> demonstration;  ///< kCancelled if it was discarded.
    std::string message;
  };
  /// Writes what arrived; the end, once.
  std::optional<End> poll();

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

  TakeWriter writer_;
  LiveTracer trace_;
  trial::HandSession* hand_ = nullptr;  ///< The runner's session, if a person drives it.
  std::optional<TakeView> take_;
  std::optional<bool> verdict_;  ///< Whether it is kept; none: not said yet.
  std::optional<LiveBatch> last_;
  bool stopping_ = false;
  LiveRunner runner_;
};

}  // namespace trocar::workbench
