/// Writes films by FFmpeg's libraries. Part of the plugin; nothing here throws.
#pragma once

#include <cstdint>

#include "engine/media/plugin/media_api.h"

namespace trocar::media::plugin {

/// As `trocar_media_api` tells.
void* open_encoder(const char* path, const trocar_film_format* format);
int encode_picture(void* encoder, const std::uint8_t* rgba);
int close_encoder(void* encoder);

}  // namespace trocar::media::plugin
