#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "engine/demonstration/discretise.h"
#include "engine/demonstration/edit_effect.h"
#include "engine/demonstration/edit_stack.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/quick_edits.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/demonstration/snap_figures.h"
#include "engine/peg_board/peg_board.h"
#include "tests/support/document_samples.h"
#include "tests/support/random_edits.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

Demonstration applied(const Demonstration& document, const Edit& edit) {
  Result<Demonstration> result = apply(document, edit, 7);
  REQUIRE_MESSAGE(result.has_value(), (result ? "" : result.error().text()));
  return std::move(*result);
}

Eigen::Vector3d tip(const Demonstration& document, double t_s, std::size_t arm = 0) {
  return measured_tip(document.sample_at(t_s), arm);
}

double greatest_step_m(const Demonstration& document, std::size_t arm) {
  double greatest = 0.0;
  const std::vector<Sample> samples = document.gated().to_vector();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    greatest = std::max(greatest, (measured_tip(samples[i], arm) - measured_tip(samples[i - 1], arm)).norm());
  }
  return greatest;
}

/// The moving demonstration, standing still for 2 s in the middle and carrying block 0 from 6 s to 8 s.
Demonstration with_pause_and_grasp() {
  Recording recording = testing::moving_recording(2000);
  for (std::size_t i = 801; i < 1200; ++i) {
    recording.samples[i].arms = recording.samples[800].arms;
  }
  for (std::size_t i = 1200; i < 1600; ++i) recording.samples[i].flags |= kLeftHolds;
  return make_demonstration({1}, "Paused", std::make_shared<const Recording>(std::move(recording))).value();
}

}  // namespace

TEST_CASE("whatever is done, what comes out is a valid demonstration and what went in is untouched") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    Demonstration document = testing::moving_demonstration(600);
    for (int i = 0; i < 8; ++i) {
      const Edit edit = testing::random_edit(random, document.full_duration_s(), &document);
      const std::uint64_t before = document.hash();
      const Result<Demonstration> after = apply(document, edit, i);
      RC_ASSERT(document.hash() == before);
      if (!after) continue;
      RC_ASSERT(check_samples(after->samples.to_vector()).has_value());
      RC_ASSERT(after->gated().size() >= 2U);
      RC_ASSERT(after->begin_s < after->end_s);
      RC_ASSERT(after->end_s <= after->full_duration_s() + 1e-9);
      for (std::size_t s = 0; s < after->segments.size(); ++s) {
        RC_ASSERT(after->segments[s].begin_s < after->segments[s].end_s);
        if (s > 0) RC_ASSERT(after->segments[s - 1].end_s <= after->segments[s].begin_s + 1e-9);
      }
      document = *after;
    }
  }));
}

TEST_CASE("the stack gives again, from the recording, what its edits gave one after the other") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    Demonstration document = testing::moving_demonstration(400);
    for (int i = 1; i <= 6; ++i) {
      Result<Demonstration> after = apply(document, testing::random_edit(random, 2.0, &document), i);
      if (after) document = std::move(*after);
    }
    const Demonstration again = with_stack(document, *document.stack);
    RC_ASSERT(again.hash() == document.hash());
    RC_ASSERT(again.name == document.name);
  }));
}

TEST_CASE("a ripple delete closes the gap and takes labels, notes and gates along") {
  Demonstration document = testing::moving_demonstration(1000);
  document = applied(document, AddNote{"late", 4.5, 4.6, "", 0});
  const Demonstration cut = applied(document, DeleteSpan{1.0, 2.0, true});
  CHECK(cut.samples.size() == 800);
  CHECK(cut.full_duration_s() == doctest::Approx(3.995));
  CHECK(cut.notes.front().begin_s == doctest::Approx(3.5));
  CHECK(tip(cut, 1.0) == tip(document, 2.0));
  CHECK(cut.segment(Segment::kE)->begin_s == doctest::Approx(3.0));
  const Demonstration lifted = applied(document, DeleteSpan{1.0, 2.0, false});
  CHECK(lifted.samples.size() == 800);
  CHECK(lifted.full_duration_s() == doctest::Approx(4.995));
}

TEST_CASE("an hour's samples are shared, not copied, by a cut in the middle") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration cut = applied(document, DeleteSpan{1.0, 2.0, true});
  CHECK(cut.samples.slice(0, 200).same_pieces(document.samples.slice(0, 200)));
  CHECK(cut.samples.slice(200, 600).shifted(1000).same_pieces(document.samples.slice(400, 600)));
}

