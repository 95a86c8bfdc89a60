/// The agent: what it learned of a segment, where its lattice lies now, and the motion from cell to cell.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/control/glide.h"
#include "engine/demonstration/recording.h"
#include "engine/learning/model.h"

namespace trocar::trial {

/// To what the lattice is fixed: to the board, as in the paper, or to the target, so that the model's goal lies at the
/// block of this trial (A) wherever that is.
enum class Anchor : std::uint8_t { kBoard, kTarget };
std::string_view to_string(Anchor anchor);

struct AgentModel {
  std::shared_ptr<const learning::Model> model;
  std::string name;
  demonstration::Segment segment = demonstration::Segment::kA;
  /// Where the lattice lies, from where it was when the model was learned; metres in W.
  Eigen::Vector3d shift_W{0.0, 0.0, 0.0};
};

/// By how much the lattice has to be moved so that what was learned at one block serves another (segment A; elsewhere
/// nothing, as the hand-off is where it was). Preconditions: 0 ≤ blocks < 6.
Eigen::Vector3d target_shift(demonstration::Segment segment, int learned_at_block, int block);

/// One cell at a time along the greedy policy, inside the safe set. Threads: one at a time.
class Agent {
 public:
  enum class State : std::uint8_t {
    kIdle,
    kMoving,
    kArrived,  ///< At the goal, at rest.
    kLoops,    ///< It came where it had been: it rests there.
    kStuck,    ///< The policy knows no move: likewise.
  };

  /// `rate_hz`: cells a second; precondition: 1 … 100.
  Agent(AgentModel model, double rate_hz);

  const AgentModel& model() const { return model_; }
  State state() const { return state_; }
  /// Why it knows nothing to do with the tip there; "" if it does. Metres in W.
  std::string cannot_begin(const Eigen::Vector3d& p_W) const;
  bool safe(const Eigen::Vector3d& p_W) const;

  /// Takes over the tool where it is and as it moves. Precondition: `cannot_begin` is "".
  void begin(const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W);
  /// Where the tip is to be after `seconds` more. Precondition: begun.
  Eigen::Vector3d advance(double seconds);
  void end() { glide_.reset(), state_ = State::kIdle; }
  /// Cells that it has led through since it began.
  int steps() const { return steps_; }

 private:
  Eigen::Vector3d centre(spatial::CellIndex cell) const;
  /// The next cell of the way; where it ends the last one again.
  spatial::CellIndex next_cell();

  AgentModel model_;
  double rate_hz_;
  std::vector<std::uint8_t> policy_;
  State state_ = State::kIdle;
  State ends_as_ = State::kMoving;  ///< What it will be once it has come to rest.
  spatial::CellIndex cell_;         ///< The last that was handed to the glide.
  spatial::CellSet seen_;
  std::optional<control::Glide> glide_;
  int steps_ = 0;
};

}  // namespace trocar::trial
