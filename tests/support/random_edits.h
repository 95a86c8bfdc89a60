/// Edits at random, most of them ones that can be applied: for property tests.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "engine/core/random.h"
#include "engine/demonstration/clip.h"
#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::testing {

/// Every kind of edit comes up; times lie within `length_s`. A splice or overdub takes its clip from `source`, if there
/// is one.
inline demonstration::Edit random_edit(Random& random, double length_s,
                                       const demonstration::Demonstration* source = nullptr) {
  using namespace demonstration;
  const double a = random.uniform(0.0, length_s);
  const double b = random.uniform(0.0, length_s);
  const double from_s = std::min(a, b);
  const double to_s = std::max(a, b);
  const auto arms = static_cast<Arms>(random.below(3));
  const Eigen::Vector3d by(random.uniform(-0.005, 0.005), random.uniform(-0.005, 0.005), random.uniform(0.0, 0.005));
  std::shared_ptr<const Clip> clip;
  if (source != nullptr) {
    if (auto taken = clip_of(*source, from_s, to_s)) clip = std::make_shared<const Clip>(std::move(*taken));
  }
  const std::vector<Edit> choice{
      Trim{0.1 * from_s, length_s - 0.1 * from_s},
      TrimIdle{0.002, 0.3, 0.1, true, random.below(2) == 0, 0.0, static_cast<int>(random.below(3)), {a}},
      Rename{"Name " + std::to_string(random.below(100))},
      LabelSegment{static_cast<Segment>(random.below(5)), from_s, to_s},
      ProposeLabels{},
      DeleteSpan{from_s, from_s + 0.1 * (to_s - from_s), random.below(2) == 0},
      Splice{1, from_s, to_s, b, random.below(2) == 0 ? 0.0 : b + 0.2, static_cast<Align>(random.below(3)), 0, clip,
             static_cast<int>(random.below(7)) - 1},
      Overdub{1, from_s, to_s, b, arms, random.below(2) == 0 ? 0.0 : 0.3, 0, clip},
      Bridge{from_s, to_s, arms, static_cast<BridgeShape>(random.below(2)), random.below(2) == 0 ? 0.0 : 0.05, {by}},
      MoveTool{arms, a, by, 0.5, static_cast<Falloff>(random.below(4))},
      RotateTool{arms, a, 50.0 * by, static_cast<TurnFrame>(random.below(2)), 0.5, Falloff::kSmooth},
      Offset{arms, by},
      Smooth{from_s, to_s, arms, static_cast<Filter>(random.below(3)), 0.2, 0.001, random.below(2) == 0,
             random.below(2) == 0, random.below(2) == 0},
      Simplify{from_s, to_s, arms, 0.0005},
      Resample{random.below(2) == 0 ? 200.0 : 100.0, static_cast<ResampleBy>(random.below(3))},
      Retime{from_s,
             to_s,
             static_cast<RetimeTo>(random.below(5)),
             random.uniform(0.5, 1.5),
             1.0,
             0.05,
             random.below(2) == 0 ? 0.0 : 0.1,
             random.below(2) == 0 ? 0.0 : 0.2,
             {{0.5 * (from_s + to_s), from_s + random.uniform(0.0, 0.8) * (to_s - from_s)}}},
      SnapToGrid{from_s, to_s, Arms::kLeft, random.below(2) == 0},
      SetJaw{arms, from_s, to_s, 0.3, 0.1},
      JawEvents{from_s, to_s, arms, 0.1},
      Mirror{},
      Retarget{static_cast<int>(random.below(6)), static_cast<int>(random.below(6))},
      Perturb{0.001, 0.5, random.next()},
      Revert{from_s, to_s, arms, static_cast<RevertWhat>(random.below(4))},
      AddNote{"word", from_s, to_s, "tag", static_cast<int>(random.below(6)), static_cast<NoteColour>(random.below(7)),
              static_cast<NoteGlyph>(random.below(6))},
      RemoveNote{static_cast<std::int64_t>(random.below(50))},
  };
  return choice[random.below(static_cast<std::uint32_t>(choice.size()))];
}

}  // namespace trocar::testing
