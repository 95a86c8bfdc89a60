/// One demonstration in a film: its picture at a moment, with captions.
#pragma once

#include <memory>
#include <string>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/film/film_overlay.h"
#include "engine/scene/scene.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {

/// What the captions say about a moment of a demonstration.
film::FrameCaption caption_of(const demonstration::Demonstration& shown, double at_s, double speed);

/// Threads: that of the studio.
class FilmPane {
 public:
  struct Look {
    int width = 1280;
    int height = 720;
    double speed = 1.0;
    scene::CameraPreset camera = scene::CameraPreset::kPaper;
    bool captions = true;
    bool title = true;  ///< Of the captions; not where the name is written anyhow.
  };
  FilmPane(std::shared_ptr<const demonstration::Demonstration> shown, const Look& look);

  /// `elapsed_s` after the begin gate; after the end the last moment stays.
  Result<Image> frame(Studio& studio, double elapsed_s);

 private:
  std::shared_ptr<const demonstration::Demonstration> shown_;
  Look look_;
  film::FilmOverlay overlay_;
  int picture_height_;
  scene::Camera camera_;
};

}  // namespace trocar::workbench
