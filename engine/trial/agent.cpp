#include "engine/trial/agent.h"

#include <array>
#include <utility>

#include "engine/core/check.h"
#include "engine/learning/rollout.h"

namespace trocar::trial {

using spatial::CellIndex;

std::string_view to_string(Anchor anchor) {
  return anchor == Anchor::kBoard ? "board" : "target";
}

Eigen::Vector3d target_shift(demonstration::Segment segment, int learned_at_block, int block) {
  if (segment != demonstration::Segment::kA) return Eigen::Vector3d::Zero();
  return peg_board::start_peg(block) - peg_board::start_peg(learned_at_block);
}

Agent::Agent(AgentModel model, double rate_hz)
    : model_(std::move(model)), rate_hz_(rate_hz), policy_(learning::greedy_policy(*model_.model)) {
  TROCAR_CHECK(rate_hz >= 1.0 && rate_hz <= 100.0);
}

Eigen::Vector3d Agent::centre(CellIndex cell) const {
  return model_.model->grid.centre(cell) + model_.shift_W;
}

bool Agent::safe(const Eigen::Vector3d& p_W) const {
  const Result<CellIndex> cell = model_.model->grid.cell_at(p_W - model_.shift_W);
  return cell && model_.model->safe.contains(*cell);
}

std::string Agent::cannot_begin(const Eigen::Vector3d& p_W) const {
  const Result<CellIndex> cell = model_.model->grid.cell_at(p_W - model_.shift_W);
  if (!cell) return "the tool is outside of the agent's lattice";
  if (!model_.model->safe.contains(*cell)) return "the tool is outside of the safe set";
  const bool knows = policy_[static_cast<std::size_t>(cell->value)] != learning::kNoAction;
  return knows || *cell == model_.model->goal ? "" : "the agent knows no move here";
}

CellIndex Agent::next_cell() {
  const learning::Model& model = *model_.model;
  if (ends_as_ != State::kMoving) return cell_;
  const std::uint8_t action = policy_[static_cast<std::size_t>(cell_.value)];
  if (cell_ == model.goal) {
    ends_as_ = State::kArrived;
  } else if (action == learning::kNoAction) {
    ends_as_ = State::kStuck;
  } else {
    const CellIndex next = *model.grid.neighbour(cell_, static_cast<spatial::Action>(action));
    if (seen_.contains(next)) {
      ends_as_ = State::kLoops;
    } else {
      seen_.insert(next);
      cell_ = next;
      ++steps_;
    }
  }
  return cell_;
}

void Agent::begin(const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W) {
  TROCAR_CHECK(cannot_begin(p_W).empty());
  cell_ = *model_.model->grid.cell_at(p_W - model_.shift_W);
  seen_ = spatial::CellSet(model_.model->grid);
  seen_.insert(cell_);
  steps_ = 0;
  state_ = State::kMoving;
  ends_as_ = State::kMoving;
  glide_.emplace(p_W, v_W, rate_hz_, centre(next_cell()));
}

Eigen::Vector3d Agent::advance(double seconds) {
  TROCAR_CHECK(glide_.has_value());
  if (glide_->wants_place()) glide_->add(centre(next_cell()));
  const Eigen::Vector3d p_W = glide_->advance(seconds);
  if (glide_->at_rest() && ends_as_ != State::kMoving) state_ = ends_as_;
  return p_W;
}

}  // namespace trocar::trial
