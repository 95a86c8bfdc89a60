#include "app/commands/model_study_commands.h"

#include <fmt/format.h>

#include "app/commands/train_arguments.h"
#include "app/lookup.h"
#include "engine/core/file.h"
#include "engine/figure/field_figure.h"
#include "engine/learning/learning_history.h"
#include "engine/learning/seed_study.h"
#include "engine/statistics/proportion.h"
#include "engine/workbench/jobs/field_job.h"
#include "engine/workbench/jobs/train_job.h"

namespace trocar::app {
namespace {

struct StudyArguments {
  TrainArguments training;
  learning::SeedStudyOptions study;
  std::string out;
  std::string layer = "reward";
  std::string mean;
  std::string spread;
};

void bind_study(CLI::App& verb, StudyArguments& arguments) {
  bind_training(verb, arguments.training);
  verb.add_option("--seeds", arguments.study.count, "How many seeds, counting up from --seed")->capture_default_str();
  verb.add_option("--threads", arguments.study.threads, "The result does not depend on it")->capture_default_str();
  verb.add_option("--out", arguments.out, "F.csv: also write one row for each seed");
}

/// What a study learns from.
struct Subject {
  spatial::Grid grid;
  std::vector<learning::CellSequence> experts;
  learning::TrainOptions options;
};

Result<Subject> subject_of(const StudyArguments& arguments, Console& console) {
  if (!arguments.out.empty()) {
    TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.training.project, {".csv"}));
  }
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.training.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const workbench::TrainModel request, training_of(arguments.training, *file.project()));
  TROCAR_ASSIGN_OR_RETURN(const spatial::Grid grid, workbench::training_grid(request.grid));
  std::vector<std::shared_ptr<const demonstration::Demonstration>> demonstrations;
  for (const auto id : request.demonstrations) demonstrations.push_back(file.project()->demonstrations.at(id));
  TROCAR_ASSIGN_OR_RETURN(std::vector<learning::CellSequence> experts,
                          workbench::expert_cells(demonstrations, request.segment, grid));
  Subject subject{grid, std::move(experts), request.options};
  return subject;
}

Json seed_json(const learning::SeedResult& result) {
  return {{"seed", result.seed},
          {"fully_explored", result.exploration.fully_explored},
          {"partly_explored", result.exploration.partly_explored},
          {"fully_unexplored", result.exploration.fully_unexplored},
          {"arrived", result.all.arrived},
          {"near_count", result.near.count},
          {"near_arrived", result.near.arrived},
          {"near_from_above", result.near.from_above},
          {"mismatch", result.mismatch}};
}

/// A header and one row for each object, all with the keys of the first.
std::string csv_of(const Json& rows) {
  std::string csv;
  for (const Json& row : rows) {
    if (csv.empty()) {
      for (const auto& [key, value] : row.items()) csv += (csv.empty() ? "" : ",") + key;
      csv += "\n";
    }
    std::string line;
    for (const auto& [key, value] : row.items()) line += (line.empty() ? "" : ",") + value.dump();
    csv += line + "\n";
  }
  return csv;
}

void bind_seeds(CLI::App& verb, StudyArguments& arguments) {
  bind_study(verb, arguments);
  verb.add_option("--layer", arguments.layer, "Of which mean and spread are taken")->capture_default_str();
  verb.add_option("--mean", arguments.mean, "F, as of `field export`: the layer's mean over the seeds");
  verb.add_option("--spread", arguments.spread, "Likewise: its standard deviation");
}

/// A field over the seeds as a file; nothing for an empty path.
Status save_study(const learning::Field& field, const std::string& path, const StudyArguments& arguments) {
  if (path.empty()) return {};
  TROCAR_RETURN_IF_ERROR(
      check_output(path, arguments.training.project, {".png", ".svg", ".pdf", ".csv", ".npy", ".vti", ".h5"}));
  return workbench::write_field(field, figure::suggested_options(field), path);
}

Result<Answer> run_seeds(const StudyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const Subject subject, subject_of(arguments, console));
  TROCAR_ASSIGN_OR_RETURN(const learning::Layer layer, learning::layer_from(arguments.layer));
  learning::SeedStudyOptions study = arguments.study;
  study.first_seed = subject.options.seed;
  TROCAR_ASSIGN_OR_RETURN(
      const learning::SeedStudy result,
      learning::study_seeds(subject.grid, subject.experts, subject.options, layer, study, console.progress()));
  TROCAR_RETURN_IF_ERROR(save_study(result.mean, arguments.mean, arguments));
  TROCAR_RETURN_IF_ERROR(save_study(result.spread, arguments.spread, arguments));
  Answer answer;
  answer.json["seeds"] = Json::array();
  double least = 1.0;
  double most = 0.0;
  for (const learning::SeedResult& one : result.seeds) {
    answer.json["seeds"].push_back(seed_json(one));
    const double share = static_cast<double>(one.near.arrived) / std::max(one.near.count, 1);
    least = std::min(least, share);
    most = std::max(most, share);
  }
  answer.json["near_least"] = least;
  answer.json["near_most"] = most;
  if (!arguments.out.empty()) TROCAR_RETURN_IF_ERROR(write_file(arguments.out, csv_of(answer.json["seeds"])));
  answer.summary = fmt::format("{} seeds: within ±3 cells {} to {} arrive", result.seeds.size(),
                               statistics::share_text(least, 0), statistics::share_text(most, 0));
  answer.text = answer.summary;
  if (!learning::is_sampled(subject.options.method)) answer.text += "; this method draws nothing, every seed is alike";
  for (const std::string& path : {arguments.mean, arguments.spread, arguments.out}) {
    if (!path.empty()) answer.text += "\nWrote " + path;
  }
  return answer;
}

