#include "engine/exchange/robomimic_foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "engine/exchange/plausible.h"
#include "engine/kinematics/psm.h"
#include "engine/spatial/units.h"

namespace trocar::exchange {
namespace {

using demonstration::ArmSample;
using demonstration::Sample;
using Nodes = std::map<std::string, TreeNode>;
using Names = std::vector<const char*>;

/// Of one arm, as different programs name it; the first that is there counts.
struct ArmNames {
  Names position;
  Names rotation;
  Names gripper;
};
const std::array<ArmNames, 2> kNames{ArmNames{{"robot0_eef_pos", "eef_pos", "ee_pos"},
                                              {"robot0_eef_quat", "eef_quat", "ee_ori"},
                                              {"robot0_gripper_qpos", "gripper_qpos", "gripper_states"}},
                                     ArmNames{{"robot1_eef_pos"}, {"robot1_eef_quat"}, {"robot1_gripper_qpos"}}};

/// What wide open jaws are set to where a file tells only how far its gripper opens.
constexpr double kOpen_deg = 60.0;

/// Where one arm is in a file; null where there is no such array.
struct ArmArrays {
  const TreeNode* position = nullptr;
  const TreeNode* rotation = nullptr;  ///< 4: a quaternion x, y, z, w; 3: axis times angle.
  const TreeNode* gripper = nullptr;
};

/// The smallest and the largest opening in the file, in the gripper's own unit.
struct Opening {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

class ForeignReader {
 public:
  ForeignReader(const Nodes& nodes, const std::string& group) : nodes_(nodes), group_(group) {}

  Result<Imported> read(double rate_hz) {
    for (std::size_t arm = 0; arm < 2; ++arm) arms_[arm] = arrays_of(kNames[arm]);
    if (arms_[0].position == nullptr && arms_[1].position == nullptr) {
      return fail(ErrorCode::kUnsupported, "it has no tool position that is known here, such as obs/robot0_eef_pos");
    }
    TROCAR_RETURN_IF_ERROR(check_shapes());
    for (std::size_t i = 0; i < rows_; ++i) {
      Sample sample;
      sample.tick = std::llround(static_cast<double>(i) * Tick::kPerSecond / rate_hz);
      if (lacks_number(i)) {
        if (left_out_++ == 0) first_left_out_ = i + 1;
        continue;
      }
      for (std::size_t arm = 0; arm < 2; ++arm) TROCAR_RETURN_IF_ERROR(read_arm(arm, i, sample.arms[arm]));
      imported_.recording.samples.push_back(sample);
    }
    const std::size_t taken = imported_.recording.samples.size();
    if (taken < 2 || 2 * taken < rows_) {
      return fail(ErrorCode::kCorrupt,
                  fmt::format("only {} of {} rows can be samples, numbers are missing from row {} on", taken, rows_,
                              first_left_out_));
    }
    TROCAR_RETURN_IF_ERROR(demonstration::check_samples(imported_.recording.samples));
    say();
    return std::move(imported_);
  }

 private:
  const TreeNode* first_of(const Names& names) {
    for (const char* name : names) {
      const auto found = nodes_.find(fmt::format("{}/obs/{}", group_, name));
      if (found == nodes_.end() || !found->second.holds_numbers()) continue;
      used_.insert(found->first);
      return &found->second;
    }
    return nullptr;
  }

  ArmArrays arrays_of(const ArmNames& names) {
    ArmArrays arrays;
    arrays.position = first_of(names.position);
    if (arrays.position == nullptr) return arrays;
    arrays.rotation = first_of(names.rotation);
    arrays.gripper = first_of(names.gripper);
    return arrays;
  }

  Status check_shapes() {
    for (const ArmArrays& arm : arms_) {
      if (arm.position == nullptr) continue;
      if (rows_ == 0 && !arm.position->shape.empty()) rows_ = static_cast<std::size_t>(arm.position->shape[0]);
      TROCAR_RETURN_IF_ERROR(check_shape(*arm.position, 3, 3));
      if (arm.rotation != nullptr) TROCAR_RETURN_IF_ERROR(check_shape(*arm.rotation, 3, 4));
      if (arm.gripper != nullptr) TROCAR_RETURN_IF_ERROR(check_shape(*arm.gripper, 1, 16));
    }
    if (rows_ < 2) return fail(ErrorCode::kCorrupt, "a demonstration needs at least 2 samples");
    for (std::size_t arm = 0; arm < 2; ++arm) opening_[arm] = opening(arms_[arm].gripper);
    return {};
  }

