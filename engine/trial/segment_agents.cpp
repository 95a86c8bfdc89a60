#include "engine/trial/segment_agents.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/check.h"

namespace trocar::trial {

using demonstration::Segment;

SegmentAgents::SegmentAgents(const TrialOptions& options) : mode_(options.mode) {
  for (const AgentModel& model : options.agents) agents_.emplace_back(model, options.agent_rate_hz);
}

const Agent* SegmentAgents::of(Segment segment) const {
  const auto found = std::find_if(agents_.begin(), agents_.end(),
                                  [segment](const Agent& agent) { return agent.model().segment == segment; });
  return found == agents_.end() ? nullptr : &*found;
}

std::string SegmentAgents::refusal(Segment segment, const Eigen::Vector3d& p_W) const {
  if (mode_ == Mode::kManual) return "this is a manual trial";
  const bool of_agent = segment == Segment::kA || segment == Segment::kC;
  if (!of_agent) return fmt::format("segment {} is the operator's", demonstration::letter(segment));
  const Agent* agent = of(segment);
  if (agent == nullptr) return fmt::format("there is no model of segment {}", demonstration::letter(segment));
  return agent->cannot_begin(p_W);
}

bool SegmentAgents::safe(Segment segment, const Eigen::Vector3d& p_W) const {
  const Agent* agent = of(segment);
  return agent == nullptr || agent->safe(p_W);
}

void SegmentAgents::begin(Segment segment, const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W) {
  const Agent* agent = of(segment);
  TROCAR_CHECK(agent != nullptr);
  driving_ = &agents_[static_cast<std::size_t>(agent - agents_.data())];
  driving_->begin(p_W, v_W);
}

void SegmentAgents::end() {
  if (driving_ == nullptr) return;
  steps_ += driving_->steps();
  driving_->end();
  driving_ = nullptr;
}

}  // namespace trocar::trial
