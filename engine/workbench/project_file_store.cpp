// What a project keeps beside its journal: recordings and models.
#include <utility>

#include "engine/workbench/model_codec.h"
#include "engine/workbench/project_file.h"
#include "engine/workbench/project_file_impl.h"

namespace trocar::workbench {

Result<RecordingWriter> ProjectFile::begin_recording(const demonstration::Provenance& provenance,
                                                     const std::string& initial_world) {
  demonstration::Provenance dated = provenance;
  if (dated.created.empty()) dated.created = iso_time(impl_->clock->unix_s());
  return RecordingWriter::begin(impl_->store, dated, initial_world);
}

Result<demonstration::RecordingId> ProjectFile::store_recording(const demonstration::Recording& recording) {
  TROCAR_RETURN_IF_ERROR(demonstration::check_samples(recording.samples));
  return store_recording(recording, demonstration::SampleTrack(recording.samples));
}

Result<demonstration::RecordingId> ProjectFile::store_recording(const demonstration::RecordingInfo& info,
                                                                const demonstration::SampleTrack& samples) {
  demonstration::RecordingId id;
  const auto work = [&]() -> Status {
    TROCAR_ASSIGN_OR_RETURN(RecordingWriter writer, begin_recording(info.provenance, info.initial_world));
    for (const demonstration::Sample& sample : samples) TROCAR_RETURN_IF_ERROR(writer.add(sample));
    for (const demonstration::HashMark& mark : info.hashes) TROCAR_RETURN_IF_ERROR(writer.mark(mark));
    TROCAR_ASSIGN_OR_RETURN(id, writer.finish(info.outcome, info.placed));
    return {};
  };
  TROCAR_RETURN_IF_ERROR(impl_->store.transaction(work));
  return id;
}

Result<std::int64_t> ProjectFile::store_model(const ModelEntry& entry) {
  if (entry.model == nullptr) return fail(ErrorCode::kInvalidArgument, "there is no model to store");
  ModelEntry dated = entry;
  if (dated.created.empty()) dated.created = iso_time(impl_->clock->unix_s());
  const EncodedModel encoded = encode_model(dated);
  return impl_->store.put_object(kModelKind, encoded.meta, encoded.bytes);
}

Result<std::vector<DemonstrationId>> ProjectFile::import_recordings(const std::string& file,
                                                                    const std::vector<NewRecording>& recordings) {
  std::vector<demonstration::RecordingId> stored;
  const Result<std::int64_t> node = impl_->commit([&]() -> Result<Edit> {
    ImportDemonstrations import{file, {}};
    for (const NewRecording& each : recordings) {
      TROCAR_ASSIGN_OR_RETURN(const demonstration::RecordingId id, store_recording(*each.info, each.samples));
      stored.push_back(id);
      import.parts.push_back({id, each.name, each.edits});
    }
    return import;
  });
  if (!node) {
    for (const demonstration::RecordingId id : stored) impl_->blobs.forget(id);
    return tl::unexpected(node.error());
  }
  std::vector<DemonstrationId> ids;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    ids.push_back(DemonstrationId{*node - static_cast<std::int64_t>(recordings.size() - 1 - i)});
  }
  return ids;
}

Result<std::int64_t> ProjectFile::add_model(const ModelEntry& entry, const Progress& progress) {
  std::int64_t object = 0;
  Result<std::int64_t> node = impl_->commit([&]() -> Result<Edit> {
    TROCAR_ASSIGN_OR_RETURN(object, store_model(entry));
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the training was stopped; the model was not kept");
    return AddModel{object};
  });
  if (!node) impl_->blobs.forget_model(object);
  return node;
}

}  // namespace trocar::workbench
