#include "engine/simulation/physics.h"

namespace trocar::simulation {

Physics make_physics() {
  Physics physics;
  physics.stepper = make_ode_stepper();
  physics.contacts.reset(dJointGroupCreate(0));
  physics.board = make_board();
  for (Block& block : physics.blocks) block = make_block(physics.world());
  for (Gripper& gripper : physics.grippers) gripper = make_gripper(physics.world());
  return physics;
}

}  // namespace trocar::simulation
