/// What is asked for when trials are to be run: one block of a protocol, or one alone.
#pragma once

#include <string>
#include <vector>

#include "engine/trial/trial_options.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// Several transfers in a row by one mode: one block of a protocol.
struct TrialPlan {
  trial::TrialOptions options;  ///< Of every transfer; seed, block, goal and agents are found from what follows.
  /// Of A and C; those of a segment of which none is named are all that the project has.
  std::vector<ModelId> models;
  std::uint64_t seed = 1;  ///< Of the first transfer; the next ones count up.
  int first_block = 0;     ///< 0 … 5; the next transfer takes the next block, and its goal has the same number.
  int transfers = 1;
  bool same_block = false;  ///< Each transfer takes `first_block`.
  int threads = 1;          ///< The result does not depend on it.
  std::string subject;
  std::string session;
  int block_number = 0;
  bool in_results = true;  ///< Familiarisation is not.
};

}  // namespace trocar::workbench
