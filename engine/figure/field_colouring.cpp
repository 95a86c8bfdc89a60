#include "engine/figure/field_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/outcome_colours.h"
#include "engine/figure/slice_geometry.h"

namespace trocar::figure {
namespace {

using learning::Layer;
using learning::RolloutEnd;

constexpr Rgba kNothing{216, 219, 224, 255};

// Numbers of Okabe and Ito's colours.
constexpr int kOrange = 0;
constexpr int kSky = 1;
constexpr int kGreen = 2;
constexpr int kBlue = 4;
constexpr int kVermilion = 5;

std::vector<Rgba> colours_of(Layer layer) {
  using plot::category;
  switch (layer) {
    case Layer::kExplored:
      return {kNothing, category(kSky), category(kBlue)};
    case Layer::kSafe:
      return {kNothing, category(kGreen)};
    case Layer::kExpert:
      return {kNothing, category(kVermilion)};
    case Layer::kObstacles:
      return {kNothing, category(kOrange)};
    case Layer::kBasin:
      return {outcome_colour(RolloutEnd::kArrives), outcome_colour(RolloutEnd::kLoops),
              outcome_colour(RolloutEnd::kDeadEnd), outcome_colour(RolloutEnd::kOutsideSafeSet)};
    default:
      return {};
  }
}

/// "10,000".
std::string grouped(int count) {
  std::string text = std::to_string(count);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), 1, ',');
  return text;
}

bool has_both_signs(const std::vector<double>& values) {
  const bool above = std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v) && v > 0.0; });
  const bool below = std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v) && v < 0.0; });
  return above && below;
}

}  // namespace

std::vector<Rgba> category_colours(const learning::Field& field) {
  std::vector<Rgba> colours = colours_of(field.layer);
  for (std::size_t i = colours.size(); i < field.categories.size(); ++i) {
    colours.push_back(plot::category(static_cast<int>(i)));
  }
  colours.resize(field.categories.size());
  return colours;
}

FieldFigureOptions suggested_options(const learning::Field& field) {
  FieldFigureOptions options;
  if (field.categorical) {
    options.map = plot::ColourMap::kCategorical;
    return options;
  }
  if (has_both_signs(field.values)) options.map = plot::ColourMap::kDiverging;
  if (field.layer == Layer::kVisits) {
    options.map = plot::ColourMap::kMagma;
    options.scale = plot::ScaleKind::kSymlog;
  }
  if (field.layer == Layer::kMargin) options.scale = plot::ScaleKind::kPercentile;
  return options;
}

FieldFigureOptions suggested_options(const learning::Field& field, const learning::Model& model) {
  FieldFigureOptions options = suggested_options(field);
  for (const learning::CellSequence& cells : model.experts) {
    options.path.insert(options.path.end(), cells.begin(), cells.end());
  }
  options.safe = model.safe;
  options.start = model.start;
  options.goal = model.goal;
  options.subtitle = learning::to_string(model.options.method);
  if (learning::is_sampled(model.options.method)) {
    options.subtitle += fmt::format(", ε = {}, {} episodes, seed {}", model.options.epsilon,
                                    grouped(model.options.episodes), model.options.seed);
  }
  return options;
}

plot::Colouring colouring_of(const learning::Field& field, const FieldFigureOptions& options) {
  plot::Colouring colouring;
  const bool centred = options.map == plot::ColourMap::kDiverging;
  colouring.map =
      options.map == plot::ColourMap::kCategorical && !field.categorical ? plot::ColourMap::kViridis : options.map;
  colouring.scale = plot::fit_scale(options.scale, field.values, centred);
  colouring.vision = options.vision;
  if (field.categorical) colouring.categories = category_colours(field);
  if (!options.limits) return colouring;
  const auto [low, high] = *options.limits;
  const bool across = colouring.scale.kind == plot::ScaleKind::kLog && (low <= 0.0) != (high < 0.0);
  if (low < high && !across) {
    colouring.scale.low = low;
    colouring.scale.high = high;
  }
  return colouring;
}

Image slice_pixels(const learning::Field& field, const Slice& slice, const plot::Colouring& colouring) {
  const int n = field.grid.n;
  Image pixels(n, n, {0, 0, 0, 0});
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const spatial::CellIndex cell = cell_at(field.grid, slice, {column, row});
      pixels.set(column, row, colouring.colour(field.values[static_cast<std::size_t>(cell.value)]));
    }
  }
  return pixels;
}

}  // namespace trocar::figure
