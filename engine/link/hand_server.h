/// The workbench's end of the TCP link: a hand controller somewhere else as the operator of a trial.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/control/authority.h"
#include "engine/core/result.h"
#include "engine/trial/operator_input.h"

namespace trocar::link {

struct HandServerOptions {
  std::string address = "127.0.0.1";  ///< "0.0.0.0": from any machine.
  std::uint16_t port = 0;             ///< 0: any that is free.
};

struct HandServerStatus {
  bool connected = false;
  std::string peer;            ///< Who is connected, or was last: name and address.
  bool scripted = false;       ///< A console that was taken said that no person moves its hands.
  int connections = 0;         ///< So far.
  int refused = 0;             ///< Who came while another was connected, or of another version.
  std::int64_t frames = 0;     ///< Taken in.
  std::int64_t malformed = 0;  ///< No message, a pose that is none, a wrong length (guard rule 11).
  std::int64_t dropped = 0;    ///< Out of order, or nobody took them.
  std::int64_t lost = 0;       ///< Gaps in the sequence.
  std::int64_t unseen_presses = 0;
  bool one_clock = false;    ///< Console and workbench share a clock: `delay_…` are known.
  double delay_p50_s = 0.0;  ///< From sent to taken in, of the newest 4096.
  double delay_p95_s = 0.0;
  double delay_mean_s = 0.0;  ///< Of all, as the next.
  double delay_worst_s = 0.0;
  double rtt_p50_s = 0.0;  ///< There and back, as the console measured it.
  double rtt_p95_s = 0.0;
  std::string last_trouble;  ///< Why the last connection ended; "" if the console closed it.
};

/// One console at a time; one that is silent for 2 s makes way for another. The network has a thread of its own, which
/// the control loop never waits for. Threads: `sample`, `news`, `link`, `arrived`, `pass_over`, `begin_anew` and those
/// of the assistant by one, the control loop's while it runs; `status` and `tell` by any.
class HandServer final : public trial::OperatorInput {
 public:
  /// Errors: kIo where the address or port cannot be had; kInvalidArgument for what is no address.
  static Result<std::unique_ptr<HandServer>> listen(const HandServerOptions& options);
  ~HandServer() override;

  std::uint16_t port() const;
  HandServerStatus status() const;

  /// A hand has come, and its console is still there.
  bool arrived();
  /// Seconds since a frame was last taken in; large if none ever was.
  double silent_s();
  /// Between two transfers: what came is gone by, and is of neither.
  void pass_over();
  /// Before a transfer: the same, and delays are those of what comes from now on.
  void begin_anew();
  /// What the answers to the console say of who has the arm.
  void tell(control::ControlState state);

  trial::HandSample sample(const simulation::WorldState& seen) override;
  std::optional<trial::HandSample> news(Tick now) override;
  trial::LinkState link(Tick now) override;
  std::string_view name() const override { return "TCP hand controller"; }
  /// The right hand at the same console, for the right arm; it is as fresh as the left. Asked after the operator's.
  trial::OperatorInput& assistant();

 private:
  struct Impl;
  explicit HandServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::link
