#include "engine/media/plugin/silence.h"

#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

extern "C" {
#include <libavutil/log.h>
}

namespace trocar::media::plugin {
namespace {

/// Guards how many live, and what `stderr` was before the first.
std::mutex& hushes() {
  static std::mutex only;
  return only;
}
int alive = 0;
std::FILE* told = nullptr;

}  // namespace

void silence() {
  static std::once_flag once;
  std::call_once(once, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    // One picture at a time is converted; a thread pool would only take turns with whoever waits for it.
    cv::setNumThreads(1);
    // OpenCV sets FFmpeg's level again with each film, but leaves the function that prints alone.
    av_log_set_callback([](void*, int, const char*, va_list) {});
  });
}

Hush::Hush() {
  const std::scoped_lock lock(hushes());
  if (alive++ > 0) return;
  told = stderr;
  static std::FILE* const nowhere = std::fopen("/dev/null", "we");
  if (nowhere != nullptr) stderr = nowhere;
}

Hush::~Hush() {
  const std::scoped_lock lock(hushes());
  if (--alive == 0) stderr = told;
}

}  // namespace trocar::media::plugin
