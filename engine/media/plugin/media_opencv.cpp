#include "engine/media/plugin/media_opencv.h"

#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <vector>

#include "engine/media/plugin/silence.h"

namespace trocar::media::plugin {
namespace {

/// OpenCV throws; C callers get `otherwise`.
template <typename Result, typename Action>
Result guarded(Result otherwise, Action action) {
  try {
    return action();
  } catch (...) {
    return otherwise;
  }
}

struct Reader {
  cv::VideoCapture video;
  cv::Mat bgr;
};

}  // namespace

void* reader_open(const char* path) {
  return guarded<void*>(nullptr, [&]() -> void* {
    silence();
    auto reader = std::make_unique<Reader>();
    for (const int backend : {cv::CAP_FFMPEG, cv::CAP_OPENCV_MJPEG}) {
      if (reader->video.open(path, backend)) return reader.release();
    }
    return nullptr;
  });
}

void reader_info(void* handle, int* width, int* height, double* fps, double* declared_frames) {
  guarded(0, [&] {
    const cv::VideoCapture& video = static_cast<Reader*>(handle)->video;
    *width = static_cast<int>(video.get(cv::CAP_PROP_FRAME_WIDTH));
    *height = static_cast<int>(video.get(cv::CAP_PROP_FRAME_HEIGHT));
    *fps = video.get(cv::CAP_PROP_FPS);
    *declared_frames = video.get(cv::CAP_PROP_FRAME_COUNT);
    return 1;
  });
}

int reader_next(void* handle) {
  return guarded(0, [&] { return static_cast<Reader*>(handle)->video.grab() ? 1 : 0; });
}

int reader_picture(void* handle, std::uint8_t* rgba) {
  return guarded(0, [&] {
    auto* reader = static_cast<Reader*>(handle);
    if (!reader->video.retrieve(reader->bgr) || reader->bgr.type() != CV_8UC3) return 0;
    cv::Mat out(reader->bgr.size(), CV_8UC4, rgba);
    cv::cvtColor(reader->bgr, out, cv::COLOR_BGR2RGBA);
    return 1;
  });
}

void reader_close(void* handle) {
  const std::unique_ptr<Reader> reader(static_cast<Reader*>(handle));
}

int png_encode(const std::uint8_t* rgba, int width, int height, void* sink,
               void (*take)(void*, const std::uint8_t*, std::size_t)) {
  return guarded(0, [&] {
    silence();
    const cv::Mat picture(height, width, CV_8UC4, const_cast<std::uint8_t*>(rgba));
    cv::Mat alpha;
    cv::extractChannel(picture, alpha, 3);
    const bool opaque = cv::countNonZero(alpha != 255) == 0;
    cv::Mat bgr;
    cv::cvtColor(picture, bgr, opaque ? cv::COLOR_RGBA2BGR : cv::COLOR_RGBA2BGRA);
    std::vector<std::uint8_t> bytes;
    if (!cv::imencode(".png", bgr, bytes, {cv::IMWRITE_PNG_COMPRESSION, 6})) return 0;
    take(sink, bytes.data(), bytes.size());
    return 1;
  });
}

int picture_decode(const std::uint8_t* bytes, std::size_t size, void* sink,
                   std::uint8_t* (*make_room)(void*, int, int)) {
  return guarded(0, [&] {
    silence();
    const cv::Mat buffer(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(bytes));
    cv::Mat picture = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    if (picture.empty()) return 0;
    if (picture.depth() == CV_16U) picture.convertTo(picture, CV_8U, 1.0 / 257.0);
    if (picture.depth() != CV_8U) return 0;
    cv::Mat out(picture.size(), CV_8UC4, make_room(sink, picture.cols, picture.rows));
    const int channels = picture.channels();
    if (channels != 1 && channels != 3 && channels != 4) return 0;
    cv::cvtColor(picture, out,
                 channels == 1   ? cv::COLOR_GRAY2RGBA
                 : channels == 3 ? cv::COLOR_BGR2RGBA
                                 : cv::COLOR_BGRA2RGBA);
    return 1;
  });
}

}  // namespace trocar::media::plugin
