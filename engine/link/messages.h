/// What console and workbench tell each other, and how it looks on the wire (hand.proto).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "engine/core/result.h"
#include "engine/spatial/pose.h"
#include "engine/trial/operator_input.h"

namespace trocar::link {

constexpr std::uint32_t kVersion = 1;

/// Both ways, first of all.
struct Hello {
  std::uint32_t version = kVersion;
  std::string name;
  std::string clock_id;
  bool scripted = false;  ///< No person moves these hands: never to be passed off as one's.
  bool operator==(const Hello&) const = default;
};

struct OneHand {
  spatial::Pose X_DH;
  double grip_rad = 0.0;
  bool operator==(const OneHand&) const = default;
};

/// Both hands and pedals at one instant, console to workbench.
struct HandFrame {
  std::uint64_t sequence = 0;  ///< From 1, each one more than the last.
  std::int64_t sent_ns = 0;    ///< By the console's monotonic clock.
  OneHand left;
  OneHand right;
  bool agent_pedal = false;
  std::uint32_t agent_presses = 0;  ///< Edges so far.
  bool clutch_pedal = false;
  std::uint32_t clutch_presses = 0;
  bool present = true;      ///< Somebody is at the controller.
  std::int64_t rtt_ns = 0;  ///< Of the last answer; 0: none yet.
  bool operator==(const HandFrame&) const = default;

  /// The left hand and the pedals are the operator's, the right hand may be an assistant's.
  trial::HandSample sample() const { return {left.X_DH, left.grip_rad, agent_pedal, clutch_pedal}; }
  trial::HandSample assistant_sample() const { return {right.X_DH, right.grip_rad, false, false}; }
};

/// The answer to each frame.
struct Ack {
  std::uint64_t sequence = 0;
  std::int64_t sent_ns = 0;
  std::int64_t remote_ns = 0;
  std::string authority;
  std::int64_t delay_ns = -1;  ///< −1: the clocks differ.
  bool operator==(const Ack&) const = default;
};

using Message = std::variant<Hello, HandFrame, Ack>;

/// With its length in front of it: what goes over the wire. Precondition: strings of at most 200 bytes.
std::string encode(const Message& message);
/// Of one packet without its length. Errors: kCorrupt in a sentence: what is no message, poses that are not finite or
/// farther than 10 m, rotations that are none (guard rule 11), grips beyond ±π.
Result<Message> decode(std::string_view packet);

/// "…" that two programs share exactly if they share a monotonic clock: the boot of the machine; "" if unknown.
std::string clock_id();
/// Nanoseconds of the monotonic clock.
std::int64_t monotonic_ns();

}  // namespace trocar::link