TEST_CASE("a tool is moved by what is asked at its instant, by nothing at the edge, and takes the block along") {
  const Demonstration document = with_pause_and_grasp();
  const Eigen::Vector3d by(0.0025, 0.0, 0.001);
  const Demonstration moved = applied(document, MoveTool{Arms::kLeft, 7.0, by, 0.5, Falloff::kSmooth});
  CHECK((tip(moved, 7.0) - tip(document, 7.0) - by).norm() < 1e-8);
  CHECK((tip(moved, 6.4) - tip(document, 6.4)).norm() == 0.0);
  CHECK((tip(moved, 7.0, 1) - tip(document, 7.0, 1)).norm() == 0.0);
  const auto block = [](const Demonstration& shown) { return shown.sample_at(7.0).blocks[0].pose().p; };
  CHECK((block(moved) - block(document) - by).norm() < 1e-8);
  const Demonstration back = applied(moved, MoveTool{Arms::kLeft, 7.0, -by, 0.5, Falloff::kSmooth});
  CHECK((tip(back, 6.8) - tip(document, 6.8)).norm() < 2e-8);
}

TEST_CASE("a tool is turned about its tip in its own frame or that of the board") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Eigen::Vector3d by(0.0, 0.0, 0.3);
  const Demonstration turned = applied(document, RotateTool{Arms::kRight, 2.0, by, TurnFrame::kBoard, 0.3});
  CHECK(tip(turned, 2.0, 1) == tip(document, 2.0, 1));
  const auto q = turned.sample_at(2.0).arms[1].measured.pose().q;
  CHECK(spatial::angle_between(q, document.sample_at(2.0).arms[1].measured.pose().q) == doctest::Approx(0.3));
}

TEST_CASE("smoothing lowers the jerk, keeps within its limit and leaves ends and grasps alone") {
  Recording recording = testing::moving_recording(2000);
  Random random(1);
  for (Sample& sample : recording.samples) {
    for (float& p : sample.arms[0].measured.p) p += static_cast<float>(2e-4 * random.normal());
  }
  for (std::size_t i = 1200; i < 1600; ++i) recording.samples[i].flags |= kLeftHolds;
  const Demonstration document =
      make_demonstration({1}, "Noisy", std::make_shared<const Recording>(std::move(recording))).value();
  for (const Filter filter : {Filter::kSavitzkyGolay, Filter::kGaussian, Filter::kLowPass}) {
    const Demonstration smooth = applied(document, Smooth{0.0, 9.9, Arms::kLeft, filter, 0.2, 0.0005, true});
    CHECK(greatest_step_m(smooth, 0) < greatest_step_m(document, 0));
    CHECK(tip(smooth, 0.0) == tip(document, 0.0));
    CHECK(tip(smooth, 6.0) == tip(document, 6.0));
    for (double t_s = 0.0; t_s < 9.9; t_s += 0.05) {
      CHECK((tip(smooth, t_s) - tip(document, t_s)).norm() <= 0.0005 + 1e-8);
    }
  }
}

TEST_CASE("filters leave a straight path at constant speed as it is") {
  Recording recording = testing::moving_recording(400);
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    recording.samples[i].arms[0].measured =
        CompactPose::from(spatial::Pose::translation({1e-5 * static_cast<double>(i), 0.0, 0.03}));
  }
  const Demonstration document =
      make_demonstration({1}, "Straight", std::make_shared<const Recording>(std::move(recording))).value();
  for (const Filter filter : {Filter::kSavitzkyGolay, Filter::kGaussian}) {
    const Demonstration smooth = applied(document, Smooth{0.0, 1.9, Arms::kLeft, filter, 0.2, 0.01, false});
    for (double t_s = 0.0; t_s < 1.9; t_s += 0.1) CHECK((tip(smooth, t_s) - tip(document, t_s)).norm() < 2e-8);
  }
}

TEST_CASE("a simplified path stays within the tolerance and is straight between few knots") {
  const Demonstration document = testing::moving_demonstration(2000);
  const Demonstration simple = applied(document, Simplify{0.0, 9.99, Arms::kLeft, 0.0005});
  int bends = 0;
  const std::vector<Sample> samples = simple.samples.to_vector();
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const Eigen::Vector3d bend =
        measured_tip(samples[i - 1], 0) - 2.0 * measured_tip(samples[i], 0) + measured_tip(samples[i + 1], 0);
    if (bend.norm() > 1e-7) ++bends;
    CHECK((measured_tip(samples[i], 0) - measured_tip(document.samples[i], 0)).norm() <= 0.0005 + 1e-8);
  }
  CHECK(bends > 3);
  CHECK(bends < 60);
}

