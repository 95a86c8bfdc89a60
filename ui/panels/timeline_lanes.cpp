#include "ui/panels/timeline_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/demonstration/edit_words.h"
#include "ui/format.h"
#include "ui/panels/common.h"
#include "ui/panels/lane_painter.h"
#include "ui/widgets/plot.h"

namespace trocar::ui {
namespace {

constexpr float kRulerHeight = 24.0F;  // All at 100 %.
constexpr float kGatesHeight = 16.0F;

void draw_segments(LanePainter& lanes, const LaneLayout& layout, const demonstration::Demonstration& shown) {
  UniqueNames unique;
  lanes.begin(Lane::kSegments);
  for (const demonstration::SegmentSpan& span : shown.segments) {
    const std::string letter(1, demonstration::letter(span.label));
    const double begin_s = std::max(span.begin_s, layout.gate_in_s);
    const double end_s = std::min(span.end_s, layout.gate_out_s);
    const std::string length = seconds(std::max(end_s - begin_s, 0.0));
    lanes.block(span.begin_s, span.end_s, segment_colour(span.label), fmt::format("{}  {}", letter, length), letter);
    if (end_s <= begin_s) continue;
    const float x0 = std::clamp(layout.x_of(begin_s), layout.lanes.x0, layout.lanes.x1);
    const float x1 = std::clamp(layout.x_of(end_s), layout.lanes.x0, layout.lanes.x1);
    const Rect lane = lanes.lane_rect();
    // The segment may be too narrow for its letter.
    lanes.note_mark("text", unique("Segment " + letter), length, {x0, lane.y0, x1, lane.y1},
                    fmt::format("Segment {}: {:.2f}–{:.2f} s, {} long", letter, begin_s, end_s, length));
  }
  lanes.end();
}

void draw_authority(LanePainter& lanes, const LaneData& data) {
  lanes.begin(Lane::kAuthority);
  for (const Run& run : data.authority()) {
    const auto authority = static_cast<demonstration::Authority>(run.state - 1);
    lanes.block(run.begin_s, run.end_s, authority_colour(authority), demonstration::to_string(authority));
  }
  lanes.end();
}

void draw_jaw(LanePainter& lanes, const Ui& ui, const LaneData& data, int arm, Rgba colour) {
  using demonstration::EventKind;
  lanes.begin(arm == 0 ? Lane::kJawLeft : Lane::kJawRight);
  lanes.area(data.jaw(arm), data.jaw_low(), data.jaw_high(), colour);
  for (const demonstration::Event& event : data.events()) {
    const bool opens = event.kind == EventKind::kJawOpens;
    if (event.arm == arm && (opens || event.kind == EventKind::kJawCloses))
      lanes.mark(event.t_s, opens, ui.theme().text);
  }
  lanes.end();
}

void draw_flags(LanePainter& lanes, const LaneData& data, Lane lane, std::array<demonstration::SampleFlag, 2> flags,
                std::array<Rgba, 2> colours) {
  lanes.begin(lane);
  for (int row = 0; row < 2; ++row) {
    const auto index = static_cast<std::size_t>(row);
    lanes.thin_row(data.flag(flags[index]), row, 2, colours[index]);
  }
  lanes.end();
}

void draw_notes(LanePainter& lanes, const demonstration::Demonstration& shown) {
  UniqueNames unique;
  lanes.begin(Lane::kNotes);
  for (const demonstration::Note& note : shown.notes) lanes.note(note, unique("Note"));
  lanes.end();
}

void draw_problems(LanePainter& lanes, std::span<const review::Problem> problems) {
  lanes.begin(Lane::kProblems);
  for (const review::Problem& problem : problems) {
    if (problem.severity != demonstration::Severity::kInfo) lanes.problem(problem);
  }
  lanes.end();
}

std::string words_of(const demonstration::Demonstration& shown, std::int64_t entry) {
  for (const demonstration::StackEntry& each : *shown.stack) {
    if (each.id != entry) continue;
    return each.name.empty() ? demonstration::title_of(demonstration::name_of(*each.edit)) : each.name;
  }
  return {};
}

void draw_edits(LanePainter& lanes, const demonstration::Demonstration& shown, const LaneData& data) {
  UniqueNames unique;
  lanes.begin(Lane::kEdits);
  for (const demonstration::EditSpan& span : data.edits()) {
    const std::string words = words_of(shown, span.entry);
    if (span.end_s > span.begin_s) {
      lanes.outline(span.begin_s, span.end_s, words);
    } else {
      lanes.seam(span.begin_s);
    }
    const Rect rect = lanes.rect_of(span.begin_s, span.end_s);
    lanes.note_mark("mark", unique("Edit " + words), fmt::format("{:.3f}–{:.3f} s", span.begin_s, span.end_s), rect,
                    fmt::format("{}: {:.2f}–{:.2f} s", words, span.begin_s, span.end_s));
  }
  lanes.end();
}

void draw_original(LanePainter& lanes, const LaneData& data) {
  lanes.begin(Lane::kOriginal);
  for (const demonstration::SegmentSpan& span : data.original()) {
    lanes.outline(span.begin_s, span.end_s, std::string(1, demonstration::letter(span.label)));
  }
  lanes.end();
}

// Left edge where its instant is; what is not drawn yet is a frame.
void draw_pictures(LanePainter& lanes, Ui& ui, const LaneLayout& layout,
                   const std::shared_ptr<const workbench::Filmstrip>& strip) {
  lanes.begin(Lane::kPictures);
  const Rect lane = lanes.lane_rect();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({layout.lanes.x0, lane.y0}, {layout.lanes.x1, lane.y1}, true);
  std::size_t drawn = 0;
  for (std::size_t i = 0; strip && i < strip->pictures.size(); ++i) {
    const float x0 = std::round(layout.x_of(strip->first_s + static_cast<double>(i) * strip->step_s));
    const float y0 = lane.y0 + ui.px(2);
    const float height = lane.y1 - ui.px(2) - y0;
    const Rect place{x0, y0, std::round(x0 + height * 16.0F / 9.0F), lane.y1 - ui.px(2)};
    if (place.x1 < layout.lanes.x0 || place.x0 > layout.lanes.x1) continue;
    const auto& picture = strip->pictures[i];
    if (!picture || picture->empty()) continue;
    ++drawn;
    const ImTextureID texture =
        ui.textures().texture(fmt::format("film {}", i), *picture, strip->number, Sampling::kLinear);
    list.AddImageRounded(texture, {place.x0, place.y0}, {place.x1, place.y1}, {0.0F, 0.0F}, {1.0F, 1.0F},
                         IM_COL32_WHITE, ui.px(2));
  }
  list.PopClipRect();
  lanes.note_mark("mark", "Pictures", count(static_cast<std::int64_t>(drawn)), lane, "");
  lanes.end();
}

struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

// Of what is seen between the gates.
std::optional<Bounds> bounds_of(const workbench::CurveSet& curves, workbench::CurveKind kind,
                                const LaneLayout& layout) {
  const double begin_s = std::max(layout.range.begin_s, layout.gate_in_s);
  const double end_s = std::min(layout.range.end_s, layout.gate_out_s);
  std::optional<Bounds> all;
  for (int arm = 0; arm < 2; ++arm) {
    const workbench::ShownCurve* curve = curves.find(kind, arm);
    const auto extent = curve == nullptr ? std::nullopt : curve->now->extent(begin_s, end_s);
    if (!extent) continue;
    all = all ? Bounds{std::min(all->low, extent->low), std::max(all->high, extent->high)}
              : Bounds{extent->low, extent->high};
  }
  if (all && workbench::look_of(kind).from_zero) all->low = std::min(all->low, 0.0);
  if (all && all->high - all->low < 1e-9) all->high = all->low + 1.0;
  return all;
}

void draw_curve(LanePainter& lanes, const Ui& ui, const LaneLayout& layout, Lane lane,
                const workbench::CurveSet* curves) {
  const workbench::CurveKind kind = *curve_of(lane);
  lanes.begin(lane);
  const auto bounds = curves == nullptr ? std::nullopt : bounds_of(*curves, kind, layout);
  for (int arm = 1; bounds && arm >= 0; --arm) {
    const workbench::ShownCurve* curve = curves->find(kind, arm);
    if (curve == nullptr) continue;
    lanes.line(*curve->now, bounds->low, bounds->high, arm_colour(ui.theme(), arm), arm == 1);
  }
  const std::string words =
      bounds ? fmt::format("{:.3g}–{:.3g} {}", bounds->low, bounds->high, workbench::look_of(kind).unit) : "";
  if (bounds) lanes.words_at_end(words);
  lanes.note_mark("mark", name_of(lane), words, lanes.lane_rect(), "");
  lanes.end();
}

void draw_runs(LanePainter& lanes, const std::vector<Run>& segments) {
  lanes.begin(Lane::kSegments);
  for (const Run& run : segments) {
    const auto segment = static_cast<demonstration::Segment>(run.state - 1);
    lanes.block(run.begin_s, run.end_s, segment_colour(segment), std::string(1, demonstration::letter(segment)));
  }
  lanes.end();
}

/// A distance of pictures in time that is round, so that they stay when the view is shifted, and little more than
/// `least_s`.
double picture_step(double least_s) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(least_s, 1e-3))));
  for (const double factor : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (decade * factor >= least_s) return decade * factor;
  }
  return decade * 10.0;
}

