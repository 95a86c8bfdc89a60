#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/commands/model_study_commands.h"
#include "app/commands/train_arguments.h"
#include "app/lookup.h"
#include "app/options.h"
#include "engine/core/file.h"
#include "engine/exchange/lattice_table.h"
#include "engine/learning/comparison_csv.h"
#include "engine/learning/model_comparison.h"
#include "engine/statistics/proportion.h"
#include "engine/workbench/jobs/train_job.h"

namespace trocar::app {
namespace {

struct TrainModelArguments {
  TrainArguments training;
  std::string name;
};

void bind_train(CLI::App& verb, TrainModelArguments& arguments) {
  bind_training(verb, arguments.training);
  verb.add_option("--name", arguments.name, "Name of the model (else made from method and segment)");
}

std::string method_text(const learning::Model& model) {
  return std::string(learning::to_string(model.options.method));
}

bool is_sampled(const learning::Model& model) {
  return learning::is_sampled(model.options.method);
}

/// How the training went, from the JSON: what was explored, or how the solver ended.
std::string learned_text(const Json& json) {
  if (json["method"] == "imported") return "imported";
  if (json["fully_explored"].is_null()) {
    return fmt::format("{} iterations", json["iterations"].get<std::size_t>());
  }
  return fmt::format("{} explored fully, {} not at all", json["fully_explored"].get<int>(),
                     json["fully_unexplored"].get<int>());
}

struct Success {
  learning::Basin basin;
  bool arrival_from_start = false;
  learning::RolloutSummary all;
};

Success success_of(const learning::Model& model) {
  Success success;
  success.basin = learning::basin(model, learning::greedy_policy(model));
  success.arrival_from_start =
      success.basin.end[static_cast<std::size_t>(model.start.value)] == learning::RolloutEnd::kArrives;
  std::vector<spatial::CellIndex> cells;
  for (int i = 0; i < model.grid.cell_count(); ++i) cells.push_back({i});
  success.all = learning::summarise(success.basin, cells);
  return success;
}

Json summary_json(const workbench::Project& project, const workbench::ModelEntry& entry) {
  const learning::Model& model = *entry.model;
  const learning::Exploration exploration = learning::exploration(model);
  // `exact` draws nothing and explores nothing.
  const auto if_sampled = [&](const auto& value) { return is_sampled(model) ? Json(value) : Json(); };
  Json json = {{"id", entry.id.value},
               {"name", entry.name},
               {"method", method_text(model)},
               {"segment", std::string(1, demonstration::letter(entry.segment))},
               {"epsilon", if_sampled(model.options.epsilon)},
               {"episodes", if_sampled(model.options.episodes)},
               {"seed", if_sampled(model.options.seed)},
               {"grid", model.grid.n},
               {"states", model.grid.cell_count()},
               {"seconds", model.seconds},
               {"fully_explored", if_sampled(exploration.fully_explored)},
               {"partly_explored", if_sampled(exploration.partly_explored)},
               {"fully_unexplored", if_sampled(exploration.fully_unexplored)},
               {"iterations", model.options.method == learning::Method::kExact ? Json(model.curve.size()) : Json()},
               {"mismatch", model.curve.empty() ? Json() : Json(model.curve.back())},
               {"stale", project.stale(entry)},
               {"hash", hash_text(model.hash())},
               {"created", entry.created},
               {"demonstrations", Json::array()}};
  for (const demonstration::DemonstrationId id : entry.demonstrations) json["demonstrations"].push_back(id.value);
  return json;
}

Json full_json(const workbench::Project& project, const workbench::ModelEntry& entry) {
  const learning::Model& model = *entry.model;
  const Success success = success_of(model);
  Json json = summary_json(project, entry);
  const auto cell = [&](spatial::CellIndex index) {
    const spatial::CellCoordinates c = model.grid.coordinates(index);
    return Json{{"i", c.x}, {"j", c.y}, {"k", c.z}};
  };
  json["start"] = cell(model.start);
  json["goal"] = cell(model.goal);
  json["expert_cells"] = model.experts.front().size();
  json["safe_cells"] = model.safe.count();
  json["arrival_from_start"] = success.arrival_from_start;
  json["arrived_from_all"] = success.all.arrived;
  return json;
}

std::string model_line(const Json& json) {
  const std::string time = json["method"] == "imported" ? "" : fmt::format(", {:.3f} s", json["seconds"].get<double>());
  return fmt::format("{}: {}, {} from the start{}", json["name"].get<std::string>(), learned_text(json),
                     json["arrival_from_start"].get<bool>() ? "arrives" : "does not arrive", time);
}

Result<Answer> run_train(const TrainModelArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file,
                          open_to_edit(arguments.training.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(workbench::TrainModel request, training_of(arguments.training, *file.project()));
  if (!arguments.name.empty()) request.name = free_model_name(*file.project(), arguments.name, console);
  TROCAR_ASSIGN_OR_RETURN(workbench::ModelEntry trained,
                          workbench::train_model(*file.project(), request, console.progress()));
  if (trained.created.empty()) trained.created = iso_time(console.clock->unix_s());
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.add_model(trained, console.progress()));
  const auto& entry = *file.project()->models.at(workbench::ModelId{id});
  Answer answer;
  answer.json = full_json(*file.project(), entry);
  answer.json["seconds"] = trained.model->seconds;
  answer.summary = model_line(answer.json);
  answer.text = fmt::format("Model {}, {}", id, answer.summary);
  return answer;
}

struct ImportModelArguments {
  std::string project;
  workbench::ImportTable table;
  std::string file;
  std::string kind;
  std::vector<std::string> demonstrations;
  std::string segment = "A";
};

void bind_model_import(CLI::App& verb, ImportModelArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("FILE", arguments.file,
                  "F.npy of n×n×n×6 or n³×6 (θ: n×n×n or n³), or F.csv with a header i,j,k,+x,-x,+y,-y,+z,-z (θ: "
                  "i,j,k,theta) or rows in that order; NaN is unknown")
      ->required();
  verb.add_option("--kind", arguments.kind,
                  "q, in the order " + exchange::table_order(learning::TableKind::kQ) + "; or theta, in the order " +
                      exchange::table_order(learning::TableKind::kTheta))
      ->required();
  verb.add_option("--demo", arguments.demonstrations,
                  "Demonstrations by id or name: the first gives start and goal, all of them the safe set")
      ->required();
  verb.add_option("--segment", arguments.segment, "A (to the block) or C (to the hand-off)")->capture_default_str();
  verb.add_option("--grid", arguments.table.grid, "Cells a side of the table")->capture_default_str();
  verb.add_option("--safe-radius", arguments.table.safe_radius,
                  "Cells around the demonstration that the agent never leaves")
      ->capture_default_str();
  verb.add_option("--name", arguments.table.name, "Name of the model (else that of the file)");
}

Result<Answer> run_model_import(const ImportModelArguments& arguments, Console& console) {
  workbench::ImportTable request = arguments.table;
  request.path = arguments.file;
  TROCAR_ASSIGN_OR_RETURN(request.kind, learning::table_kind_from(arguments.kind));
  TROCAR_ASSIGN_OR_RETURN(request.segment, agents_segment(arguments.segment));
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kWhole));
  for (const std::string& text : arguments.demonstrations) {
    TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_demonstration(*file.project(), text));
    request.demonstrations.push_back(demonstration->id);
  }
  if (!request.name.empty()) request.name = free_model_name(*file.project(), request.name, console);
  TROCAR_ASSIGN_OR_RETURN(workbench::ModelEntry imported, workbench::import_table(*file.project(), request));
  imported.created = iso_time(console.clock->unix_s());
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.add_model(imported, console.progress()));
  Answer answer;
  answer.json = full_json(*file.project(), *file.project()->models.at(workbench::ModelId{id}));
  answer.summary = model_line(answer.json);
  const std::vector<double>& numbers =
      request.kind == learning::TableKind::kQ ? imported.model->q : imported.model->theta;
  const auto known = std::count_if(numbers.begin(), numbers.end(), [](double value) { return std::isfinite(value); });
  answer.json["numbers"] = numbers.size();
  answer.json["known"] = known;
  answer.text = fmt::format("Model {}, {}; {} of {} numbers are known", id, answer.summary, known, numbers.size());
  return answer;
}

