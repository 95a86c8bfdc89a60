#include "engine/review/review.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "engine/demonstration/edits.h"
#include "engine/review/fixes.h"
#include "tests/support/document_samples.h"
#include "tests/support/recorded_transfer.h"

using namespace trocar;
using namespace trocar::review;
using namespace trocar::demonstration;
using trocar::testing::transfer;

namespace {

std::vector<Problem> of_kind(const std::vector<Problem>& problems, ProblemKind kind) {
  std::vector<Problem> found = problems;
  std::erase_if(found, [kind](const Problem& problem) { return problem.kind != kind; });
  return found;
}

std::vector<Problem> problems_of(const Demonstration& document) {
  return Reviewer().make(document).problems;
}

Demonstration edited(const Demonstration& document, const Edit& edit) {
  return apply(document, edit).value();
}

/// The transfer with its left tool pushed far down while it hovers.
Demonstration pushed_into_the_board() {
  MoveTool move;
  move.at_s = 3.0;
  move.by_m = {0.0, 0.0, -0.045};
  move.radius_s = 0.5;
  return edited(transfer(1), move);
}

Demonstration fixed(const Demonstration& document, const Problem& problem) {
  return edited(document, edit_of_fix(problem).value());
}

}  // namespace

TEST_CASE("an expert's transfer has no errors, whatever the seed, the block and the goal") {
  for (int seed = 1; seed <= 8; ++seed) {
    const Demonstration document = transfer(static_cast<std::uint64_t>(seed), seed % 6, (2 * seed) % 6);
    const std::vector<Problem> problems = problems_of(document);
    for (const Problem& problem : problems) {
      CAPTURE(seed);
      CAPTURE(problem.message);
      CHECK(problem.severity != Severity::kError);
    }
  }
}

TEST_CASE("a tool in the board is an error with its depth, and its fix lifts it out") {
  const Demonstration document = pushed_into_the_board();
  const auto found = of_kind(problems_of(document), ProblemKind::kCollision);
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].severity == Severity::kError);
  CHECK(found[0].id == "collision-1");
  CHECK(found[0].arm == 0);
  CHECK(found[0].begin_s > 2.5);
  CHECK(found[0].end_s < 3.5);
  CHECK(found[0].message.find("mm into") != std::string::npos);
  Demonstration mended = document;
  for (const Edit& edit : fixes_of_all(document)) mended = edited(mended, edit);
  CHECK(of_kind(problems_of(mended), ProblemKind::kCollision).empty());
}

TEST_CASE("a tool that leans on a peg is told which one, and goes around it when it is fixed") {
  Demonstration document = transfer(1);
  // To beside start peg 2 while the arm is on its way.
  const Sample at = document.sample_at(2.0);
  MoveTool move;
  move.at_s = 2.0;
  const auto& p = at.arms[0].measured.p;
  const Eigen::Vector3d tip(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  move.by_m = peg_board::start_peg(2) + Eigen::Vector3d(0.0, 0.0015, 0.020) - tip;
  move.radius_s = 0.6;
  document = edited(document, move);
  const auto found = of_kind(problems_of(document), ProblemKind::kCollision);
  REQUIRE_FALSE(found.empty());
  CHECK(std::any_of(found.begin(), found.end(), [](const Problem& each) {
    return each.message.find("start peg 2") != std::string::npos && each.fix.starts_with("move ");
  }));
  Demonstration mended = document;
  for (const Edit& edit : fixes_of_all(document)) mended = edited(mended, edit);
  CHECK(count_of(problems_of(mended), Severity::kError) == 0);
}

TEST_CASE("tools that meet are one error of both") {
  Demonstration document = transfer(1);
  MoveTool move;
  move.arms = Arms::kRight;
  move.at_s = 1.0;
  const Sample at = document.sample_at(1.0);
  const Eigen::Vector3d left = at.arms[0].measured.pose().p;
  move.by_m = left - at.arms[1].measured.pose().p;
  document = edited(document, move);
  const auto found = of_kind(problems_of(document), ProblemKind::kCollision);
  REQUIRE(found.size() >= 1);
  CHECK(found[0].arm == -1);
  CHECK(found[0].message.find("the other tool's") != std::string::npos);
}

TEST_CASE("a setpoint beyond a joint is an error with the joint and the angle; an import's only a warning") {
  Recording recording = testing::recording_of(transfer(1));
  for (std::size_t i = 400; i < 420; ++i) {
    ArmSample& arm = recording.samples[i].arms[0];
    arm.set_setpoint(
        {arm.setpoint().p, arm.setpoint().q * Eigen::Quaterniond(Eigen::AngleAxisd(1.9, Eigen::Vector3d::UnitX()))},
        arm.setpoint_jaw_rad);
  }
  for (const bool imported : {false, true}) {
    if (imported) recording.provenance.operator_kind = "imported";
    const auto document = make_demonstration({1}, "Bent", std::make_shared<const Recording>(recording)).value();
    const auto found = of_kind(problems_of(document), ProblemKind::kJoint);
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == (imported ? Severity::kWarning : Severity::kError));
    CHECK(found[0].message.find("the left arm's wrist") == 0);
    CHECK(found[0].message.find("beyond its limit of") != std::string::npos);
    CHECK(found[0].begin_s == doctest::Approx(document.time_of(document.samples[400])));
  }
}

