#include "engine/workbench/take_writer.h"

#include <utility>

namespace trocar::workbench {

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
  TROCAR_RETURN_IF_ERROR(file_.commit(EditDemonstration{punch_->into, splice}).map([](std::int64_t) {}));
  return punch_->into;
}

Status TakeWriter::discard() {
  return writer_ ? writer_->discard() : Status();
}

}  // namespace trocar::workbench
