/// A demonstration or trial in a film: the scene at an instant, with captions.
#pragma once

#include <memory>
#include <optional>

#include "engine/workbench/jobs/film_pane.h"
#include "engine/workbench/jobs/film_tips.h"

namespace trocar::workbench {

class RecordingPane final : public FilmPane {
 public:
  RecordingPane(FilmSource source, const PaneLook& look);

  Result<Image> frame(Studio& studio, const PaneMoment& moment) override;
  std::string caption_at(const film::Instant& instant) const override;

 private:
  ViewRequest view_at(const PaneMoment& moment) const;
  /// The scene without captions; one that stands still is not drawn again.
  Result<Image> picture(Studio& studio, const PaneMoment& moment);
  film::FrameCaption captions(const PaneMoment& moment) const;
  std::vector<std::string> lines_at(double at_s) const;

  FilmSource source_;
  PaneLook look_;
  film::FilmOverlay overlay_;
  int picture_height_;
  std::optional<FilmTips> tips_;  ///< Where something needs them.
  struct Drawn {
    double at_s = 0.0;
    double ghost_s = 0.0;
    Eigen::Matrix4d X_WC = Eigen::Matrix4d::Zero();
    Image image;
  };
  Drawn last_;
};

}  // namespace trocar::workbench
