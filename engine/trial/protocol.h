/// A study's protocol as data: blocks of transfers in an order, with their limits and rests (paper, IV-C).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/trial/trial_options.h"

namespace trocar::trial {

/// Some transfers in a row by one mode.
struct ProtocolBlock {
  std::string name;          ///< "Familiarisation, manual".
  std::string instructions;  ///< What the subject reads.
  Mode mode = Mode::kManual;
  bool counts = true;  ///< Familiarisation does not.
  /// The block ends at the first of those that there are; at least one is.
  std::optional<double> time_s;
  std::optional<int> transfers;
  std::optional<int> successes;
  double rest_s = 0.0;      ///< After it.
  std::string delay = "0";  ///< As `control::delay_from` reads it.
};

/// What follows after `fixed` blocks is one group of blocks for each mode; which group comes first is balanced.
struct Protocol {
  std::string name;
  std::string about;
  std::vector<ProtocolBlock> blocks;
  int fixed = 0;              ///< So many blocks come first, in this order, for everybody.
  double transfer_s = 120.0;  ///< The longest that a transfer may take.
};

/// The blocks as a subject has them: those of manual control first for every other subject, by number (from 0) and the
/// study's seed; the fixed ones stay.
std::vector<ProtocolBlock> order_for(const Protocol& protocol, int subject_number, std::uint64_t seed);
/// A block is over after so many transfers, successes and seconds of it.
bool block_over(const ProtocolBlock& block, int transfers, int successes, double elapsed_s);

/// Errors: kCorrupt naming the member that makes no sense.
Result<Protocol> protocol_from_json(std::string_view text);
std::string to_json(const Protocol& protocol);

/// "sim" and "dvrk" are the paper's, which ship (assets/protocols); anything else is a file's name.
/// Errors: those of reading; kCorrupt.
Result<Protocol> find_protocol(const std::string& name);

}  // namespace trocar::trial
