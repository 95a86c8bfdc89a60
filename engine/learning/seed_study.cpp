#include "engine/learning/seed_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "engine/core/parallel.h"
#include "engine/statistics/proportion.h"
#include "engine/statistics/summary.h"

namespace trocar::learning {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr int kNear = 3;
constexpr double kRobust = 0.9;  ///< Of the starts near the expert's have to arrive, to be called so.

Status check(const SeedStudyOptions& study) {
  if (study.count < 2 || study.count > 1000) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} seeds were asked for; 2 \u2026 1000 are possible", study.count));
  }
  if (study.threads < 1 || study.threads > 64) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} threads were asked for; 1 \u2026 64 are possible", study.threads));
  }
  return {};
}

SeedResult result_of(const Model& model) {
  SeedResult result;
  result.seed = model.options.seed;
  result.exploration = exploration(model);
  const Basin outcomes = basin(model, greedy_policy(model));
  std::vector<spatial::CellIndex> all(outcomes.end.size());
  for (std::size_t s = 0; s < all.size(); ++s) all[s].value = static_cast<std::int32_t>(s);
  result.all = summarise(outcomes, all);
  result.near = summarise(outcomes, starts_around(model, kNear));
  result.mismatch = model.curve.empty() ? 0.0 : model.curve.back();
  return result;
}

/// Trains `count` times; `made` takes each model in the thread that trained it.
Status train_all(const spatial::Grid& grid, const std::vector<CellSequence>& experts, int count, int threads,
                 const std::function<TrainOptions(int)>& options, const std::function<void(int, const Model&)>& made,
                 Progress& progress) {
  std::atomic<int> done{0};
  std::mutex guard;
  Status first_error;
  const auto one = [&](int i) {
    Progress own;  // Its fraction is of this training alone.
    const Result<Model> model = train(grid, experts, options(i), own);
    if (model) made(i, *model);
    progress.set(static_cast<double>(++done) / count);
    if (model) return;
    const std::lock_guard lock(guard);
    if (first_error) first_error = tl::unexpected(model.error());
  };
  const int finished = parallel_for(count, threads, 1, one, [&] { return progress.cancelled(); });
  TROCAR_RETURN_IF_ERROR(first_error);
  if (finished < count) return fail(ErrorCode::kCancelled, "the trainings were cancelled");
  return {};
}

/// The mean and the standard deviation of what is finite.
std::array<double, 2> moments(const std::vector<double>& values) {
  std::vector<double> finite;
  for (const double value : values) {
    if (std::isfinite(value)) finite.push_back(value);
  }
  return {statistics::mean(finite), statistics::standard_deviation(finite)};
}

/// The commonest class, the lower of two, and the share that is another.
std::array<double, 2> commonest(const std::vector<double>& values, std::size_t classes) {
  std::vector<int> counts(classes, 0);
  int known = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++counts[static_cast<std::size_t>(value)];
    ++known;
  }
  if (known == 0) return {kNoNumber, kNoNumber};
  const auto most = std::max_element(counts.begin(), counts.end());
  return {static_cast<double>(most - counts.begin()), 1.0 - static_cast<double>(*most) / known};
}

void summarise_layer(const std::vector<Field>& fields, SeedStudy& study) {
  study.mean = fields.front();
  study.spread = fields.front();
  study.mean.title += fmt::format(", mean of {} seeds", fields.size());
  study.spread.title += fields.front().categorical ? ", share of seeds that differ" : ", spread over the seeds";
  study.spread.categorical = false;
  study.spread.categories.clear();
  if (fields.front().categorical) {
    study.mean.title = fields.front().title + fmt::format(", commonest of {} seeds", fields.size());
    study.spread.unit.clear();
  }
  std::vector<double> values(fields.size());
  for (std::size_t s = 0; s < study.mean.values.size(); ++s) {
    for (std::size_t i = 0; i < fields.size(); ++i) values[i] = fields[i].values[s];
    const auto [mean, spread] =
        fields.front().categorical ? commonest(values, fields.front().categories.size()) : moments(values);
    study.mean.values[s] = mean;
    study.spread.values[s] = spread;
  }
}

double relative(int before, int after) {
  return before == 0 ? kNoNumber : static_cast<double>(after - before) / before;
}

double share(const RolloutSummary& summary) {
  return summary.count == 0 ? 0.0 : static_cast<double>(summary.arrived) / summary.count;
}

std::string percent(double ratio) {
  const double share = std::round(100.0 * ratio);
  if (share == 0.0) return "0 %";
  return fmt::format("{}{:.0f} %", share < 0.0 ? "\u2212" : "+", std::abs(share));
}

}  // namespace

