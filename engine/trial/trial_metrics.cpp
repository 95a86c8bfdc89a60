#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "engine/trial/trial_record.h"

namespace trocar::trial {
namespace {

using demonstration::Sample;

constexpr double kCutOff_hz = 10.0;
constexpr double kThreshold = 0.05;
constexpr std::size_t kPadding = 16;  // 2⁴

Eigen::Vector3d tip(const Sample& sample) {
  return sample.arms[0].measured.pose().p;
}

}  // namespace

double spectral_arc_length(const std::vector<double>& speed, double rate_hz) {
  if (speed.size() < 8 || !(*std::max_element(speed.begin(), speed.end()) > 0.0)) return 0.0;
  std::size_t size = 1;
  while (size < speed.size()) size *= 2;
  size *= kPadding;
  std::vector<double> padded(speed);
  padded.resize(size, 0.0);
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> transform;
  transform.fwd(spectrum, padded);
  const double step_hz = rate_hz / static_cast<double>(size);
  const auto highest = std::min(size / 2, static_cast<std::size_t>(kCutOff_hz / step_hz));
  const double scale = std::abs(spectrum[0]);
  if (!(scale > 0.0)) return 0.0;
  // Up to the last frequency that still counts.
  std::size_t last = 1;
  for (std::size_t i = 0; i <= highest; ++i) {
    if (std::abs(spectrum[i]) >= kThreshold * scale) last = std::max(last, i);
  }
  double length = 0.0;
  const double across = 1.0 / static_cast<double>(last);
  for (std::size_t i = 1; i <= last; ++i) {
    length += std::hypot(across, (std::abs(spectrum[i]) - std::abs(spectrum[i - 1])) / scale);
  }
  return -length;
}

TrialMetrics trial_metrics(const std::vector<Sample>& samples, std::optional<double> decided_s, double agent_s) {
  TrialMetrics metrics;
  if (samples.size() < 2) return metrics;
  const double end_s = decided_s.value_or(samples.back().t_s());
  const double begin_s = samples.front().t_s();
  double straight_m = 0.0;
  Eigen::Vector3d segment_from = tip(samples.front());
  std::vector<double> speed;
  for (std::size_t i = 1; i < samples.size() && samples[i].t_s() <= end_s; ++i) {
    const double way_m = (tip(samples[i]) - tip(samples[i - 1])).norm();
    metrics.path_length_m += way_m;
    const bool last = i + 1 == samples.size() || samples[i + 1].t_s() > end_s;
    if (samples[i].segment != samples[i - 1].segment || last) {
      straight_m += (tip(samples[i]) - segment_from).norm();
      segment_from = tip(samples[i]);
    }
    // At the samples' own rate; those of a hand-over in between are left out.
    if (samples[i].tick % demonstration::kTicksPerSample == 0) {
      std::size_t before = i - 1;
      while (before > 0 && samples[before].tick % demonstration::kTicksPerSample != 0) --before;
      const double seconds = samples[i].t_s() - samples[before].t_s();
      if (seconds > 0.0) speed.push_back((tip(samples[i]) - tip(samples[before])).norm() / seconds);
    }
  }
  if (metrics.path_length_m > 0.0) metrics.economy = std::min(1.0, straight_m / metrics.path_length_m);
  metrics.smoothness = spectral_arc_length(speed, demonstration::kSampleRate_hz);
  if (end_s > begin_s) metrics.agent_share = agent_s / (end_s - begin_s);
  return metrics;
}

}  // namespace trocar::trial
