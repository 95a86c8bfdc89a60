/// Whether bytes are a sound text PLY file: what the importer, which trusts its files, may be given.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/core/result.h"

namespace trocar::scene {

/// What a sound file holds.
struct PlyCounts {
  std::uint32_t vertices = 0;
  std::uint32_t faces = 0;
};

/// Text PLY, one element a line: vertices (floating x, y, z, perhaps nx, ny, nz, in any order and among other scalars)
/// before faces (a list of 3 to 64 vertices and nothing else). Lines end with a newline, perhaps after a carriage
/// return; the last one need not.
/// Errors: kUnsupported for binary PLY; kCorrupt if it is cut short or longer than it says, has numbers that are not
/// finite, a face of a vertex that is not there, or no faces at all. Threads: any.
Result<PlyCounts> check_ply(std::string_view bytes);

}  // namespace trocar::scene
