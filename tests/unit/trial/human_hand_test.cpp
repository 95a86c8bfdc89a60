#include "engine/trial/human_hand.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/control/clutch.h"
#include "engine/trial/tremor.h"

using namespace trocar;
using trial::HandSample;
using trial::HumanHand;
using trial::Intention;
using trial::SkillParameters;

namespace {

/// Hands without noise, to see what is meant.
SkillParameters steady() {
  SkillParameters skill;
  skill.aim_noise = 0.0;
  skill.turn_noise_rad = 0.0;
  skill.tremor_m = 0.0;
  return skill;
}

int samples_of(HumanHand& hand, const Intention& intention) {
  hand.move(intention);
  int count = 0;
  for (; hand.busy(); ++count) hand.step();
  return count;
}

}  // namespace

TEST_CASE("a minimum-jerk course begins and ends at rest") {
  using trial::minimum_jerk;
  CHECK(minimum_jerk(0.0) == 0.0);
  CHECK(minimum_jerk(0.5) == doctest::Approx(0.5));
  CHECK(minimum_jerk(1.0) == 1.0);
  CHECK(minimum_jerk(2.0) == 1.0);
  CHECK(minimum_jerk(1e-3) < 1e-7);
  CHECK(1.0 - minimum_jerk(1.0 - 1e-3) < 1e-7);
}

TEST_CASE("an intention within reach moves and turns the tool as meant") {
  const Eigen::Quaterniond R_WD = control::display_rotation();
  HumanHand hand(steady(), Random(1), R_WD, 0.2);
  control::ClutchedMapping mapping{control::ToolMapping(R_WD, 0.2)};
  const spatial::Pose start{{0.01, 0.02, 0.03}, Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5)};
  mapping.take_over(hand.step().X_DH, start);
  const Intention intention{{0.004, -0.003, 0.005},
                            Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()))};
  hand.move(intention);
  spatial::Pose tool;
  while (hand.busy()) tool = mapping.follow(hand.step().X_DH, false, Tick{0});
  CHECK((tool.p - start.p - intention.way_W).norm() < 1e-12);
  CHECK(spatial::angle_between(tool.q, intention.turn_W * start.q) < 1e-9);
}

TEST_CASE("movement time grows by the same amount whenever distance over width doubles") {
  SkillParameters skill = steady();
  skill.fitts_a_s = 0.0;
  skill.fitts_b_s = 0.2;
  const auto samples = [&](double distance_m) {
    HumanHand hand(skill, Random(1), control::display_rotation(), 0.5);
    return samples_of(hand, {{0.0, distance_m, 0.0}, Eigen::Quaterniond::Identity(), 1e-3, 1.0});
  };
  // log2(D/W + 1) = 1, 2, 3, 4 bits of 0.2 s, 40 samples each.
  CHECK(samples(0.001) == 40);
  CHECK(samples(0.003) == 80);
  CHECK(samples(0.007) == 120);
  CHECK(samples(0.015) == 160);
}

TEST_CASE("a way beyond the hand's reach is done by clutching, and the hand stays within its reach") {
  const Eigen::Quaterniond R_WD = control::display_rotation();
  HumanHand hand(steady(), Random(1), R_WD, 0.2);
  control::ClutchedMapping mapping{control::ToolMapping(R_WD, 0.2)};
  const spatial::Pose start;
  const Eigen::Vector3d goal{-0.03, 0.05, -0.04};
  spatial::Pose tool = start;
  mapping.take_over(hand.step().X_DH, start);
  double farthest_m = 0.0;
  Tick now;
  for (int move = 0; move < 20 && (goal - tool.p).norm() > 1e-9; ++move) {
    hand.move({goal - tool.p, Eigen::Quaterniond::Identity(), 1e-3, 1.0});
    while (hand.busy()) {
      const HandSample sample = hand.step();
      farthest_m = std::max(farthest_m, sample.X_DH.p.cwiseAbs().maxCoeff());
      now.count += 5;
      tool = mapping.follow(sample.X_DH, sample.clutch_pedal, now);
    }
  }
  CHECK((goal - tool.p).norm() < 1e-9);
  CHECK(mapping.count() >= 1);
  CHECK(farthest_m <= trial::kHandReach_m + 1e-12);
}

TEST_CASE("the end of a longer way is missed by more, most of all in depth") {
  const auto spread = [](double distance_m, const Eigen::Vector3d& axis_D) {
    SkillParameters skill = steady();
    skill.aim_noise = 0.05;
    const Eigen::Quaterniond R_WD = control::display_rotation();
    const Eigen::Vector3d way_W = distance_m * (R_WD * Eigen::Vector3d::UnitY());
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      HumanHand hand(skill, Random(seed), R_WD, 0.5);
      hand.move({way_W, Eigen::Quaterniond::Identity(), 1e-3, 1.0});
      HandSample last;
      while (hand.busy()) last = hand.step();
      const double error = axis_D.dot(0.5 * last.X_DH.p - distance_m * Eigen::Vector3d::UnitY());
      sum += error * error;
    }
    return std::sqrt(sum / 400.0);
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  CHECK(spread(0.02, x) > 1.8 * spread(0.01, x));
  CHECK(spread(0.02, z) > 1.4 * spread(0.02, x));
}

TEST_CASE("the gripper opens smoothly to the angle asked for") {
  HumanHand hand(steady(), Random(1), control::display_rotation(), 0.2);
  hand.grip(0.3, 0.4);
  double last = 0.0;
  double fastest = 0.0;
  while (hand.gripping()) {
    const double now = hand.step().grip_rad;
    fastest = std::max(fastest, now - last);
    last = now;
  }
  CHECK(last == doctest::Approx(0.3));
  // The peak of a minimum-jerk course is 1.875 times its mean speed.
  CHECK(fastest <= 1.876 * 0.3 / 80.0);
}

TEST_CASE("tremor has the asked strength and lies between 8 and 12 Hz") {
  constexpr int kCount = 8000;
  constexpr double kRate_hz = 200.0;
  trial::Tremor tremor(1e-4, Random(7));
  std::vector<double> x;
  double square = 0.0;
  for (int i = 0; i < kCount; ++i) {
    x.push_back(tremor.next().x());
    square += x.back() * x.back();
  }
  // 40 s of a band 4 Hz wide hold about 160 independent values: 10 % is two of their standard errors.
  CHECK(std::sqrt(square / kCount) == doctest::Approx(1e-4).epsilon(0.10));
  double inside = 0.0;
  double total = 0.0;
  for (int k = 1; k < kCount / 2; k += 1) {
    const double hz = k * kRate_hz / kCount;
    if (hz > 30.0) break;
    std::complex<double> sum = 0.0;
    for (int i = 0; i < kCount; ++i) {
      sum += x[static_cast<std::size_t>(i)] * std::polar(1.0, -2.0 * std::numbers::pi * hz * i / kRate_hz);
    }
    total += std::norm(sum);
    if (hz >= 8.0 && hz <= 12.0) inside += std::norm(sum);
  }
  CHECK(inside / total > 0.7);
}
