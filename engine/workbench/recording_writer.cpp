#include "engine/workbench/recording_writer.h"

#include <utility>
#include <vector>

#include "engine/workbench/recording_codec.h"

namespace trocar::workbench {
namespace {

using demonstration::HashMark;
using demonstration::RecordingId;
using demonstration::Sample;

constexpr std::size_t kSamplesPerChunk = 50;
constexpr int kPatience_ms = 500;

}  // namespace

struct RecordingWriter::Impl {
  store::ProjectStore& store;
  RecordingId id;
  demonstration::Provenance provenance;  ///< As it can be read back.
  std::string initial_world;
  std::vector<Sample> pending{};
  std::vector<HashMark> pending_marks{};
  std::vector<HashMark> marks{};
  Sample last{};
  std::int64_t count = 0;
  std::int64_t sequence = kFirstSampleChunk;
  demonstration::SampleHasher hasher{};
  bool open = true;

  ~Impl() {
    // A failure only delays the recovery until this program ends.
    if (open) (void)store.abandon_recording(id.value);
  }

  /// What another program's writing holds up stays for the next time; a recording does not wait for it.
  Status flush_if_free() {
    constexpr std::size_t kMostPending = 200 * 30;  // half a minute
    store.set_patience_ms(0);
    Status flushed = flush();
    store.set_patience_ms(kPatience_ms);
    return flushed || !store.held_elsewhere() || pending.size() >= kMostPending ? flushed : Status();
  }

  Status flush() {
    if (pending.empty() && pending_marks.empty()) return {};
    TROCAR_RETURN_IF_ERROR(store.append_chunk(id.value, {sequence, encode_chunk(pending, pending_marks)}));
    ++sequence;
    pending.clear();
    pending_marks.clear();
    return {};
  }
};

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RecordingWriter::~RecordingWriter() = default;
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;

Result<RecordingWriter> RecordingWriter::begin(store::ProjectStore& store, const demonstration::Provenance& provenance,
                                               const std::string& initial_world) {
  const std::string header = header_to_json(provenance);
  TROCAR_ASSIGN_OR_RETURN(demonstration::Provenance stored, header_from_json(header));
  std::int64_t id = 0;
  TROCAR_RETURN_IF_ERROR(store.transaction([&]() -> Status {
    TROCAR_ASSIGN_OR_RETURN(id, store.begin_recording(header));
    return store.append_chunk(id, {0, initial_world});
  }));
  // NOLINTNEXTLINE(modernize-make-unique): clang 14 cannot make an aggregate so
  return RecordingWriter(std::unique_ptr<Impl>(
      new Impl{.store = store, .id = {id}, .provenance = stored, .initial_world = initial_world}));
}

Status RecordingWriter::add(const Sample& sample) {
  const Sample both[2] = {impl_->last, sample};
  TROCAR_RETURN_IF_ERROR(
      demonstration::check_samples(impl_->count == 0 ? std::span(both).subspan(1) : std::span<const Sample>(both)));
  impl_->pending.push_back(sample);
  impl_->hasher.add(sample);
  impl_->last = sample;
  ++impl_->count;
  return impl_->pending.size() >= kSamplesPerChunk ? impl_->flush_if_free() : Status();
}

Status RecordingWriter::mark(const HashMark& mark) {
  impl_->pending_marks.push_back(mark);
  impl_->marks.push_back(mark);
  return {};
}

Result<RecordingId> RecordingWriter::finish(demonstration::Outcome outcome, bool placed) {
  if (!impl_->open) return fail(ErrorCode::kInvalidArgument, "the recording is finished already");
  if (impl_->count < 2) return fail(ErrorCode::kInvalidArgument, "a recording needs at least 2 samples");
  const std::uint64_t hash =
      demonstration::content_hash(impl_->hasher.digest(), impl_->provenance, impl_->initial_world, impl_->marks);
  const RecordingFooter footer{outcome, placed, false, impl_->count, hash};
  TROCAR_RETURN_IF_ERROR(impl_->flush());
  TROCAR_RETURN_IF_ERROR(impl_->store.finish_recording(impl_->id.value, footer_to_json(footer)));
  impl_->open = false;
  return impl_->id;
}

Status RecordingWriter::discard() {
  TROCAR_RETURN_IF_ERROR(impl_->store.discard_recording(impl_->id.value));
  impl_->open = false;
  return {};
}

RecordingId RecordingWriter::id() const {
  return impl_->id;
}

}  // namespace trocar::workbench
