#include "engine/media/video_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <thread>

#include "engine/core/check.h"
#include "engine/core/file.h"
#include "engine/media/codec.h"
#include "engine/media/frame_queue.h"
#include "engine/media/gif_writer.h"
#include "engine/media/media_library.h"

namespace trocar::media {
namespace {

namespace fs = std::filesystem;

// Deep enough to ride out a slow frame on either side; at 1920 × 1080 it holds 33 MB.
constexpr std::size_t kQueuedFrames = 4;
// What an encoder holds back, and the index, need about this much; some files are whole only with them.
constexpr std::uintmax_t kLeastFree_bytes = std::uintmax_t{4} << 20U;
constexpr int kFramesBetweenDiskChecks = 15;
// What the libraries take.
constexpr int kSmallestAv1_px = 64;
constexpr int kLargestMpeg4_px = 8190;

Status check_options(const VideoOptions& options) {
  const auto [width, height, fps, codec] = options;
  if (width < 16 || height < 16 || width > 8192 || height > 8192) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("a film is 16 to 8192 pixels wide and high, not {} × {}", width, height));
  }
  if (width % 2 != 0 || height % 2 != 0) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("a film's width and height are even numbers, not {} × {}", width, height));
  }
  if (!std::isfinite(fps) || fps < 1.0 || fps > 240.0) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a film has 1 to 240 frames a second, not {}", fps));
  }
  return {};
}

/// What this codec has not of what others have.
Status check_codec(Codec codec, const VideoOptions& options, std::optional<int> crf) {
  const auto refused = [](std::string sentence) { return fail(ErrorCode::kInvalidArgument, std::move(sentence)); };
  const std::string_view name = to_string(codec);
  const Crf range = crf_of(codec);
  if (codec == Codec::kGif && options.fps > GifWriter::kFastest_fps) {
    return refused(fmt::format("a GIF has at most {} frames a second, not {}", GifWriter::kFastest_fps, options.fps));
  }
  if (codec == Codec::kAv1 && std::min(options.width, options.height) < kSmallestAv1_px) {
    return refused(fmt::format("a film in av1 is at least {} pixels wide and high, not {} × {}", kSmallestAv1_px,
                               options.width, options.height));
  }
  if (codec == Codec::kMpeg4 && std::max(options.width, options.height) > kLargestMpeg4_px) {
    return refused(fmt::format("a film in mpeg4 is at most {} pixels wide and high, not {} × {}", kLargestMpeg4_px,
                               options.width, options.height));
  }
  if (crf && range.most == 0) return refused(fmt::format("a film in {} has no crf", name));
  if (crf && (*crf < Crf::kLeast || *crf > range.most)) {
    return refused(fmt::format("the crf of {} is {} to {}, not {}", name, Crf::kLeast, range.most, *crf));
  }
  return {};
}

/// Makes the empty file, so that a path that cannot be written says why.
Status create_file(const fs::path& temporary) {
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return fail(ErrorCode::kIo, fmt::format("could not create the file ({})", std::strerror(errno)));
  ::close(file);
  return {};
}

bool has_room(const fs::path& path) {
  std::error_code error;
  const fs::space_info space = fs::space(path, error);
  return error || space.available >= kLeastFree_bytes;
}