TEST_CASE("a bridge starts and ends where the motion was, and its speed sets its duration") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration bridged = applied(document, Bridge{1.0, 2.0, Arms::kBoth, BridgeShape::kMinimumJerk, 0.0, {}});
  CHECK(bridged.samples.size() == document.samples.size());
  CHECK(tip(bridged, 1.0) == tip(document, 1.0));
  CHECK(tip(bridged, 2.0) == tip(document, 2.0));
  const Eigen::Vector3d middle = 0.5 * (tip(document, 1.0) + tip(document, 2.0));
  CHECK((tip(bridged, 1.5) - middle).norm() < 1e-7);
  const Demonstration slow = applied(document, Bridge{1.0, 2.0, Arms::kBoth, BridgeShape::kStraight, 0.001, {}});
  CHECK(slow.full_duration_s() > document.full_duration_s() + 1.0);
  CHECK(greatest_step_m(applied(slow, Trim{1.0, 2.0}), 0) <= 0.001 * 0.005 * 1.02);
  const Eigen::Vector3d via(0.0, -0.02, 0.05);
  const Demonstration over = applied(document, Bridge{1.0, 2.0, Arms::kLeft, BridgeShape::kStraight, 0.0, {via}});
  double nearest = 1.0;
  for (const Sample& sample : over.gated()) nearest = std::min(nearest, (measured_tip(sample, 0) - via).norm());
  CHECK(nearest < 0.0005);
}

TEST_CASE("a bridge fills the gap that a lift left") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration lifted = applied(document, DeleteSpan{1.0, 2.0, false});
  const Demonstration bridged = applied(lifted, Bridge{0.995, 2.0, Arms::kBoth, BridgeShape::kMinimumJerk, 0.0, {}});
  CHECK(bridged.samples.size() == document.samples.size());
}

TEST_CASE("a bridge over the pegs goes up, across and down, and rests at its corners") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration bridged = applied(document, Bridge{1.0, 3.0, Arms::kLeft, BridgeShape::kOver, 0.0, {}});
  const double over_m = peg_board::kPegHeight_m + peg_board::kBlockHeight_m;
  const Eigen::Vector3d begin = bridged.sample_at(1.0).arms[0].measured.pose().p;
  const Eigen::Vector3d end = bridged.sample_at(3.0).arms[0].measured.pose().p;
  double highest_m = 0.0;
  for (double t_s = 1.0; t_s <= 3.0; t_s += 0.01) {
    const Eigen::Vector3d p_WT = bridged.sample_at(t_s).arms[0].measured.pose().p;
    highest_m = std::max(highest_m, p_WT.z());
    // Nothing but up or down while it is low.
    const bool above_begin = (p_WT - begin).head<2>().norm() < 1e-6;
    const bool above_end = (p_WT - end).head<2>().norm() < 1e-6;
    CHECK((p_WT.z() > over_m || above_begin || above_end));
  }
  CHECK(highest_m > over_m);
}

TEST_CASE("a bridge is as dense as what is beside it, and one of a journal from before fills at 200 Hz") {
  const Demonstration document = testing::slow_demonstration(120, 30.0);
  const Demonstration lifted = applied(document, DeleteSpan{1.0, 1.5, false});
  Bridge bridge;
  bridge.from_s = 1.0;
  bridge.to_s = 1.5;
  const Demonstration bridged = applied(lifted, bridge);
  CHECK(bridged.samples.size() == document.samples.size());
  for (std::size_t i = 1; i < bridged.samples.size(); ++i) {
    const std::int64_t step = bridged.samples.tick(i) - bridged.samples.tick(i - 1);
    CHECK((step >= 32 && step <= 35));
  }
  CHECK(sample_gaps(bridged.samples).empty());
  const auto old = edit_from_json("bridge", R"({"from_s": 1.0, "to_s": 1.5, "arms": "both", "shape": "minimum-jerk",
                                                 "peak_speed_m_s": 0.0, "via_m": [], "model": 0})");
  REQUIRE(old);
  CHECK(std::get<Bridge>(*old).rate_hz == 200.0);
  const Demonstration as_then = applied(lifted, *old);
  const std::size_t first = as_then.samples.lower_bound(as_then.tick_from(1.0));
  CHECK(as_then.samples.tick(first + 1) - as_then.samples.tick(first) == 5);
  Bridge dense = bridge;
  dense.rate_hz = 5000.0;
  CHECK_FALSE(apply(lifted, dense));
  // At 200 Hz both are the same.
  const Demonstration quick = applied(testing::moving_demonstration(1000), DeleteSpan{1.0, 1.5, false});
  Bridge by_rate = bridge;
  by_rate.rate_hz = 200.0;
  CHECK(applied(quick, by_rate).hash() == applied(quick, bridge).hash());
}

