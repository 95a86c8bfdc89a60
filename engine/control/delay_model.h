/// The delay of a network as it is simulated: for trials in the simulator, and in the relay between console and arm.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/random.h"
#include "engine/core/result.h"

namespace trocar::control {

enum class DelayKind : std::uint8_t {
  kConstant,
  kNormal,
  kLogNormal,
  kAutoregressive,  ///< AR(1): one message's delay resembles the last one's, so that order raises the mean little.
  kTrace,           ///< Of a file, again and again.
};

struct DelayOptions {
  DelayKind kind = DelayKind::kConstant;
  double mean_s = 0.0;
  double deviation_s = 0.0;   ///< σ.
  double correlation = 0.95;  ///< φ of AR(1).
  double stall_chance = 0.0;  ///< Of each message: lost and sent again, everything behind it waits.
  double stall_s = 0.2;
  std::vector<double> trace_s;
  std::string file;  ///< Of the trace.
  std::uint64_t seed = 1;
  bool operator==(const DelayOptions&) const = default;
};

/// "40", "normal:20:5", "lognormal:20:5", "ar1:20:5", "trace:F.txt" (one number a line), each with ",stall:0.01:200" if
/// wanted; milliseconds. Errors: kInvalidArgument with what can be said; those of reading the file.
Result<DelayOptions> delay_from(std::string_view text);
std::string to_string(const DelayOptions& options);

/// Deterministic. Threads: one at a time.
class DelayModel {
 public:
  explicit DelayModel(DelayOptions options);
  /// Of the next message, sent at `sent_s`: when it arrives, never before the one ahead of it (one ordered stream).
  double arrival_s(double sent_s);

 private:
  double draw();

  DelayOptions options_;
  Random random_;
  double state_ = 0.0;  ///< Of AR(1), in σ.
  bool begun_ = false;
  std::size_t next_ = 0;
  double last_arrival_s_ = -1e300;
};

}  // namespace trocar::control
