/// A network's delay between console and workbench, made by ourselves: a TCP relay that lets each packet wait.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/control/delay_model.h"
#include "engine/core/result.h"
#include "engine/link/hand_client.h"
#include "engine/link/relay_queue.h"

namespace trocar::link {

struct DelayRelayOptions {
  std::string address = "127.0.0.1";  ///< Where the console connects.
  std::uint16_t port = 0;             ///< 0: any that is free.
  Endpoint to;                        ///< The workbench.
  control::DelayOptions delay;        ///< From console to workbench; answers pass at once.
};

struct DelayRelayStatus {
  int connections = 0;
  std::int64_t relayed = 0;    ///< Packets from console to workbench.
  std::int64_t malformed = 0;  ///< Connections that a wrong length ended.
  DelayFigures applied;        ///< From received to let go.
  std::string last_trouble;
};

/// One connection at a time, in a thread of its own. Threads: any.
class DelayRelay {
 public:
  /// Errors: kIo where the port cannot be had; kInvalidArgument for what is no address.
  static Result<std::unique_ptr<DelayRelay>> start(const DelayRelayOptions& options);
  ~DelayRelay();

  std::uint16_t port() const;
  DelayRelayStatus status() const;
  /// Each packet that was let go so far, the first `RelayQueue::kLogged` of them.
  std::vector<RelayedPacket> log() const;
  /// Ends the connection that there is, as a cut cable would; the next one is relayed again.
  void cut();

 private:
  struct Impl;
  explicit DelayRelay(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// As lines of "number,received_s,delay_ms,applied_ms" under a header; the first packet is received at 0.
std::string to_csv(const std::vector<RelayedPacket>& log);

}  // namespace trocar::link
