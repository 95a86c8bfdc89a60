// All of OpenCV that Trocar uses. Built as a library of its own, loaded by engine/media/media_library.cpp.
#include <dlfcn.h>

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include "engine/media/plugin/media_api.h"

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

/// Errors are ours to tell, in one sentence: OpenCV and FFmpeg write theirs to standard error.
void silence() {
  static std::once_flag once;
  std::call_once(once, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    // One picture at a time is converted, in the encoder's own thread; a thread pool would only take turns with it.
    cv::setNumThreads(1);
    // OpenCV sets FFmpeg's level again with each film, but leaves the function that prints alone.
    using Print = void (*)(void*, int, const char*, va_list);
    using SetPrint = void (*)(Print);
    if (const auto set_print = reinterpret_cast<SetPrint>(dlsym(RTLD_DEFAULT, "av_log_set_callback"))) {
      set_print([](void*, int, const char*, va_list) {});
    }
  });
}

/// While one lives, what OpenCV prints itself is lost: of each WebM, that its tag of four letters is unknown there.
/// glibc lets `stderr` be set like any variable; the descriptor, which other threads and programs have too, stays.
class Hush {
 public:
  Hush() : lock_(mutex()), told_(stderr) {
    static std::FILE* const nowhere = std::fopen("/dev/null", "we");
    if (nowhere != nullptr) stderr = nowhere;
  }
  ~Hush() { stderr = told_; }
  Hush(const Hush&) = delete;
  Hush& operator=(const Hush&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }
  std::scoped_lock<std::mutex> lock_;
  std::FILE* told_;
};

struct Writer {
  cv::VideoWriter video;
  cv::Mat bgr;
  int width = 0;
  int height = 0;
};

struct Reader {
  cv::VideoCapture video;
  cv::Mat bgr;
};

void* writer_open(const char* path, const char* fourcc, double fps, int width, int height) {
  return guarded<void*>(nullptr, [&]() -> void* {
    silence();
    auto writer = std::make_unique<Writer>();
    writer->width = width;
    writer->height = height;
    const int code = cv::VideoWriter::fourcc(fourcc[0], fourcc[1], fourcc[2], fourcc[3]);
    const Hush hush;
    for (const int backend : {cv::CAP_FFMPEG, cv::CAP_OPENCV_MJPEG}) {
      if (backend == cv::CAP_OPENCV_MJPEG && std::string(fourcc) != "MJPG") continue;
      if (writer->video.open(path, backend, code, fps, cv::Size(width, height), true)) return writer.release();
    }
    return nullptr;
  });
}

int writer_add(void* handle, const std::uint8_t* rgba) {
  return guarded(0, [&] {
    auto* writer = static_cast<Writer*>(handle);
    const cv::Mat picture(writer->height, writer->width, CV_8UC4, const_cast<std::uint8_t*>(rgba));
    cv::cvtColor(picture, writer->bgr, cv::COLOR_RGBA2BGR);
    writer->video.write(writer->bgr);
    return 1;
  });
}

void writer_close(void* handle) {
  const std::unique_ptr<Writer> writer(static_cast<Writer*>(handle));
  guarded(0, [&] {
    writer->video.release();
    return 1;
  });
}

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

constexpr trocar_media_api kApi{writer_open, writer_add,     writer_close, reader_open, reader_info,
                                reader_next, reader_picture, reader_close, png_encode,  picture_decode};

}  // namespace

extern "C" __attribute__((visibility("default"))) const trocar_media_api* trocar_media_api_1() {
  return &kApi;
}
