/// A demonstration, trial or rollout in a film: the scene at an instant, with a field in it and captions over it.
#pragma once

#include <memory>
#include <optional>

#include "engine/workbench/jobs/film_pane.h"
#include "engine/workbench/jobs/film_tips.h"

namespace trocar::workbench {

class RecordingPane final : public FilmPane {
 public:
  /// Errors: kInvalidArgument for a layer or slice of a field that there is not.
  static Result<std::unique_ptr<FilmPane>> create(const FilmSource& source, const PaneLook& look);

  Result<Image> frame(Studio& studio, const PaneMoment& moment) override;
  std::string caption_at(const film::Instant& instant) const override;

 private:
  RecordingPane(FilmSource source, const PaneLook& look);
  Status add_field();
  /// The cell at which the field in the scene is cut. Precondition: there is one.
  int slice_at(double film_s) const;
  ViewRequest view_at(const PaneMoment& moment) const;
  /// The scene without captions; one that stands still is not drawn again.
  Result<Image> picture(Studio& studio, const PaneMoment& moment);
  film::FrameCaption captions(const PaneMoment& moment) const;
  std::vector<std::string> lines_at(const PaneMoment& moment) const;

  FilmSource source_;
  PaneLook look_;
  film::FilmOverlay overlay_;
  int picture_height_;
  std::optional<FilmTips> tips_;  ///< Where something needs them.
  struct SceneSlice {
    stage::FieldLayer layer;
    std::size_t axis = 2;
    film::ColourKey colours;
  };
  std::optional<SceneSlice> field_;
  struct Drawn {
    double at_s = 0.0;
    double ghost_s = 0.0;
    std::array<double, 6> numbers{};  ///< What else a picture depends on.
    Eigen::Matrix4d X_WC = Eigen::Matrix4d::Zero();
    Image image;
  };
  Drawn last_;
};

}  // namespace trocar::workbench
