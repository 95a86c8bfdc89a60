/// A transfer by the scripted operators, recorded once for each choice of options.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "engine/demonstration/demonstration.h"
#include "engine/trial/transfer_session.h"
#include "tests/support/session_recording.h"

namespace trocar::testing {

inline demonstration::Demonstration transfer(std::uint64_t seed, int block = 0, int goal = 0) {
  static std::map<std::pair<std::uint64_t, int>, demonstration::Demonstration> known;
  const auto found = known.find({seed, 10 * block + goal});
  if (found != known.end()) return found->second;
  trial::TransferOptions options;
  options.seed = seed;
  options.block = block;
  options.goal = goal;
  trial::TransferSession session = trial::TransferSession::create(options).value();
  while (!session.done()) session.step();
  auto recording = std::make_shared<demonstration::Recording>(recording_of(session));
  const demonstration::Demonstration document =
      demonstration::make_demonstration({1}, "Transfer", std::move(recording)).value();
  known.emplace(std::pair{seed, 10 * block + goal}, document);
  return document;
}

}  // namespace trocar::testing
