#include "engine/learning/monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {
namespace {

using spatial::CellIndex;

constexpr int kStartsAtOnce = 64;
constexpr int kLastMoves = 3;
constexpr int kDown = static_cast<int>(spatial::Action::kMinusZ);

Status check(const MonteCarloOptions& o) {
  if (!(o.epsilon >= 0.0 && o.epsilon <= 1.0)) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("epsilon is {}, but must lie in 0 … 1", o.epsilon));
  }
  if (o.runs < 1 || o.runs > 100'000) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} runs were asked for; 1 … 100,000 are possible", o.runs));
  }
  if (o.max_steps < 0) return fail(ErrorCode::kInvalidArgument, "the number of steps is negative");
  if (o.threads < 1 || o.threads > 64) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} threads were asked for; 1 … 64 are possible", o.threads));
  }
  return {};
}

/// What all rollouts share.
struct Board {
  std::vector<std::uint8_t> policy;
  std::vector<std::uint8_t> allowed;
  std::array<std::int32_t, spatial::kActionCount> stride;
  std::int32_t goal;
  int max_steps;
  double epsilon;
};

int random_action(unsigned allowed, Random& random) {
  auto nth = static_cast<int>(random.below(static_cast<std::uint32_t>(std::popcount(allowed))));
  int action = 0;
  for (;; ++action) {
    if ((allowed >> action & 1U) != 0 && nth-- == 0) return action;
  }
}

struct Outcome {
  bool arrived = false;
  bool from_above = false;
  int steps = 0;
};

Outcome roll(const Board& board, std::int32_t cell, Random& random) {
  int down = 0;  // how many of the last moves were
  for (int step = 0;; ++step) {
    if (cell == board.goal) return {true, down >= kLastMoves, step};
    const auto s = static_cast<std::size_t>(cell);
    if (step == board.max_steps || board.policy[s] == kNoAction) return {};
    const bool errs = board.epsilon > 0.0 && random.uniform() < board.epsilon;
    const int action = errs ? random_action(board.allowed[s], random) : board.policy[s];
    down = action == kDown ? down + 1 : 0;
    cell += board.stride[static_cast<std::size_t>(action)];
  }
}

void roll_start(const Board& board, std::size_t i, MonteCarlo& result) {
  Random random = Random(result.options.seed).child(static_cast<std::uint64_t>(result.starts[i].value));
  for (int run = 0; run < result.options.runs; ++run) {
    const Outcome outcome = roll(board, result.starts[i].value, random);
    if (!outcome.arrived) continue;
    ++result.arrived[i];
    result.steps[i] += outcome.steps;
    result.from_above[i] += outcome.from_above ? 1 : 0;
  }
}

}  // namespace

Result<MonteCarlo> monte_carlo(const Model& model, const std::vector<CellIndex>& starts,
                               const MonteCarloOptions& options, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(options));
  const int max_steps = options.max_steps > 0 ? options.max_steps : 10 * model.grid.n;
  const Board board{
      greedy_policy(model), allowed_moves(model.grid, model.safe), strides(model.grid), model.goal.value, max_steps,
      options.epsilon};
  MonteCarlo result;
  result.options = options;
  result.starts = starts;
  result.arrived.assign(starts.size(), 0);
  result.steps.assign(starts.size(), 0);
  result.from_above.assign(starts.size(), 0);
  const int count = static_cast<int>(starts.size());
  const auto one = [&](int i) {
    roll_start(board, static_cast<std::size_t>(i), result);
    if (i % kStartsAtOnce == 0) progress.set(static_cast<double>(i) / count);
  };
  result.finished = parallel_for(count, options.threads, kStartsAtOnce, one, [&] { return progress.cancelled(); });
  return result;
}

Field success_share(const spatial::Grid& grid, const MonteCarlo& result) {
  Field field;
  field.layer = Layer::kBasin;
  field.grid = grid;
  field.values.assign(static_cast<std::size_t>(grid.cell_count()), std::numeric_limits<double>::quiet_NaN());
  field.title = fmt::format("Share that arrives, \u03b5 = {:g}, {} runs each", result.options.epsilon, result.runs());
  for (std::size_t i = 0; i < static_cast<std::size_t>(result.finished); ++i) {
    field.values[static_cast<std::size_t>(result.starts[i].value)] =
        static_cast<double>(result.arrived[i]) / result.runs();
  }
  return field;
}

}  // namespace trocar::learning
