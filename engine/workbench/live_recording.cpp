#include "engine/workbench/live_recording.h"

#include <fmt/format.h>

#include <utility>

#include "engine/workbench/jobs/record_job.h"
#include "engine/workbench/take_plan.h"

namespace trocar::workbench {

Result<std::unique_ptr<LiveRecording>> LiveRecording::start(ProjectFile& file, const RecordScripted& request) {
  TROCAR_ASSIGN_OR_RETURN(trial::TransferSession session, trial::TransferSession::create(request.options));
  std::string name = request.name.empty() ? demonstration_name(*file.project(), request.options.skill) : request.name;
  TakeWriter writer(file, session.provenance(), std::move(name));
  std::unique_ptr<LiveRecording> recording(new LiveRecording(
      std::move(writer), std::make_unique<trial::TransferSession>(std::move(session)), request.realtime));
  recording->verdict_ = true;
  return recording;
}

Result<std::unique_ptr<LiveRecording>> LiveRecording::start(ProjectFile& file, const RecordByHand& request) {
  TROCAR_ASSIGN_OR_RETURN(TakePlan plan, plan_take(*file.project(), request));
  TROCAR_ASSIGN_OR_RETURN(std::unique_ptr<trial::HandSession> session,
                          trial::HandSession::create(std::move(plan.options)));
  trial::HandSession& hand = *session;
  TakeWriter writer(file, hand.provenance(), std::move(plan.name), plan.target);
  std::unique_ptr<LiveRecording> recording(new LiveRecording(std::move(writer), std::move(session), true));
  recording->hand_ = &hand;
  recording->take_ = TakeView{request, recording->writer_.name(), false, {}};
  recording->take_->request.options.block = hand.options().block;
  recording->take_->request.options.goal = hand.options().goal;
  return recording;
}

Result<std::unique_ptr<LiveRecording>> LiveRecording::start(ProjectFile& file, const TrialStart& request) {
  TROCAR_ASSIGN_OR_RETURN(trial::TrialOptions options, options_of(*file.project(), request.plan, request.transfer));
  Trial trial{request, nullptr, nullptr, nullptr, {}, {}};
  trial::TrialInputs inputs;
  if (request.console != nullptr) {
    inputs.user = request.console;
    inputs.assistant = request.person_assists ? &request.console->assistant() : nullptr;
    inputs.scripted = request.console->status().scripted;
  }
  const auto person_at = [](kinematics::ArmSide side, double scale) {
    const control::ToolCommand ready{kinematics::ready_pose(side), 0.0};
    return std::make_unique<trial::EventOperator>(side, ready, scale);
  };
  if (request.person && request.console == nullptr) {
    trial.person = person_at(kinematics::ArmSide::kLeft, options.scale);
    inputs.user = trial.person.get();
  }
  if (request.person_assists && request.console == nullptr) {
    trial.assistant = person_at(kinematics::ArmSide::kRight, trial::kAssistantScale);
    inputs.assistant = trial.assistant.get();
  }
  TROCAR_ASSIGN_OR_RETURN(auto session, trial::SharedControlSession::create(std::move(options), inputs));
  trial.session = session.get();
  TakeWriter writer(file, session->provenance(), trial_name(*file.project(), request.plan.options.mode));
  std::unique_ptr<LiveRecording> recording(new LiveRecording(std::move(writer), std::move(session), request.realtime));
  recording->file_ = &file;
  recording->trial_ = std::move(trial);
  recording->verdict_ = true;
  return recording;
}

LiveRecording::LiveRecording(TakeWriter writer, std::unique_ptr<trial::LiveSession> session, bool realtime)
    : writer_(std::move(writer)), runner_(std::move(session), realtime) {}

void LiveRecording::stop_trial() {
  if (trial_) trial_->session->stop();
}

void LiveRecording::mark_incident(std::string text) {
  if (trial_) trial_->session->mark_incident(std::move(text));
}

void LiveRecording::post(const HandInput& input) {
  if (trial_) {
    for (trial::EventOperator* person : {trial_->person.get(), trial_->assistant.get()}) {
      if (person == nullptr) continue;
      for (const trial::HandEvent& event : input.events) person->post(event);
    }
  }
  if (hand_ == nullptr) return;
  for (const trial::HandEvent& event : input.events) hand_->post(event);
}

void LiveRecording::stop(bool keep) {
  verdict_ = keep;
  stopping_ = true;
  // A person may end at any time: that is no abortion.
  if (hand_ != nullptr && hand_->post(trial::EndTake{})) return;
  runner_.stop();
}

void LiveRecording::ask_for_verdict() {
  const trial::SessionStatus& status = view().status;
  take_->reviewing = true;
  take_->summary = fmt::format("{:.1f} s, {} samples: {}{}", writer_.duration_s(), writer_.samples(),
                               demonstration::to_string(last_->outcome), last_->placed ? ", block placed" : "");
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    const trial::ArmReport& arm = status.arms[kinematics::index_of(side)];
    const char* name = side == kinematics::ArmSide::kLeft ? "left" : "right";
    if (arm.refused_count > 0) {
      take_->summary += fmt::format("; {} arm out of reach in {} samples", name, arm.refused_count);
    }
    if (arm.limited_count > 0) take_->summary += fmt::format("; {} arm at a limit in {}", name, arm.limited_count);
  }
}