TEST_CASE("a bridge of a journal from before there were policies is read") {
  const auto edit = edit_from_json(
      "bridge",
      R"({"from_s": 1.0, "to_s": 2.0, "arms": "left", "shape": "straight", "peak_speed_m_s": 0.0, "via_m": []})");
  REQUIRE(edit);
  CHECK(std::get<Bridge>(*edit).model == 0);
  CHECK_FALSE(edit_from_json("bridge", R"({"from_s": 1.0, "model": 0})"));
}

TEST_CASE("a gripper that is told to close stays closed until it next does something else") {
  Demonstration document = testing::moving_demonstration(1000);
  const SetJaw close = gripper_event(document, Arms::kLeft, 0.5, false);
  CHECK(close.from_s == 0.5);
  CHECK(close.jaw_rad == kClosedJaw_rad);
  CHECK(close.to_s > 0.5);
  CHECK(close.to_s <= document.end_s);
  document.segments = {{Segment::kA, 0.0, 1.0}, {Segment::kB, 2.0, 3.0}};
  CHECK(label_from(document, Segment::kC, 1.2).to_s == 2.0);
  CHECK(label_from(document, Segment::kC, 3.2).to_s == document.end_s);
}

TEST_CASE("retiming scales, fits, caps and evens out the speed, and what follows moves along") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration twice = applied(document, Retime{1.0, 2.0, RetimeTo::kScale, 2.0});
  CHECK(twice.full_duration_s() == doctest::Approx(document.full_duration_s() + 1.0));
  CHECK((tip(twice, 2.0) - tip(document, 1.5)).norm() < 1e-7);
  CHECK(tip(twice, 3.0) == tip(document, 2.0));
  const Demonstration fitted = applied(document, Retime{1.0, 2.0, RetimeTo::kDuration, 1.0, 0.5});
  CHECK(fitted.full_duration_s() == doctest::Approx(document.full_duration_s() - 0.5));
  const double cap = 0.6 * greatest_step_m(document, 0);
  const Demonstration capped = applied(document, Retime{0.0, 4.9, RetimeTo::kSpeedCap, 1.0, 1.0, cap / 0.005});
  CHECK(greatest_step_m(applied(capped, Trim{0.0, capped.full_duration_s() - 0.1}), 0) < cap * 1.05);
  const Demonstration even = applied(document, Retime{0.0, 4.9, RetimeTo::kConstantSpeed, 1.0, 1.0, 0.01});
  CHECK(greatest_step_m(applied(even, Trim{0.0, even.full_duration_s() - 0.2}), 0) < 0.01 * 0.005 * 1.05);
}

TEST_CASE("resampling keeps the motion at any rate up to that of the ticks, and does not drift") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration half = applied(document, Resample{100.0});
  CHECK(half.samples.size() == 500);
  CHECK(tip(half, 2.0) == tip(document, 2.0));
  for (const double rate_hz : {1.0, 7.3, 30.0, 60.0, 300.0, 700.0, 1000.0}) {
    CAPTURE(rate_hz);
    const Demonstration other = applied(document, Resample{rate_hz});
    REQUIRE(other.samples.size() == static_cast<std::size_t>(std::floor(4.9955 * rate_hz)) + 1);
    for (std::size_t i = 0; i < other.samples.size(); ++i) {
      CHECK(std::abs(static_cast<double>(other.samples.tick(i)) - 1000.0 * static_cast<double>(i) / rate_hz) <= 0.5);
    }
    CHECK(sample_gaps(other.samples).empty());
    CHECK(usual_rate_hz(other.samples) == doctest::Approx(rate_hz).epsilon(1e-3));
  }
  const Demonstration camera = applied(document, Resample{30.0});
  CHECK(camera.samples.tick(1) == 33);
  CHECK(camera.samples.tick(2) == 67);
  CHECK(camera.samples.tick(3) == 100);
  CHECK(usual_rate_hz(camera.samples) == 30.0);
  // Stamps that jitter, and a gap, make it hardly another rate; the middle steps alone would say 28.3 Hz.
  std::vector<Sample> uneven;
  for (int i = 0; i < 300; ++i) {
    if (i >= 120 && i < 130) continue;
    uneven.push_back(testing::moving_sample(i));
    uneven.back().tick = std::llround(1000.0 * i / 30.0) + i * 7 % 5;
  }
  CHECK(usual_rate_hz(SampleTrack(uneven)) == doctest::Approx(30.0).epsilon(1e-3));
  for (const double rate_hz : {0.5, 1000.5}) {
    CHECK(apply(document, Resample{rate_hz}).error().text() == "a rate must be from 1 to 1000 Hz");
  }
}

