/// What can be drawn over the lattice: one number for each cell, unknown where nothing was learned.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/learning/model.h"

namespace trocar::learning {

enum class Layer : std::uint8_t {
  kReward,
  kValue,
  kQPlusX,
  kQMinusX,
  kQPlusY,
  kQMinusY,
  kQPlusZ,
  kQMinusZ,
  kMargin,
  kVisits,
  kExplored,
  kSafe,
  kBasin,
  kSteps,
  kPolicy,
  kExpert,
  kThetaChange,  ///< In the last epoch: the model is trained again up to the one before (`learning_history.h`).
  kObstacles,
};
/// As the command line writes them: "reward", "q+x", "margin" …
std::string_view to_string(Layer layer);
Result<Layer> layer_from(std::string_view text);
/// All of them, in the order of the menus.
const std::vector<Layer>& all_layers();

/// `values` is NaN where the model knows nothing.
struct Field {
  Layer layer = Layer::kReward;
  spatial::Grid grid;
  std::vector<double> values;  ///< By CellIndex.
  std::string title;           ///< "Reward θ"
  std::string unit;            ///< "" if none.
  bool categorical = false;    ///< Values are small whole numbers with names.
  std::vector<std::string> categories;

  double low() const;   ///< Smallest finite value, 0 if none.
  double high() const;  ///< Largest finite value, 1 if none.
};
/// Whether it says how often cells are visited: an imported table does not. Which actions were tried is known of
/// methods that sample alone (`is_sampled`).
bool knows_visits(const Model& model);
/// What the layer has in one cell, without making the layer; nothing where it is unknown. Of the layers reward, value,
/// Q and margin.
std::optional<double> known_value(const Model& model, Layer layer, spatial::CellIndex cell);
/// `obstacles`, of the model's grid, is what the layer of that name shows; without them nothing is known there.
Field field(const Model& model, Layer layer, const spatial::CellSet* obstacles = nullptr);

}  // namespace trocar::learning
