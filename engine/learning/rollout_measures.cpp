// What the measures of rollouts are called, and their values in words.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/learning/rollout_table.h"

namespace trocar::learning {
namespace {

constexpr std::array<MeasureWords, kRolloutMeasures> kWords{{
    {"start", "Start", "Start", "", 1.0},
    {"end", "End", "End", "", 1.0},
    {"steps", "Steps", "Steps", "", 1.0},
    {"length", "Length", "Length", "mm", 1e3},
    {"straightness", "Straight", "Straightness", "", 1.0},
    {"max_deviation", "Worst", "Worst deviation", "mm", 1e3},
    {"mean_deviation", "Mean", "Mean deviation", "mm", 1e3},
    {"frechet", "Fréchet", "Fréchet distance", "mm", 1e3},
    {"hausdorff", "Hausdorff", "Hausdorff distance", "mm", 1e3},
    {"dtw", "Warped", "Warped distance (DTW)", "mm", 1e3},
    {"last_moves", "Last moves", "Last moves down", "", 1.0},
    {"from_above", "From above", "From above", "", 1.0},
    {"reward", "Reward", "Sum of rewards", "", 1.0},
    {"divergence", "Departs", "Step of departure", "", 1.0},
    {"outside", "Outside", "Steps outside of the safe set", "", 1.0},
    {"clearance", "Clearance", "Least clearance", "mm", 1e3},
}};

}  // namespace

const MeasureWords& words_of(RolloutMeasure measure) {
  return kWords[static_cast<std::size_t>(measure)];
}

Result<RolloutMeasure> rollout_measure_from(std::string_view word) {
  std::string known;
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    if (kWords[i].word == word) return static_cast<RolloutMeasure>(i);
    known += (i == 0 ? "" : i + 1 < kWords.size() ? ", " : " or ") + std::string(kWords[i].word);
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no measure of a rollout; use {}", word, known));
}

std::string measure_text(RolloutMeasure measure, double value) {
  if (!std::isfinite(value)) return "unknown";
  const auto whole = static_cast<int>(std::lround(value));
  switch (measure) {
    case RolloutMeasure::kEnd:
      return std::string(to_string(static_cast<RolloutEnd>(std::clamp(whole, 0, 3))));
    case RolloutMeasure::kFromAbove:
      return whole == 1 ? "yes" : "no";
    case RolloutMeasure::kDivergence:
      return whole < 0 ? "never" : fmt::format("{}", whole);
    case RolloutMeasure::kStart:
    case RolloutMeasure::kSteps:
    case RolloutMeasure::kLastMoves:
    case RolloutMeasure::kOutside:
      return fmt::format("{}", whole);
    default:
      break;
  }
  const MeasureWords& words = words_of(measure);
  const std::string number = fmt::format("{:.3g}", value * words.scale);
  const std::string signed_number = number.front() == '-' ? "−" + number.substr(1) : number;
  return words.unit.empty() ? signed_number : fmt::format("{} {}", signed_number, words.unit);
}

}  // namespace trocar::learning
