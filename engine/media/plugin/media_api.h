/// The seam to the one library that links OpenCV and FFmpeg: a table of C functions, so that it can be loaded when
/// first needed. (Linking their codecs into the programs costs each start more than 0.1 s.)
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// What a film is; the container goes by the path's extension.
struct trocar_film_format {  // NOLINT(readability-identifier-naming): a C name for a C seam
  const char* encoder;       ///< FFmpeg's name of it: "libx264".
  double fps;
  int width;
  int height;
  int crf;              ///< Constant rate factor: less is better. Only for encoders that have one.
  const char* title;    ///< Kept in the file, as is …
  const char* comment;  ///< … this; not if empty.
};

/// Nothing here throws. Pictures are rows of straight RGBA from the top. `int` results: 1 done, 0 not.
struct trocar_media_api {  // NOLINT(readability-identifier-naming): a C name for a C seam
  /// Null if this machine cannot write it.
  void* (*writer_open)(const char* path, const trocar_film_format* format);
  int (*writer_add)(void* writer, const std::uint8_t* rgba);
  /// Ends the file and frees the writer, whether it could or not.
  int (*writer_close)(void* writer);

  /// Null if it is no film.
  void* (*reader_open)(const char* path);
  void (*reader_info)(void* reader, int* width, int* height, double* fps, double* declared_frames);
  /// Decodes the next frame; 0 at the end.
  int (*reader_next)(void* reader);
  /// The frame decoded last; `rgba` has room for 4 · width · height bytes.
  int (*reader_picture)(void* reader, std::uint8_t* rgba);
  void (*reader_close)(void* reader);

  int (*png_encode)(const std::uint8_t* rgba, int width, int height, void* sink,
                    void (*take)(void* sink, const std::uint8_t* bytes, std::size_t size));
  /// PNG or JPEG. `make_room` gives the place for 4 · width · height bytes.
  int (*picture_decode)(const std::uint8_t* bytes, std::size_t size, void* sink,
                        std::uint8_t* (*make_room)(void* sink, int width, int height));
};

/// The only exported symbol. The version is part of the name: a library of another build is not found, not misread.
const trocar_media_api* trocar_media_api_2();

}  // extern "C"