Result<Answer> run_explore(const StudyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const Subject subject, subject_of(arguments, console));
  learning::SeedStudyOptions study = arguments.study;
  study.first_seed = subject.options.seed;
  TROCAR_ASSIGN_OR_RETURN(
      const learning::EpsilonStudy result,
      learning::study_epsilon(subject.grid, subject.experts, subject.options, study, console.progress()));
  Answer answer;
  Json rows = Json::array();
  for (const learning::EpsilonPair& pair : result.pairs) {
    rows.push_back({{"seed", pair.greedy.seed},
                    {"fully_explored_0", pair.greedy.exploration.fully_explored},
                    {"fully_explored", pair.exploring.exploration.fully_explored},
                    {"fully_explored_change", pair.fully_explored_change},
                    {"fully_unexplored_0", pair.greedy.exploration.fully_unexplored},
                    {"fully_unexplored", pair.exploring.exploration.fully_unexplored},
                    {"fully_unexplored_change", pair.fully_unexplored_change},
                    {"near_arrived_0", pair.greedy.near.arrived},
                    {"near_arrived", pair.exploring.near.arrived},
                    {"near_count", pair.exploring.near.count}});
  }
  if (!arguments.out.empty()) TROCAR_RETURN_IF_ERROR(write_file(arguments.out, csv_of(rows)));
  const std::vector<std::string> sentences = learning::findings(result);
  answer.json = {{"epsilon", result.epsilon},
                 {"seeds", rows},
                 {"explored_change_mean", result.explored_mean},
                 {"explored_change_sd", result.explored_sd},
                 {"unexplored_change_mean", result.unexplored_mean},
                 {"unexplored_change_sd", result.unexplored_sd},
                 {"explored_rose", result.explored_rose},
                 {"unexplored_fell", result.unexplored_fell},
                 {"near_share_0", result.near_greedy},
                 {"near_share", result.near_exploring},
                 {"findings", sentences}};
  answer.summary = sentences.front();
  for (const std::string& sentence : sentences) answer.text += (answer.text.empty() ? "" : "\n") + sentence;
  return answer;
}

struct EpochArguments {
  std::string project;
  std::string model;
  int epoch = -1;
};

Result<Answer> run_epoch(const EpochArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
  const learning::Model& model = *entry->model;
  const int epochs = learning::epoch_count(model);
  if (arguments.epoch > epochs) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("the training had {} epochs", epochs));
  }
  const int wanted = arguments.epoch < 0 ? epochs : arguments.epoch;
  TROCAR_ASSIGN_OR_RETURN(const learning::Model early, learning::model_at_epoch(model, wanted, console.progress()));
  const learning::Exploration explored = learning::exploration(early);
  const learning::Basin basin = learning::basin(early, learning::greedy_policy(early));
  const learning::RolloutSummary near = learning::summarise(basin, learning::starts_around(early, 3));
  Answer answer;
  answer.json = {{"epoch", wanted},
                 {"epochs", epochs},
                 {"curve", early.curve},
                 {"fully_explored", explored.fully_explored},
                 {"fully_unexplored", explored.fully_unexplored},
                 {"near_count", near.count},
                 {"near_arrived", near.arrived},
                 {"hash", hash_text(early.hash())}};
  answer.summary = fmt::format("after epoch {} of {}: mismatch {:.3g}, within ±3 cells {} of {} arrive", wanted, epochs,
                               early.curve.empty() ? 0.0 : early.curve.back(), near.arrived, near.count);
  answer.text = answer.summary;
  return answer;
}

}  // namespace

void add_model_study_commands(CLI::App& noun, Action& chosen) {
  add_verb<StudyArguments>(noun, chosen, "seeds", "Train with several seeds and say how much is chance", bind_seeds,
                           run_seeds);
  add_verb<StudyArguments>(
      noun, chosen, "explore", "Compare exploration with none over seeds, as section V.A of the paper",
      [](CLI::App& verb, StudyArguments& a) {
        a.training.method = "eg-maxent";
        bind_study(verb, a);
      },
      run_explore);
  add_verb<EpochArguments>(
      noun, chosen, "epoch", "Say what a model had learned after an epoch of its training",
      [](CLI::App& verb, EpochArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("MODEL", a.model, "Its id or name")->required();
        verb.add_option("--at", a.epoch, "The epoch, from 0; else the last")->check(CLI::Range(0, 1'000'000));
      },
      run_epoch);
}

}  // namespace trocar::app
