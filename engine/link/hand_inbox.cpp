#include "engine/link/hand_inbox.h"

#include <algorithm>

namespace trocar::link {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000'000 / Tick::kPerSecond;
/// Whoever counts in larger steps has not lost as many.
constexpr std::uint64_t kMostCounted = 1'000'000;

}  // namespace

void HandInbox::put(const ArrivedFrame& arrived) {
  const HandFrame& frame = arrived.frame;
  const bool goes_on = any_ && arrived.connection == connection_;
  if (goes_on && frame.sequence <= newest_.sequence) {
    ++dropped_;
    return;
  }
  if (goes_on) {
    lost_ += static_cast<std::int64_t>(std::min(frame.sequence - newest_.sequence - 1, kMostCounted));
    // Up and down again, or down and up, between two frames: the count of presses tells. What was let go must be seen.
    const auto let_go = [](bool before, bool now, std::uint32_t count_before, std::uint32_t count) {
      return before && now && count != count_before;
    };
    HandFrame up = frame;
    const bool agent = let_go(newest_.agent_pedal, frame.agent_pedal, newest_.agent_presses, frame.agent_presses);
    const bool clutch = let_go(newest_.clutch_pedal, frame.clutch_pedal, newest_.clutch_presses, frame.clutch_presses);
    if (agent) up.agent_pedal = false;
    if (clutch) up.clutch_pedal = false;
    if (agent || clutch) add(up);
    const std::uint32_t told = frame.agent_pedal && (agent || !newest_.agent_pedal) ? 1 : 0;
    const std::uint32_t presses = frame.agent_presses - newest_.agent_presses;
    if (presses > told && presses < kMostCounted) unseen_presses_ += presses - told;
  }
  connection_ = arrived.connection;
  newest_ = frame;
  any_ = true;
  add(frame);
}

void HandInbox::add(const HandFrame& frame) {
  if (waiting_.size() == kMostWaiting) {
    waiting_.pop_front();
    ++dropped_;
  }
  waiting_.push_back(frame);
}

bool HandInbox::changes_pedal(const HandFrame& frame) const {
  return frame.agent_pedal != taken_.agent_pedal || frame.clutch_pedal != taken_.clutch_pedal;
}

std::optional<trial::HandSample> HandInbox::take() {
  if (waiting_.empty()) return std::nullopt;
  bool changed = false;
  while (!waiting_.empty() && !changed) {
    changed = any_taken_ && changes_pedal(waiting_.front());
    taken_ = waiting_.front().sample();
    assistant_ = waiting_.front().assistant_sample();
    any_taken_ = true;
    waiting_.pop_front();
  }
  return taken_;
}

std::optional<trial::HandSample> HandInbox::take_pedal() {
  // Poses before the change are passed over.
  while (!waiting_.empty() && any_taken_) {
    if (changes_pedal(waiting_.front())) return take();
    if (waiting_.size() == 1) return std::nullopt;
    waiting_.pop_front();
  }
  return std::nullopt;
}

void HandInbox::pass_over() {
  waiting_.clear();
  if (!any_) return;
  taken_ = newest_.sample();
  assistant_ = newest_.assistant_sample();
  any_taken_ = true;
}

void LinkWatchdog::heard(std::int64_t at_ns, bool present) {
  heard_ns_ = at_ns;
  present_ = present;
  any_ = true;
}

trial::LinkState LinkWatchdog::state(Tick now, std::int64_t now_ns, bool connected) const {
  trial::LinkState state;
  state.connected = connected && any_;
  state.present = present_;
  const std::int64_t age = age_ns(now_ns);
  state.stamp = Tick{now.count - (age > 0 ? age / kTick_ns : 0)};
  return state;
}

}  // namespace trocar::link
