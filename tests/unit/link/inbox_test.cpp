// Which frame is gone by, how fresh the link is, what the relay does to a stream, and the figures of all that: without
// sockets and without a clock.
#include <doctest/doctest.h>

#include <vector>

#include "engine/link/hand_inbox.h"
#include "engine/link/relay_queue.h"
#include "engine/link/tick_pacer.h"

using namespace trocar;
using namespace trocar::link;

namespace {

ArrivedFrame frame(std::uint64_t sequence, bool agent = false, std::uint32_t presses = 0,
                   std::uint32_t connection = 1) {
  ArrivedFrame arrived;
  arrived.frame.sequence = sequence;
  arrived.frame.left.X_DH.p.x() = 0.001 * static_cast<double>(sequence);
  arrived.frame.agent_pedal = agent;
  arrived.frame.agent_presses = presses;
  arrived.connection = connection;
  return arrived;
}

double x_of(const std::optional<trial::HandSample>& sample) {
  return sample ? 1000.0 * sample->X_DH.p.x() : -1.0;
}

control::DelayOptions jitter(std::uint64_t seed) {
  control::DelayOptions options;
  options.kind = control::DelayKind::kAutoregressive;
  options.mean_s = 0.020;
  options.deviation_s = 0.005;
  options.stall_chance = 0.01;
  options.stall_s = 0.2;
  options.seed = seed;
  return options;
}

/// 200 Hz for ten seconds, looked at every millisecond.
std::vector<RelayedPacket> relayed(const control::DelayOptions& options) {
  RelayQueue queue(options);
  std::int64_t passed = 0;
  for (std::int64_t tick = 0; tick < 11'000; ++tick) {
    const std::int64_t now_ns = tick * 1'000'000;
    if (tick < 10'000 && tick % 5 == 0) queue.push("packet " + std::to_string(tick / 5), now_ns);
    while (const auto packet = queue.pop(now_ns)) CHECK(*packet == "packet " + std::to_string(passed++));
  }
  CHECK(passed == 2000);
  CHECK(queue.held() == 0);
  return queue.log();
}

}  // namespace

TEST_CASE("poses are passed over for the newest, pedals never") {
  HandInbox inbox;
  CHECK_FALSE(inbox.take());
  for (const auto& each : {frame(1), frame(2), frame(3)}) inbox.put(each);
  CHECK(x_of(inbox.take()) == doctest::Approx(3));
  CHECK_FALSE(inbox.take());
  // A tap between two looks: down, and up, one after the other.
  for (const auto& each : {frame(4), frame(5, true, 1), frame(6, false, 1), frame(7, false, 1)}) inbox.put(each);
  const auto down = inbox.take_pedal();
  CHECK(x_of(down) == doctest::Approx(5));
  CHECK(down->agent_pedal);
  const auto up = inbox.take_pedal();
  CHECK(x_of(up) == doctest::Approx(6));
  CHECK_FALSE(up->agent_pedal);
  CHECK_FALSE(inbox.take_pedal());
  CHECK(x_of(inbox.take()) == doctest::Approx(7));
  CHECK(inbox.dropped() == 0);
  CHECK(inbox.lost() == 0);
  CHECK(inbox.unseen_presses() == 0);
}

TEST_CASE("a pedal that was let go and pressed between two frames is let go") {
  HandInbox inbox;
  inbox.put(frame(1));
  inbox.put(frame(2, true, 1));
  CHECK_FALSE(inbox.take()->agent_pedal == false);
  inbox.put(frame(3, true, 2));
  CHECK_FALSE(inbox.take_pedal()->agent_pedal);
  CHECK(inbox.take_pedal()->agent_pedal);
  CHECK(inbox.unseen_presses() == 0);
  inbox.put(frame(4, false, 4));
  CHECK_FALSE(inbox.take()->agent_pedal);
  CHECK(inbox.unseen_presses() == 2);
}

TEST_CASE("what is out of order is dropped, gaps are counted, and a new connection counts anew") {
  HandInbox inbox;
  inbox.put(frame(5));
  inbox.put(frame(5));
  inbox.put(frame(4));
  CHECK(inbox.dropped() == 2);
  inbox.put(frame(9));
  CHECK(inbox.lost() == 3);
  inbox.put(frame(1, true, 0, 2));
  CHECK(inbox.dropped() == 2);
  CHECK(inbox.lost() == 3);
  CHECK(inbox.take()->agent_pedal);
  for (std::uint64_t i = 2; i < 2 + HandInbox::kMostWaiting + 10; ++i) inbox.put(frame(i, true, 0, 2));
  CHECK(inbox.dropped() == 12);
  CHECK(x_of(inbox.take()) == doctest::Approx(static_cast<double>(HandInbox::kMostWaiting + 11)));
}

TEST_CASE("the watchdog tells the age of what was heard in the session's ticks") {
  LinkWatchdog watchdog;
  CHECK_FALSE(watchdog.state(Tick{50}, 0, true).connected);
  watchdog.heard(1'000'000'000, true);
  trial::LinkState state = watchdog.state(Tick{50}, 1'000'900'000, true);
  CHECK(state.connected);
  CHECK(state.present);
  CHECK(state.stamp == Tick{50});
  state = watchdog.state(Tick{150}, 1'120'000'000, true);
  CHECK(state.stamp == Tick{30});
  // The session's clock may stand still; the age goes on.
  CHECK(watchdog.state(Tick{50}, 1'120'000'000, true).stamp == Tick{-70});
  CHECK_FALSE(watchdog.state(Tick{150}, 1'120'000'000, false).connected);
  watchdog.heard(1'130'000'000, false);
  CHECK_FALSE(watchdog.state(Tick{160}, 1'130'000'000, true).present);
}

TEST_CASE("the relay keeps the order, and the same seed gives the same log") {
  const auto log = relayed(jitter(5));
  const auto again = relayed(jitter(5));
  const auto other = relayed(jitter(6));
  REQUIRE(log.size() == again.size());
  bool same = true;
  bool same_as_other = true;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto equal = [&log, i](const RelayedPacket& b) {
      return log[i].number == b.number && log[i].received_ns == b.received_ns && log[i].due_ns == b.due_ns &&
             log[i].passed_ns == b.passed_ns;
    };
    same = same && equal(again[i]);
    same_as_other = same_as_other && equal(other[i]);
    CHECK(log[i].passed_ns >= log[i].due_ns);
    CHECK(log[i].due_ns >= log[i].received_ns);
    if (i > 0) CHECK(log[i].due_ns >= log[i - 1].due_ns);
  }
  CHECK(same);
  CHECK_FALSE(same_as_other);
}

TEST_CASE("a constant delay lets each packet wait as long, and none lets none wait") {
  control::DelayOptions options;
  for (const auto& each : relayed(options)) CHECK(each.passed_ns == each.received_ns);
  options.mean_s = 0.040;
  for (const auto& each : relayed(options)) CHECK(each.passed_ns == each.received_ns + 40'000'000);
}

TEST_CASE("the figures of delays are those of the list") {
  DelayFigures figures;
  CHECK(figures.quantile_s(0.5) == 0.0);
  CHECK(figures.mean_s() == 0.0);
  for (int i = 100; i >= 1; --i) figures.add(0.001 * i);
  CHECK(figures.quantile_s(0.50) == doctest::Approx(0.050));
  CHECK(figures.quantile_s(0.95) == doctest::Approx(0.095));
  CHECK(figures.quantile_s(1.0) == doctest::Approx(0.100));
  CHECK(figures.mean_s() == doctest::Approx(0.0505));
  CHECK(figures.worst_s() == doctest::Approx(0.100));
  for (std::size_t i = 0; i < DelayFigures::kKept; ++i) figures.add(0.002);
  CHECK(figures.quantile_s(1.0) == doctest::Approx(0.002));
  CHECK(figures.worst_s() == doctest::Approx(0.100));
}

TEST_CASE("late ticks are counted by how late they were") {
  LatenessHistogram histogram;
  for (const std::int64_t late_us : {0, 50, 51, 999, 1000, 1500, 20'000}) histogram.add(1000 * late_us);
  CHECK(histogram.ticks() == 7);
  CHECK(histogram.counts()[0] == 2);
  CHECK(histogram.counts()[1] == 1);
  CHECK(histogram.counts()[4] == 2);
  CHECK(histogram.counts()[5] == 1);
  CHECK(histogram.counts().back() == 1);
  CHECK(histogram.missed() == 3);
  CHECK(histogram.worst_ns() == 20'000'000);
  CHECK(histogram.text().find("up to 50 us") != std::string::npos);
}

TEST_CASE("a pacer's deadlines do not drift") {
  TickPacer pacer;
  const std::int64_t begin_ns = monotonic_ns();
  for (int i = 0; i < 20; ++i) pacer.wait();
  // Never early; how late is the machine's affair.
  CHECK(monotonic_ns() - begin_ns >= 19'000'000);
  CHECK(pacer.lateness().ticks() == 20);
}

TEST_CASE("what is passed over is gone by, pedals too, and what comes after it is new") {
  HandInbox inbox;
  inbox.pass_over();
  CHECK_FALSE(inbox.taken());
  for (const auto& each : {frame(1), frame(2, true, 1), frame(3, false, 1), frame(4, true, 2)}) inbox.put(each);
  inbox.pass_over();
  REQUIRE(inbox.taken());
  CHECK(inbox.taken()->agent_pedal);
  CHECK_FALSE(inbox.take());
  CHECK_FALSE(inbox.take_pedal());
  inbox.put(frame(5, false, 2));
  const auto up = inbox.take_pedal();
  REQUIRE(up);
  CHECK_FALSE(up->agent_pedal);
  CHECK(inbox.dropped() == 0);
}
