#include "engine/link/relay_queue.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::link {

void RelayQueue::push(std::string packet, std::int64_t now_ns) {
  const double arrives_s = delay_.arrival_s(static_cast<double>(now_ns) * 1e-9);
  RelayedPacket entry;
  entry.number = next_number_++;
  entry.received_ns = now_ns;
  entry.due_ns = std::max(now_ns, static_cast<std::int64_t>(std::llround(arrives_s * 1e9)));
  held_.push_back({std::move(packet), entry});
}

std::optional<std::int64_t> RelayQueue::due_ns() const {
  if (held_.empty()) return std::nullopt;
  return held_.front().entry.due_ns;
}

std::optional<std::string> RelayQueue::pop(std::int64_t now_ns) {
  if (held_.empty() || held_.front().entry.due_ns > now_ns) return std::nullopt;
  Held front = std::move(held_.front());
  held_.pop_front();
  front.entry.passed_ns = now_ns;
  applied_.add(static_cast<double>(now_ns - front.entry.received_ns) * 1e-9);
  if (log_.size() < kLogged) log_.push_back(front.entry);
  return std::move(front.packet);
}

}  // namespace trocar::link
