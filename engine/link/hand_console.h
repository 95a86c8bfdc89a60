/// What a console does: sends a hand's poses and pedals at its rate, and comes back when the connection was lost.
#pragma once

#include <functional>
#include <string>

#include "engine/core/progress.h"
#include "engine/link/hand_client.h"

namespace trocar::link {

struct HandConsoleOptions {
  Endpoint to;
  std::string name;
  bool scripted = false;                  ///< No person moves the hands.
  double rate_hz = 200.0;                 ///< 1 … 2000.
  double seconds = 0.0;                   ///< For so long; positive.
  double patience_s = 5.0;                ///< How long it tries to get a connection, at the beginning and after a loss.
  std::function<HandFrame(double)> hand;  ///< At so many seconds since the first connection.
};

struct HandConsoleReport {
  double seconds = 0.0;
  std::int64_t sent = 0;
  std::int64_t answered = 0;
  int connections = 0;
  DelayFigures round_trips;
  DelayFigures delays;    ///< From sent to taken in, where both ends share a clock.
  std::string authority;  ///< Who had the arm, by the last answer.
  std::string ended;      ///< Why it ended before its time; "" if it did not.
};

/// Ends after its time, when it is cancelled, or once a connection that was lost does not come back. The progress is
/// the share of its time. Errors: kInvalidArgument for a rate or time out of range; kIo if there never was a
/// connection; kUnsupported for a workbench of another version.
Result<HandConsoleReport> run_hand_console(const HandConsoleOptions& options, Progress& progress);

}  // namespace trocar::link
