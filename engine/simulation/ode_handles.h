/// ODE inside this module: owners of its handles, its units, and its library-wide set-up.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "engine/spatial/pose.h"

namespace trocar::simulation {

// ODE works in centimetres, grams and seconds here: blocks of 2 g and 10 mm then give numbers near one, which its
// absolute tolerances expect. Everything that enters or leaves ODE passes through these factors.
constexpr double kOdeLength = 100.0;                                           ///< ODE lengths in a metre.
constexpr double kOdeMass = 1000.0;                                            ///< ODE masses in a kilogram.
constexpr double kOdeStiffness = kOdeMass;                                     ///< For N/m, and N·s/m.
constexpr double kOdeTorsionalStiffness = kOdeMass * kOdeLength * kOdeLength;  ///< For N·m/rad, and N·m·s/rad.

template <typename Handle, auto destroy>
struct HandleDeleter {
  void operator()(std::remove_pointer_t<Handle>* handle) const { destroy(handle); }
};
template <typename Handle, auto destroy>
using OdeOwner = std::unique_ptr<std::remove_pointer_t<Handle>, HandleDeleter<Handle, destroy>>;

using OdeWorld = OdeOwner<dWorldID, dWorldDestroy>;
using OdeBody = OdeOwner<dBodyID, dBodyDestroy>;
using OdeGeom = OdeOwner<dGeomID, dGeomDestroy>;
using OdeJoint = OdeOwner<dJointID, dJointDestroy>;
using OdeJointGroup = OdeOwner<dJointGroupID, dJointGroupDestroy>;
using OdeThreading = OdeOwner<dThreadingImplementationID, dThreadingFreeImplementation>;

/// Initialises ODE once for the process and allocates its data for the calling thread; cheap when done before.
/// Every thread calls it before it touches a world. Threads: any.
void prepare_ode_for_this_thread();

/// How often ODE complained in the calling thread so far ("LCP internal error" and its kin).
std::int64_t ode_complaints_in_this_thread();

/// A world that computes in the calling thread only, with the task's contact parameters.
struct OdeStepper {
  OdeThreading threading;  ///< Destroyed after the world that uses it.
  OdeWorld world;
};
OdeStepper make_ode_stepper();

inline Eigen::Vector3d from_ode(const dReal* v) {
  return Eigen::Vector3d(v[0], v[1], v[2]) / kOdeLength;
}
/// The pose of a body, in SI.
spatial::Pose pose_of(dBodyID body);
/// Puts a body at a pose, in SI. The velocity stays.
void set_pose(dBodyID body, const spatial::Pose& X_WB);
/// Gives a body the constant velocity that takes its origin from one pose to the other in `duration_s`.
void set_motion(dBodyID body, const spatial::Pose& from, const spatial::Pose& to, double duration_s);
/// Puts a geom without body at a pose, in SI.
void set_pose(dGeomID geom, const spatial::Pose& X_WG);

}  // namespace trocar::simulation