TEST_CASE("too fast a stretch is capped by its fix") {
  const Demonstration whole = transfer(1);
  Retime hurry;
  hurry.from_s = 1.0;
  hurry.to_s = 4.0;
  hurry.scale = 0.1;
  const Demonstration document = edited(whole, hurry);
  const auto found = of_kind(problems_of(document), ProblemKind::kSpeed);
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].fix.starts_with("retime --from "));
  CHECK(found[0].fix.find("--mode speed-cap") != std::string::npos);
  Demonstration mended = document;
  for (const Edit& edit : fixes_of_all(document)) mended = edited(mended, edit);
  CHECK(of_kind(problems_of(mended), ProblemKind::kSpeed).empty());
}

TEST_CASE("jaws that are told to snap shut begin to close early enough, and still close") {
  Demonstration document = transfer(1);
  std::vector<Sample> samples = document.samples.to_vector();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].arms[0].setpoint_jaw_rad = i < 500 ? 0.7 : 0.02;
    for (demonstration::CompactPose& block : samples[i].blocks) block.p = {};  // as in an import
  }
  document.samples = demonstration::SampleTrack(std::move(samples));
  const auto snaps = [](const Demonstration& shown) {
    auto found = of_kind(problems_of(shown), ProblemKind::kJaw);
    std::erase_if(found, [](const Problem& each) { return each.message.find("the left jaws are told") != 0; });
    return found;
  };
  const auto found = snaps(document);
  REQUIRE(found.size() == 1);
  const Demonstration mended = fixed(document, found[0]);
  CHECK(snaps(mended).empty());
  const auto jaw = [&](std::size_t i) { return Sample(mended.samples[i]).arms[0].setpoint_jaw_rad; };
  CHECK(jaw(300) == 0.7);
  CHECK(jaw(500) == doctest::Approx(0.02));
  CHECK(jaw(mended.samples.size() - 1) == 0.02);
}

TEST_CASE("a gap is bridged by its fix, and a missing label proposed") {
  const Demonstration whole = transfer(1);
  DeleteSpan lift;
  lift.from_s = 2.0;
  lift.to_s = 2.2;
  lift.ripple = false;
  const Demonstration gap = edited(whole, lift);
  const auto time = of_kind(problems_of(gap), ProblemKind::kTime);
  REQUIRE(time.size() == 1);
  CHECK(of_kind(problems_of(fixed(gap, time[0])), ProblemKind::kTime).empty());
  Demonstration bare = whole;
  bare.segments.clear();
  const auto segments = of_kind(problems_of(bare), ProblemKind::kSegments);
  REQUIRE_FALSE(segments.empty());
  CHECK(segments[0].fix == "propose-labels");
  CHECK(of_kind(problems_of(fixed(bare, segments[0])), ProblemKind::kSegments).empty());
}

TEST_CASE("fixing all makes fewer problems and never more errors, one edit each") {
  Demonstration document = pushed_into_the_board();
  DeleteSpan lift;
  lift.from_s = 6.0;
  lift.to_s = 6.4;
  lift.ripple = false;
  document = edited(document, lift);
  document.segments.clear();
  const std::vector<Problem> before = problems_of(document);
  const std::vector<Edit> edits = fixes_of_all(document);
  CHECK(edits.size() >= 3);
  Demonstration mended = document;
  for (const Edit& edit : edits) mended = edited(mended, edit);
  const std::vector<Problem> after = problems_of(mended);
  CHECK(after.size() < before.size());
  CHECK(count_of(after, Severity::kError) == 0);
}

