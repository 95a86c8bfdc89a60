#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "app/commands/rollout_commands.h"
#include "app/lookup.h"
#include "engine/core/ending.h"
#include "engine/core/file.h"
#include "engine/exchange/rollout_file.h"
#include "engine/learning/start_file.h"
#include "engine/trial/physics_rollout.h"
#include "engine/workbench/rolling.h"

namespace trocar::app {
namespace {

struct PhysicsArguments {
  std::string project;
  std::string model;
  std::string starts = "around:1";
  std::string out;
  bool resume = false;
  double delay_ms = 0.0;
  double noise_mm = 0.0;
  trial::PhysicsOptions options;
};

void bind_physics(CLI::App& verb, PhysicsArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.model, "Id or name")->required();
  verb.add_option("--starts", arguments.starts, starts_help())->capture_default_str();
  verb.add_option("--out", arguments.out,
                  "F.csv, F.json or F.h5 (HDF5): one row for each rollout; what was finished, if it is stopped")
      ->required();
  verb.add_flag("--resume", arguments.resume, "Go on from what F.csv holds; no other file");
  verb.add_flag("--continuous", arguments.options.continuous, "Start anywhere in the cell, not in its middle");
  add_seed(verb, arguments.options.seed, "Seed of the blocks' yaw, of the place in the cell and of what is perturbed");
  trial::Perturbation& perturbed = arguments.options.perturbed;
  verb.add_option("--epsilon", perturbed.epsilon, "This share of the actions is drawn evenly from those allowed, 0 … 1")
      ->check(CLI::Range(0.0, 1.0));
  verb.add_option("--delay-ms", arguments.delay_ms, "The policy is asked for where the tool was so long ago")
      ->check(CLI::Range(0.0, 5000.0));
  verb.add_option("--noise-mm", arguments.noise_mm,
                  "Standard deviation, on each axis, of where the tool is taken to be")
      ->check(CLI::Range(0.0, 50.0));
  verb.add_option("--time-limit", arguments.options.time_limit_s, "Seconds of simulated time for each")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  verb.add_option("--threads", arguments.options.threads, "The result does not depend on it")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

Result<trial::PhysicsRollouts> kept_rollouts(const PhysicsArguments& arguments, const learning::Model& model,
                                             const std::vector<spatial::CellIndex>& starts) {
  std::error_code failed;
  if (!arguments.resume || !std::filesystem::exists(arguments.out, failed)) {
    return trial::PhysicsRollouts(starts.size());
  }
  TROCAR_ASSIGN_OR_RETURN(const std::string csv, read_file(arguments.out));
  auto kept = trial::parse_physics_csv(csv, model, starts, arguments.options);
  if (!kept) return tl::unexpected<Error>(std::move(kept).error().in("go on").at(arguments.out));
  return kept;
}

Result<Answer> run_physics_command(const PhysicsArguments& typed, Console& console) {
  PhysicsArguments arguments = typed;
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, kRowEndings));
  if (arguments.resume && ending_of(arguments.out) != ".csv") {
    return tl::unexpected(Error(ErrorCode::kInvalidArgument, "--resume goes on from a .csv only").at(arguments.out));
  }
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
  arguments.options = workbench::physics_options_of(*file.project(), *entry, arguments.options);
  arguments.options.perturbed.delay_s = 1e-3 * arguments.delay_ms;
  arguments.options.perturbed.noise_m = 1e-3 * arguments.noise_mm;
  const learning::Model& model = *entry->model;
  TROCAR_ASSIGN_OR_RETURN(const std::vector<spatial::CellIndex> starts, learning::read_starts(arguments.starts, model));
  warn_if_stale(*file.project(), *entry, console);
  TROCAR_ASSIGN_OR_RETURN(trial::PhysicsRollouts rollouts, kept_rollouts(arguments, model, starts));
  const int resumed = trial::finished(rollouts);
  const double begin_s = console.clock->now_s();
  TROCAR_RETURN_IF_ERROR(trial::run_physics(model, starts, arguments.options, rollouts, console.progress()));
  const double seconds = console.clock->now_s() - begin_s;
  TROCAR_RETURN_IF_ERROR(exchange::write_rollout_rows(trial::physics_csv(model, starts, arguments.options, rollouts),
                                                      workbench::about_rollouts(*entry, arguments.starts),
                                                      arguments.out));
  const int finished = trial::finished(rollouts);
  if (static_cast<std::size_t>(finished) < starts.size()) {
    return fail(ErrorCode::kCancelled, fmt::format("stopped after {} of {} rollouts, which are kept; --resume goes on",
                                                   finished, starts.size()));
  }
  std::array<int, trial::kPhysicsEnds> ends{};
  for (const auto& rollout : rollouts) ++ends[static_cast<std::size_t>(rollout->end)];
  const workbench::PhysicsView view =
      workbench::physics_view(entry, arguments.starts, starts, arguments.options, std::move(rollouts));
  Answer answer;
  answer.json = {{"count", starts.size()},
                 {"arrived", view.arrived},
                 {"resumed", resumed},
                 {"pushed_mm", 1e3 * view.pushed_m},
                 {"seconds", seconds}};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    answer.json["ends"][std::string(trial::to_string(static_cast<trial::PhysicsEnd>(i)))] = ends[i];
  }
  answer.summary = fmt::format("{} of {} arrive in the simulator, no block is pushed by more than {:.1f} mm",
                               view.arrived, starts.size(), 1e3 * view.pushed_m);
  answer.text = answer.summary;
  if (resumed > 0) answer.text += fmt::format("; {} were there already", resumed);
  return answer;
}

}  // namespace

void add_rollout_physics_command(CLI::App& noun, Action& chosen) {
  add_verb<PhysicsArguments>(noun, chosen, "physics", "Drive the policy through the simulator from many starts",
                             bind_physics, run_physics_command);
}

}  // namespace trocar::app
