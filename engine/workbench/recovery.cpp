#include "engine/workbench/recovery.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>

#include "engine/workbench/blob_cache.h"
#include "engine/workbench/edit.h"
#include "engine/workbench/recording_codec.h"

namespace trocar::workbench {
namespace {

using demonstration::Recording;

std::set<std::int64_t> recordings_named_by(const std::vector<store::JournalRow>& journal) {
  std::set<std::int64_t> named;
  for (const store::JournalRow& row : journal) {
    if (row.name != AddDemonstration::kName) continue;
    const Result<Edit> edit = edit_from_json(row.name, row.parameters);
    const auto* added = edit ? std::get_if<AddDemonstration>(&*edit) : nullptr;
    if (added != nullptr) named.insert(added->recording.value);
  }
  return named;
}

Result<std::optional<Recovered>> recover(store::ProjectStore& store, const store::RecordingRow& row,
                                         Diagnostics& diagnostics) {
  TROCAR_ASSIGN_OR_RETURN(const Recording recording, read_whole_chunks(store, row));
  if (recording.samples.size() < 2) {
    TROCAR_RETURN_IF_ERROR(store.discard_recording(row.id));
    diagnostics.warn("a recording was cut off before it had 2 samples and was dropped");
    return std::nullopt;
  }
  if (!row.finished) {
    const RecordingFooter footer{demonstration::Outcome::kUnfinished, false, true,
                                 static_cast<std::int64_t>(recording.samples.size()), recording.content_hash()};
    TROCAR_RETURN_IF_ERROR(store.finish_recording(row.id, footer_to_json(footer)));
  }
  const double duration_s = recording.samples.back().t_s() - recording.samples.front().t_s();
  diagnostics.warn(fmt::format("a recording was cut off after {:.1f} s and has been recovered", duration_s));
  return Recovered{{row.id}, fmt::format("Recovered ({:.1f} s)", duration_s)};
}

}  // namespace

std::vector<Recovered> recover_recordings(store::ProjectStore& store, const std::vector<store::JournalRow>& journal,
                                          Diagnostics& diagnostics) {
  std::vector<Recovered> found;
  const Result<std::vector<store::RecordingRow>> rows = store.recordings();
  if (!rows) {
    diagnostics.warn(rows.error().text());
    return found;
  }
  const std::set<std::int64_t> named = recordings_named_by(journal);
  for (const store::RecordingRow& row : *rows) {
    if (row.writer_lives || named.contains(row.id)) continue;
    Result<std::optional<Recovered>> recovered = recover(store, row, diagnostics);
    if (!recovered) {
      diagnostics.warn(
          fmt::format("recording {} was cut off and cannot be recovered now ({})", row.id, recovered.error().text()));
    } else if (*recovered) {
      found.push_back(std::move(**recovered));
    }
  }
  return found;
}

}  // namespace trocar::workbench
