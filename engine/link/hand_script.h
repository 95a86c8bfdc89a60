/// A hand that moves as a text says: for tests, and to try a link without a device.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/link/messages.h"

namespace trocar::link {

/// Minimum-jerk movements, which add up where they overlap, and pedals. Threads: any, once made.
class HandScript {
 public:
  struct Move {
    double at_s = 0.0;
    double over_s = 0.0;
    Eigen::Vector3d way_D{0.0, 0.0, 0.0};   ///< Metres.
    Eigen::Vector3d turn_D{0.0, 0.0, 0.0};  ///< Axis times angle, radians.
    double grip_rad = 0.0;                  ///< By so much more.
  };
  enum class Switch { kAgent, kClutch, kPresent };
  struct Press {
    double at_s = 0.0;
    Switch which = Switch::kAgent;
    bool down = false;
  };

  /// The left hand, pedals and presence at `t_s`; number and clock are the sender's.
  HandFrame at(double t_s) const;
  /// When it is over.
  double end_s() const { return end_s_; }

  const std::vector<Move>& moves() const { return moves_; }
  const std::vector<Press>& presses() const { return presses_; }

 private:
  friend Result<HandScript> parse_hand_script(std::string_view text);
  std::vector<Move> moves_;
  std::vector<Press> presses_;
  double end_s_ = 0.0;
};

/// One act a line, with the second at which it begins; `#` begins a remark. Metres, degrees and seconds, in the frame
/// of the display (x right, y up, z towards the operator):
///     0.5 agent down            1.2 agent up              2 clutch down
///     1.5 move 0.01 0 0 over 0.5                          2 turn 0 0 30 over 0.5
///     3 grip -20 over 0.3       4 away                    4.5 back              6 end
/// Times do not run backwards. The end, if none is said, is when the last act is over.
/// Errors: kInvalidArgument naming the line; no more than 10,000 acts, an hour, ±0.5 m and ±180° for each.
Result<HandScript> parse_hand_script(std::string_view text);

}  // namespace trocar::link
