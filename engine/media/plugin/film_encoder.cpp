#include "engine/media/plugin/film_encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/media/plugin/silence.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace trocar::media::plugin {
namespace {

/// The same on every machine: what libx264 writes depends on it.
constexpr int kThreads = 2;
/// A player that jumps decodes from the key picture before.
constexpr double kBetweenKeyPictures_s = 4.0;

struct Option {
  const char* name;
  const char* value;
};

/// How a library is used: as fast as it gets before pictures suffer, measured on drawn films.
struct Use {
  std::string_view encoder;  ///< FFmpeg's name.
  AVPixelFormat pixels;
  int scale;  ///< Of a quantiser, where it has no CRF but loses something; else 0.
  std::array<Option, 3> options;
};

constexpr std::array<Use, 6> kUses{{
    {"libx264", AV_PIX_FMT_YUV420P, 0, {{{"preset", "veryfast"}}}},
    {"mpeg4", AV_PIX_FMT_YUV420P, 3, {}},
    {"mjpeg", AV_PIX_FMT_YUVJ420P, 3, {}},
    {"ffv1", AV_PIX_FMT_BGR0, 0, {{{"level", "3"}, {"slices", "4"}, {"slicecrc", "1"}}}},
    {"libvpx-vp9", AV_PIX_FMT_YUV420P, 0, {{{"deadline", "realtime"}, {"cpu-used", "7"}, {"row-mt", "1"}}}},
    {"libsvtav1", AV_PIX_FMT_YUV420P, 0, {{{"preset", "10"}}}},
}};

struct CodecClose {
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
};
struct FileClose {
  void operator()(AVFormatContext* file) const {
    if (file->pb != nullptr) avio_closep(&file->pb);
    avformat_free_context(file);
  }
};
struct FrameFree {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct PacketFree {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct ScalerFree {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

/// 29.97 is meant to be 30000/1001.
AVRational rate_of(double fps) {
  const double of_television = std::round(fps * 1.001) / 1.001;
  if (std::abs(fps - of_television) < 5e-4 && std::abs(fps - std::round(fps)) > 5e-4) {
    return {static_cast<int>(std::lround(fps * 1.001)) * 1000, 1001};
  }
  return av_d2q(fps, 60000);
}

class Encoder {
 public:
  bool open(const char* path, const trocar_film_format& format);
  bool add(const std::uint8_t* rgba);
  /// Writes what is still held back, and the end of the file.
  bool finish();

 private:
  bool open_codec(const trocar_film_format& format);
  void set_quality(const Use& use, int crf);
  bool open_file(const char* path, const trocar_film_format& format);
  bool open_conversion();
  /// A frame, or none at the end, goes in; what comes out goes into the file.
  bool encode(const AVFrame* frame);