  Status check_shape(const TreeNode& node, std::uint64_t low, std::uint64_t high) const {
    const bool flat = node.shape.size() == 1 && low == 1;
    const std::uint64_t width = flat ? 1 : node.shape.size() == 2 ? node.shape[1] : 0;
    if (width >= low && width <= high && node.shape[0] == rows_) return {};
    return fail(ErrorCode::kCorrupt,
                fmt::format("{} has not the shape of {} by {}", node.path.substr(group_.size() + 1), rows_,
                            low == high ? fmt::format("{}", low) : fmt::format("{} to {}", low, high)));
  }

  static std::size_t width_of(const TreeNode& node) {
    return node.shape.size() == 2 ? static_cast<std::size_t>(node.shape[1]) : 1;
  }

  bool lacks_number(std::size_t row) const {
    for (const ArmArrays& arm : arms_) {
      if (arm.position == nullptr) continue;
      for (const TreeNode* node : {arm.position, arm.rotation, arm.gripper}) {
        for (std::size_t i = 0; node != nullptr && i < width_of(*node); ++i) {
          if (!std::isfinite(node->number(row * width_of(*node) + i))) return true;
        }
      }
    }
    return false;
  }

  /// Of all fingers together.
  static double opening_at(const TreeNode& gripper, std::size_t row) {
    double sum = 0.0;
    const std::size_t width = width_of(gripper);
    for (std::size_t i = 0; i < width; ++i) sum += std::abs(gripper.number(row * width + i));
    return sum;
  }

  Opening opening(const TreeNode* gripper) const {
    Opening range;
    for (std::size_t row = 0; gripper != nullptr && row < rows_; ++row) {
      if (!std::isfinite(opening_at(*gripper, row))) continue;
      range.low = std::min(range.low, opening_at(*gripper, row));
      range.high = std::max(range.high, opening_at(*gripper, row));
    }
    return range;
  }

  static bool in_radians(const TreeNode& gripper) {
    const auto units = gripper.attributes.find("units");
    const auto* text = units == gripper.attributes.end() ? nullptr : std::get_if<std::string>(&units->second);
    return text != nullptr && *text == "rad" && width_of(gripper) == 1;
  }

  double jaw_at(std::size_t arm, std::size_t row) const {
    const TreeNode* gripper = arms_[arm].gripper;
    if (gripper == nullptr) return 0.0;
    if (in_radians(*gripper)) return gripper->number(row);
    const double here = opening_at(*gripper, row);
    const double span = opening_[arm].high - opening_[arm].low;
    if (!std::isfinite(here)) return here;
    return span > 0.0 ? (here - opening_[arm].low) / span * spatial::from_degrees(kOpen_deg) : 0.0;
  }

  Result<Eigen::Quaterniond> rotation_at(std::size_t arm, std::size_t row) {
    const TreeNode* node = arms_[arm].rotation;
    if (node == nullptr) return kinematics::pointing_down(0.0);
    const std::size_t width = width_of(*node);
    std::array<double, 4> v{};
    for (std::size_t i = 0; i < width; ++i) v[i] = node->number(row * width + i);
    if (width == 3) {
      const Eigen::Vector3d turn(v[0], v[1], v[2]);
      const double angle = turn.norm();
      if (!(angle < kFarthest_m)) return no_rotation(*node, row);
      if (angle == 0.0) return Eigen::Quaterniond::Identity();
      return Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle));
    }
    const Eigen::Quaterniond q(v[3], v[0], v[1], v[2]);
    const double off = std::abs(q.norm() - 1.0);
    if (!(off <= kFarFromRotation)) return no_rotation(*node, row);
    worst_ = std::max(worst_, off);
    return q.normalized();
  }

  tl::unexpected<Error> no_rotation(const TreeNode& node, std::size_t row) const {
    return fail(ErrorCode::kCorrupt,
                fmt::format("row {} of {} is no rotation", row + 1, node.path.substr(group_.size() + 1)));
  }

