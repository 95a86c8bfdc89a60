#include "engine/trial/hand_line.h"

#include <algorithm>
#include <cmath>

namespace trocar::trial {

void HandLine::send(const HandSample& sample, Tick now) {
  const double arrives_s = delay_.arrival_s(now.seconds());
  // To the next whole tick; what took no time arrives at once.
  const auto ticks = static_cast<std::int64_t>(std::ceil(arrives_s * Tick::kPerSecond - 1e-6));
  under_way_.push_back({sample, now, Tick{std::max(ticks, now.count)}});
}

bool HandLine::receive(Tick now) {
  bool got = false;
  while (!under_way_.empty() && under_way_.front().arrives <= now) {
    const Message& message = under_way_.front();
    newest_ = message.sample;
    arrived_ = message.arrives;
    last_delay_s_ = Tick{message.arrives.count - message.sent.count}.seconds();
    sum_delay_s_ += last_delay_s_;
    worst_delay_s_ = std::max(worst_delay_s_, last_delay_s_);
    ++count_;
    got = any_ = true;
    under_way_.pop_front();
  }
  return got;
}

}  // namespace trocar::trial
