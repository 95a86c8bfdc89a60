#include "engine/workbench/seed_insight.h"

#include <utility>

namespace trocar::workbench {
namespace {

Status study(const SeedRequest& request, SeedInsight& insight) {
  const learning::Model& model = *request.entry->model;
  learning::SeedStudyOptions options;
  options.first_seed = model.options.seed;
  options.count = request.count;
  Progress progress;
  TROCAR_ASSIGN_OR_RETURN(learning::SeedStudy seeds, learning::study_seeds(model.grid, model.experts, model.options,
                                                                           request.layer, options, progress));
  insight.mean = std::make_shared<const learning::Field>(std::move(seeds.mean));
  insight.spread = std::make_shared<const learning::Field>(std::move(seeds.spread));
  insight.seeds = std::move(seeds.seeds);
  learning::TrainOptions exploring = model.options;
  // Beside a model that does not explore, what exploring would do.
  if (exploring.epsilon == 0.0) exploring.epsilon = learning::TrainOptions{}.epsilon;
  TROCAR_ASSIGN_OR_RETURN(insight.exploration,
                          learning::study_epsilon(model.grid, model.experts, exploring, options, progress));
  insight.findings = learning::findings(insight.exploration);
  return {};
}

}  // namespace

std::shared_ptr<const SeedInsight> seed_insight(const SeedRequest& request) {
  if (request.entry == nullptr || request.entry->model == nullptr || request.count == 0) return nullptr;
  auto insight = std::make_shared<SeedInsight>();
  insight->of = request;
  if (request.entry->model->options.method == learning::Method::kExact) {
    insight->error = "The exact method draws nothing at random: every seed gives this model";
    return insight;
  }
  if (const Status done = study(request, *insight); !done) insight->error = done.error().text();
  return insight;
}

}  // namespace trocar::workbench
