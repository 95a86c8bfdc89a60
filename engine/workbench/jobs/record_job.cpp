#include "engine/workbench/jobs/record_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace trocar::workbench {
namespace {

bool name_taken(const Project& project, const std::string& name) {
  return std::any_of(project.demonstrations.begin(), project.demonstrations.end(),
                     [&name](const auto& entry) { return entry.second->name == name; });
}

/// Moves what the session recorded to disk. Returns how many samples that were.
Result<std::int64_t> drain(trial::TransferSession& session, RecordingWriter& writer) {
  std::int64_t count = 0;
  for (const demonstration::Sample& sample : session.take_samples()) {
    TROCAR_RETURN_IF_ERROR(writer.add(sample));
    ++count;
  }
  for (const demonstration::HashMark& mark : session.take_marks()) TROCAR_RETURN_IF_ERROR(writer.mark(mark));
  return count;
}

}  // namespace

std::string demonstration_name(const Project& project, trial::Skill skill) {
  std::string word(trial::to_string(skill));
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{} {}", word, number);
    if (!name_taken(project, name)) return name;
  }
}

Result<RecordReport> record_transfer(ProjectFile& file, const trial::TransferOptions& options, std::string name,
                                     Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(trial::TransferSession session, trial::TransferSession::create(options));
  TROCAR_ASSIGN_OR_RETURN(RecordingWriter writer, file.begin_recording(session.provenance(), session.initial_world()));
  RecordReport report;
  while (!session.done()) {
    for (int tick = 0; tick < 250 && !session.done(); ++tick) session.step();
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t count, drain(session, writer));
    report.samples += count;
    report.duration_s = session.state().tick.seconds();
    // How far a transfer has come is best told by its segment.
    progress.set(static_cast<double>(session.segment()) / demonstration::kSegmentCount);
    if (!progress.cancelled()) continue;
    // Who stops it on purpose does not want it back as if a crash had cut it off.
    TROCAR_RETURN_IF_ERROR(writer.discard());
    return fail(ErrorCode::kCancelled,
                fmt::format("the recording was stopped; its {:.1f} s were discarded", report.duration_s));
  }
  report.outcome = session.outcome();
  report.placed = session.placed();
  TROCAR_ASSIGN_OR_RETURN(const demonstration::RecordingId recording, writer.finish(report.outcome, report.placed));
  if (name.empty()) name = demonstration_name(*file.project(), options.skill);
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(AddDemonstration{recording, std::move(name)}));
  report.id = DemonstrationId{id};
  return report;
}

}  // namespace trocar::workbench