TEST_CASE("a model's segment must stay in its safe set and end in its goal") {
  const Demonstration document = transfer(1);
  SegmentGoal goal{"Model A", Segment::kA, spatial::Grid{}, spatial::CellSet(spatial::Grid{}, true), {}};
  ReviewOptions options;
  const auto span = document.segment(Segment::kA).value();
  const Sample last = document.samples_in(span).back();
  goal.goal = goal.grid.cell_at(last.arms[0].measured.pose().p).value();
  options.goals = {goal};
  const auto with = [&](ProblemKind kind) { return of_kind(Reviewer().make(document, options).problems, kind); };
  CHECK(with(ProblemKind::kSafeSet).empty());
  CHECK(with(ProblemKind::kEnds).empty());
  options.goals[0].goal =
      goal.grid.neighbour(*goal.grid.neighbour(goal.goal, spatial::Action::kPlusY), spatial::Action::kPlusY).value();
  options.goals[0].safe = spatial::CellSet(goal.grid, false);
  REQUIRE(with(ProblemKind::kEnds).size() == 1);
  CHECK(with(ProblemKind::kEnds)[0].message == "segment A ends 2 cells from the goal of Model A");
  CHECK(with(ProblemKind::kSafeSet).size() == 1);
}

TEST_CASE("a tool that strays from the safe set is led back into it by its fix") {
  const Demonstration document = transfer(1);
  const auto span = document.segment(Segment::kA).value();
  SegmentGoal goal{"Model A", Segment::kA, spatial::Grid{}, spatial::CellSet(spatial::Grid{}), {}};
  std::vector<spatial::CellIndex> path;
  for (const Sample& sample : document.samples_in(span)) {
    if (const auto cell = goal.grid.cell_at(sample.arms[0].measured.pose().p)) path.push_back(*cell);
  }
  goal.safe = spatial::cells_within(goal.grid, path, 1);
  goal.goal = path.back();
  ReviewOptions options;
  options.goals = {goal};
  MoveTool stray;
  stray.at_s = 0.5 * (span.begin_s + span.end_s);
  stray.by_m = {0.0, 0.008, 0.0};
  stray.radius_s = 0.3;
  const Demonstration strayed = edited(document, stray);
  const auto strays = of_kind(Reviewer().make(strayed, options).problems, ProblemKind::kSafeSet);
  REQUIRE_FALSE(strays.empty());
  REQUIRE(strays[0].fix.starts_with("move "));
  Demonstration mended = strayed;
  for (const Edit& edit : fixes_of_all(strayed, options)) mended = edited(mended, edit);
  CHECK(of_kind(Reviewer().make(mended, options).problems, ProblemKind::kSafeSet).size() < strays.size());
}

TEST_CASE("a gripper that closes on nothing stays open by its fix") {
  Demonstration document = transfer(1);
  SetJaw open;
  open.arms = Arms::kLeft;
  open.from_s = 0.2;
  open.to_s = 0.6;
  open.jaw_rad = 0.4;
  SetJaw close = open;
  close.from_s = 0.6;
  close.to_s = 0.9;
  close.jaw_rad = 0.0;
  document = edited(edited(document, open), close);
  const auto found = of_kind(problems_of(document), ProblemKind::kJaw);
  const auto nothing = std::find_if(found.begin(), found.end(), [](const Problem& each) {
    return each.message.find("closes on nothing") != std::string::npos;
  });
  REQUIRE(nothing != found.end());
  REQUIRE(nothing->fix.starts_with("jaw "));
  const Demonstration mended = fixed(document, *nothing);
  CHECK(of_kind(problems_of(mended), ProblemKind::kJaw).size() < found.size());
}

TEST_CASE("a transfer to another peg than it says ends elsewhere") {
  Demonstration document = transfer(1);
  CHECK(of_kind(problems_of(document), ProblemKind::kEnds).empty());
  document.goal = 4;
  const auto found = of_kind(problems_of(document), ProblemKind::kEnds);
  REQUIRE(found.size() == 1);
  CHECK(found[0].message.find("from goal peg 4") != std::string::npos);
}

TEST_CASE("a fix is what is typed after demo edit, without what is as usual") {
  MoveTool move;
  move.at_s = 3.2;
  move.by_m = {0.001, 0.0, 0.0};
  CHECK(words_of_fix(move) == "move --at 3.2 --by-mm 1,0,0");
  CHECK(words_of_fix(ProposeLabels{}) == "propose-labels");
  DeleteSpan cut;
  cut.ripple = false;
  CHECK(words_of_fix(cut) == "delete --from 0 --to 0 --ripple=no");
}
