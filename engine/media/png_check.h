/// Whether bytes are a whole PNG: libpng reports damage on standard error, so it gets only what passed here. And the
/// chunk that says how large a picture is on paper.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace trocar::media {

bool has_png_signature(std::string_view bytes);
bool has_jpeg_signature(std::string_view bytes);
/// Signature, chunks with their checksums from IHDR to IEND, and a size of at most 16,384 a side.
/// Errors: kCorrupt with what is wrong.
Status check_png(std::string_view bytes);
/// Puts a pHYs chunk behind the header. Preconditions: a whole PNG without one; dpi > 0.
void add_resolution(std::string& png, double dpi);

}  // namespace trocar::media
