#include "engine/simulation/block.h"

#include "engine/simulation/shapes.h"
#include "engine/spatial/rotation.h"

namespace trocar::simulation {
namespace {

using namespace peg_board;

OdeGeom add_box(dBodyID body, const BlockBox& part) {
  OdeGeom box(dCreateBox(nullptr, part.depth_m * kOdeLength, part.width_m * kOdeLength, kBlockHeight_m * kOdeLength));
  dGeomSetBody(box.get(), body);
  const Eigen::Quaterniond q = spatial::about_z(part.angle_rad);
  const Eigen::Vector3d p = q * Eigen::Vector3d(part.distance_m * kOdeLength, 0.0, 0.0);
  const dQuaternion turn = {q.w(), q.x(), q.y(), q.z()};
  dGeomSetOffsetPosition(box.get(), p.x(), p.y(), p.z());
  dGeomSetOffsetQuaternion(box.get(), turn);
  return box;
}

/// Mass and inertia of the six boxes at even density, scaled to the block's mass. By symmetry its centre is K's origin.
dMass block_mass() {
  dMass total;
  dMassSetZero(&total);
  const auto boxes = block_boxes();
  // Each wall with the corner beside it: the order of the sum decides its last bits.
  for (std::size_t i = 0; i < kWallCount; ++i) {
    for (const BlockBox* box : {&boxes[i], &boxes[i + kWallCount]}) {
      dMass part;
      dMassSetBox(&part, 1.0, box->depth_m * kOdeLength, box->width_m * kOdeLength, kBlockHeight_m * kOdeLength);
      dMatrix3 R;
      dRFromAxisAndAngle(R, 0.0, 0.0, 1.0, box->angle_rad);
      dMassRotate(&part, R);
      const Eigen::Vector3d p =
          spatial::about_z(box->angle_rad) * Eigen::Vector3d(box->distance_m * kOdeLength, 0.0, 0.0);
      dMassTranslate(&part, p.x(), p.y(), p.z());
      dMassAdd(&total, &part);
    }
  }
  dMassAdjust(&total, kBlockMass_kg * kOdeMass);
  // What rounding leaves of the centre must be nothing: ODE wants it in the body's origin.
  dMassTranslate(&total, -total.c[0], -total.c[1], -total.c[2]);
  return total;
}

}  // namespace

Block make_block(dWorldID world) {
  Block block;
  block.body.reset(dBodyCreate(world));
  dBodySetFiniteRotationMode(block.body.get(), 1);
  const dMass mass = block_mass();
  dBodySetMass(block.body.get(), &mass);
  const auto boxes = block_boxes();
  for (std::size_t i = 0; i < kWallCount; ++i) {
    for (const std::size_t k : {i, i + kWallCount}) block.boxes[k] = add_box(block.body.get(), boxes[k]);
  }
  return block;
}

}  // namespace trocar::simulation
