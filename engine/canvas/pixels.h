/// Between our straight RGBA and Cairo's premultiplied, native-endian ARGB. Private to the module.
#pragma once

#include <cairo.h>

#include "engine/core/image.h"

namespace trocar::canvas {

/// A new image surface with a copy of `image`; at least 1 × 1.
cairo_surface_t* surface_from(const Image& image);
/// Precondition: an ARGB32 image surface.
Image image_from(cairo_surface_t* surface);

}  // namespace trocar::canvas