struct ExportModelArguments {
  std::string project;
  std::string model;
  std::string kind = "q";
  std::string out;
};

Result<Answer> run_model_export(const ExportModelArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".npy", ".csv"}));
  TROCAR_ASSIGN_OR_RETURN(const learning::TableKind kind, learning::table_kind_from(arguments.kind));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
  warn_if_stale(*file.project(), *entry, console);
  const std::vector<double> table = learning::table_of(*entry->model, kind);
  TROCAR_RETURN_IF_ERROR(exchange::write_table(table, kind, entry->model->grid, arguments.out));
  const auto known = std::count_if(table.begin(), table.end(), [](double value) { return std::isfinite(value); });
  Answer answer;
  answer.json = {{"model", entry->id.value},
                 {"kind", learning::to_string(kind)},
                 {"order", exchange::table_order(kind)},
                 {"numbers", table.size()},
                 {"known", known},
                 {"out", arguments.out}};
  answer.summary =
      fmt::format("{} numbers, {} of them known; the order is {}", table.size(), known, exchange::table_order(kind));
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

struct ListModelsArguments {
  std::string project;
};

Result<Answer> run_list_models(const ListModelsArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  Answer answer;
  answer.json = {{"models", Json::array()}};
  answer.summary = counted(file.project()->models.size(), "model");
  for (const auto& [id, entry] : file.project()->models) {
    const Json json = summary_json(*file.project(), *entry);
    const std::string epsilon = is_sampled(*entry->model) ? fmt::format("ε {:<5}", entry->model->options.epsilon) : "";
    answer.text += fmt::format("{}{:>4}  {:<24} {:<11} {}  {:<7}  {}{}", answer.text.empty() ? "" : "\n", id.value,
                               entry->name, method_text(*entry->model), demonstration::letter(entry->segment), epsilon,
                               learned_text(json), json["stale"].get<bool>() ? "  stale" : "");
    answer.json["models"].push_back(json);
  }
  return answer;
}

