/// Numbers that tell a good demonstration from a poor one, and the trim that leaves out its idle ends.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/demonstration/edits.h"

namespace trocar::demonstration {

/// A tool that moves more slowly than this, for longer than that, is idle (workbench, "Auto-trim idle").
constexpr double kIdleSpeed_m_s = 0.002;
constexpr double kIdleTime_s = 0.3;
/// What stays of an idle end when it is trimmed.
constexpr double kIdleMargin_s = 0.1;

/// Between the gates; arrays are by arm, left first.
struct Quality {
  double duration_s = 0.0;
  int samples = 0;
  double rate_hz = 0.0;
  std::array<double, 2> path_length_m{};
  std::array<double, 2> mean_speed_m_s{};
  std::array<double, 2> peak_speed_m_s{};
  /// Mean magnitude; none where samples are too few or too far apart to tell.
  std::array<std::optional<double>, 2> mean_jerk_m_s3{};
  /// Of the duration in which neither tool moves nor opens or closes; none for fewer than 3 samples.
  std::optional<double> idle_share;
};
Quality quality(const Demonstration& document);
/// `Quality::idle_share` alone.
std::optional<double> idle_share(const Demonstration& document);

struct IdleOptions {
  double speed_m_s = kIdleSpeed_m_s;
  double longer_s = kIdleTime_s;
  double margin_s = kIdleMargin_s;
  /// Speeds are measured over so long before and after; 0: 0.15 s, and where samples are rare one and a half of what is
  /// usual from one to the next.
  double window_s = 0.0;
};

/// A stretch in which neither tool moves nor opens or closes.
struct IdleSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
};
/// Between the gates, by time, those longer than `options.longer_s`.
std::vector<IdleSpan> idle_spans(const Demonstration& document, const IdleOptions& options = {});

/// Leaves out what comes before the first motion and after the last one; nothing if neither end is idle for longer
/// than `options.longer_s`, or nothing moves at all.
std::optional<Trim> idle_ends(const Demonstration& document, const IdleOptions& options = {});

}  // namespace trocar::demonstration
