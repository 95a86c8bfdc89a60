#include "engine/demonstration/edit_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <type_traits>
#include <unsupported/Eigen/FFT>

#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/problems.h"

namespace trocar::demonstration {
namespace {

/// Less than this is not worth a word: tremor and rounding.
constexpr double kUnheard = 0.01;
constexpr double kAround_s = 0.04;
/// At 200 Hz a quarter of an hour; of a longer demonstration the middle is looked at.
constexpr std::size_t kMostPoints = std::size_t{1} << 18;

struct Span {
  double from_s;
  double to_s;
};

/// What the edit works on, in times before it.
struct SpanOf {
  const Demonstration& document;

  template <typename Any>
  Span operator()(const Any& edit) const {
    if constexpr (requires {
                    edit.from_s;
                    edit.to_s;
                  }) {
      if constexpr (!std::is_same_v<Any, Trim>) return {edit.from_s, edit.to_s};
    } else if constexpr (requires {
                           edit.at_s;
                           edit.radius_s;
                         }) {
      return {edit.at_s - edit.radius_s, edit.at_s + edit.radius_s};
    }
    return {document.begin_s, document.end_s};
  }
};

SpanMotion motion_in(const Demonstration& document, double from_s, double to_s) {
  SpanMotion result{std::max(from_s, document.begin_s), std::min(to_s, document.end_s), {}, {}};
  if (!(result.from_s < result.to_s)) return result;
  // A speed takes some samples around it.
  const SampleTrack samples = document.samples_within(std::max(result.from_s - kAround_s, document.begin_s),
                                                      std::min(result.to_s + kAround_s, document.end_s));
  if (samples.empty()) return result;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const std::vector<MotionPoint> points = motion_of(samples, document.first_tick(), arm);
    for (const MotionPoint& point : points) {
      result.peak_speed_m_s[arm] = std::max(result.peak_speed_m_s[arm], point.speed_m_s);
      result.mean_jerk_m_s3[arm] += point.jerk_m_s3 / static_cast<double>(points.size());
    }
  }
  return result;
}

std::optional<std::string> aliasing(const Resample& edit, const Demonstration& before) {
  const double share = energy_above(before, 0.5 * edit.rate_hz);
  if (share < kUnheard) return std::nullopt;
  return fmt::format(
      "{:.1f} % of the energy of the motion lies above {:g} Hz, half of the new rate: it is lost or comes "
      "back as slower motion (aliasing); smooth first, or take a higher rate",
      100.0 * share, 0.5 * edit.rate_hz);
}

/// Another mirroring brings it back.
bool is_mirrored(const Demonstration& document) {
  const auto mirrors = std::count_if(document.stack->begin(), document.stack->end(), [](const StackEntry& entry) {
    return entry.enabled && std::holds_alternative<Mirror>(*entry.edit);
  });
  return mirrors % 2 != 0;
}

/// Across the board, from where a mirror through x and z shows a peg to the peg itself.
double mirrored_off_m(const Eigen::Vector3d& p_WP) {
  return 2.0 * std::abs(p_WP.y());
}

/// The board is no mirror image of itself: no start peg lies opposite a goal peg, so that no other task fits either.
std::string mirroring(const Demonstration& document) {
  const bool known = document.block >= 0 && document.block < peg_board::kBlockCount && document.goal >= 0 &&
                     document.goal < peg_board::kBlockCount;
  const std::string where =
      known ? fmt::format(": block {} would begin {:.1f} mm from its start peg and end {:.1f} mm from goal peg {}",
                          document.block, 1e3 * mirrored_off_m(peg_board::start_peg(document.block)),
                          1e3 * mirrored_off_m(peg_board::goal_peg(document.goal)), document.goal)
            : "";
  return fmt::format(
      "the mirrored block no longer fits a peg, as the board's pegs are no mirror image of each other{}; no block is "
      "transferred so",
      where);
}

}  // namespace

double SpanMotion::fastest_m_s() const {
  return std::max(peak_speed_m_s[0], peak_speed_m_s[1]);
}

EditEffect effect_of(const Edit& edit, const Demonstration& before, const Demonstration& after) {
  const Span span = std::visit(SpanOf{before}, edit);
  const double longer_s = after.full_duration_s() - before.full_duration_s();
  EditEffect effect{motion_in(before, span.from_s, span.to_s), motion_in(after, span.from_s, span.to_s + longer_s), {}};
  if (const auto* resample = std::get_if<Resample>(&edit)) {
    if (auto remark = aliasing(*resample, before)) effect.remarks.push_back(std::move(*remark));
  }
  if (std::holds_alternative<Mirror>(edit) && !is_mirrored(before)) effect.remarks.push_back(mirroring(before));
  const double limit_m_s = MotionBounds{}.speed_m_s;
  if (effect.after.fastest_m_s() > limit_m_s && effect.after.fastest_m_s() > 1.001 * effect.before.fastest_m_s()) {
    effect.remarks.push_back(fmt::format("a tool would reach {:.0f} mm/s, more than the {:.0f} mm/s that it may",
                                         1e3 * effect.after.fastest_m_s(), 1e3 * limit_m_s));
  }
  return effect;
}

double energy_above(const Demonstration& document, double frequency_hz) {
  SampleTrack track = document.gated();
  if (track.size() < 4) return 0.0;
  if (track.size() > kMostPoints) track = track.slice((track.size() - kMostPoints) / 2, kMostPoints);
  const auto count = track.size() - 1;
  const auto first = static_cast<double>(track.tick(0));
  const double length = static_cast<double>(track.tick(count)) - first;
  const double rate_hz = static_cast<double>(count) * static_cast<double>(Tick::kPerSecond) / length;
  // Zeros behind it change no share, and powers of two are quick.
  std::size_t padded = 1;
  while (padded < count) padded *= 2;
  Eigen::FFT<double> transform;
  double all = 0.0;
  double above = 0.0;
  std::vector<double> speeds(padded, 0.0);
  std::vector<std::complex<double>> waves;
  TrackReader reader(track);
  std::vector<Sample> even;
  even.reserve(track.size());
  const double step = length / static_cast<double>(count);
  for (std::size_t i = 0; i <= count; ++i) even.push_back(reader.at(first + step * static_cast<double>(i)));
  for (std::size_t arm = 0; arm < 2; ++arm) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < count; ++i) {
        speeds[i] = measured_tip(even[i + 1], arm)[axis] - measured_tip(even[i], arm)[axis];
      }
      transform.fwd(waves, speeds);
      for (std::size_t i = 0; i <= padded / 2; ++i) {
        const double energy = std::norm(waves[i]);
        all += energy;
        if (static_cast<double>(i) * rate_hz / static_cast<double>(padded) > frequency_hz) above += energy;
      }
    }
  }
  return all > 0.0 ? above / all : 0.0;
}

}  // namespace trocar::demonstration
