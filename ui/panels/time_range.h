/// What part of time a timeline shows, and where that is on the screen.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace trocar::ui {

struct TimeRange {
  double begin_s = 0.0;
  double end_s = 1.0;

  double span_s() const { return end_s - begin_s; }
  /// Pixel of a time when the range fills `width` pixels from `x0` on.
  float x_of(double t_s, float x0, float width) const;
  double time_at(float x, float x0, float width) const;
  /// `factor` < 1 shows less; the time at `t_s` stays where it is.
  void zoom(double t_s, double factor);
  void pan(double seconds);
  /// Keeps the range within [0, length] with a margin of 3 %, and not shorter than 50 ms.
  void keep_within(double length_s);
};

/// What the timeline's ruler counts: seconds, frames of a film (30 a second), or steps of the left tool on the lattice.
enum class RulerUnit : std::uint8_t { kTime, kFrame, kGridStep };
constexpr int kRulerUnitCount = 3;
/// "time", "frame", "grid".
std::string_view name_of(RulerUnit unit);
/// "Time, s", "Frames", "Grid steps".
std::string_view title_of(RulerUnit unit);
RulerUnit next(RulerUnit unit);

/// Lanes of the timeline that are hidden until somebody wants them: those of curves.
constexpr std::uint32_t kLanesHiddenAtFirst = 0x3F800;

/// The range that all panels over time show together. Threads: that of the window.
struct SharedTime {
  TimeRange range;
  std::int64_t demonstration = 0;                    ///< Of which it is; 0: of none yet.
  double length_s = 0.0;                             ///< Of that, when it was last followed.
  std::uint32_t hidden_lanes = kLanesHiddenAtFirst;  ///< A bit for each `Lane`; remembered between runs.
  RulerUnit ruler = RulerUnit::kTime;                ///< Likewise.
  /// The curves (`workbench::CurveKinds`) that the panels of this frame draw; nothing: none of them is there.
  std::optional<std::uint32_t> wanted_curves;
  void want_curves(std::uint32_t kinds) { wanted_curves = wanted_curves.value_or(0) | kinds; }

  /// Shows the whole of another demonstration than before, and of one that has another length where all of it was
  /// shown; keeps the range within its length.
  void follow(std::int64_t shown, double shown_length_s);
  /// Shows [begin, end] with a margin.
  void show(double begin_s, double end_s);
};

/// A round distance between marks of a ruler that leaves at least `pixels` between them.
double ruler_step(const TimeRange& range, float width, float pixels);

}  // namespace trocar::ui
