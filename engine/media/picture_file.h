/// Pictures in files (PNG), through OpenCV, which is loaded when first needed.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::media {

/// Writes atomically; with `dpi`, the file says how many pixels an inch of paper has.
/// Errors: kInvalidArgument for an empty picture; kIo.
Status write_png(const std::filesystem::path& path, const Image& image, std::optional<double> dpi = {});
/// Errors: kIo, kCorrupt.
Result<Image> read_picture(const std::filesystem::path& path);

}  // namespace trocar::media
