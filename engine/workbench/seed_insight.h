/// The selected model beside trainings that differ from it in their seed alone: how much of what it shows is chance.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/learning/seed_study.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct SeedRequest {
  std::shared_ptr<const ModelEntry> entry;  ///< Null: nothing is asked.
  learning::Layer layer = learning::Layer::kReward;
  int count = 0;  ///< Of seeds, from the model's own on; at least 2.
};

/// As `trocar model seeds` and `trocar model explore` say it of the same demonstrations.
struct SeedInsight {
  SeedRequest of;
  std::string error;                            ///< Why there is nothing else here.
  std::shared_ptr<const learning::Field> mean;  ///< Of `of.layer`, over the seeds.
  std::shared_ptr<const learning::Field> spread;
  std::vector<learning::SeedResult> seeds;
  learning::EpsilonStudy exploration;  ///< The paper's section V.A, with the same seeds.
  std::vector<std::string> findings;   ///< What of it holds.
};

/// The study that is asked for; null where nothing is. Works for as long as its trainings take.
std::shared_ptr<const SeedInsight> seed_insight(const SeedRequest& request);

}  // namespace trocar::workbench
