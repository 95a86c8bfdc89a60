#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "app/commands/rollout_commands.h"
#include "app/lookup.h"
#include "engine/learning/explanation.h"
#include "engine/learning/field.h"
#include "engine/learning/rollout.h"
#include "engine/spatial/cell_text.h"

namespace trocar::app {
namespace {

Json cell_json(const spatial::Grid& grid, spatial::CellIndex cell) {
  const spatial::CellCoordinates c = grid.coordinates(cell);
  return {c.x, c.y, c.z};
}

Json cells_json(const spatial::Grid& grid, const std::vector<spatial::CellIndex>& cells) {
  Json list = Json::array();
  for (const spatial::CellIndex cell : cells) list.push_back(cell_json(grid, cell));
  return list;
}

std::string cell_words(const spatial::Grid& grid, spatial::CellIndex cell) {
  const spatial::CellCoordinates c = grid.coordinates(cell);
  return fmt::format("{},{},{}", c.x, c.y, c.z);
}

std::string action_words(std::uint8_t action) {
  return action == learning::kNoAction ? "none" : std::string(spatial::to_string(static_cast<spatial::Action>(action)));
}

/// What was learned of an action; nothing where it was never tried.
std::optional<double> known_q(const learning::Model& model, spatial::CellIndex cell, int action) {
  return learning::known_value(model, static_cast<learning::Layer>(static_cast<int>(learning::Layer::kQPlusX) + action),
                               cell);
}

/// The six Q values at a cell; null where the agent knows none.
Json q_json(const learning::Model& model, spatial::CellIndex cell) {
  Json values;
  for (int a = 0; a < spatial::kActionCount; ++a) {
    const auto q = known_q(model, cell, a);
    values[std::string(spatial::to_string(static_cast<spatial::Action>(a)))] = q ? Json(*q) : Json();
  }
  return values;
}

std::string q_words(const learning::Model& model, spatial::CellIndex cell) {
  std::string words;
  for (int a = 0; a < spatial::kActionCount; ++a) {
    const auto q = known_q(model, cell, a);
    words += fmt::format("  {} {}", spatial::to_string(static_cast<spatial::Action>(a)),
                         q ? fmt::format("{:.4g}", *q) : "unknown");
  }
  return words;
}

struct WhyArguments {
  std::string project;
  std::string model;
  std::string cell;
};

void bind_why(CLI::App& verb, WhyArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.model, "Id or name")->required();
  verb.add_option("CELL", arguments.cell, "The start: I,J,K")->required();
}

Result<Answer> run_why(const WhyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
  const learning::Model& model = *entry->model;
  TROCAR_ASSIGN_OR_RETURN(const spatial::CellIndex start, cell_from(arguments.cell, model.grid));
  warn_if_stale(*file.project(), *entry, console);
  const learning::Explanation why = learning::explain(model, learning::greedy_policy(model), start);
  const bool arrives = why.end == learning::RolloutEnd::kArrives;

  Answer answer;
  answer.json = {{"start", cell_json(model.grid, start)},
                 {"end", learning::to_string(why.end)},
                 {"where", cell_json(model.grid, why.where)},
                 {"steps", why.steps},
                 {"cycle", cells_json(model.grid, why.cycle)},
                 {"unexplored", cells_json(model.grid, why.unexplored)},
                 {"margin", std::isfinite(why.margin) ? Json(why.margin) : Json()},
                 {"q", q_json(model, why.where)}};
  answer.summary =
      fmt::format("from {} it {} after {} steps", cell_words(model.grid, start),
                  arrives ? "arrives" : fmt::format("is lost ({})", learning::to_string(why.end)), why.steps);
  answer.text = answer.summary;
  if (arrives) return answer;
  answer.text +=
      fmt::format("\n  lost in {}: margin {},{}", cell_words(model.grid, why.where),
                  std::isfinite(why.margin) ? fmt::format("{:.4g}", why.margin) : "unknown", q_words(model, why.where));
  if (!why.cycle.empty()) {
    answer.text += fmt::format("\n  goes round {} cells:", why.cycle.size());
    for (const spatial::CellIndex cell : why.cycle) answer.text += "  " + cell_words(model.grid, cell);
  }
  answer.text += fmt::format("\n  {} neighbours in which nothing was tried", why.unexplored.size());
  return answer;
}

struct DivergeArguments {
  std::string project;
  std::string model_a;
  std::string model_b;
  std::string cell;
};

void bind_diverge(CLI::App& verb, DivergeArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL_A", arguments.model_a, "Id or name")->required();
  verb.add_option("MODEL_B", arguments.model_b, "Id or name")->required();
  verb.add_option("CELL", arguments.cell, "The start: I,J,K")->required();
}

Result<Answer> run_diverge(const DivergeArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry_a, find_model(*file.project(), arguments.model_a));
  TROCAR_ASSIGN_OR_RETURN(const auto entry_b, find_model(*file.project(), arguments.model_b));
  const learning::Model& a = *entry_a->model;
  const learning::Model& b = *entry_b->model;
  if (a.grid != b.grid) return fail(ErrorCode::kInvalidArgument, "the models have different lattices");
  TROCAR_ASSIGN_OR_RETURN(const spatial::CellIndex start, cell_from(arguments.cell, a.grid));
  warn_if_stale(*file.project(), *entry_a, console);
  if (entry_a != entry_b) warn_if_stale(*file.project(), *entry_b, console);
  warn_if_unlike(*entry_a, *entry_b, console);
  const std::vector<std::uint8_t> policy_a = learning::greedy_policy(a);
  const std::vector<std::uint8_t> policy_b = learning::greedy_policy(b);
  const learning::Rollout way_a = learning::rollout(a, policy_a, start);
  const learning::Rollout way_b = learning::rollout(b, policy_b, start);
  const std::optional<int> parts_at = learning::first_divergence(way_a.cells, way_b.cells);

