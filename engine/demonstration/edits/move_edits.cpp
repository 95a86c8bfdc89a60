// Displacements: MoveTool, RotateTool, Offset, Perturb.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/demonstration/edits/contact_lock.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {
namespace {

/// Nothing on the board is further away than this; a displacement by more is a slip of the keyboard.
constexpr double kFarthest_m = 0.5;

double fade(Falloff falloff, double distance) {
  const double x = std::clamp(distance, 0.0, 1.0);
  switch (falloff) {
    case Falloff::kSmooth:
      return 0.5 * (1.0 + std::cos(std::numbers::pi * x));
    case Falloff::kSphere:
      return std::sqrt(1.0 - x * x);
    case Falloff::kLinear:
      return 1.0 - x;
    case Falloff::kSharp:
      return (1.0 - x) * (1.0 - x);
  }
  return 0.0;
}

Status check_shift(const Eigen::Vector3d& by_m) {
  if (by_m.allFinite() && by_m.norm() <= kFarthest_m) return {};
  return fail(ErrorCode::kInvalidArgument, fmt::format("a tool can be moved by at most {} mm", 1e3 * kFarthest_m));
}

Eigen::Quaterniond rotation_of(const Eigen::Vector3d& by_rad) {
  const double angle = by_rad.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, by_rad / angle));
}

/// The samples around `at_s`, each changed by `change(sample, weight)`.
template <typename Change>
Result<Demonstration> with_falloff(const Demonstration& document, double at_s, double radius_s, Falloff falloff,
                                   Change change) {
  TROCAR_RETURN_IF_ERROR(check_positive(radius_s, "the radius"));
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, at_s - radius_s, at_s + radius_s, 1));
  for (Sample& sample : stretch.samples) {
    const double weight = fade(falloff, std::abs(document.time_of(sample) - at_s) / radius_s);
    if (weight > 0.0) change(sample, weight);
  }
  return with_stretch(document, std::move(stretch));
}

/// Smooth noise: a normal vector every period, cubic in between.
class Wander {
 public:
  Wander(const Perturb& edit, std::uint64_t stream) : edit_(edit), random_(Random(edit.seed).child(stream)) {
    for (Eigen::Vector3d& knot : knots_) knot = draw();
  }
  /// Precondition: `t_s` never decreases.
  Eigen::Vector3d at(double t_s) {
    while (t_s >= edit_.period_s * static_cast<double>(passed_ + 1)) {
      std::rotate(knots_.begin(), knots_.begin() + 1, knots_.end());
      knots_.back() = draw();
      ++passed_;
    }
    const double x = t_s / edit_.period_s - static_cast<double>(passed_);
    const double share = x * x * (3.0 - 2.0 * x);
    return knots_[0] + share * (knots_[1] - knots_[0]);
  }

 private:
  Eigen::Vector3d draw() {
    const double x = random_.normal();
    const double y = random_.normal();
    const double z = random_.normal();
    return edit_.sigma_m * Eigen::Vector3d(x, y, z);
  }

  const Perturb& edit_;
  Random random_;
  std::array<Eigen::Vector3d, 2> knots_;
  std::int64_t passed_ = 0;
};

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const MoveTool& edit) {
  TROCAR_RETURN_IF_ERROR(check_shift(edit.by_m));
  return with_falloff(document, edit.at_s, edit.radius_s, edit.falloff, [&](Sample& sample, double weight) {
    for (const std::size_t arm : indices_of(edit.arms)) {
      displace(sample, arm, weight * edit.by_m, Eigen::Quaterniond::Identity(), document.block);
    }
  });
}

Result<Demonstration> made_by(const Demonstration& document, const RotateTool& edit) {
  if (!edit.by_rad.allFinite() || edit.by_rad.norm() > 2.0 * std::numbers::pi) {
    return fail(ErrorCode::kInvalidArgument, "a tool can be turned by at most 360°");
  }
  return with_falloff(document, edit.at_s, edit.radius_s, edit.falloff, [&](Sample& sample, double weight) {
    for (const std::size_t arm : indices_of(edit.arms)) {
      const Eigen::Quaterniond R_WT = sample.arms[arm].measured.pose().q;
      const Eigen::Quaterniond part = rotation_of(weight * edit.by_rad);
      const Eigen::Quaterniond turn = edit.frame == TurnFrame::kBoard ? part : R_WT * part * R_WT.conjugate();
      displace(sample, arm, Eigen::Vector3d::Zero(), turn, document.block);
    }
  });
}

Result<Demonstration> made_by(const Demonstration& document, const Offset& edit) {
  TROCAR_RETURN_IF_ERROR(check_shift(edit.by_m));
  return with_changed(document, {0, document.samples}, [&](Sample& sample, std::size_t) {
    for (const std::size_t arm : indices_of(edit.arms)) {
      displace(sample, arm, edit.by_m, Eigen::Quaterniond::Identity(), document.block);
    }
  });
}

Result<Demonstration> made_by(const Demonstration& document, const Perturb& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.sigma_m, "the standard deviation"));
  TROCAR_RETURN_IF_ERROR(check_positive(edit.period_s, "the period"));
  if (edit.sigma_m > 0.05 || edit.period_s < 0.005) {
    return fail(ErrorCode::kInvalidArgument, "the standard deviation goes up to 50 mm and the period down to 0.005 s");
  }
  if (document.duration_s() / edit.period_s > 1e7) {
    return fail(ErrorCode::kInvalidArgument, "the period is too short for so long a demonstration");
  }
  TROCAR_ASSIGN_OR_RETURN(const TrackPart part, part_of(document, document.begin_s, document.end_s, 2));
  const ContactLock lock(part.samples);
  std::array<Wander, 2> wander{Wander(edit, 0), Wander(edit, 1)};
  return with_changed(document, part, [&](Sample& sample, std::size_t i) {
    const double t_s = document.time_of(sample) - document.begin_s;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      displace(sample, arm, lock.freedom(i) * wander[arm].at(t_s), Eigen::Quaterniond::Identity(), document.block);
    }
  });
}

}  // namespace trocar::demonstration