TEST_CASE("a trim is kept within the demonstration, and one that changes nothing is refused") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Trim kept = kept_trim(document, Trim{-5.0, 3.0}).value();
  CHECK(kept.from_s == 0.0);
  CHECK(kept.to_s == 3.0);
  CHECK(kept_trim(document, Trim{1.0, 300.0}).value().to_s == document.full_duration_s());
  CHECK(kept_trim(document, Trim{-5.0, 300.0}).error().text() == "Moving is trimmed to 0.00–5.00 s already");
  const Demonstration trimmed = applied(document, Trim{1.0, 3.0});
  CHECK(kept_trim(trimmed, Trim{1.0, 3.0}).error().text() == "Moving is trimmed to 1.00–3.00 s already");
  CHECK(kept_trim(trimmed, Trim{-5.0, 300.0}).has_value());
}

TEST_CASE("mirroring says that no block fits a peg any more, and mirroring back does not") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration mirror = applied(document, Mirror{});
  const std::vector<std::string> remarks = effect_of(Mirror{}, document, mirror).remarks;
  REQUIRE(remarks.size() == 1);
  CHECK(remarks[0] ==
        "the mirrored block no longer fits a peg, as the board's pegs are no mirror image of each other: block 0 would "
        "begin 54.0 mm from its start peg and end 86.0 mm from goal peg 0; no block is transferred so");
  CHECK(effect_of(Mirror{}, mirror, applied(mirror, Mirror{})).remarks.empty());
  // It is so of every peg.
  for (int block = 0; block < peg_board::kBlockCount; ++block) {
    for (int goal = 0; goal < peg_board::kBlockCount; ++goal) {
      const Eigen::Vector3d opposite = peg_board::start_peg(block).cwiseProduct(Eigen::Vector3d(1.0, -1.0, 1.0));
      CHECK((opposite - peg_board::goal_peg(goal)).norm() > 0.004);
    }
  }
}

TEST_CASE("a path that was snapped makes single legal actions and passes cell centres") {
  const Demonstration document = testing::moving_demonstration(2000);
  const Demonstration snapped = applied(document, SnapToGrid{0.0, 9.9, Arms::kLeft, false});
  const spatial::Grid grid;
  std::optional<spatial::CellIndex> before;
  int off_axis = 0;
  for (const Sample& sample : snapped.samples_within(0.0, 9.85)) {
    const auto cell = grid.cell_at(measured_tip(sample, 0));
    REQUIRE(cell.has_value());
    if (before && *before != *cell) CHECK(steps_between(grid, *before, *cell).size() == 1);
    before = *cell;
    const Eigen::Vector3d off = (measured_tip(sample, 0) - grid.centre(*cell)).cwiseAbs();
    if ((off.array() > 1e-6).count() > 1) ++off_axis;
  }
  CHECK(off_axis == 0);
  // A corner of a cell is 2.5 mm √3 / 2 from its centre; a shortcut over filled cells may double it.
  CHECK((tip(snapped, 3.0) - tip(document, 3.0)).norm() < 2.0 * 0.00217);
  Recording outside = testing::moving_recording(100);
  for (Sample& sample : outside.samples) sample.arms[0].measured.p[2] = 0.2F;
  const auto far = make_demonstration({1}, "Far", std::make_shared<const Recording>(std::move(outside))).value();
  CHECK(apply(far, SnapToGrid{0.0, 0.4}).error().text() ==
        "the left tool is outside the agent's lattice at 0.00 s; it is nowhere within it in that span");
  Recording leaving = testing::moving_recording(100);
  for (std::size_t i = 60; i < 100; ++i) leaving.samples[i].arms[0].measured.p[2] = 0.2F;
  const auto half = make_demonstration({1}, "Half", std::make_shared<const Recording>(std::move(leaving))).value();
  CHECK(apply(half, SnapToGrid{0.0, 0.4}).error().text() ==
        "the left tool is outside the agent's lattice at 0.30 s; it is within it from 0.00 to 0.29 s");
  CHECK(apply(half, SnapToGrid{0.0, 0.29}).has_value());
}

