/// Films in files (H.264 in MP4 by default): written by FFmpeg's libraries and read by OpenCV, which are loaded when
/// first needed; a GIF by giflib.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::media {

enum class Codec { kAuto, kH264, kMpeg4, kFfv1, kMotionJpeg, kVp9, kAv1, kGif };
std::string_view to_string(Codec codec);
Result<Codec> codec_from(std::string_view text);
/// What a film in it is usually called: ".mp4".
std::string_view usual_ending(Codec codec);

/// What a codec may lose of the picture, as its constant rate factor says: from 1, with the largest file.
struct Crf {
  static constexpr int kLeast = 1;  ///< 0 is another, lossless, kind of film, which few players show; FFV1 is for that.
  int usual = 0;
  int most = 0;  ///< 0: it has none.
};
Crf crf_of(Codec codec);
/// The codec of a film with that name, if the machine has it. Errors: kInvalidArgument if the ending is no film's, or
/// does not fit `wanted`.
Result<Codec> codec_for(const std::filesystem::path& path, Codec wanted);

/// All but kAuto, best first.
std::vector<Codec> all_codecs();
/// Those that this machine can write. For `trocar doctor`.
std::vector<Codec> available_codecs();

struct VideoOptions {
  int width = 1280;  ///< Even.
  int height = 720;  ///< Even.
  double fps = 30.0;
  Codec codec = Codec::kAuto;  ///< The first of `all_codecs` that the extension fits and the machine can write.
};

/// What may be left as it is.
struct VideoDetails {
  std::optional<int> crf;  ///< 1 to the codec's most: less looks better. None: what is usual for the codec.
  std::string title;       ///< Kept in the file, where players show it …
  std::string comment;     ///< … and this. Not in a GIF.
};

/// What `VideoWriter::open` would refuse, without a look at the disk. Errors: kInvalidArgument: odd or zero size, a
/// size or rate that the codec has not, an ending that does not fit, no such crf.
Status check_video(const std::filesystem::path& path, const VideoOptions& options, const VideoDetails& details);

/// Writes beside the target and renames in `finish()`; destroyed before that, it leaves nothing behind. Encodes in a
/// thread of its own behind a bounded queue. Threads: one caller.
class VideoWriter {
 public:
  /// Errors: those of `check_video`; kUnsupported (codec), kIo (path,
  /// something there that is no file, disk full).
  static Result<VideoWriter> open(const std::filesystem::path& path, const VideoOptions& options,
                                  const VideoDetails& details = {});
  ~VideoWriter();
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;

  /// Errors: kInvalidArgument for a picture of another size; kIo when encoding failed (disk full).
  Status add(Image frame);
  /// Errors: kIo. Checks that the file is there and not empty.
  Status finish();
  Codec codec() const;

 private:
  struct Impl;
  explicit VideoWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Size, frame rate and number of frames of a film, by decoding it all; for tests and checks.
struct VideoInfo {
  int width = 0;
  int height = 0;
  double fps = 0.0;
  int frames = 0;
};
Result<VideoInfo> probe_video(const std::filesystem::path& path);
/// Frame `index` of a film.
Result<Image> read_video_frame(const std::filesystem::path& path, int index);

}  // namespace trocar::media
