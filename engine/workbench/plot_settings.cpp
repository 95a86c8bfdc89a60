#include "engine/workbench/plot_settings.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace trocar::workbench {
namespace {

constexpr std::array<std::string_view, kPlotKinds> kPlotNames{"arrivals",  "band", "boxes", "axes",
                                                              "multiples", "map",  "curve", "report"};

bool read_whole_number(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::string_view to_string(PlotKind kind) {
  return kPlotNames[static_cast<std::size_t>(kind)];
}

Result<PlotKind> rollout_plot_from(std::string_view text) {
  for (std::size_t i = 0; i < kPlotNames.size(); ++i) {
    const auto kind = static_cast<PlotKind>(i);
    if (kPlotNames[i] == text && kind != PlotKind::kCurve && kind != PlotKind::kReport) return kind;
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("\"{}\" is no plot of rollouts; use arrivals, band, boxes, axes, multiples or map", text));
}

std::string kept_text(const learning::RolloutRange& range) {
  const learning::MeasureWords& words = learning::words_of(range.measure);
  return fmt::format("{}:{}..{}", words.word, range.low * words.scale, range.high * words.scale);
}

Result<learning::RolloutRange> kept_from(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::size_t dots = text.find("..");
  learning::RolloutRange range;
  if (colon == std::string_view::npos || dots == std::string_view::npos || dots < colon ||
      !read_whole_number(text.substr(colon + 1, dots - colon - 1), range.low) ||
      !read_whole_number(text.substr(dots + 2), range.high) || !(range.low <= range.high)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("\"{}\" is no range of a measure; write it as steps:10..25", text));
  }
  TROCAR_ASSIGN_OR_RETURN(range.measure, learning::rollout_measure_from(text.substr(0, colon)));
  range.low /= learning::words_of(range.measure).scale;
  range.high /= learning::words_of(range.measure).scale;
  return range;
}

}  // namespace trocar::workbench
