// Recording: what a script or a person drives live.
#include <algorithm>
#include <utility>

#include "engine/workbench/take_plan.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

bool Workbench::Impl::can_record() {
  if (!project_open()) return false;
  const auto& views = jobs.jobs();
  const bool imports = std::any_of(views.begin(), views.end(), [this](const JobView& job) {
    return job.id == importing && (job.state == JobState::kQueued || job.state == JobState::kRunning);
  });
  std::string why;
  if (editing.busy() || !waiting_writes.empty()) why = "An edit is still being made; record when it is done";
  if (imports) why = "A file is still being imported; record when it is there";
  if (recording) why = "A recording is running already";
  if (!why.empty()) log(Severity::kWarning, why);
  return why.empty();
}

void Workbench::Impl::on(const RecordScripted& command) {
  if (!can_record()) return;
  auto started = LiveRecording::start(*file, command);
  if (!started) return log(Severity::kError, started.error().text());
  recording = std::move(*started);
  state.play_speed = 0.0;
  log(Severity::kInfo, "Recording");
}

void Workbench::Impl::on(const StopRecording& command) {
  if (recording) recording->stop(command.keep);
}

void Workbench::Impl::on(const RecordByHand& command) {
  if (!can_record()) return;
  state.last_take = command;
  RecordByHand request = command;
  if (request.space_mouse) on(FindDevices{});
  if (request.space_mouse && !space_mouse) {
    request.space_mouse = false;
    log(Severity::kWarning, state.space_mouse_missing);
  }
  space_mouse_hand = {};
  auto started = LiveRecording::start(*file, request);
  if (!started) return log(Severity::kError, started.error().text());
  recording = std::move(*started);
  state.play_speed = 0.0;
  on(EndPreview{});
  log(Severity::kInfo, "Armed");
}

void Workbench::Impl::on(const FindDevices&) {
  dirty = true;
  if (space_mouse) return;
  Result<device::SpaceMouse> found = device::SpaceMouse::open();
  state.space_mouse_missing = found ? "" : found.error().text();
  if (found) space_mouse.emplace(std::move(*found));
}

std::array<bool, 2> Workbench::Impl::driven_by_hand() const {
  if (state.take) {
    const auto& sources = state.take->request.options.sources;
    return {sources[0] == trial::ArmSource::kHand, sources[1] == trial::ArmSource::kHand};
  }
  return {state.trials && state.trials->request.person, state.trials && state.trials->request.person_assists};
}

void Workbench::Impl::follow_space_mouse() {
  const bool of_take = state.take && state.take->request.space_mouse && !state.take->reviewing;
  const bool of_trial = state.trials && state.trials->request.space_mouse;
  if (!space_mouse || (!of_take && !of_trial)) return;
  const device::SpaceMouseLook look = space_mouse->look();
  const auto& arms = recording->view().world.arms;
  recording->post({space_mouse_hand.look(trial::look_of_space_mouse(look.axes, look.buttons), driven_by_hand(),
                                         {arms[0].X_WT.q, arms[1].X_WT.q})});
}

void Workbench::Impl::on(const HandInput& command) {
  if (recording) recording->post(command);
}

void Workbench::Impl::on(const JudgeTake& command) {
  if (!recording || !state.take || !state.take->reviewing) return;
  const bool again = command.verdict == TakeVerdict::kAgain || command.verdict == TakeVerdict::kKeepAndNext;
  if (again) next_take = state.take->request;
  if (next_take && command.verdict == TakeVerdict::kKeepAndNext) {
    next_take = another_take(*next_take);
    ++next_take->options.seed;
  }
  recording->judge(command.verdict == TakeVerdict::kKeep || command.verdict == TakeVerdict::kKeepAndNext);
}

void Workbench::Impl::look_at_disk() {
  constexpr double kPeriod_s = 2.0;
  if (last_poll_s - disk_looked_s < kPeriod_s) return;
  disk_looked_s = last_poll_s;
  std::error_code failed;
  const std::filesystem::space_info space = std::filesystem::space(file->path(), failed);
  state.disk_free_bytes = failed ? -1 : static_cast<std::int64_t>(space.available);
}

void Workbench::Impl::poll_recording() {
  if (!recording) return;
  const bool waited = recording->waits();
  const std::optional<LiveRecording::End> end = recording->poll();
  if (waited && !end) return;
  state.live = recording->view();
  state.take = recording->take() == nullptr ? std::nullopt : std::optional(*recording->take());
  state.live_trace = recording->trace();
  look_at_disk();
  dirty = true;
  if (!end) return follow_space_mouse();
  recording.reset();
  state.live.reset();
  state.take.reset();
  state.live_trace.reset();
  if (state.trials) {
    conclude_transfer(*end);
    return refresh_document();
  }
  if (end->demonstration) {
    tell(end->message);
    state.demonstration = *end->demonstration;
    state.playhead_s = 0.0;
  } else {
    const bool discarded = end->demonstration.error().code() == ErrorCode::kCancelled;
    log(discarded ? Severity::kInfo : Severity::kError, end->demonstration.error().text());
  }
  refresh_document();
  if (const std::optional<RecordByHand> next = std::exchange(next_take, std::nullopt)) on(*next);
}

}  // namespace trocar::workbench
