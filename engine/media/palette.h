/// Few colours for a picture of many. Private to the module.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/image.h"

namespace trocar::media {

struct Palette {
  std::vector<Rgba> colours;          ///< Opaque; none for no pixels.
  std::vector<std::uint8_t> indices;  ///< For each pixel its colour.
};

/// At most `most` colours (1 to 256) for `pixels`, each the mean of the pixels that get it. Colours that differ by less
/// than eight steps may become one even where there is room for both. The same for the same pixels.
Palette palette_of(std::span<const Rgba> pixels, std::size_t most);

}  // namespace trocar::media