struct TwoColours {
  Rgba left;
  Rgba right;
};

TwoColours arm_areas(const Ui& ui) {
  return {mix(ui.theme().accent, ui.theme().text, 0.1F), mix(ui.theme().warning, ui.theme().text, 0.1F)};
}

void draw_holds(LanePainter& lanes, const Ui& ui, const LaneData& data) {
  draw_flags(lanes, data, Lane::kHolds, {demonstration::kLeftHolds, demonstration::kRightHolds},
             {arm_areas(ui).left, arm_areas(ui).right});
}

void draw_pedals(LanePainter& lanes, const Ui& ui, const LaneData& data) {
  draw_flags(lanes, data, Lane::kPedals, {demonstration::kAgentPedal, demonstration::kClutchPedal},
             {ui.theme().good, ui.theme().text_dim});
}

}  // namespace

std::string_view name_of(Lane lane) {
  return row_of(lane).name;
}

std::string_view help_of(Lane lane) {
  return row_of(lane).help;
}

std::optional<workbench::CurveKind> curve_of(Lane lane) {
  using workbench::CurveKind;
  switch (lane) {
    case Lane::kX:
      return CurveKind::kX;
    case Lane::kY:
      return CurveKind::kY;
    case Lane::kZ:
      return CurveKind::kZ;
    case Lane::kSpeed:
      return CurveKind::kSpeed;
    case Lane::kAcceleration:
      return CurveKind::kAcceleration;
    case Lane::kJerk:
      return CurveKind::kJerk;
    case Lane::kClearance:
      return CurveKind::kClearance;
    default:
      return std::nullopt;
  }
}

