#include "engine/learning/model.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "engine/core/hash.h"
#include "engine/learning/eg_maxent.h"
#include "engine/learning/exact_maxent.h"
#include "engine/learning/training_input.h"

namespace trocar::learning {
namespace {

constexpr std::array<std::string_view, 4> kMethodNames{"eg-maxent", "eg-maxent+", "exact", "imported"};
constexpr std::array<std::string_view, 3> kPresetNames{"paper", "product", "exact"};

template <typename T>
void hash_numbers(Hasher& hasher, const std::vector<T>& numbers) {
  hasher.value(numbers.size());
  hasher.bytes(std::as_bytes(std::span<const T>(numbers)));
}

void hash_options(Hasher& hasher, const TrainOptions& o) {
  hasher.value(o.method).value(o.theta_rate).value(o.q_rate).value(o.discount).value(o.epsilon).value(o.episodes);
  hasher.value(o.seed).value(o.safe_radius).value(o.start_spread).value(o.theta_prior).value(o.regularisation);
}

}  // namespace

std::string_view to_string(Method method) {
  return kMethodNames[static_cast<std::size_t>(method)];
}

Result<Method> method_from(std::string_view text) {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    if (text == to_string(method)) return method;
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("\"{}\" is no learning method: use eg-maxent, eg-maxent+ or exact", text));
}

bool is_sampled(Method method) {
  return method == Method::kEgMaxent || method == Method::kEgMaxentPlus;
}

std::string_view to_string(Preset preset) {
  return kPresetNames[static_cast<std::size_t>(preset)];
}

Result<Preset> preset_from(std::string_view text) {
  for (std::size_t i = 0; i < kPresetNames.size(); ++i) {
    if (text == kPresetNames[i]) return static_cast<Preset>(i);
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no preset: use paper, product or exact", text));
}

TrainOptions options_of(Preset preset, int cells) {
  constexpr std::array kMethods{Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact};
  TrainOptions options;
  options.method = kMethods[static_cast<std::size_t>(preset)];
  const double finer = static_cast<double>(cells) / spatial::Grid{}.n;
  options.safe_radius = static_cast<int>(std::lround(options.safe_radius * finer));
  options.start_spread = static_cast<int>(std::lround(options.start_spread * finer));
  return options;
}

std::uint64_t Model::hash() const {
  Hasher hasher;
  hash_options(hasher, options);
  for (int i = 0; i < 3; ++i) hasher.value(grid.p_WGo[i]);
  hasher.value(grid.cell_m).value(grid.n).value(experts.size());
  for (const CellSequence& cells : experts) {
    hasher.value(cells.size());
    for (const spatial::CellIndex cell : cells) hasher.value(cell.value);
  }
  hasher.value(start.value).value(goal.value);
  hash_numbers(hasher, safe.flags());
  hash_numbers(hasher, theta);
  hash_numbers(hasher, q);
  hash_numbers(hasher, value);
  hash_numbers(hasher, visits);
  hash_numbers(hasher, tried);
  hash_numbers(hasher, curve);
  return hasher.digest();
}

Result<Model> train(const spatial::Grid& grid, const std::vector<CellSequence>& experts, const TrainOptions& options,
                    Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check_training(grid, experts, options));
  if (options.method == Method::kImported) {
    return fail(ErrorCode::kInvalidArgument, "an imported model was learned elsewhere and cannot be trained");
  }
  const auto begin = std::chrono::steady_clock::now();
  Model model = untrained_model(grid, experts, options);
  const Status trained =
      options.method == Method::kExact ? solve_exact(model, nullptr, progress) : train_eg_maxent(model, progress);
  TROCAR_RETURN_IF_ERROR(trained);
  model.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  progress.set(1.0);
  return model;
}

Result<Model> train_warm(const Model& previous, const std::vector<CellSequence>& experts, const TrainOptions& options,
                         Progress& progress) {
  if (options.method != Method::kExact || previous.options.method != Method::kExact) {
    return train(previous.grid, experts, options, progress);
  }
  TROCAR_RETURN_IF_ERROR(check_training(previous.grid, experts, options));
  const auto begin = std::chrono::steady_clock::now();
  Model model = untrained_model(previous.grid, experts, options);
  TROCAR_RETURN_IF_ERROR(solve_exact(model, &previous, progress));
  model.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  progress.set(1.0);
  return model;
}

Exploration exploration(const Model& model) {
  Exploration counts;
  for (std::size_t cell = 0; cell < model.tried.size(); ++cell) {
    if (static_cast<std::int32_t>(cell) == model.goal.value) continue;
    constexpr std::uint8_t kAllActions = (1U << spatial::kActionCount) - 1;
    const std::uint8_t tried = model.tried[cell];
    if (tried == kAllActions) {
      ++counts.fully_explored;
    } else if (tried == 0) {
      ++counts.fully_unexplored;
    } else {
      ++counts.partly_explored;
    }
  }
  return counts;
}

}  // namespace trocar::learning
