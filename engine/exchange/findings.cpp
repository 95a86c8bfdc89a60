#include "engine/exchange/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/quality.h"
#include "engine/demonstration/sampling_rate.h"

namespace trocar::exchange {
namespace {

using demonstration::Sample;
using demonstration::SampleTrack;

constexpr std::array<const char*, 2> kArms{"left", "right"};

std::vector<std::int64_t> steps_of(const SampleTrack& samples) {
  std::vector<std::int64_t> steps;
  steps.reserve(samples.size());
  for (std::size_t i = 1; i < samples.size(); ++i) steps.push_back(samples.tick(i) - samples.tick(i - 1));
  return steps;
}

/// "2 gaps, the longest 0.60 s at 3.20 s"; empty if there is none. What the checks call a gap.
std::string gaps(const SampleTrack& samples) {
  const std::vector<demonstration::SampleGap> found = demonstration::sample_gaps(samples);
  if (found.empty()) return "";
  const auto length = [&](const demonstration::SampleGap& gap) {
    return samples.tick(gap.after) - samples.tick(gap.after - 1);
  };
  const auto longest = std::max_element(
      found.begin(), found.end(), [&](const auto& one, const auto& other) { return length(one) < length(other); });
  return fmt::format("{} {}, the longest {:.2f} s at {:.2f} s", found.size(), found.size() == 1 ? "gap" : "gaps",
                     Tick{length(*longest)}.seconds(),
                     Tick{samples.tick(longest->after - 1) - samples.tick(0)}.seconds());
}

/// "samples come unevenly: 9 of 10 are 31 to 36 ms after the one before"; empty where whole milliseconds explain it.
std::string unevenness(const SampleTrack& samples) {
  constexpr std::int64_t kByRounding = 2;
  std::vector<std::int64_t> steps = steps_of(samples);
  std::sort(steps.begin(), steps.end());
  const std::int64_t low = steps[steps.size() / 20];
  const std::int64_t high = steps[steps.size() - 1 - steps.size() / 20];
  if (high - low <= kByRounding) return "";
  return fmt::format("samples come unevenly: 9 of 10 are {:.0f} to {:.0f} ms after the one before",
                     1e3 * Tick{low}.seconds(), 1e3 * Tick{high}.seconds());
}

int sign_changes(const SampleTrack& samples, std::size_t arm) {
  int count = 0;
  std::array<double, 4> before{};
  for (const Sample& sample : samples) {
    const std::array<double, 4>& after = sample.arms[arm].setpoint_q_wxyz;
    double dot = 0.0;
    for (std::size_t part = 0; part < 4; ++part) dot += before[part] * after[part];
    if (dot < 0.0) ++count;
    before = after;
  }
  return count;
}

/// "the left tool jumps 2 times, by 31 mm at 0.40 s at the farthest"; empty if it does not. A jump is farther and
/// faster than a hand with a tool goes from one sample to the next.
std::string jumps(const SampleTrack& samples, std::size_t arm) {
  constexpr double kJump_m = 0.005;
  constexpr double kJumpSpeed_m_s = 1.0;
  int count = 0;
  double farthest_m = 0.0;
  double at_s = 0.0;
  std::optional<Sample> last;
  for (const Sample& sample : samples) {
    const std::optional<Sample> before = std::exchange(last, sample);
    if (!before) continue;
    const double way_m = (sample.arms[arm].setpoint().p - before->arms[arm].setpoint().p).norm();
    if (way_m < kJump_m || way_m < kJumpSpeed_m_s * (sample.t_s() - before->t_s())) continue;
    ++count;
    if (way_m <= farthest_m) continue;
    farthest_m = way_m;
    at_s = before->t_s() - Tick{samples.tick(0)}.seconds();
  }
  if (count == 0) return "";
  return fmt::format("the {} tool jumps {} {}, by {:.0f} mm at {:.2f} s at the farthest", kArms[arm], count,
                     count == 1 ? "time" : "times", 1e3 * farthest_m, at_s);
}

/// Where a tool goes, when much of it is not over the lattice.
std::string outside(const SampleTrack& samples, std::size_t arm, const spatial::Grid& grid) {
  // A tool that never moves is one that the file does not have.
  const Eigen::Vector3d first = demonstration::measured_tip(samples[0], arm);
  const bool rests = std::all_of(samples.begin(), samples.end(), [&](const Sample& sample) {
    return demonstration::measured_tip(sample, arm) == first;
  });
  if (rests) return "";
  std::size_t count = 0;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector3d high = -low;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d tip = demonstration::measured_tip(sample, arm);
    low = low.cwiseMin(tip);
    high = high.cwiseMax(tip);
    if (!grid.cell_at(tip)) ++count;
  }
  if (count == 0) return "";
  // Whole millimetres, and no "-0".
  const Eigen::Vector3d middle = (500.0 * (low + high)).array().round() + 0.0;
  return fmt::format(
      "{:.0f} % of the {} tool's samples are outside of the learning lattice, its middle is {:.0f}, "
      "{:.0f}, {:.0f} mm",
      100.0 * static_cast<double>(count) / static_cast<double>(samples.size()), kArms[arm], middle.x(), middle.y(),
      middle.z());
}

std::string idle(const demonstration::Demonstration& document) {
  const std::vector<demonstration::IdleSpan> spans = demonstration::idle_spans(document);
  if (spans.empty()) return "";
  double total_s = 0.0;
  for (const demonstration::IdleSpan& span : spans) total_s += span.end_s - span.begin_s;
  return fmt::format("neither tool moves in {} {}, {:.1f} s together", spans.size(),
                     spans.size() == 1 ? "stretch" : "stretches", total_s);
}

}  // namespace

std::vector<std::string> findings(const demonstration::Demonstration& document, const spatial::Grid& grid) {
  const SampleTrack samples = document.gated();
  std::vector<std::string> found{fmt::format("{:.6g} samples a second", demonstration::usual_rate_hz(samples))};
  const auto add = [&](std::string sentence) {
    if (!sentence.empty()) found.push_back(std::move(sentence));
  };
  add(unevenness(samples));
  add(gaps(samples));
  add(idle(document));
  for (std::size_t arm = 0; arm < 2; ++arm) {
    if (const int count = sign_changes(samples, arm); count > 0) {
      add(fmt::format("the {} tool's quaternion changes sign {} {}", kArms[arm], count, count == 1 ? "time" : "times"));
    }
    add(jumps(samples, arm));
    add(outside(samples, arm, grid));
  }
  return found;
}

}  // namespace trocar::exchange
