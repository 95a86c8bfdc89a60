#include "engine/workbench/recovery.h"

#include "engine/workbench/blob_cache.h"
#include "engine/workbench/recording_codec.h"

namespace trocar::workbench {

Result<Recovered> recover_recording(store::ProjectStore& store, const store::RecordingRow& row) {
  TROCAR_ASSIGN_OR_RETURN(const demonstration::Recording recording, read_whole_chunks(store, row));
  Recovered recovered;
  recovered.recording = {row.id};
  recovered.kept = recording.samples.size() >= 2;
  if (!recovered.kept) {
    TROCAR_RETURN_IF_ERROR(store.discard_recording(row.id));
    return recovered;
  }
  if (!row.finished) {
    const RecordingFooter footer{demonstration::Outcome::kUnfinished, false, true,
                                 static_cast<std::int64_t>(recording.samples.size()), recording.content_hash()};
    TROCAR_RETURN_IF_ERROR(store.finish_recording(row.id, footer_to_json(footer)));
  }
  recovered.duration_s = recording.samples.back().t_s() - recording.samples.front().t_s();
  return recovered;
}

}  // namespace trocar::workbench
