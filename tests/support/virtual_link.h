/// The TCP link without sockets and without a clock: an operator whose hand goes through packets, a relay's delay, the
/// reader and the inbox, in simulated time.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/link/frame_reader.h"
#include "engine/link/hand_inbox.h"
#include "engine/link/hand_script.h"
#include "engine/link/messages.h"
#include "engine/link/relay_queue.h"
#include "engine/trial/operator_input.h"

namespace trocar::testing {

/// A script as an operator at the arm itself.
class ScriptedHandInput final : public trial::OperatorInput {
 public:
  explicit ScriptedHandInput(link::HandScript script) : script_(std::move(script)) {}
  trial::HandSample sample(const simulation::WorldState& seen) override {
    return script_.at(seen.tick.seconds()).sample();
  }
  std::string_view name() const override { return "script"; }

 private:
  link::HandScript script_;
};

class VirtualLink final : public trial::OperatorInput {
 public:
  /// Nothing goes through from `from` to before `to`. `silent`: a cable that was pulled; nobody is told.
  struct Cut {
    Tick from{std::numeric_limits<std::int64_t>::max()};
    Tick to{std::numeric_limits<std::int64_t>::max()};
    bool silent = false;
  };

  VirtualLink(trial::OperatorInput& source, const control::DelayOptions& delay) : source_(&source), relay_(delay) {}

  Cut cut;

  trial::HandSample sample(const simulation::WorldState& seen) override {
    const trial::HandSample hand = source_->sample(seen);
    link::HandFrame frame;
    frame.sequence = ++sequence_;
    frame.sent_ns = ns(seen.tick);
    frame.left = {hand.X_DH, hand.grip_rad};
    presses_[0] += hand.agent_pedal && !last_sent_.agent_pedal ? 1 : 0;
    presses_[1] += hand.clutch_pedal && !last_sent_.clutch_pedal ? 1 : 0;
    last_sent_ = hand;
    frame.agent_pedal = hand.agent_pedal;
    frame.agent_presses = presses_[0];
    frame.clutch_pedal = hand.clutch_pedal;
    frame.clutch_presses = presses_[1];
    if (!is_cut(seen.tick)) relay_.push(encode(frame), ns(seen.tick));
    deliver(seen.tick);
    if (const auto next = inbox_.take()) last_ = *next;
    return last_;
  }

  std::optional<trial::HandSample> news(Tick now) override {
    deliver(now);
    const auto next = inbox_.take_pedal();
    if (next) last_ = *next;
    return next;
  }

  trial::LinkState link(Tick now) override {
    const bool there = (cut.silent || !is_cut(now)) && heard_connection_ == connection_;
    return watchdog_.state(now, ns(now), there);
  }

  std::string_view name() const override { return "virtual link"; }
  const link::RelayQueue& relay() const { return relay_; }
  const link::HandInbox& inbox() const { return inbox_; }

 private:
  static std::int64_t ns(Tick tick) { return tick.count * 1'000'000; }
  bool is_cut(Tick now) const { return now >= cut.from && now < cut.to; }

  void deliver(Tick now) {
    if (is_cut(now)) {
      relay_.clear();
      if (!cut.silent && connection_ == 1) {
        connection_ = 2;
        reader_ = {};
      }
      return;
    }
    while (const auto bytes = relay_.pop(ns(now))) {
      // As TCP would: in pieces of any size.
      for (std::size_t i = 0; i < bytes->size(); i += 7) {
        static_cast<void>(reader_.feed(std::string_view(*bytes).substr(i, 7)));
      }
      while (const auto packet = reader_.next()) {
        const auto message = link::decode(*packet);
        const auto& frame = std::get<link::HandFrame>(message.value());
        watchdog_.heard(ns(now), frame.present);
        heard_connection_ = connection_;
        inbox_.put({frame, ns(now), connection_});
      }
    }
  }

  trial::OperatorInput* source_;
  link::RelayQueue relay_;
  link::FrameReader reader_;
  link::HandInbox inbox_;
  link::LinkWatchdog watchdog_;
  trial::HandSample last_;
  trial::HandSample last_sent_;
  std::array<std::uint32_t, 2> presses_{};
  std::uint64_t sequence_ = 0;
  std::uint32_t connection_ = 1;
  std::uint32_t heard_connection_ = 0;
};

}  // namespace trocar::testing
