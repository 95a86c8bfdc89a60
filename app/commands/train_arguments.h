/// What is said of a training on the command line, for every command that trains.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project_file.h"

namespace trocar::app {

struct TrainArguments {
  std::string project;
  std::vector<std::string> demonstrations;
  std::string segment = "A";
  std::string method = "exact";
  learning::TrainOptions options;
  int grid = 22;
  std::optional<int> safe_radius;   ///< Cells; none: the paper's lengths on this lattice.
  std::optional<int> start_spread;  ///< Likewise.
};

/// Errors: kInvalidArgument for what is no segment, and for the operator's.
Result<demonstration::Segment> agents_segment(const std::string& text);

/// PROJECT, DEMO…, --segment, --method, --grid and one option for each hyperparameter.
void bind_training(CLI::App& verb, TrainArguments& arguments);

/// Errors: kInvalidArgument for a segment that is the operator's, or a method that is none; those of
/// `find_demonstration`.
Result<workbench::TrainModel> training_of(const TrainArguments& arguments, const workbench::Project& project);

}  // namespace trocar::app
