/// A person at keys, mouse, gamepad or SpaceMouse as the operator of a trial, or as its assistant: events in, a hand on
/// its controller out.
#pragma once

#include <atomic>
#include <string>

#include "engine/core/spsc_queue.h"
#include "engine/trial/hand_event.h"
#include "engine/trial/operator_input.h"
#include "engine/trial/tool_hand.h"

namespace trocar::trial {

/// What drives the tool drives a hand that is `scale` times as slow, so that mapping, clutch and hand-over are those of
/// any other hand. While the agent has the arm the hand goes along with the tool. Threads: `post` in the interface's,
/// `sample` in the simulation's.
class EventOperator final : public OperatorInput {
 public:
  /// Of the tool of `side`, which is at `start`; the pedals are those of who has the left one. `name`: of the devices.
  EventOperator(kinematics::ArmSide side, const control::ToolCommand& start, double scale,
                std::string name = "keyboard and mouse");

  /// Takes effect with the next sample. False if so much waits already that it was dropped.
  bool post(const HandEvent& event) { return events_.push(HandEvent(event)); }

  HandSample sample(const simulation::WorldState& seen) override;
  /// The hand as it was, with the pedals as they are, if one has changed since.
  std::optional<HandSample> news(Tick now) override;
  std::string_view name() const override { return name_; }

 private:
  void take_events();

  kinematics::ArmSide side_;
  double scale_;
  std::string name_;
  spatial::Pose start_;
  ToolHand hand_;
  bool agent_pedal_ = false;
  bool clutch_ = false;
  HandSample last_;
  SpscQueue<HandEvent> events_{1024};
};

}  // namespace trocar::trial
