/// How a recording is laid out in the project file: a JSON header, chunks of bytes, a JSON footer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/demonstration/recording.h"

namespace trocar::workbench {

/// Chunk 0 holds the initial world as it is; the chunks after it hold samples and marks.
constexpr std::int64_t kFirstSampleChunk = 1;

struct RecordingFooter {
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;
  bool placed = false;
  bool recovered = false;
  std::int64_t samples = 0;
  std::uint64_t content_hash = 0;
};

/// Text that is not UTF-8 is replaced, so what `header_from_json` gives back is what was stored.
std::string header_to_json(const demonstration::Provenance& provenance);
/// Errors: kCorrupt naming the key at fault, kUnsupported for samples of another layout.
Result<demonstration::Provenance> header_from_json(std::string_view text);

std::string footer_to_json(const RecordingFooter& footer);
/// Errors: kCorrupt naming the key at fault.
Result<RecordingFooter> footer_from_json(std::string_view text);

/// Two 32-bit counts (samples, marks), the samples as they are in memory, the marks; all little-endian.
std::string encode_chunk(std::span<const demonstration::Sample> samples,
                         std::span<const demonstration::HashMark> marks);
/// Appends to `recording`. Errors: kCorrupt for a length that does not fit the counts.
Status decode_chunk(std::string_view bytes, demonstration::Recording& recording);

}  // namespace trocar::workbench
