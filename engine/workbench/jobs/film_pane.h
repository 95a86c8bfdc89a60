/// The picture of one source of a film, frame by frame.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/film/film_overlay.h"
#include "engine/film/time_map.h"
#include "engine/workbench/jobs/film_source.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {

struct PaneLook {
  int width = 1280;
  int height = 720;
  film::Overlays overlays = film::Overlays::usual();
  film::Quality quality = film::Quality::kFast;
  bool inset = false;            ///< It lies in another: it has no band.
  bool lines_at_right = false;   ///< Another lies in its upper left corner …
  bool colours_at_left = false;  ///< … or in its upper right one.
};

struct PaneMoment {
  double film_s = 0.0;  ///< In the pass.
  double speed = 1.0;
  film::Instant instant;
  const demonstration::Demonstration* ghost = nullptr;  ///< Whose arms are seen through in the picture, if anybody's …
  double ghost_s = 0.0;                                 ///< … and where they are.
};

/// A frame depends on its moment alone. Threads: that of the studio.
class FilmPane {
 public:
  virtual ~FilmPane() = default;
  virtual Result<Image> frame(Studio& studio, const PaneMoment& moment) = 0;
  /// What the captions say; may be several words, never a line break. Empty: nothing.
  virtual std::string caption_at(const film::Instant& instant) const = 0;
};

/// What the captions say about an instant of a demonstration.
film::FrameCaption caption_of(const demonstration::Demonstration& shown, double at_s, double speed);

/// Errors: kInvalidArgument for a slice, layer or curve that there is not.
Result<std::unique_ptr<FilmPane>> make_pane(const FilmSource& source, const PaneLook& look);

}  // namespace trocar::workbench
