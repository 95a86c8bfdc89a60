/// One arm of a mapped table: from the numbers of a row to a pose. Private to the module.
#pragma once

#include <string>
#include <vector>

#include "engine/demonstration/recording.h"
#include "engine/exchange/column_map.h"
#include "engine/exchange/number_table.h"
#include "engine/kinematics/psm.h"

namespace trocar::exchange {

class MappedArm {
 public:
  /// Errors: kInvalidArgument for a column that the table has not.
  static Result<MappedArm> resolve(const NumberTable& table, const ArmColumns& columns, const FrameMap& frame,
                                   kinematics::ArmSide side);

  enum class Outcome { kTaken, kNumberMissing, kNoRotation };
  /// Sets pose, jaw and joints. Errors: kCorrupt naming the place.
  Result<Outcome> take(const NumberTable& table, std::size_t row, demonstration::ArmSample& into);

  const std::vector<std::size_t>& used() const { return used_; }
  /// What is odd about all that was taken.
  std::vector<std::string> found() const;
  /// What the table does not have of this arm.
  std::vector<std::string> lossy() const;

 private:
  MappedArm(ArmColumns columns, const FrameMap& frame, kinematics::ArmSide side);
  Result<Outcome> take_pose(const std::string& place, demonstration::ArmSample& into);
  Result<Outcome> take_joints(const std::string& place, demonstration::ArmSample& into);
  /// Nothing for what is no rotation.
  std::optional<Eigen::Quaterniond> rotation(const double* numbers);
  spatial::Pose placed(const spatial::Pose& X_FT) const;

  ArmColumns columns_;
  FrameMap frame_;
  kinematics::ArmSide side_;
  kinematics::PsmModel model_;
  std::vector<std::size_t> used_;  ///< Position or joints, then rotation, then jaw.
  std::vector<double> numbers_;    ///< Of the row in hand, by `used_`.
  Eigen::Quaterniond last_ = Eigen::Quaterniond::Identity();
  double worst_rotation_ = 0.0;
  std::size_t beyond_limits_ = 0;
  std::string first_beyond_;  ///< Where, and what of the first.
};

}  // namespace trocar::exchange