struct ShowModelArguments {
  std::string project;
  std::string model;
};

Result<Answer> run_show_model(const ShowModelArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
  Answer answer;
  answer.json = full_json(*file.project(), *entry);
  answer.summary = model_line(answer.json);
  for (const auto& [key, value] : answer.json.items()) {
    answer.text += fmt::format("{}{:<20} {}", answer.text.empty() ? "" : "\n", key, shown(value));
  }
  return answer;
}

struct CompareModelsArguments {
  std::string project;
  std::string model_a;
  std::string model_b;
  std::string out;
};

/// Both values, and B's change against A in per cent; null where A is 0, or where a model has no such value.
Json change(std::optional<int> a_or_none, std::optional<int> b_or_none) {
  if (!a_or_none || !b_or_none) {
    const auto json = [](std::optional<int> value) { return value ? Json(*value) : Json(); };
    return {{"a", json(a_or_none)}, {"b", json(b_or_none)}, {"change_percent", Json()}};
  }
  const int a = *a_or_none;
  const int b = *b_or_none;
  return {{"a", a}, {"b", b}, {"change", b - a}, {"change_percent", a == 0 ? Json() : Json(100.0 * (b - a) / a)}};
}

Json around_json(const learning::ModelComparison& compared) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < compared.a.around.size(); ++k) {
    const learning::RolloutSummary& of_a = compared.a.around[k];
    const learning::RolloutSummary& of_b = compared.b.around[k];
    rows.push_back({{"k", k + 1},
                    {"count", of_a.count},
                    {"arrived_a", of_a.arrived},
                    {"arrived_b", of_b.arrived},
                    {"from_above_a", of_a.from_above},
                    {"from_above_b", of_b.from_above}});
  }
  return rows;
}