  Status read_arm(std::size_t arm, std::size_t row, ArmSample& into) {
    spatial::Pose X_WT = kinematics::ready_pose(kinematics::kArmSides[arm]);
    if (const TreeNode* position = arms_[arm].position; position != nullptr) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        X_WT.p[static_cast<Eigen::Index>(axis)] = position->number(3 * row + axis);
      }
      if (!X_WT.p.allFinite() || X_WT.p.norm() > kFarthest_m) {
        return fail(ErrorCode::kCorrupt, fmt::format("row {} of {} is no position in metres", row + 1,
                                                     position->path.substr(group_.size() + 1)));
      }
      TROCAR_ASSIGN_OR_RETURN(X_WT.q, rotation_at(arm, row));
    }
    const double jaw_rad = jaw_at(arm, row);
    if (!std::isfinite(jaw_rad) || std::abs(jaw_rad) > kFarthest_m) {
      return fail(ErrorCode::kCorrupt, fmt::format("row {} of the gripper is no opening", row + 1));
    }
    into.set_setpoint(X_WT, jaw_rad);
    into.measured = demonstration::CompactPose::from(X_WT);
    into.jaw_rad = static_cast<float>(jaw_rad);
    return {};
  }

  void say() {
    demonstration::Recording& recording = imported_.recording;
    recording.provenance.operator_kind = "imported";
    recording.provenance.block = demonstration::kUnknownPlace;
    recording.provenance.goal = demonstration::kUnknownPlace;
    recording.outcome = demonstration::Outcome::kUnknown;
    for (std::size_t arm = 0; arm < 2; ++arm) say_arm(arm);
    if (left_out_ > 0) {
      imported_.found.push_back(fmt::format("{} {} left out, the first is row {}: a number is missing", left_out_,
                                            left_out_ == 1 ? "row is" : "rows are", first_left_out_));
    }
    if (const std::optional<std::int64_t> told = told_samples(); told && *told != static_cast<std::int64_t>(rows_)) {
      imported_.found.push_back(fmt::format("the file says {} samples, but holds {}; all are taken", *told, rows_));
    }
    if (worst_ > kRounded) {
      imported_.found.push_back(
          fmt::format("quaternions are off by up to {:.2g} in length; unit ones stand in", worst_));
    }
    imported_.found.emplace_back("quaternions are taken as x, y, z, w, positions as metres in the robot's own frame");
    for (const char* lost :
         {"setpoints (what was measured stands in)", "joints", "the blocks", "segments (all is labelled A)",
          "its block, goal and outcome", "a simulated world (it cannot be replayed)"}) {
      imported_.lossy.emplace_back(lost);
    }
    say_unused();
  }

  void say_arm(std::size_t arm) {
    const char* side = arm == 0 ? "left" : "right";
    const ArmArrays& arrays = arms_[arm];
    if (arrays.position == nullptr) {
      imported_.lossy.push_back(fmt::format("the {} arm (it stands at its ready pose)", side));
      return;
    }
    imported_.found.push_back(
        fmt::format("the {} tool follows {}", side, arrays.position->path.substr(group_.size() + 1)));
    if (arrays.rotation == nullptr)
      imported_.lossy.push_back(fmt::format("the {} tool's rotation (it points down)", side));
    if (arrays.gripper == nullptr) {
      imported_.lossy.push_back(fmt::format("the {} tool's jaw (it is closed)", side));
    } else if (!in_radians(*arrays.gripper)) {
      imported_.found.push_back(fmt::format("the {} tool's jaw: {:g} to {:g} of the file's gripper become 0 to {:g}°",
                                            side, opening_[arm].low, opening_[arm].high, kOpen_deg));
    }
  }

  /// Arrays of the demonstration that nothing was made of.
  void say_unused() {
    constexpr std::size_t kShown = 12;
    std::vector<std::string> names;
    const std::string inside = group_ + "/";
    for (auto at = nodes_.lower_bound(inside); at != nodes_.end() && at->first.starts_with(inside); ++at) {
      if (at->second.kind == TreeNode::Kind::kGroup || used_.contains(at->first)) continue;
      std::string name = at->first.substr(inside.size());
      if (!at->second.why.empty()) name += fmt::format(" ({})", at->second.why);
      names.push_back(std::move(name));
    }
    const std::size_t shown = std::min(names.size(), kShown);
    for (std::size_t i = 0; i < shown; ++i) imported_.lossy.push_back("its " + names[i]);
    if (names.size() > shown) imported_.lossy.push_back(fmt::format("{} further arrays", names.size() - shown));
  }

  std::optional<std::int64_t> told_samples() const {
    const auto group = nodes_.find(group_);
    if (group == nodes_.end()) return std::nullopt;
    const auto told = group->second.attributes.find("num_samples");
    const auto* number = told == group->second.attributes.end() ? nullptr : std::get_if<std::int64_t>(&told->second);
    return number == nullptr ? std::nullopt : std::optional(*number);
  }

  const Nodes& nodes_;
  const std::string& group_;
  std::size_t left_out_ = 0;
  std::size_t first_left_out_ = 0;  ///< From 1.
  std::array<ArmArrays, 2> arms_;
  std::array<Opening, 2> opening_;
  std::size_t rows_ = 0;
  std::set<std::string> used_;
  double worst_ = 0.0;
  Imported imported_;
};

}  // namespace

bool is_known_observation(std::string_view name) {
  const auto holds = [name](const Names& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return std::any_of(kNames.begin(), kNames.end(), [&](const ArmNames& arm) {
    return holds(arm.position) || holds(arm.rotation) || holds(arm.gripper);
  });
}

Result<Imported> read_foreign(const Nodes& nodes, const std::string& group, double rate_hz) {
  return ForeignReader(nodes, group).read(rate_hz);
}

}  // namespace trocar::exchange
