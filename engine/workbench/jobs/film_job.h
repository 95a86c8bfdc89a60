/// A film of one demonstration, or of two side by side, with captions.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/media/video_writer.h"
#include "engine/scene/scene.h"

namespace trocar::workbench {

struct FilmJob {
  std::vector<std::shared_ptr<const demonstration::Demonstration>> demonstrations;  ///< One, or two side by side.
  std::filesystem::path path;
  int width = 1280;  ///< Even.
  int height = 720;  ///< Even.
  double fps = 30.0;
  double speed = 1.0;  ///< Demonstration seconds for each second of film.
  scene::CameraPreset camera = scene::CameraPreset::kPaper;
  media::Codec codec = media::Codec::kAuto;
  bool captions = true;
};

struct FilmReport {
  int frames = 0;
  double seconds = 0.0;  ///< Wall time.
  media::Codec codec = media::Codec::kAuto;
};

/// Frame k shows the moment k · speed / fps after the gate and depends on nothing else; the shorter of two holds its
/// last frame. Threads: any that holds no GL context. Errors: kInvalidArgument; those of `media::VideoWriter`;
/// kCancelled, which leaves no file.
Result<FilmReport> render_film(const FilmJob& job, Progress& progress);

}  // namespace trocar::workbench
