#include "engine/demonstration/sampling_rate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "engine/demonstration/recording.h"

namespace trocar::demonstration {
namespace {

constexpr std::size_t kBeside = 5;
/// A side with fewer steps says nothing of its own.
constexpr std::size_t kFewest = 3;

template <typename Steps>
std::int64_t median(Steps begin, Steps end) {
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end);
  return *middle;
}

/// In whole numbers, so that one and a half is no matter of rounding; one tick more is one: 700 Hz has steps of 1
/// and 2.
bool longer_than_usual(std::int64_t step, std::int64_t usual) {
  return 2 * step > 3 * usual && step > usual + 1;
}

}  // namespace

std::int64_t usual_step(const SampleTrack& samples) {
  constexpr std::size_t kMostSteps = 1000;
  if (samples.size() < 2) return 0;
  const std::size_t stride = (samples.size() - 2) / kMostSteps + 1;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < samples.size(); i += stride) steps.push_back(samples.tick(i) - samples.tick(i - 1));
  return median(steps.begin(), steps.end());
}

double usual_rate_hz(const SampleTrack& samples) {
  const std::int64_t usual = usual_step(samples);
  std::int64_t count = 0;
  std::int64_t ticks = 0;
  // Stamps that jitter are early and late by turns: all steps but gaps and those of another rate tell, not the middle
  // ones alone.
  const std::int64_t reach = std::max<std::int64_t>(usual / 2, 1);
  std::int64_t farthest = 1;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const std::int64_t step = samples.tick(i) - samples.tick(i - 1);
    if (std::abs(step - usual) > reach) continue;
    farthest = std::max(farthest, std::abs(step - usual));
    ++count;
    ticks += step;
  }
  const auto per_second = static_cast<double>(Tick::kPerSecond);
  const double rate_hz = per_second * static_cast<double>(count) / static_cast<double>(ticks);
  // A whole number of them a second, if both ends of the run, rounded to whole ticks or as far off as steps are, can be
  // that.
  const double whole_hz = std::max(std::round(rate_hz), 1.0);
  const double off = std::abs(per_second * static_cast<double>(count) / whole_hz - static_cast<double>(ticks));
  return off <= static_cast<double>(farthest) ? whole_hz : rate_hz;
}

std::int64_t step_between(const SampleTrack& samples, std::size_t before, std::size_t after) {
  std::array<std::int64_t, 2 * kBeside> steps{};
  std::size_t count = 0;
  for (std::size_t i = before; i > 0 && count < kBeside; --i) {
    steps[count++] = samples.tick(i) - samples.tick(i - 1);
  }
  const std::size_t early = count;
  for (std::size_t i = after; i + 1 < samples.size() && count - early < kBeside; ++i) {
    steps[count++] = samples.tick(i + 1) - samples.tick(i);
  }
  if (count == 0) return kTicksPerSample;
  auto* const begin = steps.data();
  std::int64_t expected = 0;
  if (early >= kFewest) expected = median(begin, begin + early);
  if (count - early >= kFewest) expected = std::max(expected, median(begin + early, begin + count));
  if (expected == 0) expected = median(begin, begin + count);
  return std::max<std::int64_t>(expected, 1);
}

std::vector<SampleGap> sample_gaps(const SampleTrack& samples) {
  std::vector<std::int64_t> ticks;
  ticks.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) ticks.push_back(samples.tick(i));
  std::int64_t shortest = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const std::int64_t step = ticks[i] - ticks[i - 1];
    shortest = shortest == 0 ? step : std::min(shortest, step);
  }
  std::vector<SampleGap> gaps;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const std::int64_t step = ticks[i] - ticks[i - 1];
    // Most steps are none: what is usual is at least the shortest.
    if (!longer_than_usual(step, shortest)) continue;
    const std::int64_t usual = step_between(samples, i - 1, i);
    if (longer_than_usual(step, usual)) gaps.push_back({i, usual});
  }
  return gaps;
}

}  // namespace trocar::demonstration
