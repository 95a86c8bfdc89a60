#include "engine/simulation/block.h"

#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

namespace trocar::simulation {
namespace {

using namespace peg_board;

constexpr double kWallLength_m = 0.0148;
constexpr double kCornerDepth_m = 0.00284;
constexpr double kCornerWidth_m = 0.0034;

/// A box `distance_m` from the block's axis, in the direction `angle_rad` about it.
OdeGeom add_box(dBodyID body, double angle_rad, double distance_m, double depth_m, double width_m) {
  OdeGeom box(dCreateBox(nullptr, depth_m * kOdeLength, width_m * kOdeLength, kBlockHeight_m * kOdeLength));
  dGeomSetBody(box.get(), body);
  const Eigen::Quaterniond q = spatial::about_z(angle_rad);
  const Eigen::Vector3d p = q * Eigen::Vector3d(distance_m * kOdeLength, 0.0, 0.0);
  const dQuaternion turn = {q.w(), q.x(), q.y(), q.z()};
  dGeomSetOffsetPosition(box.get(), p.x(), p.y(), p.z());
  dGeomSetOffsetQuaternion(box.get(), turn);
  return box;
}

/// Mass and inertia of the six boxes at even density, scaled to the block's mass. By symmetry its centre is K's origin.
dMass block_mass() {
  dMass total;
  dMassSetZero(&total);
  for (int i = 0; i < kWallCount; ++i) {
    const double wall = wall_angle(i);
    const double corner = wall + spatial::from_degrees(60.0);
    const auto add = [&total](double angle, double distance, double depth, double width) {
      dMass part;
      dMassSetBox(&part, 1.0, depth * kOdeLength, width * kOdeLength, kBlockHeight_m * kOdeLength);
      dMatrix3 R;
      dRFromAxisAndAngle(R, 0.0, 0.0, 1.0, angle);
      dMassRotate(&part, R);
      const Eigen::Vector3d p = spatial::about_z(angle) * Eigen::Vector3d(distance * kOdeLength, 0.0, 0.0);
      dMassTranslate(&part, p.x(), p.y(), p.z());
      dMassAdd(&total, &part);
    };
    add(wall, kHoleApothem_m + kWallThickness_m / 2.0, kWallThickness_m, kWallLength_m);
    add(corner, kHoleApothem_m + kCornerDepth_m / 2.0, kCornerDepth_m, kCornerWidth_m);
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
  for (int i = 0; i < kWallCount; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double wall = wall_angle(i);
    const double corner = wall + spatial::from_degrees(60.0);
    block.boxes[k] =
        add_box(block.body.get(), wall, kHoleApothem_m + kWallThickness_m / 2.0, kWallThickness_m, kWallLength_m);
    block.boxes[k + kWallCount] =
        add_box(block.body.get(), corner, kHoleApothem_m + kCornerDepth_m / 2.0, kCornerDepth_m, kCornerWidth_m);
  }
  return block;
}

}  // namespace trocar::simulation
