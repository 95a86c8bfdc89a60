/// Two groups side by side: bars with their spread for each measure, and each pair as a line from one to the other.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/figure/print.h"

namespace trocar::figure {

struct PairedMeasure {
  std::string name;  ///< "Completion".
  std::array<std::vector<double>, 2> values;
};

struct PairedFigure {
  std::string title;
  std::string label;  ///< Whose these are; "scripted …" stands on a tinted ground.
  bool scripted = false;
  std::string unit;  ///< Of all measures and pairs: "s".
  std::array<std::string, 2> groups{"MT", "SC"};
  std::vector<PairedMeasure> measures;  ///< At least one.
  std::string pairs_title;
  std::vector<std::array<double, 2>> pairs;  ///< May be none.
  std::vector<PairedMeasure> panels;         ///< Each a small plot of its own below, on one axis: a participant, say.
  int width_px = 1000;                       ///< At least 480.
  std::optional<Print> print;                ///< For paper: in place of `width_px`.
};

/// Bars are means, whiskers one standard deviation (n − 1), dots the values. Precondition: a measure at least.
Image draw_paired(const PairedFigure& figure);
/// As .svg or .pdf, by the ending of `path`. Errors: kInvalidArgument for another, kIo.
Status save_paired(const PairedFigure& figure, const std::filesystem::path& path);

}  // namespace trocar::figure
