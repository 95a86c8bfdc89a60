#include "engine/simulation/contacts.h"

#include <algorithm>
#include <limits>

namespace trocar::simulation {
namespace {

constexpr int kKeptPerNormal = 4;
constexpr double kSameNormal = 0.95;     ///< Cosine of the angle within which normals count as one.
constexpr double kSamePoint_m = 0.0001;  ///< Points nearer than this carry nothing of their own.
constexpr double kStiffness_n_per_m = 2000.0;
constexpr double kDamping_ns_per_m = 4.0;

Eigen::Vector3d vector(const dReal* v) {
  return {v[0], v[1], v[2]};
}

/// The geom's body; none for what never moves and for what sleeps, which a joint would otherwise wake.
dBodyID awake_body(dGeomID geom) {
  dBodyID body = dGeomGetBody(geom);
  return body != nullptr && dBodyIsEnabled(body) != 0 ? body : nullptr;
}

bool bounds_meet(dGeomID first, dGeomID second) {
  dReal a[6];
  dReal b[6];
  dGeomGetAABB(first, a);
  dGeomGetAABB(second, b);
  return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] && b[4] <= a[5];
}

}  // namespace

void ContactPatch::collide(dGeomID first, dGeomID second) {
  const int room = std::min(kPerPair, kCapacity - count_);
  if (room == 0 || !bounds_meet(first, second)) return;
  count_ += dCollide(first, second, room, &contacts_[static_cast<std::size_t>(count_)], sizeof(dContactGeom));
}

void ContactPatch::thin() {
  if (count_ <= kKeptPerNormal) return;
  std::array<dContactGeom, kCapacity> kept;
  std::array<bool, kCapacity> done{};
  int kept_count = 0;
  const auto n = static_cast<std::size_t>(count_);
  for (std::size_t first = 0; first < n; ++first) {
    if (done[first]) continue;
    // The cluster is all that is left with about this normal; `spread` is each member's distance to the kept ones.
    std::array<double, kCapacity> spread;
    std::size_t deepest = first;
    for (std::size_t i = first; i < n; ++i) {
      spread[i] = -1.0;
      if (done[i] || vector(contacts_[first].normal).dot(vector(contacts_[i].normal)) < kSameNormal) continue;
      done[i] = true;
      spread[i] = std::numeric_limits<double>::infinity();
      if (contacts_[i].depth > contacts_[deepest].depth) deepest = i;
    }
    std::size_t next = deepest;
    for (int k = 0; k < kKeptPerNormal; ++k) {
      kept[static_cast<std::size_t>(kept_count++)] = contacts_[next];
      const Eigen::Vector3d p = vector(contacts_[next].pos);
      std::size_t farthest = first;
      for (std::size_t i = first; i < n; ++i) {
        if (spread[i] < 0.0) continue;
        spread[i] = std::min(spread[i], (vector(contacts_[i].pos) - p).norm());
        if (spread[i] > spread[farthest]) farthest = i;
      }
      if (spread[farthest] < kSamePoint_m * kOdeLength) break;
      next = farthest;
    }
  }
  contacts_ = kept;
  count_ = kept_count;
}

void ContactPatch::connect(dWorldID world, dJointGroupID group, const ContactMaterial& material, double step_s) const {
  const double hk = step_s * kStiffness_n_per_m;
  dContact contact{};
  contact.surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = material.friction;
  contact.surface.soft_erp = hk / (hk + kDamping_ns_per_m);
  contact.surface.soft_cfm = 1.0 / ((hk + kDamping_ns_per_m) * kOdeStiffness);
  for (const dContactGeom& geom : contacts()) {
    contact.geom = geom;
    int axis_flag = 0;
    if (material.first_axis) {
      const Eigen::Vector3d normal = vector(geom.normal);
      const Eigen::Vector3d along = *material.first_axis - normal * normal.dot(*material.first_axis);
      const double length = along.norm();
      if (length > 0.1) {
        axis_flag = dContactFDir1;
        for (int i = 0; i < 3; ++i) contact.fdir1[i] = along[i] / length;
      }
    }
    contact.surface.mode = (contact.surface.mode & ~dContactFDir1) | axis_flag;
    dJointID joint = dJointCreateContact(world, group, &contact);
    dJointAttach(joint, awake_body(geom.g1), awake_body(geom.g2));
  }
}

}  // namespace trocar::simulation
