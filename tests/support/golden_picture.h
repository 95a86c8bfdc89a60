/// A picture against the one that somebody looked at and found right.
#pragma once

#include <cstdlib>
#include <filesystem>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/media/picture_file.h"

namespace trocar::testing {

// Pictures were the same to the byte on one CPU; another one may round the edge of a letter differently.
constexpr double kMeanLimit = 0.25;
constexpr int kWorstLimit = 64;

inline bool alike(const ImageDifference& apart) {
  return apart.mean <= kMeanLimit && apart.worst <= kWorstLimit;
}

/// With TROCAR_BLESS in the environment the golden picture is written anew. Errors: those of reading and writing it.
inline Result<ImageDifference> golden_difference(const Image& image, const std::filesystem::path& golden) {
  if (std::getenv("TROCAR_BLESS") != nullptr) TROCAR_RETURN_IF_ERROR(media::write_png(golden, image));
  TROCAR_ASSIGN_OR_RETURN(const Image expected, media::read_picture(golden));
  return difference(image, expected);
}

}  // namespace trocar::testing