TEST_CASE("a tool that goes through a corner of a cell from one sample to the next does not leap when it is snapped") {
  Recording recording = testing::moving_recording(200);
  const spatial::Grid grid;
  const Eigen::Vector3d corner = grid.centre(grid.index({8, 8, 8})) + Eigen::Vector3d::Constant(0.5 * grid.cell_m);
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    // 17 mm/s through the corner: the three faces are passed within two samples.
    const double way_m = 5e-5 * (static_cast<double>(i) - 100.3);
    const Eigen::Vector3d p_WT = corner + way_m * Eigen::Vector3d(1.0, 0.97, 0.94);
    recording.samples[i].arms[0].measured = CompactPose::from(spatial::Pose::translation(p_WT));
  }
  const auto document =
      make_demonstration({1}, "Corner", std::make_shared<const Recording>(std::move(recording))).value();
  const Demonstration snapped = applied(document, SnapToGrid{0.0, 0.995});
  double fastest_m_s = 0.0;
  for (std::size_t i = 1; i < snapped.samples.size(); ++i) {
    const double step_m = (measured_tip(snapped.samples[i], 0) - measured_tip(snapped.samples[i - 1], 0)).norm();
    fastest_m_s = std::max(fastest_m_s, step_m / 0.005);
  }
  CHECK(fastest_m_s > 0.05);
  CHECK(fastest_m_s < 0.151);
}

TEST_CASE("a path that was snapped and is snapped again stays as it is, bit for bit; a journal from before repeats") {
  const Demonstration document = testing::moving_demonstration(2000);
  for (const bool keep_offset : {false, true}) {
    SnapToGrid snap{0.0, 4.0, Arms::kLeft, keep_offset};
    const Demonstration once = applied(document, snap);
    CHECK(once.hash() != document.hash());
    CHECK(applied(once, snap).hash() == once.hash());
    snap.keep_snapped = false;
    CHECK(applied(document, snap).hash() == once.hash());
    CHECK(applied(once, snap).hash() != once.hash());
  }
  const auto old = edit_from_json("snap", R"({"from_s": 0.0, "to_s": 9.0, "arms": "both", "keep_offset": false})");
  REQUIRE(old);
  CHECK_FALSE(std::get<SnapToGrid>(*old).keep_snapped);
}

TEST_CASE("what snapping costs is told: its actions, how far it moves samples, cells filled in and come back to") {
  Recording recording = testing::moving_recording(8);
  const spatial::Grid grid;
  const auto at = [&](std::size_t i, int x, int y, double off_m) {
    const Eigen::Vector3d p_WT = grid.centre(grid.index({x, y, 10})) + Eigen::Vector3d(0.0, off_m, off_m);
    recording.samples[i].arms[0].measured = CompactPose::from(spatial::Pose::translation(p_WT));
  };
  // There, a diagonal over one cell that no sample is in, and back again.
  at(0, 5, 5, 0.0004);
  at(1, 5, 5, 0.0004);
  at(2, 6, 5, 0.0);
  at(3, 7, 6, 0.0);
  at(4, 7, 6, 0.0);
  at(5, 7, 7, 0.0);
  at(6, 7, 6, 0.0);
  at(7, 7, 6, 0.0);
  const auto document =
      make_demonstration({1}, "Told", std::make_shared<const Recording>(std::move(recording))).value();
  const auto told = snap_figures(document, SnapToGrid{0.0, 0.035}).value();
  REQUIRE(told.size() == 1);
  CHECK(told[0].actions == 5);
  CHECK(told[0].skipped_cells == 1);
  CHECK(told[0].repeated_cells == 1);
  const Demonstration snapped = applied(document, SnapToGrid{0.0, 0.035});
  double greatest_m = 0.0;
  double sum_m = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    const double by_m = (measured_tip(snapped.samples[i], 0) - measured_tip(document.samples[i], 0)).norm();
    greatest_m = std::max(greatest_m, by_m);
    sum_m += by_m;
  }
  CHECK(told[0].max_error_m == doctest::Approx(greatest_m).epsilon(1e-4));
  CHECK(told[0].mean_error_m == doctest::Approx(sum_m / 8.0).epsilon(1e-4));
  CHECK(told[0].max_error_m >= 0.0004);
}

TEST_CASE("a jaw opens to the angle, on a ramp at both edges") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration open = applied(document, SetJaw{Arms::kLeft, 1.0, 2.0, 0.9, 0.2});
  CHECK(open.sample_at(1.5).arms[0].setpoint_jaw_rad == doctest::Approx(0.9));
  CHECK(open.sample_at(1.0).arms[0].setpoint_jaw_rad == document.sample_at(1.0).arms[0].setpoint_jaw_rad);
  CHECK(open.sample_at(1.5).arms[1].jaw_rad == document.sample_at(1.5).arms[1].jaw_rad);
  CHECK_FALSE(apply(document, SetJaw{Arms::kLeft, 1.0, 2.0, 2.0, 0.2}));
}

