#include "engine/workbench/take_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::workbench {

namespace {

/// The old motion is joined again within this time of the end of what replaces a part of it, or later: no tool is to be
/// faster on its way back than this.
constexpr double kEaseOut_s = 0.5;
constexpr double kEaseOutSpeed_m_s = 0.15;
/// The peak of a motion with minimum jerk, relative to its mean.
constexpr double kPeakOfMinimumJerk = 1.875;

}  // namespace

TakePart take_part(trial::LiveSession& session) {
  return {session.take_initial_world(), session.take_samples(), session.take_marks(), session.take_notes(),
          session.take_events()};
}

TakeWriter::TakeWriter(ProjectFile& file, demonstration::Provenance provenance, std::string name,
                       std::optional<TakeTarget> target)
    : file_(file), provenance_(std::move(provenance)), name_(std::move(name)), target_(target) {}

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

std::vector<demonstration::Edit> TakeWriter::note_edits() const {
  std::vector<demonstration::Edit> edits;
  for (const trial::TakeNote& note : notes_) {
    const double at_s = Tick{note.tick - first_tick_}.seconds();
    edits.emplace_back(demonstration::AddNote{note.text, at_s, at_s, "recording", 0});
  }
  return edits;
}

Edit TakeWriter::edit_for(demonstration::RecordingId recording) const {
  AddDemonstration added{recording, name_, note_edits()};
  if (!target_) return added;
  demonstration::Overdub overdub;
  overdub.clip_to_s = duration_s();
  overdub.at_s = target_->span.begin_s;
  overdub.arms = target_->arms;
  overdub.ease_s = ease_s();
  return PunchIn{std::move(added), target_->into, overdub};
}

double TakeWriter::ease_s() const {
  const auto& demonstrations = file_.project()->demonstrations;
  const auto into = demonstrations.find(target_->into);
  if (into == demonstrations.end()) return kEaseOut_s;
  const demonstration::Sample old = into->second->sample_at(target_->span.begin_s + duration_s());
  double farthest_m = 0.0;
  for (std::size_t arm = 0; arm < old.arms.size(); ++arm) {
    farthest_m = std::max(farthest_m, (last_.arms[arm].setpoint().p - old.arms[arm].setpoint().p).norm());
  }
  const double needed_s = kPeakOfMinimumJerk * farthest_m / kEaseOutSpeed_m_s;
  return std::max(kEaseOut_s, std::ceil(needed_s * 100.0) / 100.0);
}

Result<demonstration::RecordingId> TakeWriter::finish_recording(demonstration::Outcome outcome, bool placed) {
  if (!writer_) return fail(ErrorCode::kCancelled, "nothing was recorded: it ended before the countdown did");
  return writer_->finish(outcome, placed);
}

Result<DemonstrationId> TakeWriter::finish(demonstration::Outcome outcome, bool placed) {
  TROCAR_ASSIGN_OR_RETURN(const demonstration::RecordingId recording, finish_recording(outcome, placed));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t node, file_.commit(edit_for(recording)));
  take_ = DemonstrationId{node};
  return target_ ? target_->into : take_;
}

Status TakeWriter::discard() {
  return writer_ ? writer_->discard() : Status();
}

}  // namespace trocar::workbench