  Answer answer;
  answer.json = {{"start", cell_json(a.grid, start)},
                 {"end_a", learning::to_string(way_a.end)},
                 {"end_b", learning::to_string(way_b.end)},
                 {"step", parts_at ? Json(*parts_at) : Json()}};
  if (!parts_at) {
    answer.summary =
        fmt::format("both go the same way: A {}, B {}", learning::to_string(way_a.end), learning::to_string(way_b.end));
    answer.text = answer.summary;
    return answer;
  }
  const spatial::CellIndex where = way_a.cells[static_cast<std::size_t>(*parts_at)];
  const auto at = static_cast<std::size_t>(where.value);
  answer.json["cell"] = cell_json(a.grid, where);
  answer.json["action_a"] = action_words(policy_a[at]);
  answer.json["action_b"] = action_words(policy_b[at]);
  answer.json["q_a"] = q_json(a, where);
  answer.json["q_b"] = q_json(b, where);
  answer.summary = fmt::format("they part after {} steps in {}: A goes {}, B {}", *parts_at, cell_words(a.grid, where),
                               action_words(policy_a[at]), action_words(policy_b[at]));
  answer.text = fmt::format("{}\n  Q of A:{}\n  Q of B:{}\n  A {}, B {}", answer.summary, q_words(a, where),
                            q_words(b, where), learning::to_string(way_a.end), learning::to_string(way_b.end));
  return answer;
}

}  // namespace

Result<spatial::CellIndex> cell_from(const std::string& text, const spatial::Grid& grid) {
  TROCAR_ASSIGN_OR_RETURN(const spatial::CellCoordinates cell, spatial::coordinates_from(text));
  if (grid.contains(cell)) return grid.index(cell);
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("the cell {} is outside of the lattice of {} a side", text, grid.n));
}

void add_rollout_look_commands(CLI::App& noun, Action& chosen) {
  add_verb<WhyArguments>(noun, chosen, "why", "Say why the agent does not arrive from a cell", bind_why, run_why);
  add_verb<DivergeArguments>(noun, chosen, "diverge", "Find where two models' rollouts from a cell part", bind_diverge,
                             run_diverge);
}

}  // namespace trocar::app
