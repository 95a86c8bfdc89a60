#include "engine/demonstration/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/quality.h"
#include "engine/spatial/units.h"

namespace trocar::demonstration {
namespace {

Deviation deviation_of(std::vector<double> metres) {
  Deviation deviation;
  if (metres.empty()) return deviation;
  double sum_m = 0.0;
  for (const double each : metres) sum_m += each;
  const auto count = static_cast<double>(metres.size());
  deviation.mean_m = sum_m / count;
  const auto at = static_cast<std::ptrdiff_t>(std::ceil(0.95 * count)) - 1;
  std::nth_element(metres.begin(), metres.begin() + at, metres.end());
  deviation.share_95_m = metres[static_cast<std::size_t>(at)];
  deviation.max_m = *std::max_element(metres.begin() + at, metres.end());
  return deviation;
}

void measure(Comparison& comparison) {
  std::array<std::vector<double>, 2> each;
  double square_sum = 0.0;
  comparison.difference.moved = 0;
  for (const Match& match : comparison.matches) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      each[arm].push_back(match.deviation_m(arm));
      square_sum += each[arm].back() * each[arm].back();
    }
    if (std::max(each[0].back(), each[1].back()) > kUnmoved_m) ++comparison.difference.moved;
  }
  std::vector<double> both = each[0];
  both.insert(both.end(), each[1].begin(), each[1].end());
  const double count = static_cast<double>(std::max<std::size_t>(both.size(), 1));
  for (std::size_t arm = 0; arm < 2; ++arm) comparison.deviation[arm] = deviation_of(std::move(each[arm]));
  comparison.both = deviation_of(std::move(both));
  comparison.difference.max_deviation_m = comparison.both.max_m;
  comparison.difference.rms_deviation_m = std::sqrt(square_sum / count);
}

spatial::CellSet cells_of(const Demonstration& document, const spatial::Grid& grid) {
  spatial::CellSet cells(grid);
  for (const Sample& sample : document.gated()) {
    if (const auto cell = grid.cell_at(measured_tip(sample, 0))) cells.insert(*cell);
  }
  return cells;
}

void count_cells(const Demonstration& before, const Demonstration& after, const spatial::Grid& grid,
                 Comparison& comparison) {
  const spatial::CellSet was = cells_of(before, grid);
  const spatial::CellSet is = cells_of(after, grid);
  for (std::size_t i = 0; i < was.flags().size(); ++i) {
    if (was.flags()[i] != 0 && is.flags()[i] == 0) ++comparison.cells_lost;
    if (was.flags()[i] == 0 && is.flags()[i] != 0) ++comparison.cells_gained;
  }
}

std::string row(const std::string& what, double before, double after, const std::string& unit, int digits) {
  return fmt::format("| {}, {} | {:.{}f} | {:.{}f} | {:+.{}f} |\n", what, unit, before, digits, after, digits,
                     after - before, digits);
}

/// "–" for what cannot be told.
std::string row(const std::string& what, std::optional<double> before, std::optional<double> after,
                const std::string& unit, int digits) {
  if (before && after) return row(what, *before, *after, unit, digits);
  const auto told = [digits](std::optional<double> value) {
    return value ? fmt::format("{:.{}f}", *value, digits) : std::string("–");
  };
  return fmt::format("| {}, {} | {} | {} | – |\n", what, unit, told(before), told(after));
}

std::string deviation_row(const std::string& what, const Deviation& deviation) {
  return fmt::format("| {} | {:.3f} | {:.3f} | {:.3f} |\n", what, spatial::to_mm(deviation.max_m),
                     spatial::to_mm(deviation.mean_m), spatial::to_mm(deviation.share_95_m));
}

}  // namespace

Result<Comparison> compare(const Demonstration& before, const Demonstration& after, Alignment alignment,
                           const spatial::Grid& grid) {
  Comparison comparison;
  comparison.alignment = alignment;
  TROCAR_ASSIGN_OR_RETURN(comparison.matches, match(before, after, alignment));
  comparison.difference = difference(before, after);
  measure(comparison);
  const Quality was = quality(before);
  const Quality is = quality(after);
  comparison.before_s = was.duration_s;
  comparison.after_s = is.duration_s;
  comparison.path_before_m = was.path_length_m;
  comparison.path_after_m = is.path_length_m;
  comparison.jerk_before_m_s3 = was.mean_jerk_m_s3;
  comparison.jerk_after_m_s3 = is.mean_jerk_m_s3;
  count_cells(before, after, grid, comparison);
  comparison.labels = label_differences(before, after);
  return comparison;
}

std::string to_markdown(const Comparison& comparison, const std::string& title) {
  const Difference& difference = comparison.difference;
  std::string text = fmt::format("### {}\n\n| | before | after | change |\n| --- | ---: | ---: | ---: |\n", title);
  text += row("duration", comparison.before_s, comparison.after_s, "s", 3);
  constexpr std::array<const char*, 2> kArms{"left", "right"};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    text += row(fmt::format("path, {}", kArms[arm]), spatial::to_mm(comparison.path_before_m[arm]),
                spatial::to_mm(comparison.path_after_m[arm]), "mm", 1);
  }
  for (std::size_t arm = 0; arm < 2; ++arm) {
    text += row(fmt::format("mean raw jerk, {}", kArms[arm]), comparison.jerk_before_m_s3[arm],
                comparison.jerk_after_m_s3[arm], "m/s³", 2);
  }
  text += fmt::format("\n| deviation by {}, mm | max | mean | 95 % |\n| --- | ---: | ---: | ---: |\n",
                      to_string(comparison.alignment));
  for (std::size_t arm = 0; arm < 2; ++arm) text += deviation_row(kArms[arm], comparison.deviation[arm]);
  text += deviation_row("both", comparison.both);
  text += fmt::format("\n- samples: {} removed, {} added, {} moved\n- cells of the lattice: {} lost, {} gained\n",
                      difference.removed, difference.added, difference.moved, comparison.cells_lost,
                      comparison.cells_gained);
  for (const std::string& clause : comparison.labels) text += fmt::format("- {}\n", clause);
  return text;
}

}  // namespace trocar::demonstration
