/// Whether bytes are a whole PNG: libpng reports damage on standard error, so it gets only what passed here.
#pragma once

#include <string_view>

#include "engine/core/result.h"

namespace trocar::media {

bool has_png_signature(std::string_view bytes);
bool has_jpeg_signature(std::string_view bytes);
/// Signature, chunks with their checksums from IHDR to IEND, and a size of at most 16,384 a side.
/// Errors: kCorrupt with what is wrong.
Status check_png(std::string_view bytes);

}  // namespace trocar::media
