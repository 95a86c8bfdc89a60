// What goes over the wire: packets cut out of a stream, messages to the bit, and what is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/link/frame_reader.h"
#include "engine/link/hand_client.h"
#include "engine/link/messages.h"

using namespace trocar;
using namespace trocar::link;

namespace {

HandFrame some_frame() {
  HandFrame frame;
  frame.sequence = 7;
  frame.sent_ns = 1'234'567'890'123;
  frame.left.X_DH.p = {0.1, -0.2, 1.0 / 3.0};
  frame.left.X_DH.q = Eigen::Quaterniond(0.3, -0.4, 0.5, 0.7).normalized();
  frame.left.grip_rad = -0.123456789;
  frame.right.X_DH.p = {1e-9, 2.0, -3.0};
  frame.agent_pedal = true;
  frame.agent_presses = 3;
  frame.clutch_presses = 2;
  frame.present = false;
  frame.rtt_ns = 250'000;
  return frame;
}

Result<Message> through(const Message& message) {
  FrameReader reader;
  REQUIRE(reader.feed(encode(message)));
  return decode(reader.next().value());
}

bool refuses(const HandFrame& frame) {
  const auto got = through(frame);
  return !got && got.error().code() == ErrorCode::kCorrupt;
}

}  // namespace

TEST_CASE("a message comes through to the bit") {
  CHECK(std::get<HandFrame>(through(some_frame()).value()) == some_frame());
  CHECK(std::get<HandFrame>(through(HandFrame{}).value()) == HandFrame{});
  const Hello hello{1, "console", "boot", true};
  CHECK(std::get<Hello>(through(hello).value()) == hello);
  const Ack ack{9, 5, 6, "agent", -1};
  CHECK(std::get<Ack>(through(ack).value()) == ack);
}

TEST_CASE("a pose that is none is refused (rule 11)") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool left : {true, false}) {
    for (int wrong = 0; wrong < 6; ++wrong) {
      HandFrame frame = some_frame();
      OneHand& hand = left ? frame.left : frame.right;
      if (wrong == 0) hand.X_DH.p.y() = nan;
      if (wrong == 1) hand.X_DH.p.x() = 10.5;
      if (wrong == 2) hand.X_DH.q.coeffs() *= 1.001;
      if (wrong == 3) hand.X_DH.q.coeffs().setZero();
      if (wrong == 4) hand.grip_rad = std::numeric_limits<double>::infinity();
      if (wrong == 5) hand.X_DH.q.x() = nan;
      CAPTURE(wrong);
      CHECK(refuses(frame));
    }
  }
}

TEST_CASE("what is no message is refused") {
  CHECK_FALSE(decode(""));
  CHECK_FALSE(decode("hello there"));
  const std::string whole = encode(some_frame()).substr(kLengthBytes);
  int accepted = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) accepted += decode(whole.substr(0, size)) ? 1 : 0;
  CHECK(accepted == 0);
}

TEST_CASE("packets come out of a stream whole and in order, however it is cut") {
  Random random(3);
  std::string stream;
  std::vector<std::string> sent;
  for (int i = 0; i < 300; ++i) {
    sent.emplace_back(1 + random.below(i % 20 == 0 ? 4096 : 60), static_cast<char>('a' + i % 26));
    stream += with_length(sent.back());
  }
  for (const std::uint32_t largest : {1U, 3U, 50U, 5000U}) {
    FrameReader reader;
    std::vector<std::string> got;
    for (std::size_t begin = 0; begin < stream.size();) {
      const std::size_t size = 1 + random.below(largest);
      REQUIRE(reader.feed(std::string_view(stream).substr(begin, size)));
      begin += size;
      while (auto packet = reader.next()) got.push_back(std::move(*packet));
      CHECK(reader.waiting() <= kLongestPacket + kLengthBytes);
    }
    CHECK(got == sent);
    CHECK(reader.waiting() == 0);
  }
}

TEST_CASE("a wrong length is refused at once and ends the stream") {
  for (const std::string& wrong :
       {std::string("\0\0\0\0", 4), std::string("\0\0\x10\x01", 4), std::string("\xFF\xFF\xFF\xFF", 4)}) {
    FrameReader reader;
    const Status fed = reader.feed(with_length("good") + wrong);
    REQUIRE_FALSE(fed);
    CHECK(fed.error().code() == ErrorCode::kCorrupt);
    CHECK(reader.next() == "good");
    CHECK_FALSE(reader.next());
    CHECK(reader.broken());
    CHECK_FALSE(reader.feed(with_length("more")));
    CHECK_FALSE(reader.next());
  }
  FrameReader reader;
  CHECK(reader.feed(with_length(std::string(kLongestPacket, 'x'))));
  CHECK(reader.next()->size() == kLongestPacket);
}

TEST_CASE("a place in the network is a host and a port") {
  CHECK(endpoint_from("127.0.0.1:5005")->host == "127.0.0.1");
  CHECK(endpoint_from("127.0.0.1:5005")->port == 5005);
  CHECK(endpoint_from("[::1]:80")->host == "::1");
  for (const char* wrong : {"", ":", "host", "host:", ":5", "host:0", "host:65536", "host:5x", "host:-1"}) {
    CAPTURE(wrong);
    CHECK_FALSE(endpoint_from(wrong));
  }
}

TEST_CASE("programs of one machine share a clock") {
  CHECK(clock_id().size() == 36);
  CHECK(clock_id() == clock_id());
  const std::int64_t before = monotonic_ns();
  CHECK(monotonic_ns() >= before);
}
