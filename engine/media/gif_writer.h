/// A film as a GIF in an endless loop, frame by frame. Private to the module; `VideoWriter` puts the file in place.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/core/image.h"

namespace trocar::media {

/// A frame shows what changed since the one before, in 255 colours of its own. Holds one frame. Threads: one at a time.
class GifWriter {
 public:
  /// Players show a shorter frame for a tenth of a second.
  static constexpr double kFastest_fps = 50.0;

  /// Null if the file cannot be written. `fps` is 1 to kFastest_fps.
  static std::unique_ptr<GifWriter> open(const std::filesystem::path& path, double fps, int width, int height);
  ~GifWriter();
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  /// False if it cannot be written, from then on. Precondition: a frame of the film's size.
  bool add(const Image& frame);
  /// Ends the file; false if any of it could not be written. Nothing can be added then.
  bool finish();

 private:
  struct Impl;
  explicit GifWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::media
