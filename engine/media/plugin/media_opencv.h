/// All of OpenCV that Trocar uses: films are read and pictures turned into files and back. Part of the plugin.
#pragma once

#include <cstddef>
#include <cstdint>

namespace trocar::media::plugin {

// Each as `trocar_media_api` tells.
void* reader_open(const char* path);
void reader_info(void* reader, int* width, int* height, double* fps, double* declared_frames);
int reader_next(void* reader);
int reader_picture(void* reader, std::uint8_t* rgba);
void reader_close(void* reader);

int png_encode(const std::uint8_t* rgba, int width, int height, void* sink,
               void (*take)(void* sink, const std::uint8_t* bytes, std::size_t size));
int picture_decode(const std::uint8_t* bytes, std::size_t size, void* sink,
                   std::uint8_t* (*make_room)(void* sink, int width, int height));

}  // namespace trocar::media::plugin