std::optional<LiveRecording::End> LiveRecording::poll() {
  runner_.update();
  while (!last_) {
    std::optional<LiveBatch> batch = runner_.take();
    if (!batch) break;
    if (const Status written = writer_.write(batch->part); !written) {
      runner_.stop();
      return End{tl::unexpected(written.error()), {}};
    }
    trace_.add(batch->part.samples);
    if (trial_) {
      const TakePart& part = batch->part;
      trial_->samples.insert(trial_->samples.end(), part.samples.begin(), part.samples.end());
      trial_->events.insert(trial_->events.end(), part.events.begin(), part.events.end());
    }
    if (batch->last) last_ = std::move(batch);
  }
  if (!last_) return std::nullopt;
  runner_.update();
  if (verdict_ || !writer_.begun()) return conclude();
  if (!take_->reviewing) ask_for_verdict();
  return std::nullopt;
}

/// The thread has ended: the session is the main thread's now.
LiveRecording::End LiveRecording::conclude_trial() {
  trial::TrialRecord record =
      record_of(*trial_->session, trial_->request.plan, trial_->request.transfer, trial_->samples, trial_->events);
  if (trial_->request.console != nullptr) add_link(trial_->request.console->status(), record);
  // Ended by the runner, in the middle of it.
  record.interrupted = !trial_->session->done();
  if (record.interrupted && record.outcome == demonstration::Outcome::kUnfinished) {
    record.outcome = demonstration::Outcome::kAborted;
  }
  const Result<demonstration::RecordingId> recording = writer_.finish_recording(record.outcome, record.placed);
  if (!recording) return {tl::unexpected(recording.error()), {}, {}};
  const Result<std::int64_t> node = file_->commit(AddTrial{*recording, writer_.name(), record});
  if (!node) return {tl::unexpected(node.error()), {}, {}};
  std::string message = fmt::format("Trial \"{}\": {}", writer_.name(), demonstration::to_string(record.outcome));
  if (record.completion_s) message += fmt::format(" after {:.1f} s", *record.completion_s);
  return {DemonstrationId{*node}, std::move(message), std::move(record)};
}

LiveRecording::End LiveRecording::conclude() {
  if (!verdict_.value_or(true)) {
    // Left unfinished it would be recovered as if a crash had cut it off.
    if (Status gone = writer_.discard(); !gone) return {tl::unexpected(std::move(gone).error()), {}};
    return {fail(ErrorCode::kCancelled, "the recording was discarded"), {}};
  }
  if (trial_) return conclude_trial();
  const Result<DemonstrationId> id = writer_.finish(last_->outcome, last_->placed);
  if (!id) return {id, {}};
  if (writer_.target()) {
    const TimeSpan& span = writer_.target()->span;
    return {id, fmt::format("Recorded \"{}\", {:.2f} s, in place of what was from {:.2f} s on", writer_.name(),
                            writer_.duration_s(), span.begin_s)};
  }
  return {id, fmt::format("Recorded \"{}\": {}{}", writer_.name(), demonstration::to_string(last_->outcome),
                          last_->placed ? ", block placed" : "")};
}

}  // namespace trocar::workbench
