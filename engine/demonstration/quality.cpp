#include "engine/demonstration/quality.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"

namespace trocar::demonstration {
namespace {

/// Half the span over which a speed is measured: a tremor of 10 Hz and 0.1 mm is then no motion.
constexpr double kSpeedWindow_s = 0.15;
/// A motion at this speed is seen so much before it begins and after it ends, which is taken back.
constexpr double kUsualSpeed_m_s = 0.010;
constexpr double kSeenEarly = 1.0 - 2.0 * kIdleSpeed_m_s / kUsualSpeed_m_s;  // of the window
constexpr double kIdleJaw_rad_s = 0.05;

double window_of(const Demonstration& document, double wanted_s) {
  constexpr double kSteps = 1.5;
  if (wanted_s > 0.0) return wanted_s;
  return std::max(kSpeedWindow_s, kSteps * Tick{usual_step(document.gated())}.seconds());
}

/// What of a sample tells whether anything moves.
struct Instant {
  double t_s = 0.0;
  std::array<Eigen::Vector3d, 2> p_WT;
  std::array<float, 2> jaw_rad{};
};

Instant instant_of(const Demonstration& document, const Sample& sample) {
  return {document.time_of(sample),
          {measured_tip(sample, 0), measured_tip(sample, 1)},
          {sample.arms[0].jaw_rad, sample.arms[1].jaw_rad}};
}

bool moves(const Instant& before, const Instant& after, double dt_s, double speed_m_s) {
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const double distance_m = (after.p_WT[arm] - before.p_WT[arm]).norm();
    const double jaw_rad = std::abs(static_cast<double>(after.jaw_rad[arm] - before.jaw_rad[arm]));
    if (distance_m >= speed_m_s * dt_s || jaw_rad >= kIdleJaw_rad_s * dt_s) return true;
  }
  return false;
}

/// For each gated sample, whether anything moves in the time around it.
std::vector<bool> moving(const Demonstration& document, double speed_m_s, double window_s) {
  const SampleTrack samples = document.gated();
  std::vector<bool> result(samples.size());
  // The samples around the one that is asked about, and one that is later than them.
  std::deque<Instant> around;
  std::size_t first = 0;
  auto next = samples.begin();
  const auto read = [&] { around.push_back(instant_of(document, *next++)); };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i == first + around.size()) read();
    const double t_s = around[i - first].t_s;
    while (next != samples.end() && around.back().t_s <= t_s + window_s) read();
    for (; around.front().t_s < t_s - window_s; ++first) around.pop_front();
    const bool later = around.back().t_s > t_s + window_s;
    const Instant& last = around[around.size() - (later ? 2 : 1)];
    const double dt_s = last.t_s - around.front().t_s;
    result[i] = dt_s > 0.0 && moves(around.front(), last, dt_s, speed_m_s);
  }
  return result;
}

}  // namespace

Quality quality(const Demonstration& document) {
  const SampleTrack samples = document.gated();
  Quality result;
  result.samples = static_cast<int>(samples.size());
  result.duration_s = document.duration_s();
  if (samples.size() < 2) return result;
  const double covered_s = document.time_of(samples.back()) - document.time_of(samples.front());
  result.rate_hz = static_cast<double>(samples.size() - 1) / covered_s;
  const bool jerk_known = Tick{usual_step(samples)}.seconds() <= kRarestForJerk_s;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    result.path_length_m[arm] = path_length_m(document, arm);
    result.mean_speed_m_s[arm] = result.path_length_m[arm] / covered_s;
    const std::vector<MotionPoint> points = motion_of(document, arm);
    double jerk_sum_m_s3 = 0.0;
    for (const MotionPoint& point : points) {
      result.peak_speed_m_s[arm] = std::max(result.peak_speed_m_s[arm], point.speed_m_s);
      jerk_sum_m_s3 += point.jerk_m_s3;
    }
    if (jerk_known && !points.empty()) {
      result.mean_jerk_m_s3[arm] = jerk_sum_m_s3 / static_cast<double>(points.size());
    }
  }
  result.idle_share = idle_share(document);
  return result;
}

std::optional<double> idle_share(const Demonstration& document) {
  const std::vector<bool> flags = moving(document, kIdleSpeed_m_s, window_of(document, 0.0));
  constexpr std::size_t kFewest = 3;
  if (flags.size() < kFewest) return std::nullopt;
  const auto idle = std::count(flags.begin(), flags.end(), false);
  return static_cast<double>(idle) / static_cast<double>(flags.size());
}

std::vector<IdleSpan> idle_spans(const Demonstration& document, const IdleOptions& options) {
  const SampleTrack samples = document.gated();
  const double window_s = window_of(document, options.window_s);
  const double seen_early_s = kSeenEarly * window_s;
  const std::vector<bool> flags = moving(document, options.speed_m_s, window_s);
  std::vector<IdleSpan> spans;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i]) continue;
    const double begin_s = i == 0 ? document.begin_s : document.time_of(samples[i]) - seen_early_s;
    while (i + 1 < flags.size() && !flags[i + 1]) ++i;
    const double end_s = i + 1 == flags.size() ? document.end_s : document.time_of(samples[i]) + seen_early_s;
    if (end_s - begin_s > options.longer_s) spans.push_back({begin_s, end_s});
  }
  return spans;
}

std::optional<Trim> idle_ends(const Demonstration& document, const IdleOptions& options) {
  const SampleTrack samples = document.gated();
  const double window_s = window_of(document, options.window_s);
  const double seen_early_s = kSeenEarly * window_s;
  const std::vector<bool> flags = moving(document, options.speed_m_s, window_s);
  const auto first = std::find(flags.begin(), flags.end(), true);
  if (first == flags.end()) return std::nullopt;
  const auto last = std::find(flags.rbegin(), flags.rend(), true);
  const double begin_s = document.time_of(samples[static_cast<std::size_t>(first - flags.begin())]) + seen_early_s;
  const double end_s = document.time_of(samples[static_cast<std::size_t>(flags.rend() - last - 1)]) - seen_early_s;
  Trim trim{document.begin_s, document.end_s};
  if (!flags.front() && begin_s - document.begin_s > options.longer_s) trim.from_s = begin_s - options.margin_s;
  if (!flags.back() && document.end_s - end_s > options.longer_s) trim.to_s = end_s + options.margin_s;
  if (trim.from_s == document.begin_s && trim.to_s == document.end_s) return std::nullopt;
  return trim;
}

}  // namespace trocar::demonstration
