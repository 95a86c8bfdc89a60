/// What is shown of trials that are being run: the blocks, where they stand, what came of them so far.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/trial/protocol.h"
#include "engine/workbench/command.h"

namespace trocar::workbench {

enum class TrialsPhase : std::uint8_t {
  kReady,    ///< The next block waits to be started.
  kRunning,  ///< A transfer goes on.
  kPaused,   ///< Between two transfers.
  kResting,  ///< After a block.
  kDone,     ///< All blocks are over.
  kWaiting,  ///< For the console, which is to begin the transfer.
};
std::string_view to_string(TrialsPhase phase);

/// How the console over TCP stands.
struct ConsoleView {
  std::uint16_t port = 0;
  bool there = false;
  std::string peer;          ///< Who it is, or was last.
  bool scripted = false;     ///< It says that no person moves its hands.
  bool one_clock = false;    ///< Its clock is ours: `delay_p95_s` is known.
  double delay_p95_s = 0.0;  ///< From sent to taken in.
  double rtt_p95_s = 0.0;    ///< There and back.
  std::int64_t frames = 0;
  std::int64_t lost = 0;       ///< That never came.
  std::int64_t malformed = 0;  ///< That were none.
};

struct TrialsView {
  StartTrials request;
  std::string protocol;  ///< Its name; "" of a single block.
  std::vector<trial::ProtocolBlock> blocks;
  TrialsPhase phase = TrialsPhase::kReady;
  int block = 0;     ///< That runs or is next.
  int transfer = 0;  ///< Of the block, from 0.
  int successes = 0;
  int drops = 0;
  double block_s = 0.0;  ///< Time of transfers in this block, simulated.
  double rest_s = 0.0;   ///< After the block that was last.
  double rest_left_s = 0.0;
  bool paused = false;  ///< No further transfer begins by itself.
  std::optional<ConsoleView> console;
};

}  // namespace trocar::workbench
