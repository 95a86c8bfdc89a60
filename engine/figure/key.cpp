#include "engine/figure/key.h"

#include <algorithm>
#include <cmath>

namespace trocar::figure {
namespace {

using canvas::Canvas;
using canvas::TextStyle;

constexpr double kBarWidth = 18.0;
constexpr double kTick = 5.0;
constexpr double kGap = 7.0;
constexpr double kRow = 24.0;
constexpr double kSwatch = 15.0;

TextStyle label_style(double unit) {
  return {14.0 * unit, canvas::Weight::kRegular, kInk, canvas::Align::kLeft};
}

struct BarTicks {
  std::vector<double> values;
  std::vector<std::string> labels;
};

BarTicks bar_ticks(const plot::Scale& scale) {
  BarTicks bar;
  bar.values = plot::ticks(scale, 7);
  bar.labels = plot::format_ticks(scale, bar.values);
  return bar;
}

/// The marks that this figure has, from the top.
enum class Mark { kPath, kSafe, kUnknown };
struct MarkRow {
  Mark mark;
  const char* text;
};
std::vector<MarkRow> mark_rows(const learning::Field& field, const FieldFigureOptions& options) {
  std::vector<MarkRow> rows;
  if (!options.path.empty()) rows.push_back({Mark::kPath, "expert"});
  if (!options.safe.empty()) rows.push_back({Mark::kSafe, "safe set"});
  const bool whole = std::all_of(field.values.begin(), field.values.end(), [](double v) { return std::isfinite(v); });
  if (!whole) rows.push_back({Mark::kUnknown, "unknown"});
  return rows;
}

void draw_swatch(Canvas& canvas, Mark mark, double x, double y, double size) {
  const canvas::Point middle{x + size / 2, y + size / 2};
  if (mark == Mark::kPath) draw_path_mark(canvas, middle, 0.3 * size);
  if (mark == Mark::kSafe) draw_safe_line(canvas, {x, middle.y}, {x + size, middle.y}, 0.14 * size);
  if (mark != Mark::kUnknown) return;
  canvas.rectangle(x, y, size, size, kHatchGround);
  canvas.hatch(x, y, size, size, kHatchInk, size / 4);
  canvas.outline(x, y, size, size, kQuiet, 1.0);
}

void draw_bar(Canvas& canvas, const FieldLook& look, const KeyPlace& place, double height) {
  const double width = kBarWidth * place.unit;
  const int steps = std::max(2, static_cast<int>(height));
  for (int i = 0; i < steps; ++i) {
    const double top = place.y + height * i / steps;
    canvas.rectangle(place.x, top, width, height / steps + (i + 1 < steps ? 0.5 : 0.0),
                     plot::colour(look.map, 1.0 - (i + 0.5) / steps));
  }
  canvas.outline(place.x, place.y, width, height, kInk, 1.0);
  const BarTicks bar = bar_ticks(look.scale);
  const TextStyle style = label_style(place.unit);
  for (std::size_t i = 0; i < bar.values.size(); ++i) {
    const double y = std::round(place.y + height * (1.0 - look.scale.position(bar.values[i])) - 0.5) + 0.5;
    canvas.line({place.x + width, y}, {place.x + width + kTick * place.unit, y}, kInk, 1.0);
    canvas.text({place.x + width + (kTick + kGap) * place.unit, y + 0.36 * style.size_px}, bar.labels[i], style);
  }
}

void draw_classes(Canvas& canvas, const learning::Field& field, const FieldLook& look, const KeyPlace& place) {
  const TextStyle style = label_style(place.unit);
  const double size = kSwatch * place.unit;
  for (std::size_t i = 0; i < field.categories.size(); ++i) {
    const double y = place.y + kRow * place.unit * static_cast<double>(i);
    canvas.rectangle(place.x, y, size, size, look.categories[i]);
    canvas.outline(place.x, y, size, size, kQuiet, 1.0);
    canvas.text({place.x + size + kGap * place.unit, y + size / 2 + 0.36 * style.size_px}, field.categories[i], style);
  }
}

}  // namespace

void draw_key(Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options, const FieldLook& look,
              const KeyPlace& place) {
  const std::vector<MarkRow> marks = mark_rows(field, options);
  const double row = kRow * place.unit;
  const double marks_height = static_cast<double>(marks.size()) * row;
  double y = place.y + place.height - marks_height + row - kSwatch * place.unit;
  if (look.categories.empty()) {
    const double head = field.unit.empty() ? 0.0 : row;
    if (head > 0.0) canvas.text({place.x, place.y + 0.6 * row}, field.unit, label_style(place.unit));
    KeyPlace bar = place;
    bar.y += head;
    draw_bar(canvas, look, bar, place.height - head - marks_height - (marks.empty() ? 0.0 : 0.8 * row));
  } else {
    draw_classes(canvas, field, look, place);
    y = place.y + row * (static_cast<double>(field.categories.size()) + 0.6);
  }
  const TextStyle style = label_style(place.unit);
  for (const MarkRow& mark : marks) {
    const double size = kSwatch * place.unit;
    draw_swatch(canvas, mark.mark, place.x, y, size);
    canvas.text({place.x + size + kGap * place.unit, y + size / 2 + 0.36 * style.size_px}, mark.text, style);
    y += row;
  }
}

double key_width(const Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const FieldLook& look, double unit) {
  const TextStyle style = label_style(unit);
  double width = field.unit.empty() ? 0.0 : canvas.text_width(field.unit, style);
  const auto beside = [&](double left, std::string_view text) {
    width = std::max(width, left * unit + canvas.text_width(text, style));
  };
  for (const MarkRow& mark : mark_rows(field, options)) beside(kSwatch + kGap, mark.text);
  if (look.categories.empty()) {
    for (const std::string& label : bar_ticks(look.scale).labels) beside(kBarWidth + kTick + kGap, label);
  } else {
    for (const std::string& name : field.categories) beside(kSwatch + kGap, name);
  }
  return std::ceil(width);
}

}  // namespace trocar::figure
