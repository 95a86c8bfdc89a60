// The arms' files against the arms' code: whoever plans with assets/arms/*.urdf moves the arm that we simulate.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "engine/core/file.h"
#include "engine/core/random.h"
#include "engine/kinematics/psm.h"

using namespace trocar;
using namespace trocar::kinematics;

namespace {

struct UrdfJoint {
  std::string type;
  Eigen::Isometry3d X_PC = Eigen::Isometry3d::Identity();  ///< Child in parent at zero.
  JointLimit limit{0.0, 0.0};
};

std::vector<double> numbers_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double x = 0.0; stream >> x;) numbers.push_back(x);
  return numbers;
}

std::string attribute(const std::string& text, const std::string& name) {
  std::smatch match;
  REQUIRE(std::regex_search(text, match, std::regex(name + "=\"([^\"]*)\"")));
  return match[1];
}

/// The joints of a file in order; our own writer puts each element on a line of its own.
std::vector<UrdfJoint> joints_of(const std::string& name) {
  const std::string text = read_file(share_path("assets/arms/" + name)).value();
  std::vector<UrdfJoint> joints;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("<joint") != std::string::npos) joints.push_back({attribute(line, "type"), {}, {0.0, 0.0}});
    if (line.find("<origin") != std::string::npos) {
      const std::vector<double> p = numbers_in(attribute(line, "xyz"));
      const std::vector<double> rpy = numbers_in(attribute(line, "rpy"));
      joints.back().X_PC =
          Eigen::Translation3d(p[0], p[1], p[2]) * Eigen::AngleAxisd(rpy[2], Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy[1], Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(rpy[0], Eigen::Vector3d::UnitX());
    }
    if (line.find("<limit") != std::string::npos) {
      joints.back().limit = {std::stod(attribute(line, "lower")), std::stod(attribute(line, "upper"))};
    }
  }
  return joints;
}

Eigen::Isometry3d tip(const std::vector<UrdfJoint>& joints, const Joints& q) {
  Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
  std::size_t moved = 0;
  for (const UrdfJoint& joint : joints) {
    X_WT = X_WT * joint.X_PC;
    if (joint.type == "revolute") X_WT.rotate(Eigen::AngleAxisd(q[moved++], Eigen::Vector3d::UnitZ()));
    if (joint.type == "prismatic") X_WT.translate(Eigen::Vector3d(0.0, 0.0, q[moved++]));
  }
  REQUIRE(moved == q.size());
  return X_WT;
}

}  // namespace

TEST_CASE("the arms' files put the tip where the code does, and have its limits") {
  for (const ArmSide side : kArmSides) {
    const PsmModel model = psm_model(side);
    const std::vector<UrdfJoint> joints = joints_of(side == ArmSide::kLeft ? "psm2.urdf" : "psm1.urdf");
    REQUIRE(joints.size() == 8);  // base, six joints, tip
    for (std::size_t i = 0; i < model.limits.size(); ++i) {
      CHECK(joints[i + 1].limit.low == doctest::Approx(model.limits[i].low).epsilon(1e-15));
      CHECK(joints[i + 1].limit.high == doctest::Approx(model.limits[i].high).epsilon(1e-15));
    }
    Random random(1);
    for (int trial = 0; trial < 1000; ++trial) {
      Joints q{};
      for (std::size_t i = 0; i < q.size(); ++i) q[i] = random.uniform(model.limits[i].low, model.limits[i].high);
      const spatial::Pose X_WT = forward(model, q);
      const Eigen::Isometry3d expected = tip(joints, q);
      // Rounding of seven products of metres.
      REQUIRE((X_WT.p - expected.translation()).norm() < 1e-14);
      REQUIRE((X_WT.rotation() - expected.rotation()).norm() < 1e-13);
    }
  }
}
