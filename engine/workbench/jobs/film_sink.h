/// Where the frames of a film go: into a film file, or into a row of pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/media/video_writer.h"

namespace trocar::workbench {

/// Destroyed before `finish`, it leaves nothing behind. Threads: one caller.
class FilmSink {
 public:
  virtual ~FilmSink() = default;
  /// Errors: kIo.
  virtual Status add(Image frame) = 0;
  virtual Status finish() = 0;
  /// "h264", "png" …
  virtual std::string codec() const = 0;
};

/// A name such as "F_%05d.png" is of pictures, numbered from 0; any other of a film file.
bool is_picture_row(const std::filesystem::path& path);
/// What `open_film_sink` would refuse, without a look at the disk. Errors: those of `media::check_video`;
/// kInvalidArgument for a codec or crf with pictures.
Status check_film_sink(const std::filesystem::path& path, const media::VideoOptions& options,
                       const media::VideoDetails& details);
/// Errors: those of `check_film_sink` and `media::VideoWriter::open`.
Result<std::unique_ptr<FilmSink>> open_film_sink(const std::filesystem::path& path, const media::VideoOptions& options,
                                                 const media::VideoDetails& details);
/// The subtitles of the film: beside it, with its name and the ending, ".srt" or ".vtt".
std::filesystem::path subtitles_beside(const std::filesystem::path& path, std::string_view ending);

}  // namespace trocar::workbench
