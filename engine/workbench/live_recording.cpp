#include "engine/workbench/live_recording.h"

#include <fmt/format.h>

#include <utility>

#include "engine/workbench/jobs/record_job.h"

namespace trocar::workbench {

Result<std::unique_ptr<LiveRecording>> LiveRecording::start(ProjectFile& file, const RecordScripted& request) {
  TROCAR_ASSIGN_OR_RETURN(trial::TransferSession session, trial::TransferSession::create(request.options));
  TROCAR_ASSIGN_OR_RETURN(RecordingWriter writer, file.begin_recording(session.provenance(), session.initial_world()));
  std::string name = request.name.empty() ? demonstration_name(*file.project(), request.options.skill) : request.name;
  return std::unique_ptr<LiveRecording>(
      new LiveRecording(file, std::move(name), std::move(session), std::move(writer), request.realtime));
}

LiveRecording::LiveRecording(ProjectFile& file, std::string name, trial::TransferSession session,
                             RecordingWriter writer, bool realtime)
    : file_(file), name_(std::move(name)), writer_(std::move(writer)), runner_(std::move(session), realtime) {}

void LiveRecording::stop(bool keep) {
  keep_ = keep;
  stopping_ = true;
  runner_.stop();
}

std::optional<LiveRecording::End> LiveRecording::poll() {
  runner_.update();
  while (const std::optional<LiveBatch> batch = runner_.take()) {
    if (const Status written = write(*batch); !written) {
      runner_.stop();
      return End{tl::unexpected(written.error()), {}};
    }
    if (batch->last) return conclude(*batch);
  }
  return std::nullopt;
}

Status LiveRecording::write(const LiveBatch& batch) {
  for (const demonstration::Sample& sample : batch.samples) TROCAR_RETURN_IF_ERROR(writer_.add(sample));
  for (const demonstration::HashMark& mark : batch.marks) TROCAR_RETURN_IF_ERROR(writer_.mark(mark));
  return {};
}

LiveRecording::End LiveRecording::conclude(const LiveBatch& last) {
  if (!keep_) {
    // Left unfinished it would be recovered as if a crash had cut it off.
    if (Status gone = writer_.discard(); !gone) return {tl::unexpected(std::move(gone).error()), {}};
    return {fail(ErrorCode::kCancelled, "the recording was discarded"), {}};
  }
  const Result<demonstration::RecordingId> recording = writer_.finish(last.outcome, last.placed);
  if (!recording) return {tl::unexpected(recording.error()), {}};
  const Result<std::int64_t> id = file_.commit(AddDemonstration{*recording, name_});
  if (!id) return {tl::unexpected(id.error()), {}};
  return {DemonstrationId{*id}, fmt::format("Recorded \"{}\": {}{}", name_, demonstration::to_string(last.outcome),
                                            last.placed ? ", block placed" : "")};
}

}  // namespace trocar::workbench