workbench::CurveKinds curves_of(const LaneSet& lanes) {
  workbench::CurveKinds kinds = 0;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const auto kind = curve_of(static_cast<Lane>(i));
    if (lanes[i] && kind) kinds |= workbench::bit(*kind);
  }
  return kinds;
}

float lanes_head(const Ui& ui) {
  return ui.px(kRulerHeight) + ui.px(kGatesHeight);
}

float lanes_height(const Ui& ui, const LaneSet& shown) {
  float height = 0.0F;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if (shown[i]) height += ui.px(row_of(static_cast<Lane>(i)).height) + 1.0F;
  }
  return height;
}

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range, float scroll) {
  const float x0 = area.x0 + ui.px(78);
  const float x1 = area.x1 - ui.px(12);
  const float gates = area.y0 + ui.px(kRulerHeight);
  const float lanes = gates + ui.px(kGatesHeight);
  LaneLayout layout;
  layout.names = {area.x0, gates, x0, area.y1};
  layout.ruler = {x0, area.y0, x1, gates};
  layout.gates = {x0, gates, x1, lanes};
  layout.lanes = {x0, lanes, x1, area.y1};
  layout.range = range;
  layout.scroll = scroll;
  return layout;
}

workbench::ShowFilmstrip pictures_for(const Ui& ui, const LaneLayout& layout) {
  workbench::ShowFilmstrip asked;
  asked.height_px = static_cast<int>(ui.px(row_of(Lane::kPictures).height - 4.0F));
  const float width = static_cast<float>(asked.height_px) * 16.0F / 9.0F + ui.px(2);
  asked.step_s = picture_step(layout.range.span_s() * static_cast<double>(width / layout.lanes.width()));
  const double first = std::floor(std::max(layout.range.begin_s, 0.0) / asked.step_s);
  asked.first_s = first * asked.step_s;
  asked.count = 1 + static_cast<int>(std::floor((layout.range.end_s - asked.first_s) / asked.step_s));
  return asked;
}

