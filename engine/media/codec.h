/// Which codecs go into which files, and what libraries call them. Private to the module.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/media/video_writer.h"

namespace trocar::media {

/// The codecs to try for `path`, best first; only `wanted` unless it is kAuto.
/// Errors: kInvalidArgument if the extension is no film's, or does not fit `wanted`.
Result<std::vector<Codec>> codecs_for(const std::filesystem::path& path, Codec wanted);
/// FFmpeg's name; empty for kGif, which it does not write here. Precondition: not kAuto.
const char* encoder_of(Codec codec);

/// Whether a film there knows the number of its frames; Matroska and WebM know their length alone.
bool declares_frames(const std::filesystem::path& path);

}  // namespace trocar::media
