#include "engine/workbench/recording_codec.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>

#include "engine/core/hash.h"

namespace trocar::workbench {
namespace {

using demonstration::HashMark;
using demonstration::Outcome;
using demonstration::Provenance;
using demonstration::Sample;
using nlohmann::json;

constexpr int kRecordingFormat = 1;

tl::unexpected<Error> corrupt_recording(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

std::string dump(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Takes values out of an object and remembers the first key that is missing or of another type.
class Fields {
 public:
  explicit Fields(const json& object) : object_(object) {}

  void take(const char* key, std::string& value) {
    if (const json* found = find(key, &json::is_string)) value = found->get<std::string>();
  }
  void take(const char* key, bool& value) {
    if (const json* found = find(key, &json::is_boolean)) value = found->get<bool>();
  }
  void take(const char* key, std::uint64_t& value) {
    if (const json* found = find(key, &json::is_number_unsigned)) value = found->get<std::uint64_t>();
  }
  void take(const char* key, std::int64_t& value) {
    if (const json* found = find(key, &json::is_number_integer)) value = found->get<std::int64_t>();
  }
  void take(const char* key, int& value) {
    std::int64_t wide = 0;
    take(key, wide);
    if (wide < -1'000'000'000 || wide > 1'000'000'000) wrong(key);
    value = static_cast<int>(wide);
  }
  void wrong(const char* key) {
    if (problem_.empty()) problem_ = key;
  }
  Status done() const {
    if (problem_.empty()) return {};
    return corrupt_recording(fmt::format("the recording's {} is missing or wrong", problem_));
  }

 private:
  const json* find(const char* key, bool (json::*is_type)() const noexcept) {
    const auto found = object_.find(key);
    if (found != object_.end() && ((*found).*is_type)()) return &*found;
    wrong(key);
    return nullptr;
  }

  const json& object_;
  std::string problem_;
};

bool parse_hex(const std::string& text, std::uint64_t& value) {
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value, 16);
  return parsed.ec == std::errc() && parsed.ptr == end && !text.empty();
}

bool parse_outcome(const std::string& text, Outcome& outcome) {
  for (const Outcome candidate : {Outcome::kUnfinished, Outcome::kSuccess, Outcome::kDropped, Outcome::kAborted,
                                  Outcome::kFault, Outcome::kUnknown}) {
    if (text == to_string(candidate)) {
      outcome = candidate;
      return true;
    }
  }
  return false;
}

}  // namespace

std::string header_to_json(const Provenance& provenance) {
  return dump({{"format", kRecordingFormat},
               {"sample_bytes", sizeof(Sample)},
               {"operator", provenance.operator_kind},
               {"skill", provenance.skill},
               {"device", provenance.device},
               {"seed", provenance.seed},
               {"block", provenance.block},
               {"goal", provenance.goal},
               {"scene_hash", provenance.scene_hash},
               {"software", provenance.software},
               {"created", provenance.created}});
}

Result<Provenance> header_from_json(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt_recording("the recording's header is not a JSON object");
  Fields fields(object);
  Provenance provenance;
  int format = 0;
  int sample_bytes = 0;
  fields.take("format", format);
  fields.take("sample_bytes", sample_bytes);
  fields.take("operator", provenance.operator_kind);
  fields.take("skill", provenance.skill);
  fields.take("device", provenance.device);
  fields.take("seed", provenance.seed);
  fields.take("block", provenance.block);
  fields.take("goal", provenance.goal);
  fields.take("scene_hash", provenance.scene_hash);
  fields.take("software", provenance.software);
  fields.take("created", provenance.created);
  TROCAR_RETURN_IF_ERROR(fields.done());
  if (format != kRecordingFormat || sample_bytes != static_cast<int>(sizeof(Sample))) {
    return fail(ErrorCode::kUnsupported, "the recording has a layout that this version cannot read");
  }
  return provenance;
}

std::string footer_to_json(const RecordingFooter& footer) {
  return dump({{"outcome", std::string(to_string(footer.outcome))},
               {"placed", footer.placed},
               {"recovered", footer.recovered},
               {"samples", footer.samples},
               {"content_hash", to_hex(footer.content_hash)}});
}

Result<RecordingFooter> footer_from_json(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt_recording("the recording's footer is not a JSON object");
  Fields fields(object);
  RecordingFooter footer;
  std::string outcome;
  std::string hash;
  fields.take("outcome", outcome);
  fields.take("placed", footer.placed);
  fields.take("recovered", footer.recovered);
  fields.take("samples", footer.samples);
  fields.take("content_hash", hash);
  if (footer.samples < 0) fields.wrong("samples");
  if (!parse_outcome(outcome, footer.outcome)) fields.wrong("outcome");
  if (!parse_hex(hash, footer.content_hash)) fields.wrong("content_hash");
  TROCAR_RETURN_IF_ERROR(fields.done());
  return footer;
}

std::string encode_chunk(std::span<const Sample> samples, std::span<const HashMark> marks) {
  const std::array<std::uint32_t, 2> counts{static_cast<std::uint32_t>(samples.size()),
                                            static_cast<std::uint32_t>(marks.size())};
  static_assert(std::is_trivially_copyable_v<HashMark> && sizeof(HashMark) == 16);
  std::string bytes;
  bytes.reserve(sizeof counts + samples.size_bytes() + marks.size_bytes());
  bytes.append(reinterpret_cast<const char*>(counts.data()), sizeof counts);
  bytes.append(reinterpret_cast<const char*>(samples.data()), samples.size_bytes());
  bytes.append(reinterpret_cast<const char*>(marks.data()), marks.size_bytes());
  return bytes;
}

Status decode_chunk(std::string_view bytes, demonstration::Recording& recording) {
  std::array<std::uint32_t, 2> counts{};
  if (bytes.size() < sizeof counts) return corrupt_recording("a chunk of the recording is too short");
  std::memcpy(counts.data(), bytes.data(), sizeof counts);
  bytes.remove_prefix(sizeof counts);
  const std::size_t sample_bytes = counts[0] * sizeof(Sample);
  const std::size_t mark_bytes = counts[1] * sizeof(HashMark);
  if (bytes.size() != sample_bytes + mark_bytes)
    return corrupt_recording("a chunk of the recording has the wrong length");
  const std::size_t sample_count = recording.samples.size();
  const std::size_t mark_count = recording.hashes.size();
  recording.samples.resize(sample_count + counts[0]);
  recording.hashes.resize(mark_count + counts[1]);
  if (sample_bytes > 0) std::memcpy(recording.samples.data() + sample_count, bytes.data(), sample_bytes);
  if (mark_bytes > 0) std::memcpy(recording.hashes.data() + mark_count, bytes.data() + sample_bytes, mark_bytes);
  return {};
}

}  // namespace trocar::workbench