  std::unique_ptr<AVFormatContext, FileClose> file_;
  std::unique_ptr<AVCodecContext, CodecClose> codec_;
  std::unique_ptr<AVFrame, FrameFree> frame_;
  std::unique_ptr<AVPacket, PacketFree> packet_;
  std::unique_ptr<SwsContext, ScalerFree> scaler_;
  AVStream* stream_ = nullptr;
  std::int64_t pictures_ = 0;
};

bool Encoder::open(const char* path, const trocar_film_format& format) {
  AVFormatContext* file = nullptr;
  if (avformat_alloc_output_context2(&file, nullptr, nullptr, path) < 0) return false;
  file_.reset(file);
  return open_codec(format) && open_conversion() && open_file(path, format);
}

bool Encoder::open_codec(const trocar_film_format& format) {
  const auto use = std::find_if(kUses.begin(), kUses.end(), [&](const Use& u) { return u.encoder == format.encoder; });
  const AVCodec* library = avcodec_find_encoder_by_name(format.encoder);
  if (use == kUses.end() || library == nullptr) return false;
  codec_.reset(avcodec_alloc_context3(library));
  if (!codec_) return false;
  codec_->width = format.width;
  codec_->height = format.height;
  codec_->framerate = rate_of(format.fps);
  codec_->time_base = av_inv_q(codec_->framerate);
  codec_->gop_size = std::max(1, static_cast<int>(std::lround(kBetweenKeyPictures_s * format.fps)));
  codec_->pix_fmt = use->pixels;
  if (use->pixels != AV_PIX_FMT_BGR0) {
    // Said in the file, so that no player guesses by the picture's size: swscale's matrix is that of BT.601. MPEG-4 and
    // AVI have no room for it.
    codec_->colorspace = AVCOL_SPC_SMPTE170M;
    codec_->color_primaries = AVCOL_PRI_BT709;
    codec_->color_trc = AVCOL_TRC_BT709;
    codec_->color_range = use->pixels == AV_PIX_FMT_YUVJ420P ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
  }
  codec_->thread_count = kThreads;
  if ((file_->oformat->flags & AVFMT_GLOBALHEADER) != 0) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  codec_->flags |= AV_CODEC_FLAG_BITEXACT;
  set_quality(*use, format.crf);
  for (const Option& option : use->options) {
    if (option.name != nullptr) av_opt_set(codec_->priv_data, option.name, option.value, 0);
  }
  const std::optional<Hush> hush = use->encoder == "libsvtav1" ? std::make_optional<Hush>() : std::nullopt;
  return avcodec_open2(codec_.get(), library, nullptr) >= 0;
}

void Encoder::set_quality(const Use& use, int crf) {
  codec_->bit_rate = 0;
  av_opt_set_int(codec_->priv_data, "crf", crf, 0);
  if (use.scale == 0) return;
  codec_->flags |= AV_CODEC_FLAG_QSCALE;
  codec_->global_quality = FF_QP2LAMBDA * use.scale;
}

bool Encoder::open_file(const char* path, const trocar_film_format& format) {
  stream_ = avformat_new_stream(file_.get(), nullptr);
  if (stream_ == nullptr || avcodec_parameters_from_context(stream_->codecpar, codec_.get()) < 0) return false;
  stream_->time_base = codec_->time_base;
  stream_->avg_frame_rate = codec_->framerate;
  file_->flags |= AVFMT_FLAG_BITEXACT;  // No random names: the same film is the same file.
  if (format.title[0] != '\0') av_dict_set(&file_->metadata, "title", format.title, 0);
  if (format.comment[0] != '\0') av_dict_set(&file_->metadata, "comment", format.comment, 0);
  if (avio_open(&file_->pb, path, AVIO_FLAG_WRITE) < 0) return false;
  // The index before the pictures: a page shows the first while the last are on their way. Of no account elsewhere.
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "+faststart", 0);
  const bool begun = avformat_write_header(file_.get(), &options) >= 0;
  av_dict_free(&options);
  return begun;
}

bool Encoder::open_conversion() {
  frame_.reset(av_frame_alloc());
  packet_.reset(av_packet_alloc());
  if (!frame_ || !packet_) return false;
  frame_->format = codec_->pix_fmt;
  frame_->width = codec_->width;
  frame_->height = codec_->height;
  frame_->colorspace = codec_->colorspace;
  frame_->color_range = codec_->color_range;
  if ((codec_->flags & AV_CODEC_FLAG_QSCALE) != 0) frame_->quality = codec_->global_quality;
  if (av_frame_get_buffer(frame_.get(), 0) < 0) return false;
  scaler_.reset(sws_getContext(codec_->width, codec_->height, AV_PIX_FMT_RGBA, codec_->width, codec_->height,
                               codec_->pix_fmt, SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
  return scaler_ != nullptr;
}

bool Encoder::add(const std::uint8_t* rgba) {
  if (av_frame_make_writable(frame_.get()) < 0) return false;
  const int stride = 4 * codec_->width;
  sws_scale(scaler_.get(), &rgba, &stride, 0, codec_->height, frame_->data, frame_->linesize);
  frame_->pts = pictures_++;
  return encode(frame_.get());
}

bool Encoder::encode(const AVFrame* frame) {
  if (avcodec_send_frame(codec_.get(), frame) < 0) return false;
  for (;;) {
    const int got = avcodec_receive_packet(codec_.get(), packet_.get());
    if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return true;
    if (got < 0) return false;
    av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
    packet_->stream_index = stream_->index;
    packet_->duration = av_rescale_q(1, codec_->time_base, stream_->time_base);
    if (av_interleaved_write_frame(file_.get(), packet_.get()) < 0 || file_->pb->error < 0) return false;
  }
}

bool Encoder::finish() {
  const bool encoded = encode(nullptr);
  const bool ended = av_write_trailer(file_.get()) >= 0;
  const bool closed = avio_closep(&file_->pb) >= 0;
  return encoded && ended && closed;
}

}  // namespace

void* open_encoder(const char* path, const trocar_film_format* format) {
  silence();
  try {
    auto encoder = std::make_unique<Encoder>();
    return encoder->open(path, *format) ? encoder.release() : nullptr;
  } catch (...) {
    return nullptr;
  }
}

int encode_picture(void* encoder, const std::uint8_t* rgba) {
  return static_cast<Encoder*>(encoder)->add(rgba) ? 1 : 0;
}

int close_encoder(void* encoder) {
  const std::unique_ptr<Encoder> ending(static_cast<Encoder*>(encoder));
  return ending->finish() ? 1 : 0;
}

}  // namespace trocar::media::plugin
