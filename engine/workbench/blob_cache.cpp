#include "engine/workbench/blob_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/workbench/model_codec.h"
#include "engine/workbench/recording_codec.h"

namespace trocar::workbench {
namespace {

using demonstration::Recording;
using demonstration::RecordingId;

tl::unexpected<Error> damaged(std::int64_t id, const std::string& why) {
  return fail(ErrorCode::kCorrupt, fmt::format("recording {} is damaged ({})", id, why));
}

/// Appends chunks in order. Errors: kCorrupt for a gap in the sequence or a chunk of the wrong length.
Status read_chunks(const store::ProjectStore& store, Recording& recording) {
  std::int64_t expected = 0;
  return store.visit_chunks(recording.id.value, [&](std::int64_t sequence, std::string_view bytes) -> Status {
    if (sequence != expected++) return damaged(recording.id.value, "a chunk is missing");
    if (sequence >= kFirstSampleChunk) return decode_chunk(bytes, recording);
    recording.initial_world = std::string(bytes);
    return {};
  });
}

Result<Recording> read_recording(const store::ProjectStore& store, const store::RecordingRow& row) {
  if (!row.finished) return damaged(row.id, "it was never finished");
  Recording recording;
  recording.id = {row.id};
  TROCAR_ASSIGN_OR_RETURN(recording.provenance, header_from_json(row.header));
  TROCAR_ASSIGN_OR_RETURN(const RecordingFooter footer, footer_from_json(row.footer));
  recording.outcome = footer.outcome;
  recording.placed = footer.placed;
  recording.recovered = footer.recovered;
  // A footer cannot make us reserve more than the file could hold.
  const auto most = static_cast<std::size_t>(store.size_bytes()) / sizeof(demonstration::Sample);
  recording.samples.reserve(std::min(static_cast<std::size_t>(footer.samples), most));
  TROCAR_RETURN_IF_ERROR(read_chunks(store, recording));
  if (recording.samples.size() != static_cast<std::size_t>(footer.samples)) {
    return damaged(row.id, fmt::format("{} of {} samples are there", recording.samples.size(), footer.samples));
  }
  if (recording.content_hash() != footer.content_hash) return damaged(row.id, "its content does not match its hash");
  return recording;
}

}  // namespace

Result<Recording> read_whole_chunks(const store::ProjectStore& store, const store::RecordingRow& row) {
  Recording recording;
  recording.id = {row.id};
  TROCAR_ASSIGN_OR_RETURN(recording.provenance, header_from_json(row.header));
  const Status read = read_chunks(store, recording);
  if (!read && read.error().code() != ErrorCode::kCorrupt) return tl::unexpected(read.error());
  std::size_t good = 0;
  while (good < recording.samples.size()) {
    const std::size_t first = good == 0 ? 0 : good - 1;
    if (!demonstration::check_samples(std::span(recording.samples).subspan(first, good + 1 - first))) break;
    ++good;
  }
  recording.samples.resize(good);
  return recording;
}

Result<std::shared_ptr<const Recording>> BlobCache::recording(RecordingId id) const {
  const auto known = recordings_.find(id);
  if (known != recordings_.end()) return known->second;
  TROCAR_ASSIGN_OR_RETURN(const std::vector<store::RecordingRow> rows, store_.recordings());
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return each.id == id.value; });
  if (row == rows.end()) return fail(ErrorCode::kNotFound, fmt::format("the project has no recording {}", id.value));
  TROCAR_ASSIGN_OR_RETURN(Recording read, read_recording(store_, *row));
  return recordings_[id] = std::make_shared<const Recording>(std::move(read));
}

Result<ModelEntry> BlobCache::model(std::int64_t object) const {
  const auto known = models_.find(object);
  if (known != models_.end()) return known->second;
  TROCAR_ASSIGN_OR_RETURN(const std::vector<store::ObjectRow> rows, store_.objects(kModelKind));
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return each.id == object; });
  if (row == rows.end()) return fail(ErrorCode::kNotFound, fmt::format("the project has no stored model {}", object));
  if (describe_only_) {
    TROCAR_ASSIGN_OR_RETURN(std::optional<ModelEntry> described, describe_model(row->meta, row->size_bytes));
    if (described) return models_[object] = std::move(*described);
  }
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, store_.object_bytes(object));
  TROCAR_ASSIGN_OR_RETURN(ModelEntry entry, decode_model(row->meta, bytes));
  return models_[object] = std::move(entry);
}

}  // namespace trocar::workbench
