// What the plugin offers. Built as a library of its own, loaded by engine/media/media_library.cpp.
#include "engine/media/plugin/film_encoder.h"
#include "engine/media/plugin/media_api.h"
#include "engine/media/plugin/media_opencv.h"

namespace {

namespace plugin = trocar::media::plugin;

constexpr trocar_media_api kApi{
    plugin::open_encoder, plugin::encode_picture, plugin::close_encoder, plugin::reader_open, plugin::reader_info,
    plugin::reader_next,  plugin::reader_picture, plugin::reader_close,  plugin::png_encode,  plugin::picture_decode};

}  // namespace

extern "C" __attribute__((visibility("default"))) const trocar_media_api* trocar_media_api_2() {
  return &kApi;
}