Result<Answer> run_compare_models(const CompareModelsArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry_a, find_model(*file.project(), arguments.model_a));
  TROCAR_ASSIGN_OR_RETURN(const auto entry_b, find_model(*file.project(), arguments.model_b));
  const learning::Model& a = *entry_a->model;
  const learning::Model& b = *entry_b->model;
  if (a.grid != b.grid) return fail(ErrorCode::kInvalidArgument, "the models have different lattices");
  warn_if_stale(*file.project(), *entry_a, console);
  if (entry_a != entry_b) warn_if_stale(*file.project(), *entry_b, console);
  warn_if_unlike(*entry_a, *entry_b, console);
  const auto explored = [&](int learning::Exploration::*member) {
    const auto of = [member](const learning::Model& model) {
      return is_sampled(model) ? std::optional(learning::exploration(model).*member) : std::nullopt;
    };
    return change(of(a), of(b));
  };
  const learning::ModelComparison compared = learning::compare_models(a, b);
  const int changed = compared.policy_changed;
  const double changed_percent = 100.0 * changed / a.grid.cell_count();

  Answer answer;
  answer.json = {{"model_a", entry_a->id.value},
                 {"model_b", entry_b->id.value},
                 {"fully_explored", explored(&learning::Exploration::fully_explored)},
                 {"partly_explored", explored(&learning::Exploration::partly_explored)},
                 {"fully_unexplored", explored(&learning::Exploration::fully_unexplored)},
                 {"policy_changed", changed},
                 {"policy_changed_percent", changed_percent},
                 {"policy_compared", compared.policy_compared},
                 {"policy_differs", compared.policy_differs},
                 {"mean_reward", {{"a", compared.a.mean_reward}, {"b", compared.b.mean_reward}}},
                 {"mean_margin", {{"a", compared.a.mean_margin}, {"b", compared.b.mean_margin}}},
                 {"mismatch", {{"a", compared.a.mismatch}, {"b", compared.b.mismatch}}},
                 {"success", change(compared.a.all.arrived, compared.b.all.arrived)},
                 {"only_a", compared.paired.wins_a},
                 {"only_b", compared.paired.wins_b},
                 {"mcnemar_p", compared.paired.mcnemar_p},
                 {"around", around_json(compared)}};
  const auto percent = [&](const char* key) {
    const Json& value = answer.json[key]["change_percent"];
    return value.is_null() ? std::string("n/a") : fmt::format("{:+.0f} %", value.get<double>());
  };
  if (!arguments.out.empty()) {
    TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".csv"}));
    TROCAR_RETURN_IF_ERROR(write_file(arguments.out, learning::comparison_csv(a, b, compared)));
  }
  answer.summary = fmt::format("fully explored {}, fully unexplored {}, policy differs in {} cells",
                               percent("fully_explored"), percent("fully_unexplored"), changed);
  answer.text = fmt::format("{} against {}: {} ({}), arrives from {} cells against {}", entry_b->name, entry_a->name,
                            answer.summary, statistics::share_text(0.01 * changed_percent, 1), compared.b.all.arrived,
                            compared.a.all.arrived);
  return answer;
}

}  // namespace

void add_model_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun =
      *root.add_subcommand("model", "Train or import models, list and compare them")->require_subcommand(1);
  add_verb<TrainModelArguments>(noun, chosen, "train", "Learn reward and policy from demonstrations", bind_train,
                                run_train);
  add_verb<ImportModelArguments>(noun, chosen, "import",
                                 "Make a model of a Q-table or of rewards θ that were learned elsewhere",
                                 bind_model_import, run_model_import);
  add_verb<ExportModelArguments>(
      noun, chosen, "export", "Write a model's Q-table or rewards θ for other programs",
      [](CLI::App& verb, ExportModelArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("MODEL", a.model, "Its id or name")->required();
        verb.add_option("--kind", a.kind, "q or theta")->capture_default_str();
        verb.add_option("--out", a.out, "F.npy or F.csv")->required();
      },
      run_model_export);
  add_verb<ListModelsArguments>(
      noun, chosen, "list", "List the models",
      [](CLI::App& verb, ListModelsArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
      },
      run_list_models);
  add_verb<ShowModelArguments>(
      noun, chosen, "show", "Say everything about one model",
      [](CLI::App& verb, ShowModelArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("MODEL", a.model, "Its id or name")->required();
      },
      run_show_model);
  add_verb<CompareModelsArguments>(
      noun, chosen, "compare", "Say what model B changes against model A",
      [](CLI::App& verb, CompareModelsArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("MODEL_A", a.model_a, "Id or name")->required();
        verb.add_option("MODEL_B", a.model_b, "Id or name")->required();
        verb.add_option("--out", a.out, "F.csv: also write what both measure, a row for each");
      },
      run_compare_models);
  add_model_study_commands(noun, chosen);
  add_model_curve_command(noun, chosen);
}

}  // namespace trocar::app