TEST_CASE("a mirrored mirror is what it was, and left is right") {
  const Demonstration document = with_pause_and_grasp();
  const Demonstration mirror = applied(document, Mirror{});
  CHECK(tip(mirror, 7.0, 1).y() == -tip(document, 7.0, 0).y());
  CHECK((mirror.sample_at(7.0).flags & kRightHolds) != 0);
  CHECK(applied(mirror, Mirror{}).hash() == document.hash());
}

TEST_CASE("a retargeted transfer starts at the other block and ends at the other peg") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration other = applied(document, Retarget{3, 2});
  const Eigen::Vector3d to_block = peg_board::start_peg(3) - peg_board::start_peg(0);
  const Eigen::Vector3d to_goal = peg_board::goal_peg(2) - peg_board::goal_peg(0);
  CHECK((tip(other, 0.5) - tip(document, 0.5) - to_block).norm() < 1e-7);
  CHECK((tip(other, 4.99, 1) - tip(document, 4.99, 1) - to_goal).norm() < 1e-7);
  CHECK(other.block == 3);
  CHECK(other.goal == 2);
  CHECK_FALSE(apply(applied(document, DeleteSpan{3.9, 5.0, true}), Retarget{3, 2}));
}

TEST_CASE("noise is the same for a seed, another for another, and holds ends and grasps") {
  const Demonstration document = with_pause_and_grasp();
  const Demonstration one = applied(document, Perturb{0.001, 0.5, 1});
  CHECK(one.hash() == applied(document, Perturb{0.001, 0.5, 1}).hash());
  CHECK(one.hash() != applied(document, Perturb{0.001, 0.5, 2}).hash());
  CHECK(tip(one, 0.0) == tip(document, 0.0));
  CHECK(tip(one, 6.0) == tip(document, 6.0));
  CHECK((tip(one, 3.0) - tip(document, 3.0)).norm() > 1e-5);
}

TEST_CASE("a reverted span is as it was recorded") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration moved = applied(document, Offset{Arms::kBoth, {0.01, 0.0, 0.0}});
  const Demonstration reverted = applied(moved, Revert{1.0, 2.0});
  CHECK(tip(reverted, 1.5) == tip(document, 1.5));
  CHECK(tip(reverted, 2.5) == tip(moved, 2.5));
}

TEST_CASE("pauses inside are cut out, and a demonstration without one says so") {
  const Demonstration document = with_pause_and_grasp();
  const Demonstration trimmed = applied(document, TrimIdle{0.002, 0.3, 0.1, true, true});
  CHECK(document.full_duration_s() - trimmed.full_duration_s() == doctest::Approx(1.9).epsilon(0.1));
  CHECK(apply(testing::moving_demonstration(1000), TrimIdle{}).error().text() == "nothing is idle for long enough");
}

TEST_CASE("segments are told from the approach, the lift, the offer and the release") {
  Recording recording = testing::moving_recording(1000);
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    Sample& sample = recording.samples[i];
    sample.segment = Segment::kA;
    const auto put = [&](std::size_t arm, const Eigen::Vector3d& p) {
      sample.arms[arm].measured = CompactPose::from(spatial::Pose::translation(p));
    };
    put(0, {0.0, i < 200 ? 0.1 : 0.0, 0.02});
    put(1, {0.0, i < 600 ? 0.1 : 0.0, 0.02});
    sample.blocks[0].p[2] = i < 400 ? 0.007F : 0.03F;
    if (i >= 300 && i < 800) sample.flags |= kLeftHolds;
    if (i >= 700) sample.flags |= kRightHolds;
  }
  const auto document =
      make_demonstration({1}, "Told", std::make_shared<const Recording>(std::move(recording))).value();
  const Demonstration labelled = applied(document, ProposeLabels{});
  REQUIRE(labelled.segments.size() == 5);
  const std::array<double, 5> begins{0.0, 1.0, 2.0, 3.0, 4.0};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(labelled.segments[i].label == static_cast<Segment>(i));
    CHECK(labelled.segments[i].begin_s == doctest::Approx(begins[i]));
  }
}

TEST_CASE("an edit of the stack is switched off, moved, changed and removed without touching the others") {
  Demonstration document = testing::moving_demonstration(1000);
  const std::uint64_t recorded = document.hash();
  document = apply(document, Offset{Arms::kLeft, {0.001, 0.0, 0.0}}, 1).value();
  document = apply(document, Trim{1.0, 4.0}, 2).value();
  const auto restacked = [&](const Result<EditStack>& stack) { return with_stack(document, stack.value()); };
  const Demonstration off = restacked(entry_enabled(*document.stack, 1, false));
  CHECK((tip(off, 2.0) - measured_tip(document.recorded[400], 0)).norm() == 0.0);
  CHECK(off.begin_s == 1.0);
  CHECK(restacked(entry_moved(*document.stack, 2, 0)).hash() == document.hash());
  const Demonstration further = restacked(entry_replaced(*document.stack, 1, Offset{Arms::kLeft, {0.003, 0.0, 0.0}}));
  CHECK(tip(further, 2.0).x() - tip(document, 2.0).x() == doctest::Approx(0.002).epsilon(1e-4));
  const EditStack none = entry_removed(entry_removed(*document.stack, 1).value(), 2).value();
  CHECK(with_stack(document, none).hash() == recorded);
  CHECK_FALSE(entry_enabled(*document.stack, 9, false));
}

