/// The delay of one ordered stream, without sockets and without a clock: who uses it says what time it is.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "engine/control/delay_model.h"
#include "engine/link/delay_figures.h"

namespace trocar::link {

/// A packet that has been through.
struct RelayedPacket {
  std::int64_t number = 0;  ///< From 0.
  std::int64_t received_ns = 0;
  std::int64_t due_ns = 0;     ///< As the model has it.
  std::int64_t passed_ns = 0;  ///< When it was let go.
};

/// In order, nothing lost. Deterministic: the same options, packets and times give the same log. Threads: one at a
/// time.
class RelayQueue {
 public:
  /// The log holds the first so many packets; the figures are of all.
  static constexpr std::size_t kLogged = 1'000'000;

  explicit RelayQueue(const control::DelayOptions& options) : delay_(options) {}

  /// Precondition: times never run backwards, from call to call of any function here.
  void push(std::string packet, std::int64_t now_ns);
  /// When the next packet is to be let go; nothing if none is held.
  std::optional<std::int64_t> due_ns() const;
  /// The next packet if it is due.
  std::optional<std::string> pop(std::int64_t now_ns);
  std::size_t held() const { return held_.size(); }
  /// The connection is new: what was under way is lost, and the delays go on.
  void clear() { held_.clear(); }

  const std::vector<RelayedPacket>& log() const { return log_; }
  /// The delay as it was applied: from received to passed.
  const DelayFigures& applied() const { return applied_; }

 private:
  struct Held {
    std::string packet;
    RelayedPacket entry;
  };
  control::DelayModel delay_;
  std::deque<Held> held_;
  std::vector<RelayedPacket> log_;
  DelayFigures applied_;
  std::int64_t next_number_ = 0;
};

}  // namespace trocar::link
