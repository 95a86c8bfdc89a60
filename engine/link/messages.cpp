#include "engine/link/messages.h"

#include <link/hand.pb.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/core/file.h"
#include "engine/link/frame_reader.h"

namespace trocar::link {
namespace {

constexpr double kFarthest_m = 10.0;
constexpr double kUnit = 1e-6;

void put(const OneHand& hand, wire::Hand& out) {
  for (int i = 0; i < 3; ++i) out.add_p(hand.X_DH.p[i]);
  const Eigen::Quaterniond& q = hand.X_DH.q;
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) out.add_q_wxyz(part);
  out.set_grip_rad(hand.grip_rad);
}

std::optional<OneHand> get(const wire::Hand& in) {
  if (in.p_size() != 3 || in.q_wxyz_size() != 4) return std::nullopt;
  OneHand hand;
  hand.X_DH.p = {in.p(0), in.p(1), in.p(2)};
  hand.X_DH.q = Eigen::Quaterniond(in.q_wxyz(0), in.q_wxyz(1), in.q_wxyz(2), in.q_wxyz(3));
  hand.grip_rad = in.grip_rad();
  const bool placed = hand.X_DH.finite() && hand.X_DH.p.cwiseAbs().maxCoeff() <= kFarthest_m;
  const bool turned = placed && std::abs(hand.X_DH.q.norm() - 1.0) <= kUnit;
  if (!turned || !(std::abs(hand.grip_rad) <= std::numbers::pi)) return std::nullopt;
  return hand;
}

void put(const Hello& hello, wire::Packet& packet) {
  wire::Hello& out = *packet.mutable_hello();
  out.set_version(hello.version);
  out.set_name(hello.name);
  out.set_clock_id(hello.clock_id);
  out.set_scripted(hello.scripted);
}

void put(const HandFrame& frame, wire::Packet& packet) {
  wire::HandFrame& out = *packet.mutable_hand();
  out.set_sequence(frame.sequence);
  out.set_sent_ns(frame.sent_ns);
  put(frame.left, *out.mutable_left());
  put(frame.right, *out.mutable_right());
  out.set_agent_pedal(frame.agent_pedal);
  out.set_agent_presses(frame.agent_presses);
  out.set_clutch_pedal(frame.clutch_pedal);
  out.set_clutch_presses(frame.clutch_presses);
  out.set_present(frame.present);
  out.set_rtt_ns(frame.rtt_ns);
}

void put(const Ack& ack, wire::Packet& packet) {
  wire::Ack& out = *packet.mutable_ack();
  out.set_sequence(ack.sequence);
  out.set_sent_ns(ack.sent_ns);
  out.set_remote_ns(ack.remote_ns);
  out.set_authority(ack.authority);
  out.set_delay_ns(ack.delay_ns);
}

Result<Message> frame_from(const wire::HandFrame& in) {
  const auto left = get(in.left());
  const auto right = get(in.right());
  if (!left || !right) return fail(ErrorCode::kCorrupt, "a hand's pose that is none");
  HandFrame frame;
  frame.sequence = in.sequence();
  frame.sent_ns = in.sent_ns();
  frame.left = *left;
  frame.right = *right;
  frame.agent_pedal = in.agent_pedal();
  frame.agent_presses = in.agent_presses();
  frame.clutch_pedal = in.clutch_pedal();
  frame.clutch_presses = in.clutch_presses();
  frame.present = in.present();
  frame.rtt_ns = in.rtt_ns();
  return frame;
}

}  // namespace

std::string encode(const Message& message) {
  wire::Packet packet;
  std::visit([&packet](const auto& each) { put(each, packet); }, message);
  return with_length(packet.SerializeAsString());
}

Result<Message> decode(std::string_view bytes) {
  wire::Packet packet;
  if (!packet.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    return fail(ErrorCode::kCorrupt, "a packet that is no message");
  }
  switch (packet.body_case()) {
    case wire::Packet::kHello:
      return Hello{packet.hello().version(), packet.hello().name(), packet.hello().clock_id(),
                   packet.hello().scripted()};
    case wire::Packet::kHand:
      return frame_from(packet.hand());
    case wire::Packet::kAck: {
      const wire::Ack& ack = packet.ack();
      return Ack{ack.sequence(), ack.sent_ns(), ack.remote_ns(), ack.authority(), ack.delay_ns()};
    }
    default:
      return fail(ErrorCode::kCorrupt, "a packet without a message");
  }
}

std::string clock_id() {
  const auto text = read_file("/proc/sys/kernel/random/boot_id");
  return text ? text->substr(0, text->find('\n')) : std::string();
}

std::int64_t monotonic_ns() {
  // On Linux std::chrono::steady_clock is CLOCK_MONOTONIC, the same for every process.
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace trocar::link
