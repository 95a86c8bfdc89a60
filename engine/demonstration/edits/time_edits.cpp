// Other times for the same motion: Resample, Retime.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

/// An hour; more is a slip of the keyboard.
constexpr double kLongest_s = 3600.0;
/// Over half a day at 200 Hz.
constexpr double kMostSamples = 1e7;

/// How far the faster tool goes from one sample to the next.
double step_m(const Sample& a, const Sample& b) {
  return std::max((measured_tip(b, 0) - measured_tip(a, 0)).norm(), (measured_tip(b, 1) - measured_tip(a, 1)).norm());
}

/// The new durations between neighbours, in ticks and not whole.
Result<std::vector<double>> new_steps(const SampleTrack& samples, const Retime& edit) {
  std::vector<double> steps;
  double old_total = 0.0;
  double path_m = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    steps.push_back(static_cast<double>(samples.tick(i) - samples.tick(i - 1)));
    old_total += steps.back();
    path_m += step_m(samples[i - 1], samples[i]);
  }
  const double per_tick_m = edit.speed_m_s / static_cast<double>(Tick::kPerSecond);
  double factor = 1.0;
  switch (edit.mode) {
    case RetimeTo::kScale:
      TROCAR_RETURN_IF_ERROR(check_positive(edit.scale, "the scale"));
      factor = edit.scale;
      break;
    case RetimeTo::kDuration:
      TROCAR_RETURN_IF_ERROR(check_positive(edit.duration_s, "the duration"));
      factor = edit.duration_s * static_cast<double>(Tick::kPerSecond) / old_total;
      break;
    case RetimeTo::kSpeedCap:
      TROCAR_RETURN_IF_ERROR(check_positive(edit.speed_m_s, "the speed"));
      for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i] = std::max(steps[i], step_m(samples[i], samples[i + 1]) / per_tick_m);
      }
      break;
    case RetimeTo::kConstantSpeed:
      TROCAR_RETURN_IF_ERROR(check_positive(edit.speed_m_s, "the speed"));
      if (path_m <= 0.0) return fail(ErrorCode::kInvalidArgument, "no tool moves in that span");
      for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = step_m(samples[i], samples[i + 1]) / per_tick_m;
      break;
  }
  for (double& step : steps) step *= factor;
  return steps;
}

/// The samples again, on an even grid of ticks, where sample i of `samples` comes at `ticks[i]` from the first.
SampleTrack on_grid(const SampleTrack& samples, const std::vector<double>& ticks, std::int64_t step) {
  BlockBuilder result;
  TrackReader reader(samples);
  std::size_t piece = 0;
  for (std::int64_t tick = 0; static_cast<double>(tick) <= ticks.back(); tick += step) {
    const auto wanted = static_cast<double>(tick);
    while (piece + 2 < ticks.size() && ticks[piece + 1] <= wanted) ++piece;
    const double length = ticks[piece + 1] - ticks[piece];
    const double share = length > 0.0 ? std::clamp((wanted - ticks[piece]) / length, 0.0, 1.0) : 0.0;
    const auto from = static_cast<double>(samples.tick(piece));
    Sample sample = reader.at(from + share * static_cast<double>(samples.tick(piece + 1) - samples.tick(piece)));
    sample.tick = samples.tick(0) + tick;
    result.add(sample);
  }
  return SampleTrack(result.take());
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Resample& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.rate_hz, "the rate"));
  const double step = static_cast<double>(Tick::kPerSecond) / edit.rate_hz;
  if (step < 1.0 || step > 1000.0 || std::abs(step - std::round(step)) > 1e-6) {
    const double nearest = static_cast<double>(Tick::kPerSecond) / std::clamp(std::round(step), 1.0, 1000.0);
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("a rate must be 1000 Hz divided by a whole number; the nearest to {:g} is {:g} Hz",
                            edit.rate_hz, nearest));
  }
  if (document.full_duration_s() * edit.rate_hz > kMostSamples) {
    return fail(ErrorCode::kInvalidArgument, "that would make more than ten million samples");
  }
  const SampleTrack& samples = document.samples;
  std::vector<double> ticks;
  ticks.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ticks.push_back(static_cast<double>(samples.tick(i) - samples.tick(0)));
  }
  Demonstration edited = document;
  edited.samples = on_grid(samples, ticks, std::llround(step));
  edited.end_s = std::min(edited.end_s, edited.full_duration_s());
  if (edited.samples.size() >= 2 && edited.gated().size() >= 2) return edited;
  return fail(ErrorCode::kInvalidArgument, "fewer than 2 samples would stay");
}

Result<Demonstration> made_by(const Demonstration& document, const Retime& edit) {
  TROCAR_ASSIGN_OR_RETURN(const TrackPart part, part_of(document, edit.from_s, edit.to_s, 2));
  const SampleTrack& samples = part.samples;
  TROCAR_ASSIGN_OR_RETURN(const std::vector<double> steps, new_steps(samples, edit));
  std::vector<double> ticks{0.0};
  for (const double step : steps) ticks.push_back(ticks.back() + step);
  if (ticks.back() > kLongest_s * static_cast<double>(Tick::kPerSecond)) {
    return fail(ErrorCode::kInvalidArgument, "the span would last for more than an hour");
  }
  if (!(ticks.back() >= 1.0)) return fail(ErrorCode::kInvalidArgument, "the span would have no duration");
  // The grid of the samples goes on behind the span, so that its length is a whole number of steps.
  constexpr std::int64_t kStep = kTicksPerSample;
  const auto length = std::max<std::int64_t>(std::llround(ticks.back() / static_cast<double>(kStep)), 1) * kStep;
  const double fit = static_cast<double>(length) / ticks.back();
  for (double& tick : ticks) tick *= fit;
  ticks.back() = static_cast<double>(length);
  const std::int64_t shift = length - (samples.tick(samples.size() - 1) - samples.tick(0));
  return with_other_length(document, part.first, samples.size(), on_grid(samples, ticks, kStep), shift);
}

}  // namespace trocar::demonstration
