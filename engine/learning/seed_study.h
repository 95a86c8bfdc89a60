/// The same training with several seeds: how much of what was learned is chance; and the paper's section V.A with it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/learning/field.h"
#include "engine/learning/model.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {

struct SeedStudyOptions {
  std::uint64_t first_seed = 1;  ///< The seeds count up from it.
  int count = 20;                ///< 2 … 1000.
  int threads = 1;               ///< 1 … 64; the result does not depend on it.
};

/// What one training gave.
struct SeedResult {
  std::uint64_t seed = 0;
  Exploration exploration;
  RolloutSummary near;  ///< Of the starts within ± 3 cells.
  RolloutSummary all;
  double mismatch = 0.0;  ///< The last of the curve.
};

/// A layer over the seeds, cell by cell; of classes, the spread is the share that differs from the commonest one.
struct SeedStudy {
  std::vector<SeedResult> seeds;
  Field mean;    ///< Over the seeds that know the cell; of classes, the commonest.
  Field spread;  ///< Standard deviation, NaN where fewer than two know it.
};
/// Trains once for each seed. Errors: kInvalidArgument, also as `train`; kCancelled.
Result<SeedStudy> study_seeds(const spatial::Grid& grid, const std::vector<CellSequence>& experts,
                              const TrainOptions& options, Layer layer, const SeedStudyOptions& study,
                              Progress& progress);

/// ε against 0 for one seed.
struct EpsilonPair {
  SeedResult greedy;                   ///< ε = 0.
  SeedResult exploring;                ///< ε of the options.
  double fully_explored_change = 0.0;  ///< Relative: 0.45 is "+45 %"; NaN if there were none.
  double fully_unexplored_change = 0.0;
};

/// Section V.A of the paper: what ε does to the share of explored states. There +45 % fully explored and −34 % fully
/// unexplored, of one training; here over seeds.
struct EpsilonStudy {
  double epsilon = 0.1;
  std::vector<EpsilonPair> pairs;
  double explored_mean = 0.0;  ///< Of the relative changes.
  double explored_sd = 0.0;
  double unexplored_mean = 0.0;
  double unexplored_sd = 0.0;
  int explored_rose = 0;     ///< Seeds with more fully explored states.
  int unexplored_fell = 0;   ///< Seeds with fewer fully unexplored ones.
  double near_greedy = 0.0;  ///< Share that arrives from within ± 3 cells, mean over the seeds.
  double near_exploring = 0.0;
};
/// `options.method` is one that samples. Errors: as `study_seeds`.
Result<EpsilonStudy> study_epsilon(const spatial::Grid& grid, const std::vector<CellSequence>& experts,
                                   const TrainOptions& options, const SeedStudyOptions& study, Progress& progress);

/// What of section V.A holds on these demonstrations and what does not, each a sentence with its figures.
std::vector<std::string> findings(const EpsilonStudy& study);

}  // namespace trocar::learning
