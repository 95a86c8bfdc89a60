#include "engine/learning/field_mask.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/learning/policy.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

TEST_CASE("a mask leaves the values of its cells as they are and makes all others unknown") {
  TrainOptions options;
  options.episodes = 1000;
  Progress progress;
  const Model model = train(spatial::Grid{}, {testing::sample_demonstrations()[1]}, options, progress).value();
  const Basin outcomes = basin(model, greedy_policy(model));
  const Field safe = field(model, Layer::kSafe);
  const Field whole = field(model, Layer::kExpert);
  spatial::CellSet experts(model.grid);
  for (const spatial::CellIndex cell : model.experts.front()) experts.insert(cell);
  for (const FieldMask mask : all_field_masks()) {
    CAPTURE(to_string(mask));
    const Field shown = masked(whole, model, outcomes, mask);
    int kept = 0;
    for (std::size_t s = 0; s < whole.values.size(); ++s) {
      const bool wanted = mask == FieldMask::kNone      ? true
                          : mask == FieldMask::kSafe    ? safe.values[s] != 0.0
                          : mask == FieldMask::kExpert  ? experts.flags()[s] != 0
                          : mask == FieldMask::kVisited ? model.visits[s] > 0
                                                        : outcomes.end[s] == RolloutEnd::kArrives;
      CHECK(std::isfinite(shown.values[s]) == wanted);
      if (wanted) CHECK(shown.values[s] == whole.values[s]);
      kept += wanted ? 1 : 0;
    }
    CHECK(kept > 0);
    CHECK(field_mask_from(to_string(mask)).value() == mask);
  }
  CHECK(field_mask_from("some").error().text() == "there is no mask some; there are none, safe, expert, visited, arrives");
}
