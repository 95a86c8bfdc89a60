#include "engine/simulation/ode_handles.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "engine/core/check.h"

namespace trocar::simulation {
namespace {

thread_local std::int64_t complaints = 0;

void on_message(int /*number*/, const char* /*format*/, va_list /*arguments*/) {
  ++complaints;
}

// ODE ends the program after these two in any case; what is left to do is to say why.
void on_fatal(int number, const char* format, va_list arguments) {
  std::fprintf(stderr, "ODE error %d: ", number);
  std::vfprintf(stderr, format, arguments);
  std::fputc('\n', stderr);
  std::abort();
}

constexpr double kGravity_mps2 = -9.81;
// Friction gives way by this much under load. In a minute's hold a block slips 0.08 mm at 1e-6 s/kg, 0.003 mm at 1e-8
// and 0.0004 mm at 1e-9, where a step takes a tenth longer; at 1e-11 the solver complains.
constexpr double kWorldCfm_s_per_kg = 1e-8;
constexpr double kSurfaceLayer_m = 10e-6;
constexpr double kMaximumCorrection_mps = 0.5;

}  // namespace

void prepare_ode_for_this_thread() {
  static std::once_flag once;
  std::call_once(once, [] {
    TROCAR_CHECK(dInitODE2(0) != 0);
    dSetMessageHandler(&on_message);
    dSetErrorHandler(&on_fatal);
    dSetDebugHandler(&on_fatal);
  });
  thread_local const bool prepared = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  TROCAR_CHECK(prepared);
}

std::int64_t ode_complaints_in_this_thread() {
  return complaints;
}

OdeStepper make_ode_stepper() {
  prepare_ode_for_this_thread();
  OdeStepper stepper{OdeThreading(dThreadingAllocateSelfThreadedImplementation()), OdeWorld(dWorldCreate())};
  dWorldID world = stepper.world.get();
  dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(stepper.threading.get()),
                                       stepper.threading.get());
  dWorldSetGravity(world, 0.0, 0.0, kGravity_mps2 * kOdeLength);
  dWorldSetCFM(world, kWorldCfm_s_per_kg / kOdeMass);
  dWorldSetAutoDisableFlag(world, 0);
  dWorldSetContactSurfaceLayer(world, kSurfaceLayer_m * kOdeLength);
  dWorldSetContactMaxCorrectingVel(world, kMaximumCorrection_mps * kOdeLength);
  return stepper;
}

spatial::Pose pose_of(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return {from_ode(dBodyGetPosition(body)), Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
}

void set_pose(dBodyID body, const spatial::Pose& X_WB) {
  const Eigen::Vector3d p = X_WB.p * kOdeLength;
  const dQuaternion q = {X_WB.q.w(), X_WB.q.x(), X_WB.q.y(), X_WB.q.z()};
  dBodySetPosition(body, p.x(), p.y(), p.z());
  dBodySetQuaternion(body, q);
}

void set_pose(dGeomID geom, const spatial::Pose& X_WG) {
  const Eigen::Vector3d p = X_WG.p * kOdeLength;
  const dQuaternion q = {X_WG.q.w(), X_WG.q.x(), X_WG.q.y(), X_WG.q.z()};
  dGeomSetPosition(geom, p.x(), p.y(), p.z());
  dGeomSetQuaternion(geom, q);
}

void set_motion(dBodyID body, const spatial::Pose& from, const spatial::Pose& to, double duration_s) {
  const Eigen::Vector3d v = (to.p - from.p) * (kOdeLength / duration_s);
  Eigen::Quaterniond turn = to.q * from.q.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();
  const double angle = 2.0 * std::atan2(sine, turn.w());
  // For small turns the axis times the angle is twice the vector part.
  const Eigen::Vector3d w = turn.vec() * ((sine > 1e-12 ? angle / sine : 2.0) / duration_s);
  dBodySetLinearVel(body, v.x(), v.y(), v.z());
  dBodySetAngularVel(body, w.x(), w.y(), w.z());
}

}  // namespace trocar::simulation