TEST_CASE("an edit whose span is gone is passed over and says why, and is applied again when the span is back") {
  Demonstration document = testing::moving_demonstration(1000);
  document = apply(document, DeleteSpan{4.0, 5.0, true}, 1).value();
  document = apply(document, Offset{Arms::kLeft, {0.001, 0.0, 0.0}}, 2).value();
  const std::uint64_t before = document.hash();
  document = with_stack(document, entry_enabled(*document.stack, 1, false).value());
  document = apply(document, Smooth{4.2, 4.8}, 3).value();
  const std::uint64_t smoothed = document.hash();
  const Demonstration conflict = with_stack(document, entry_enabled(*document.stack, 1, true).value());
  REQUIRE(conflict.stack->size() == 3);
  CHECK(conflict.stack->at(0).conflict.empty());
  CHECK(conflict.stack->at(1).conflict.empty());
  CHECK(conflict.stack->at(2).conflict.starts_with("4.200–4.800 s holds 0 samples"));
  CHECK(conflict.stack->at(2).enabled);
  CHECK(conflict.hash() == before);
  const Demonstration back = with_stack(conflict, entry_removed(*conflict.stack, 1).value());
  CHECK(back.stack->back().conflict.empty());
  CHECK(back.hash() == smoothed);
}

TEST_CASE("the id of an edit is read as it is written, of one step and of several") {
  CHECK(entry_words(12) == "12");
  CHECK(entry_words(entry_id(12, 3)) == "12.3");
  CHECK(entry_from("12") == 12);
  CHECK(entry_from("12.3") == entry_id(12, 3));
  CHECK(entry_from(std::to_string(entry_id(12, 3))) == entry_id(12, 3));
  for (const char* wrong : {"", "x", "12.", ".3", "12.x", "-1", "12.99999999999"}) CHECK_FALSE(entry_from(wrong));
}

TEST_CASE("huge parameters and a gap of years are refused in a sentence, at once") {
  Recording recording = testing::moving_recording(100);
  for (std::size_t i = 50; i < recording.samples.size(); ++i) recording.samples[i].tick += 900'000'000'000;
  recording.provenance.block = 77;
  const auto document =
      make_demonstration({1}, "Years", std::make_shared<const Recording>(std::move(recording))).value();
  const auto error = [&](const Edit& edit) {
    const Result<Demonstration> result = apply(document, edit);
    return result ? std::string() : result.error().text();
  };
  CHECK(error(Bridge{0.1, document.end_s, Arms::kBoth, BridgeShape::kStraight, 0.0, {}}) ==
        "the bridge would last for more than an hour");
  CHECK(error(Bridge{0.1, 0.2, Arms::kBoth, BridgeShape::kStraight, 1e-12, {}}) ==
        "the bridge would last for more than an hour");
  CHECK(error(Resample{100.0}) == "that would make more than ten million samples");
  CHECK(error(Perturb{0.001, 1.0, 1}) == "the period is too short for so long a demonstration");
  CHECK(error(Retime{0.0, 0.2, RetimeTo::kScale, 1e-12}) == "the span would have no duration");
  CHECK(error(Retime{0.0, 0.2, RetimeTo::kScale, 1e12}) == "the span would last for more than an hour");
  CHECK(error(ProposeLabels{}) == "it is not known which block was to be carried");
  CHECK(error(Retarget{1, 1}) == "it is not known which block was carried to which peg");
  CHECK_FALSE(error(MoveTool{Arms::kLeft, std::nan(""), Eigen::Vector3d::Zero(), 1.0}).empty());
  CHECK_FALSE(error(MoveTool{Arms::kLeft, 0.1, Eigen::Vector3d::Constant(1e300), 0.1}).empty());
  CHECK_FALSE(error(SetJaw{Arms::kLeft, 0.0, 0.2, std::nan(""), 0.1}).empty());
  CHECK_FALSE(error(Smooth{0.0, 0.2, Arms::kLeft, Filter::kGaussian, std::nan(""), 0.1}).empty());
}
