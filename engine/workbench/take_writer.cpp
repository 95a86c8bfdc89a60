#include "engine/workbench/take_writer.h"

#include <algorithm>
#include <utility>

namespace trocar::workbench {

namespace {

/// The old motion is joined again within this time of the end of what replaces a part of it.
constexpr double kEaseOut_s = 0.5;

/// What the guard of an arm would see as more than a step from one sample to the next.
bool leaps(const demonstration::Sample& from, const demonstration::Sample& to) {
  constexpr double kStep_m = 0.0005;
  constexpr double kStep_rad = 0.01;
  for (std::size_t arm = 0; arm < from.arms.size(); ++arm) {
    const spatial::Pose X_WA = from.arms[arm].setpoint();
    const spatial::Pose X_WB = to.arms[arm].setpoint();
    if ((X_WA.p - X_WB.p).norm() > kStep_m || X_WA.q.angularDistance(X_WB.q) > kStep_rad) return true;
  }
  return false;
}

}  // namespace

TakePart take_part(trial::LiveSession& session) {
  return {session.take_initial_world(), session.take_samples(), session.take_marks(), session.take_notes()};
}

TakeWriter::TakeWriter(ProjectFile& file, demonstration::Provenance provenance, std::string name,
                       std::optional<PunchIn> punch)
    : file_(file), provenance_(std::move(provenance)), name_(std::move(name)), punch_(punch) {}

Status TakeWriter::write(const TakePart& part) {
  if (part.initial_world) {
    TROCAR_ASSIGN_OR_RETURN(RecordingWriter writer, file_.begin_recording(provenance_, *part.initial_world));
    writer_.emplace(std::move(writer));
  }
  if (!writer_) return {};
  for (const demonstration::Sample& sample : part.samples) {
    TROCAR_RETURN_IF_ERROR(writer_->add(sample));
    if (samples_ == 0) first_tick_ = sample.tick;
    last_tick_ = sample.tick;
    last_ = sample;
    ++samples_;
  }
  for (const demonstration::HashMark& mark : part.marks) TROCAR_RETURN_IF_ERROR(writer_->mark(mark));
  notes_.insert(notes_.end(), part.notes.begin(), part.notes.end());
  return {};
}

double TakeWriter::duration_s() const {
  return Tick{last_tick_ - first_tick_}.seconds();
}

Status TakeWriter::add_notes(DemonstrationId id) {
  for (const trial::TakeNote& note : notes_) {
    const double at_s = Tick{note.tick - first_tick_}.seconds();
    TROCAR_RETURN_IF_ERROR(
        file_.commit(EditDemonstration{id, demonstration::AddNote{note.text, at_s, at_s, "recording", 0}})
            .map([](std::int64_t) {}));
  }
  return {};
}

Result<DemonstrationId> TakeWriter::finish(demonstration::Outcome outcome, bool placed) {
  if (!writer_) return fail(ErrorCode::kCancelled, "nothing was recorded: it ended before the countdown did");
  TROCAR_ASSIGN_OR_RETURN(const demonstration::RecordingId recording, writer_->finish(outcome, placed));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t node, file_.commit(AddDemonstration{recording, name_}));
  const DemonstrationId id{node};
  TROCAR_RETURN_IF_ERROR(add_notes(id));
  if (!punch_) return id;
  demonstration::Splice splice;
  splice.source = id.value;
  splice.clip_to_s = duration_s();
  splice.at_s = punch_->span.begin_s;
  splice.until_s = punch_->span.end_s;
  splice.align = demonstration::Align::kAsRecorded;
  splice.as_of = file_.head();
  const auto before = file_.project()->demonstrations.at(punch_->into);
  TROCAR_RETURN_IF_ERROR(file_.commit(EditDemonstration{punch_->into, splice}).map([](std::int64_t) {}));
  if (leaps(last_, before->sample_at(punch_->span.end_s))) TROCAR_RETURN_IF_ERROR(ease_out());
  return punch_->into;
}

Status TakeWriter::ease_out() {
  demonstration::Bridge bridge;
  bridge.from_s = punch_->span.begin_s + duration_s();
  const double end_s = file_.project()->demonstrations.at(punch_->into)->full_duration_s();
  bridge.to_s = std::min(bridge.from_s + kEaseOut_s, end_s);
  return file_.commit(EditDemonstration{punch_->into, bridge}).map([](std::int64_t) {});
}

Status TakeWriter::discard() {
  return writer_ ? writer_->discard() : Status();
}

}  // namespace trocar::workbench
