#include "engine/workbench/jobs/film_pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/workbench/jobs/still_job.h"

namespace trocar::workbench {
namespace {

/// "Scripted expert, seed 3": who made it, never to be mistaken for a person.
std::string provenance_line(const demonstration::Demonstration& shown) {
  const demonstration::Provenance& provenance = shown.recording->provenance;
  std::string line = provenance.operator_kind;
  if (!provenance.skill.empty()) line += " " + provenance.skill;
  if (provenance.operator_kind == "scripted") line += fmt::format(", seed {}", provenance.seed);
  return line + ", " + provenance.software;
}

/// A narrow picture is opened up until it shows as much of the board's width as a 16:9 one.
scene::Camera fitted(scene::Camera camera, int width, int height) {
  constexpr double kDesigned = 16.0 / 9.0;
  const double aspect = static_cast<double>(width) / height;
  if (aspect < kDesigned) {
    camera.vertical_fov_rad = 2.0 * std::atan(std::tan(0.5 * camera.vertical_fov_rad) * kDesigned / aspect);
    camera.orthographic_height_m *= kDesigned / aspect;
  }
  return camera;
}

}  // namespace

film::FrameCaption caption_of(const demonstration::Demonstration& shown, double at_s, double speed) {
  const demonstration::Sample sample = shown.sample_at(at_s);
  film::FrameCaption caption;
  caption.title = shown.name;
  caption.time_s = at_s - shown.begin_s;
  caption.duration_s = shown.duration_s();
  caption.speed = speed;
  caption.authority = sample.authority;
  caption.agent_pedal = (sample.flags & demonstration::kAgentPedal) != 0;
  caption.clutch_pedal = (sample.flags & demonstration::kClutchPedal) != 0;
  caption.jaw_rad = {sample.arms[0].jaw_rad, sample.arms[1].jaw_rad};
  caption.provenance = provenance_line(shown);
  for (const demonstration::SegmentSpan& span : shown.segments) {
    if (at_s < span.begin_s || at_s > span.end_s) continue;
    caption.segment = span.label;
    caption.segment_progress = (at_s - span.begin_s) / std::max(1e-9, span.end_s - span.begin_s);
  }
  return caption;
}

FilmPane::FilmPane(std::shared_ptr<const demonstration::Demonstration> shown, const Look& look)
    : shown_(std::move(shown)),
      look_(look),
      overlay_(look.width, look.height),
      picture_height_(look.height - (look.captions ? overlay_.band_height() : 0)),
      camera_(fitted(scene::camera(look.camera), look.width, std::max(1, picture_height_))) {}

Result<Image> FilmPane::frame(Studio& studio, double elapsed_s) {
  const double at_s = std::min(shown_->begin_s + elapsed_s, shown_->end_s);
  ViewRequest view = view_of(*shown_, at_s, camera_);
  // One shadow tap: what moves hides the difference, and the encoder needs the other core.
  view.render = {look_.width, std::max(1, picture_height_), 1, true, false};
  TROCAR_ASSIGN_OR_RETURN(Image picture, studio.picture(view));
  if (!look_.captions) return picture;
  // The captions' band is below the picture, not over it.
  Image frame(look_.width, look_.height, {14, 17, 22, 255});
  std::copy(picture.rgba.begin(), picture.rgba.end(), frame.rgba.begin());
  film::FrameCaption caption = caption_of(*shown_, at_s, look_.speed);
  if (!look_.title) caption.title.clear();
  overlay_.draw(frame, caption);
  return frame;
}

}  // namespace trocar::workbench
