/// The console's end of the TCP link.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/link/delay_figures.h"
#include "engine/link/messages.h"

namespace trocar::link {

struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
};
/// "127.0.0.1:5005", "[::1]:5005". Errors: kInvalidArgument.
Result<Endpoint> endpoint_from(std::string_view text);

/// Threads: one at a time.
class HandClient {
 public:
  /// Greets; waits for the connection as long as the system does. Errors: kIo.
  static Result<HandClient> connect(const Endpoint& to, const std::string& name, bool scripted);
  ~HandClient();
  HandClient(HandClient&&) noexcept;
  HandClient& operator=(HandClient&&) noexcept;

  /// Sends it with the next number and the time of now, and takes in what answers have come. Never waits: what the
  /// network does not take at once goes out first the next time.
  /// Errors: kIo once the connection is lost, or a megabyte waits; kCorrupt for answers that are none; kUnsupported for
  /// a workbench of another version. The client is then of no more use.
  Status send(HandFrame frame);
  /// Takes in what answers have come. Errors: as of `send`.
  Status poll();
  /// Writes what waits and takes in answers until that to the last frame has come, for at most so long. True if it
  /// came.
  bool settle(double patience_s);

  std::uint64_t sent() const;
  std::uint64_t answered() const;
  /// There and back, by this clock.
  const DelayFigures& round_trips() const;
  /// From sent to taken in, where both ends share a clock.
  const DelayFigures& delays() const;
  /// The newest answer.
  const Ack& ack() const;

 private:
  struct Impl;
  explicit HandClient(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::link
