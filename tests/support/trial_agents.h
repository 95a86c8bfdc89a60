/// Agents of segments A and C as a lab would train them: exact models of a scripted expert's transfer of a block.
#pragma once

#include <memory>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/discretise.h"
#include "engine/learning/model.h"
#include "engine/trial/agent.h"
#include "engine/trial/transfer_session.h"

namespace trocar::testing {

inline demonstration::Demonstration scripted_transfer(int block) {
  trial::TransferOptions options;
  options.block = options.goal = block;
  auto session = trial::TransferSession::create(options).value();
  auto recording = std::make_shared<demonstration::Recording>();
  recording->provenance = session.provenance();
  while (!session.done()) session.step();
  recording->samples = session.take_samples();
  return demonstration::make_demonstration({1}, "Expert", std::shared_ptr<const demonstration::Recording>(recording))
      .value();
}

/// Of A and C, in this order.
inline std::vector<trial::AgentModel> agents_for(int block) {
  const demonstration::Demonstration shown = scripted_transfer(block);
  std::vector<trial::AgentModel> agents;
  for (const auto segment : {demonstration::Segment::kA, demonstration::Segment::kC}) {
    learning::TrainOptions options;
    options.method = learning::Method::kExact;
    const spatial::Grid grid;
    Progress progress;
    auto model =
        learning::train(grid, {demonstration::discretise(shown, segment, grid).value().cells}, options, progress);
    agents.push_back({std::make_shared<const learning::Model>(std::move(model.value())),
                      segment == demonstration::Segment::kA ? "A exact" : "C exact",
                      segment,
                      {0.0, 0.0, 0.0}});
  }
  return agents;
}

}  // namespace trocar::testing