Result<SeedStudy> study_seeds(const spatial::Grid& grid, const std::vector<CellSequence>& experts,
                              const TrainOptions& options, Layer layer, const SeedStudyOptions& study,
                              Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(study));
  SeedStudy result;
  result.seeds.resize(static_cast<std::size_t>(study.count));
  std::vector<Field> fields(result.seeds.size());
  const auto seeded = [&](int i) {
    TrainOptions own = options;
    own.seed = study.first_seed + static_cast<std::uint64_t>(i);
    return own;
  };
  const auto take = [&](int i, const Model& model) {
    result.seeds[static_cast<std::size_t>(i)] = result_of(model);
    fields[static_cast<std::size_t>(i)] = field(model, layer);
  };
  TROCAR_RETURN_IF_ERROR(train_all(grid, experts, study.count, study.threads, seeded, take, progress));
  summarise_layer(fields, result);
  return result;
}

Result<EpsilonStudy> study_epsilon(const spatial::Grid& grid, const std::vector<CellSequence>& experts,
                                   const TrainOptions& options, const SeedStudyOptions& study, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(study));
  if (!is_sampled(options.method) || !(options.epsilon > 0.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "exploration is compared of a method that samples, with an epsilon above 0");
  }
  EpsilonStudy result;
  result.epsilon = options.epsilon;
  result.pairs.resize(static_cast<std::size_t>(study.count));
  const auto seeded = [&](int i) {
    TrainOptions own = options;
    own.seed = study.first_seed + static_cast<std::uint64_t>(i / 2);
    own.epsilon = i % 2 == 0 ? 0.0 : options.epsilon;
    return own;
  };
  const auto take = [&](int i, const Model& model) {
    EpsilonPair& pair = result.pairs[static_cast<std::size_t>(i / 2)];
    (i % 2 == 0 ? pair.greedy : pair.exploring) = result_of(model);
  };
  TROCAR_RETURN_IF_ERROR(train_all(grid, experts, 2 * study.count, study.threads, seeded, take, progress));
  std::vector<double> explored;
  std::vector<double> unexplored;
  for (EpsilonPair& pair : result.pairs) {
    const Exploration& before = pair.greedy.exploration;
    const Exploration& after = pair.exploring.exploration;
    pair.fully_explored_change = relative(before.fully_explored, after.fully_explored);
    pair.fully_unexplored_change = relative(before.fully_unexplored, after.fully_unexplored);
    explored.push_back(pair.fully_explored_change);
    unexplored.push_back(pair.fully_unexplored_change);
    result.explored_rose += after.fully_explored > before.fully_explored ? 1 : 0;
    result.unexplored_fell += after.fully_unexplored < before.fully_unexplored ? 1 : 0;
    result.near_greedy += share(pair.greedy.near) / study.count;
    result.near_exploring += share(pair.exploring.near) / study.count;
  }
  const auto [explored_mean, explored_sd] = moments(explored);
  const auto [unexplored_mean, unexplored_sd] = moments(unexplored);
  result.explored_mean = explored_mean;
  result.explored_sd = explored_sd;
  result.unexplored_mean = unexplored_mean;
  result.unexplored_sd = unexplored_sd;
  return result;
}

std::vector<std::string> findings(const EpsilonStudy& study) {
  const int count = static_cast<int>(study.pairs.size());
  const auto more = [](const EpsilonPair& pair) { return pair.exploring.near.arrived > pair.greedy.near.arrived; };
  const auto nearer = std::count_if(study.pairs.begin(), study.pairs.end(), more);
  const auto verdict = [count](int agreeing) {
    return agreeing == count ? "Holds" : agreeing == 0 ? "Does not hold" : "Holds in part";
  };
  return {
      fmt::format("{}: more states are fully explored with \u03b5 = {:g} than with 0 ({} of {} seeds; {} on average, "
                  "standard deviation {:.0f} points; the paper: +45 %)",
                  verdict(study.explored_rose), study.epsilon, study.explored_rose, count, percent(study.explored_mean),
                  100.0 * study.explored_sd),
      fmt::format(
          "{}: fewer states are fully unexplored ({} of {} seeds; {} on average, standard deviation {:.0f} points; "
          "the paper: \u221234 %)",
          verdict(study.unexplored_fell), study.unexplored_fell, count, percent(study.unexplored_mean),
          100.0 * study.unexplored_sd),
      fmt::format("{}: exploring makes the agent robust to other starts (within \u00b13 cells {} arrive with "
                  "\u03b5 = {:g} and {} with 0, more in {} of {} seeds; robust would be {:.0f} %)",
                  study.near_exploring > kRobust ? "Holds" : "Does not hold",
                  statistics::share_text(study.near_exploring, 0), study.epsilon,
                  statistics::share_text(study.near_greedy, 0), nearer, count, 100.0 * kRobust)};
}

}  // namespace trocar::learning
