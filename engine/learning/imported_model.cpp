#include "engine/learning/imported_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/learning/field.h"
#include "engine/learning/policy.h"
#include "engine/learning/training_input.h"
#include "engine/learning/value_iteration.h"

namespace trocar::learning {
namespace {

using spatial::kActionCount;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoMove = -std::numeric_limits<double>::infinity();

std::string cell_words(const spatial::Grid& grid, std::size_t s) {
  const spatial::CellCoordinates c = grid.coordinates({static_cast<std::int32_t>(s)});
  return fmt::format("({}, {}, {})", c.x, c.y, c.z);
}

Status check_table(const Model& model, TableKind kind, const std::vector<double>& table) {
  const auto width = static_cast<std::size_t>(table_width(kind));
  const std::size_t expected = width * model.theta.size();
  if (table.size() != expected) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the table has {} numbers, but this lattice needs {}", table.size(), expected));
  }
  if (std::none_of(table.begin(), table.end(), [](double value) { return std::isfinite(value); })) {
    return fail(ErrorCode::kInvalidArgument, "the table holds no number: all is NaN or infinite");
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    const bool is_no_move = kind == TableKind::kQ && table[i] == kNoMove;
    if (std::isinf(table[i]) && !is_no_move) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("the number of cell {} is infinite", cell_words(model.grid, i / width)));
    }
    if (kind == TableKind::kTheta && table[i] > 0.0 && static_cast<std::int32_t>(i) != model.goal.value) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("θ is {:g} in cell {}; above 0 the agent would go round and collect it", table[i],
                              cell_words(model.grid, i)));
    }
  }
  return {};
}

void take_q(const std::vector<double>& table, Model& model) {
  std::fill(model.theta.begin(), model.theta.end(), kNoNumber);
  for (std::size_t s = 0; s < model.value.size(); ++s) {
    double best = kNoMove;
    for (std::size_t a = 0; a < kActionCount; ++a) {
      const double q = table[s * kActionCount + a];
      model.q[s * kActionCount + a] = std::isfinite(q) ? q : kNoMove;
      if (!std::isfinite(q)) continue;
      model.tried[s] = static_cast<std::uint8_t>(model.tried[s] | 1U << a);
      best = std::max(best, q);
    }
    model.value[s] = best;
  }
  model.value[static_cast<std::size_t>(model.goal.value)] = 0.0;
}

void take_theta(const std::vector<double>& table, Model& model) {
  const std::vector<std::uint8_t> allowed = allowed_moves(model.grid, model.safe);
  for (std::size_t s = 0; s < table.size(); ++s) {
    model.theta[s] = table[s];
    model.tried[s] = std::isnan(table[s]) ? std::uint8_t{0} : allowed[s];
  }
  model.tried[static_cast<std::size_t>(model.goal.value)] = 0;
  iterate_values(model);
}

}  // namespace

std::string_view to_string(TableKind kind) {
  return kind == TableKind::kQ ? "q" : "theta";
}

Result<TableKind> table_kind_from(std::string_view text) {
  for (const TableKind kind : {TableKind::kQ, TableKind::kTheta}) {
    if (text == to_string(kind)) return kind;
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no table: use q or theta", text));
}

int table_width(TableKind kind) {
  return kind == TableKind::kQ ? kActionCount : 1;
}

Result<Model> imported_model(const spatial::Grid& grid, const std::vector<CellSequence>& experts, int safe_radius,
                             TableKind kind, const std::vector<double>& table) {
  TrainOptions options;
  options.method = Method::kImported;
  options.discount = 1.0;  // a path is worth the sum of its rewards
  options.epsilon = 0.0;
  options.episodes = 1;
  options.safe_radius = safe_radius;
  TROCAR_RETURN_IF_ERROR(check_training(grid, experts, options));
  Model model = untrained_model(grid, experts, options);
  TROCAR_RETURN_IF_ERROR(check_table(model, kind, table));
  kind == TableKind::kQ ? take_q(table, model) : take_theta(table, model);
  return model;
}

std::vector<double> table_of(const Model& model, TableKind kind) {
  if (kind == TableKind::kTheta) return field(model, Layer::kReward).values;
  const std::vector<std::uint8_t> candidates = candidate_moves(model);
  std::vector<double> table(model.q.size(), kNoNumber);
  const bool paper = model.options.method == Method::kEgMaxent;
  for (std::size_t s = 0; s < candidates.size(); ++s) {
    // It was tried out there in training, but has no move: an imported agent with these numbers would walk.
    if (paper && model.safe.flags()[s] == 0) continue;
    for (std::size_t a = 0; a < kActionCount; ++a) {
      const double q = model.q[s * kActionCount + a];
      if (((candidates[s] | model.tried[s]) >> a & 1) != 0 && std::isfinite(q)) table[s * kActionCount + a] = q;
    }
  }
  return table;
}

}  // namespace trocar::learning