void draw_lanes(Ui& ui, const LaneLayout& layout, const LaneSet& lane_set, const LaneGround& ground) {
  ImGui::PushClipRect({layout.names.x0, layout.lanes.y0}, {layout.lanes.x1 + ui.px(12), layout.lanes.y1}, true);
  LanePainter lanes(ui, layout);
  const LaneData& data = ground.data;
  const TwoColours colours = arm_areas(ui);
  if (has(lane_set, Lane::kPictures)) draw_pictures(lanes, ui, layout, ground.pictures);
  if (has(lane_set, Lane::kSegments)) draw_segments(lanes, layout, ground.shown);
  if (has(lane_set, Lane::kAuthority)) draw_authority(lanes, data);
  if (has(lane_set, Lane::kJawLeft)) draw_jaw(lanes, ui, data, 0, colours.left);
  if (has(lane_set, Lane::kJawRight)) draw_jaw(lanes, ui, data, 1, colours.right);
  if (has(lane_set, Lane::kHolds)) draw_holds(lanes, ui, data);
  if (has(lane_set, Lane::kPedals)) draw_pedals(lanes, ui, data);
  if (has(lane_set, Lane::kNotes)) draw_notes(lanes, ground.shown);
  if (has(lane_set, Lane::kProblems)) draw_problems(lanes, ground.problems);
  if (has(lane_set, Lane::kEdits)) draw_edits(lanes, ground.shown, data);
  if (has(lane_set, Lane::kOriginal)) draw_original(lanes, data);
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const auto lane = static_cast<Lane>(i);
    if (lane_set[i] && curve_of(lane)) draw_curve(lanes, ui, layout, lane, ground.curves);
  }
  ImGui::PopClipRect();
}

LaneSet live_lanes() {
  LaneSet lanes;
  for (const Lane lane : {Lane::kSegments, Lane::kAuthority, Lane::kJawLeft, Lane::kJawRight, Lane::kHolds,
                          Lane::kPedals, Lane::kSpeed}) {
    lanes.set(static_cast<std::size_t>(lane));
  }
  return lanes;
}

void draw_live_lanes(Ui& ui, const LaneLayout& layout, const LaneData& data) {
  ImGui::PushClipRect({layout.names.x0, layout.lanes.y0}, {layout.lanes.x1 + ui.px(12), layout.lanes.y1}, true);
  LanePainter lanes(ui, layout);
  const TwoColours colours = arm_areas(ui);
  draw_runs(lanes, data.segments());
  draw_authority(lanes, data);
  draw_jaw(lanes, ui, data, 0, colours.left);
  draw_jaw(lanes, ui, data, 1, colours.right);
  draw_holds(lanes, ui, data);
  draw_pedals(lanes, ui, data);
  lanes.begin(Lane::kSpeed);
  double high = 1.0;
  for (int arm = 0; arm < 2; ++arm) {
    if (const auto extent = data.speed(arm).extent(layout.range.begin_s, layout.range.end_s)) {
      high = std::max(high, extent->high);
    }
  }
  for (int arm = 1; arm >= 0; --arm) {
    lanes.line(data.speed(arm), 0.0, high, arm_colour(ui.theme(), arm), arm == 1);
  }
  lanes.words_at_end(fmt::format("0–{:.3g} mm/s", high));
  lanes.end();
  ImGui::PopClipRect();
}

}  // namespace trocar::ui
