#include "ui/panels/time_range.h"

#include <algorithm>
#include <cmath>

namespace trocar::ui {

std::string_view name_of(RulerUnit unit) {
  return unit == RulerUnit::kTime ? "time" : unit == RulerUnit::kFrame ? "frame" : "grid";
}

std::string_view title_of(RulerUnit unit) {
  return unit == RulerUnit::kTime ? "Time, s" : unit == RulerUnit::kFrame ? "Frames" : "Grid steps";
}

RulerUnit next(RulerUnit unit) {
  return static_cast<RulerUnit>((static_cast<int>(unit) + 1) % kRulerUnitCount);
}

float TimeRange::x_of(double t_s, float x0, float width) const {
  return x0 + static_cast<float>((t_s - begin_s) / span_s()) * width;
}

double TimeRange::time_at(float x, float x0, float width) const {
  return begin_s + span_s() * static_cast<double>((x - x0) / width);
}

void TimeRange::zoom(double t_s, double factor) {
  begin_s = t_s + (begin_s - t_s) * factor;
  end_s = t_s + (end_s - t_s) * factor;
}

void TimeRange::pan(double seconds) {
  begin_s += seconds;
  end_s += seconds;
}

void TimeRange::keep_within(double length_s) {
  constexpr double kShortest_s = 0.05;
  const double margin = 0.03 * std::max(length_s, kShortest_s);
  const double widest = std::max(length_s, kShortest_s) + 2.0 * margin;
  const double wanted = std::clamp(span_s(), kShortest_s, widest);
  const double middle = 0.5 * (begin_s + end_s);
  if (wanted != span_s()) {
    begin_s = middle - 0.5 * wanted;
    end_s = begin_s + wanted;
  }
  if (begin_s < -margin) pan(-margin - begin_s);
  if (end_s > length_s + margin && wanted < widest) pan(length_s + margin - end_s);
  if (begin_s < -margin) begin_s = -margin;
}

void SharedTime::show(double begin_s, double end_s) {
  range = {begin_s, end_s};
  range.zoom(0.5 * (begin_s + end_s), 1.06);
}

void SharedTime::follow(std::int64_t shown, double shown_length_s) {
  const bool saw_all = length_s != shown_length_s && range.span_s() >= length_s;
  if (demonstration != shown || saw_all) show(0.0, shown_length_s);
  demonstration = shown;
  length_s = shown_length_s;
  range.keep_within(length_s);
}

double ruler_step(const TimeRange& range, float width, float pixels) {
  const double least = range.span_s() * static_cast<double>(pixels / std::max(width, 1.0F));
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(least, 1e-6))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (decade * factor >= least) return decade * factor;
  }
  return decade * 10.0;
}

}  // namespace trocar::ui
