#include "app/commands/train_arguments.h"

#include <fmt/format.h>

#include "app/lookup.h"

namespace trocar::app {
Result<demonstration::Segment> agents_segment(const std::string& text) {
  TROCAR_ASSIGN_OR_RETURN(const demonstration::Segment segment, segment_from(text));
  if (segment == demonstration::Segment::kA || segment == demonstration::Segment::kC) return segment;
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("segment {} is the operator's; the agent does A (to the block) and C (to the hand-off), so "
                          "that only these are learned",
                          demonstration::letter(segment)));
}

void bind_training(CLI::App& verb, TrainArguments& arguments) {
  learning::TrainOptions& options = arguments.options;
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstrations, "Demonstrations by id or name; the first gives start and goal")
      ->required();
  verb.add_option("--segment", arguments.segment, "A (to the block) or C (to the hand-off): what the agent does")
      ->capture_default_str();
  verb.add_option("--method", arguments.method, "eg-maxent, eg-maxent+ or exact")->capture_default_str();
  verb.add_option("--epsilon", options.epsilon, "Exploration ε, 0 … 1 (0 … 0.1 in the paper)")->capture_default_str();
  verb.add_option("--episodes", options.episodes, "Episodes N")->capture_default_str();
  add_seed(verb, options.seed, "Seed of the random numbers");
  verb.add_option("--grid", arguments.grid, "Cells a side")->capture_default_str();
  verb.add_option("--theta-rate", options.theta_rate, "β of equation (1)")->capture_default_str();
  verb.add_option("--q-rate", options.q_rate, "α of equation (2)")->capture_default_str();
  verb.add_option("--discount", options.discount, "γ of equation (2)")->capture_default_str();
  verb.add_option("--safe-radius", arguments.safe_radius,
                  "Cells around the demonstration that the agent never leaves (4 of 22, as long on other lattices)");
  verb.add_option(
      "--start-spread", arguments.start_spread,
      "Training starts within ± this many cells of the expert's (6 of 22, as long on other lattices; not of "
      "eg-maxent)");
  verb.add_option("--prior", options.theta_prior, "θ₀ of exact")->capture_default_str();
  verb.add_option("--regularisation", options.regularisation, "λ of exact")->capture_default_str();
}

Result<workbench::TrainModel> training_of(const TrainArguments& arguments, const workbench::Project& project) {
  workbench::TrainModel request;
  TROCAR_ASSIGN_OR_RETURN(request.segment, agents_segment(arguments.segment));
  request.options = arguments.options;
  TROCAR_ASSIGN_OR_RETURN(request.options.method, learning::method_from(arguments.method));
  request.grid = arguments.grid;
  const learning::TrainOptions usual = learning::options_of(learning::Preset::kPaper, arguments.grid);
  request.options.safe_radius = arguments.safe_radius.value_or(usual.safe_radius);
  request.options.start_spread = arguments.start_spread.value_or(usual.start_spread);
  for (const std::string& text : arguments.demonstrations) {
    TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_demonstration(project, text));
    request.demonstrations.push_back(demonstration->id);
  }
  return request;
}

}  // namespace trocar::app
