#include "engine/workbench/blob_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
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

/// Hands on chunks in order, the samples of each alone. Errors: kCorrupt for a gap in the sequence or a chunk of the
/// wrong length; those of `take`.
Status read_chunks(const store::ProjectStore& store, Recording& recording, const std::function<Status()>& take) {
  std::int64_t expected = 0;
  return store.visit_chunks(recording.id.value, [&](std::int64_t sequence, std::string_view bytes) -> Status {
    if (sequence != expected++) return damaged(recording.id.value, "a chunk is missing");
    if (sequence >= kFirstSampleChunk) {
      TROCAR_RETURN_IF_ERROR(decode_chunk(bytes, recording));
      return take();
    }
    recording.initial_world = std::string(bytes);
    return {};
  });
}

/// Packs, hashes and checks samples chunk by chunk: an hour of them is never unpacked at once.
class ChunkReader {
 public:
  Status take(std::vector<demonstration::Sample>& samples) {
    // The last one of the chunk before comes first, so that the order is checked across the border.
    if (last_) samples.insert(samples.begin(), *last_);
    TROCAR_RETURN_IF_ERROR(demonstration::check_samples(samples));
    for (std::size_t i = last_ ? 1 : 0; i < samples.size(); ++i) {
      hasher_.add(samples[i]);
      builder_.add(samples[i]);
    }
    if (!samples.empty()) last_ = samples.back();
    samples.clear();
    return {};
  }
  std::size_t count() const { return builder_.size(); }
  std::uint64_t hash() const { return hasher_.digest(); }
  demonstration::SampleTrack finish() { return demonstration::SampleTrack(builder_.take()); }

 private:
  std::optional<demonstration::Sample> last_;
  demonstration::SampleHasher hasher_;
  demonstration::BlockBuilder builder_;
};

Result<BlobSource::StoredRecording> read_recording(const store::ProjectStore& store, const store::RecordingRow& row) {
  if (!row.finished) return damaged(row.id, "it was never finished");
  Recording recording;
  recording.id = {row.id};
  TROCAR_ASSIGN_OR_RETURN(recording.provenance, header_from_json(row.header));
  TROCAR_ASSIGN_OR_RETURN(const RecordingFooter footer, footer_from_json(row.footer));
  recording.outcome = footer.outcome;
  recording.placed = footer.placed;
  recording.recovered = footer.recovered;
  ChunkReader reader;
  TROCAR_RETURN_IF_ERROR(read_chunks(store, recording, [&] { return reader.take(recording.samples); }));
  if (reader.count() != static_cast<std::size_t>(footer.samples)) {
    return damaged(row.id, fmt::format("{} of {} samples are there", reader.count(), footer.samples));
  }
  const std::uint64_t hash =
      demonstration::content_hash(reader.hash(), recording.provenance, recording.initial_world, recording.hashes);
  if (hash != footer.content_hash) return damaged(row.id, "its content does not match its hash");
  if (reader.count() < 2) return fail(ErrorCode::kInvalidArgument, "a demonstration needs at least 2 samples");
  return BlobSource::StoredRecording{std::make_shared<const demonstration::RecordingInfo>(std::move(recording)),
                                     reader.finish()};
}

}  // namespace

Result<Recording> read_whole_chunks(const store::ProjectStore& store, const store::RecordingRow& row) {
  Recording recording;
  recording.id = {row.id};
  TROCAR_ASSIGN_OR_RETURN(recording.provenance, header_from_json(row.header));
  const Status read = read_chunks(store, recording, [] { return Status(); });
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

Result<BlobSource::StoredRecording> BlobCache::recording(RecordingId id) const {
  const auto known = recordings_.find(id);
  if (known != recordings_.end()) return known->second;
  TROCAR_ASSIGN_OR_RETURN(const std::vector<store::RecordingRow> rows, store_.recordings());
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return each.id == id.value; });
  if (row == rows.end()) return fail(ErrorCode::kNotFound, fmt::format("the project has no recording {}", id.value));
  TROCAR_ASSIGN_OR_RETURN(StoredRecording read, read_recording(store_, *row));
  return recordings_[id] = std::move(read);
}

std::shared_ptr<const demonstration::Demonstration> BlobCache::prepared(
    const std::shared_ptr<const demonstration::Demonstration>& before, const demonstration::Edit& edit) const {
  const bool same = prepared_.after && prepared_.before == before && prepared_.name == name_of(edit) &&
                    prepared_.parameters == demonstration::to_json(edit);
  return same ? prepared_.after : nullptr;
}

void BlobCache::prepare(std::shared_ptr<const demonstration::Demonstration> before, const demonstration::Edit& edit,
                        std::shared_ptr<const demonstration::Demonstration> after) {
  prepared_ = {std::move(before), std::string(name_of(edit)), demonstration::to_json(edit), std::move(after)};
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