void sync(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

struct VideoWriter::Impl {
  const trocar_media_api* api = nullptr;
  fs::path path;    ///< As it was asked for.
  fs::path target;  ///< The file at the end of its links.
  fs::path temporary;
  VideoOptions options;  ///< `codec` is the one in use.
  VideoDetails details;
  void* writer = nullptr;          ///< FFmpeg's …
  std::unique_ptr<GifWriter> gif;  ///< … or ours.
  int added = 0;
  bool finished = false;
  std::atomic<bool> cancelled{false};
  std::atomic<bool> failed{false};
  FrameQueue queue{kQueuedFrames};
  std::jthread encoder;

  ~Impl() {
    if (finished) return;
    cancelled = true;
    stop(true);
    std::error_code ignored;
    fs::remove(temporary, ignored);
  }

  void stop(bool drop) {
    queue.close(drop);
    if (encoder.joinable()) encoder.join();
    if (writer != nullptr && api->writer_close(writer) == 0) failed = true;
    writer = nullptr;
    if (gif && !gif->finish()) failed = true;
    gif.reset();
  }

  bool start(Codec codec) {
    if (codec == Codec::kGif) {
      gif = GifWriter::open(temporary, options.fps, options.width, options.height);
    } else {
      const trocar_film_format format{encoder_of(codec),
                                      options.fps,
                                      options.width,
                                      options.height,
                                      details.crf.value_or(crf_of(codec).usual),
                                      details.title.c_str(),
                                      details.comment.c_str()};
      writer = api->writer_open(temporary.c_str(), &format);
    }
    return gif || writer != nullptr;
  }

  bool write(const Image& frame) { return gif ? gif->add(frame) : api->writer_add(writer, frame.rgba.data()) != 0; }

  /// The encoder thread: the only one that uses `writer` and `gif` while it runs.
  void encode() {
    int written = 0;
    while (const std::optional<Image> frame = queue.pop()) {
      if (cancelled || failed) continue;
      const bool room = written % kFramesBetweenDiskChecks != 0 || has_room(temporary);
      if (!room || !write(*frame)) failed = true;
      ++written;
    }
  }

  Status open_first(const std::vector<Codec>& codecs) {
    // The plugin gives no reason; a full disk must not look like a codec that this machine lacks.
    if (!has_room(temporary)) return fail(ErrorCode::kIo, "the disk is full");
    for (const Codec codec : codecs) {
      options.codec = codec;
      TROCAR_RETURN_IF_ERROR(check_codec(codec, options, details.crf));
      if (start(codec)) return {};
      if (!has_room(temporary)) return fail(ErrorCode::kIo, "the disk is full");
    }
    return fail(ErrorCode::kUnsupported,
                fmt::format("this machine cannot write films in {}", to_string(options.codec)));
  }

  /// Whether so many can be decoded.
  bool has_frames(void* reader, int count) const {
    for (int i = 0; i < count; ++i) {
      if (api->reader_next(reader) == 0) return false;
    }
    return true;
  }

  /// Reads what a player would: a disk that filled up late shows here too, as the file is empty, lacks its index, or
  /// counts fewer frames.
  Status check_file() const {
    const auto bad = [](const char* what) { return fail(ErrorCode::kIo, what); };
    if (failed) return bad("the film could not be encoded, or the disk is full");
    std::error_code error;
    if (fs::file_size(temporary, error) == 0 || error) return bad("the film is empty; is the disk full");
    const std::unique_ptr<void, void (*)(void*)> reader(api->reader_open(temporary.c_str()), api->reader_close);
    if (!reader) return bad("the film is not whole; is the disk full");
    int width = 0;
    int height = 0;
    double fps = 0.0;
    double declared = 0.0;
    api->reader_info(reader.get(), &width, &height, &fps, &declared);
    if (width != options.width || height != options.height) return bad("the film has another size than asked for");
    // Matroska declares its whole length even where most frames are missing: only decoding them tells.
    const int needed = declares_frames(temporary) ? 1 : added;
    if (std::abs(declared - added) > 1.0 || !has_frames(reader.get(), needed)) {
      return bad("the film lacks frames; is the disk full");
    }
    return {};
  }
};

VideoWriter::VideoWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;

Status check_video(const fs::path& path, const VideoOptions& options, const VideoDetails& details) {
  TROCAR_RETURN_IF_ERROR(check_options(options));
  TROCAR_ASSIGN_OR_RETURN(const Codec codec, codec_for(path, options.codec));
  return check_codec(codec, options, details.crf);
}

Result<VideoWriter> VideoWriter::open(const fs::path& path, const VideoOptions& options, const VideoDetails& details) {
  TROCAR_RETURN_IF_ERROR(check_video(path, options, details));
  TROCAR_ASSIGN_OR_RETURN(const std::vector<Codec> codecs, codecs_for(path, options.codec));
  TROCAR_ASSIGN_OR_RETURN(const trocar_media_api* api, media_library());
  TROCAR_ASSIGN_OR_RETURN(const fs::path target, replaceable_file(path));
  const fs::path temporary = temporary_beside(target);
  if (Status made = create_file(temporary); !made) return tl::unexpected(std::move(made).error().at(path.string()));
  auto impl = std::make_unique<Impl>();
  impl->api = api;
  impl->path = path;
  impl->target = target;
  impl->temporary = temporary;
  impl->options = options;
  impl->details = details;
  if (Status opened = impl->open_first(codecs); !opened) {
    return tl::unexpected(std::move(opened).error().at(path.string()));
  }
  impl->encoder = std::jthread([raw = impl.get()] { raw->encode(); });
  return VideoWriter(std::move(impl));
}

Status VideoWriter::add(Image frame) {
  TROCAR_CHECK(!impl_->finished);
  if (frame.width != impl_->options.width || frame.height != impl_->options.height) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a frame is {} × {} but the film is {} × {}", frame.width,
                                                         frame.height, impl_->options.width, impl_->options.height));
  }
  if (impl_->failed || !impl_->queue.push(std::move(frame))) {
    return tl::unexpected(
        Error(ErrorCode::kIo, "the film could not be encoded, or the disk is full").at(impl_->path.string()));
  }
  ++impl_->added;
  return {};
}

Status VideoWriter::finish() {
  TROCAR_CHECK(!impl_->finished);
  impl_->stop(false);
  Status status = impl_->added > 0 ? impl_->check_file() : fail(ErrorCode::kInvalidArgument, "the film has no frames");
  if (status) {
    sync(impl_->temporary);
    if (::rename(impl_->temporary.c_str(), impl_->target.c_str()) != 0) {
      status = fail(ErrorCode::kIo, fmt::format("could not put the film in place ({})", std::strerror(errno)));
    }
  }
  if (!status) {
    std::error_code ignored;
    fs::remove(impl_->temporary, ignored);
  }
  impl_->finished = true;
  if (!status) return tl::unexpected(std::move(status).error().at(impl_->path.string()));
  return {};
}

Codec VideoWriter::codec() const {
  return impl_->options.codec;
}

}  // namespace trocar::media
