#include "engine/workbench/jobs/film_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/figure/field_figure.h"
#include "engine/film/property.h"
#include "engine/plot/colour_map.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/jobs/film_camera.h"
#include "engine/workbench/jobs/still_job.h"

namespace trocar::workbench {
namespace {

using film::Overlay;

constexpr Rgba kGround{14, 17, 22, 255};
constexpr double kNote_s = 2.0;  // A note of an instant is read for so long.

std::string segment_words(demonstration::Segment segment) {
  constexpr std::array<const char*, demonstration::kSegmentCount> kWords{
      "approach", "grasp and lift", "carry to the hand-off", "hand over", "place on the goal peg"};
  return fmt::format("{}: {}", demonstration::letter(segment), kWords[static_cast<std::size_t>(segment)]);
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// The last span that holds the instant: one that begins there, not the one that ends.
const demonstration::SegmentSpan* span_at(const demonstration::Demonstration& shown, double at_s) {
  const demonstration::SegmentSpan* found = nullptr;
  for (const demonstration::SegmentSpan& span : shown.segments) {
    if (at_s >= span.begin_s && at_s <= span.end_s) found = &span;
  }
  return found;
}

/// The colours of the layer's scale in so many steps, or of its classes.
film::ColourKey key_of(const stage::FieldLayer& layer) {
  constexpr int kSteps = 64;
  film::ColourKey key;
  key.classes = layer.field->categorical;
  if (key.classes) {
    key.colours = layer.colouring.categories;
    key.words = layer.field->categories;
    key.colours.resize(key.words.size());
    return key;
  }
  for (int i = 0; i < kSteps; ++i) key.colours.push_back(layer.colouring.colour_at(i / (kSteps - 1.0)));
  const auto words = [&](double position) {
    std::string number = fmt::format("{:.3g}", layer.colouring.scale.value(position));
    if (number.front() == '-') number.replace(0, 1, plot::unicode_minus());
    return number;
  };
  key.words = {words(0.0), words(1.0)};
  if (!layer.field->unit.empty()) key.words.back() += " " + layer.field->unit;
  return key;
}

film::Band band_of(const PaneLook& look) {
  return look.inset ? film::Band::kNone : film::band_for(look.overlays, look.width, look.height);
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
  if (const demonstration::SegmentSpan* span = span_at(shown, at_s)) {
    caption.segment = span->label;
    caption.segment_progress = (at_s - span->begin_s) / std::max(1e-9, span->end_s - span->begin_s);
  }
  return caption;
}

RecordingPane::RecordingPane(FilmSource source, const PaneLook& look)
    : source_(std::move(source)),
      look_(look),
      overlay_(look.width, look.height, band_of(look)),
      picture_height_(std::max(1, look.height - overlay_.band_height())) {
  const film::Overlays& on = look_.overlays;
  if (on.has(Overlay::kTrail) || on.has(Overlay::kMetrics) || source_.said.camera.view == film::View::kFollow) {
    tips_.emplace(*source_.shown, source_.in_s, source_.out_s);
  }
}

Result<std::unique_ptr<FilmPane>> RecordingPane::create(const FilmSource& source, const PaneLook& look) {
  std::unique_ptr<RecordingPane> pane(new RecordingPane(source, look));
  TROCAR_RETURN_IF_ERROR(pane->add_field());
  return pane;
}

Status RecordingPane::add_field() {
  if (!source_.field_model) return {};
  const film::SceneField& said = *source_.said.field;
  FieldSettings settings;
  TROCAR_ASSIGN_OR_RETURN(settings.layer, learning::layer_from(said.layer));
  auto field = std::make_shared<const learning::Field>(field_of(*source_.field_model->model, settings.layer));
  TROCAR_ASSIGN_OR_RETURN(const figure::Slice slice, figure::slice_from(said.slice, field->grid));
  SceneSlice made;
  made.axis = static_cast<std::size_t>(slice.axis);
  made.layer = field_layer(std::move(field), settings);
  made.colours = key_of(made.layer);
  field_.emplace(std::move(made));
  return {};
}

int RecordingPane::slice_at(double film_s) const {
  const auto index = static_cast<int>(std::lround(film::value_of(source_.said, "slice", film_s)));
  return std::clamp(index, 0, field_->layer.field->grid.n - 1);
}

ViewRequest RecordingPane::view_at(const PaneMoment& moment) const {
  const double at_s = moment.instant.at_s;
  const Eigen::Vector3d followed = tips_ ? tips_->followed(at_s) : Eigen::Vector3d::Zero();
  ViewRequest view =
      view_of(*source_.shown, at_s, film_camera(source_.said, moment.film_s, followed, look_.width, picture_height_));
  // One shadow tap: what moves hides the difference, and the encoder needs the other core.
  const bool fine = look_.quality == film::Quality::kFine;
  view.render = {look_.width, picture_height_, fine ? 4 : 1, true, fine};
  view.options.scale_bar = look_.overlays.has(Overlay::kScaleBar);
  if (tips_ && look_.overlays.has(Overlay::kTrail)) {
    const double length_s = film::value_of(source_.said, "trail", moment.film_s);
    view.paths = std::make_shared<const std::vector<stage::PathLayer>>(tips_->trails(at_s, length_s));
  }
  if (moment.ghost != nullptr && look_.overlays.has(Overlay::kGhost)) {
    view.ghost = stage::pose_of(moment.ghost->sample_at(moment.ghost_s));
    view.ghost_opacity = static_cast<float>(film::value_of(source_.said, "ghost", moment.film_s));
  }
  if (field_) {
    view.fields = {field_->layer};
    stage::FieldLayer& layer = view.fields.front();
    layer.slices[field_->axis] = slice_at(moment.film_s);
    layer.opacity = static_cast<float>(film::value_of(source_.said, "field.opacity", moment.film_s));
  }
  return view;
}

Result<Image> RecordingPane::picture(Studio& studio, const PaneMoment& moment) {
  const ViewRequest view = view_at(moment);
  const Eigen::Matrix4d X_WC = view.camera.X_WC.matrix();
  const std::array<int, 3> slices = field_ ? view.fields.front().slices : std::array<int, 3>{};
  const std::array<double, 6> numbers{view.camera.vertical_fov_rad,
                                      view.camera.orthographic_height_m,
                                      view.ghost_opacity,
                                      view.paths ? film::value_of(source_.said, "trail", moment.film_s) : 0.0,
                                      static_cast<double>(slices[field_ ? field_->axis : 0]),
                                      field_ ? view.fields.front().opacity : 0.0};
  const bool same = !last_.image.empty() && last_.at_s == moment.instant.at_s && last_.ghost_s == moment.ghost_s &&
                    last_.numbers == numbers && last_.X_WC == X_WC;
  if (same) return last_.image;
  TROCAR_ASSIGN_OR_RETURN(Image image, studio.picture(view));
  last_ = {moment.instant.at_s, moment.ghost_s, numbers, X_WC, std::move(image)};
  return last_.image;
}

std::vector<std::string> RecordingPane::lines_at(const PaneMoment& moment) const {
  const double at_s = moment.instant.at_s;
  std::vector<std::string> lines;
  if (field_) {
    constexpr std::array<char, 3> kAxes{'x', 'y', 'z'};
    lines.push_back(fmt::format("{} of {}, {} = {}", field_->layer.field->title, source_.field_model->name,
                                kAxes[field_->axis], slice_at(moment.film_s)));
  }
  if (tips_ && look_.overlays.has(Overlay::kMetrics)) {
    lines.push_back(fmt::format("speed {:.0f} mm/s", 1000.0 * tips_->speed_m_s(at_s)));
    lines.push_back(fmt::format("path {:.0f} mm", 1000.0 * tips_->path_m(at_s)));
  }
  if (source_.trial && look_.overlays.has(Overlay::kTally)) {
    // Its own outcome counts from the instant in which it was decided.
    const trial::TrialRecord& record = source_.trial->record;
    const double decided_s = record.completion_s.value_or(source_.shown->end_s);
    const bool decided = at_s >= std::min(decided_s, source_.shown->end_s);
    const int own = decided && record.outcome == demonstration::Outcome::kSuccess ? 1 : 0;
    lines.push_back(fmt::format("success {} of {}", source_.successes + own, source_.before + (decided ? 1 : 0)));
  }
  return lines;
}

film::FrameCaption RecordingPane::captions(const PaneMoment& moment) const {
  const double at_s = moment.instant.at_s;
  film::FrameCaption caption = caption_of(*source_.shown, at_s, moment.speed);
  caption.time_s = at_s - source_.in_s;
  caption.duration_s = source_.out_s - source_.in_s;
  caption.title = look_.overlays.has(Overlay::kTitle) ? source_.title : "";
  // The picture around an inset says the speed and has the room for measures.
  if (!look_.overlays.has(Overlay::kSpeed) || look_.inset) caption.speed = 1.0;
  caption.provenance = source_.provenance;
  caption.scripted = source_.scripted;
  caption.shown = look_.overlays;
  // Nobody holds a pedal in a rollout.
  if (source_.said.kind == film::SourceKind::kRollout) caption.shown.set(Overlay::kPedals, false);
  if (!look_.inset) caption.lines = lines_at(moment);
  if (field_ && !look_.inset && look_.overlays.has(Overlay::kColourBar)) caption.colours = field_->colours;
  caption.lines_at_right = look_.lines_at_right;
  caption.colours_at_left = look_.colours_at_left;
  if (look_.overlays.has(Overlay::kCaptions) && !look_.inset) caption.caption = caption_at(moment.instant);
  if (moment.instant.waiting) caption.status = "waiting";
  if (moment.instant.over) caption.status = "finished";
  if (!source_.ending.empty() && at_s >= source_.ends_s) caption.status = source_.ending;
  return caption;
}

std::string RecordingPane::caption_at(const film::Instant& instant) const {
  const demonstration::Demonstration& shown = *source_.shown;
  std::string text;
  if (const demonstration::SegmentSpan* span = span_at(shown, instant.at_s)) text = segment_words(span->label);
  for (const demonstration::Note& note : shown.notes) {
    if (note.text.empty() || instant.at_s < note.begin_s) continue;
    if (instant.at_s > std::max(note.end_s, note.begin_s + kNote_s)) continue;
    text += (text.empty() ? "" : " · ") + one_line(note.text);
  }
  return text;
}

Result<Image> RecordingPane::frame(Studio& studio, const PaneMoment& moment) {
  TROCAR_ASSIGN_OR_RETURN(const Image picture, this->picture(studio, moment));
  // The captions' band is below the picture, not over it.
  Image frame(look_.width, look_.height, kGround);
  std::copy(picture.rgba.begin(), picture.rgba.end(), frame.rgba.begin());
  overlay_.draw(frame, captions(moment));
  return frame;
}

}  // namespace trocar::workbench
