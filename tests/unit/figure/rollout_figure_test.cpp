#include "engine/figure/rollout_figure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "engine/core/file.h"
#include "engine/figure/curve_figure.h"
#include "engine/figure/field_figure.h"
#include "engine/figure/outcome_colours.h"
#include "engine/learning/field.h"
#include "engine/learning/training_input.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::figure;
using learning::RolloutEnd;

namespace {

/// One rollout of each end, on ways of their own.
DrawnRollouts four_ends(const std::string& name) {
  const spatial::Grid grid = spatial::Grid::with_cells(6);
  learning::CellSequence expert;
  for (int z = 5; z >= 0; --z) expert.push_back(grid.index({2, 2, z}));
  auto model = std::make_shared<learning::Model>(learning::untrained_model(grid, {expert}, {}));
  auto rollouts = std::make_shared<std::vector<learning::Rollout>>();
  for (int i = 0; i < 4; ++i) {
    learning::Rollout rollout;
    rollout.start = grid.index({2, i, 5});
    rollout.end = static_cast<RolloutEnd>(i);
    for (int z = 5; z >= i; --z) rollout.cells.push_back(grid.index({2, i, z}));
    rollout.length_m = 0.0025 * (5 - i);
    rollout.max_deviation_m = 0.002 * i;
    rollouts->push_back(rollout);
  }
  auto spread = std::make_shared<const learning::RolloutSpread>(learning::spread_of_rollouts(*model, *rollouts, {}));
  return {name, model, rollouts, nullptr, spread};
}

RolloutFigure figure_of(RolloutPlot plot) {
  RolloutFigure made;
  made.plot = plot;
  made.subtitle = "from 4 starts";
  made.models = {four_ends("one")};
  return made;
}

int pixels_of(const Image& picture, Rgba colour) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) count += picture.at(x, y) == colour ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("one set of colours says how rollouts end, in fields and in figures, and no two are alike") {
  learning::Field field;
  field.layer = learning::Layer::kBasin;
  field.categories.resize(4);
  const std::vector<Rgba> colours = category_colours(field);
  for (int i = 0; i < 4; ++i) {
    CHECK(colours[static_cast<std::size_t>(i)] == outcome_colour(static_cast<RolloutEnd>(i)));
    for (int j = 0; j < i; ++j) {
      CHECK_FALSE(outcome_colour(static_cast<RolloutEnd>(i)) == outcome_colour(static_cast<RolloutEnd>(j)));
    }
  }
}

TEST_CASE("every rollout figure shows the colour of each end that there is, and of no other") {
  for (const RolloutPlot plot : {RolloutPlot::kBoxes, RolloutPlot::kAxes, RolloutPlot::kMultiples}) {
    RolloutFigure made = figure_of(plot);
    const Image all = draw_rollouts(made);
    CHECK(all.width == 1000);
    for (int i = 0; i < 4; ++i) CHECK(pixels_of(all, outcome_colour(static_cast<RolloutEnd>(i))) > 40);
    auto fewer = std::make_shared<std::vector<learning::Rollout>>(*made.models[0].rollouts);
    fewer->pop_back();
    made.models[0].rollouts = fewer;
    made.models[0].spread = std::make_shared<const learning::RolloutSpread>(
        learning::spread_of_rollouts(*made.models[0].model, *fewer, {}));
    const Image three = draw_rollouts(made);
    CHECK(pixels_of(three, outcome_colour(RolloutEnd::kDeadEnd)) > 40);
    CHECK(pixels_of(three, outcome_colour(RolloutEnd::kOutsideSafeSet)) == 0);
  }
}

TEST_CASE("a rollout figure is as wide as its paper says at every resolution, and grows with its models") {
  for (const RolloutPlot plot : {RolloutPlot::kBoxes, RolloutPlot::kAxes, RolloutPlot::kMultiples}) {
    RolloutFigure made = figure_of(plot);
    made.print = Print{};
    const Image coarse = draw_rollouts(made);
    made.print->dpi = 600.0;
    const Image fine = draw_rollouts(made);
    CHECK(coarse.width == 1039);
    CHECK(fine.width == 2079);
    CHECK(std::abs(fine.height - 2 * coarse.height) <= 4);
    made.models.push_back(four_ends("another"));
    CHECK(draw_rollouts(made).height > fine.height);
  }
}

TEST_CASE("what is not kept is no small picture, and boxes are of the measures that are asked for") {
  RolloutFigure pictures = figure_of(RolloutPlot::kMultiples);
  const int whole = pixels_of(draw_rollouts(pictures), outcome_colour(RolloutEnd::kDeadEnd));
  pictures.kept = {{learning::RolloutMeasure::kEnd, 0.0, 1.0}};
  const int kept = pixels_of(draw_rollouts(pictures), outcome_colour(RolloutEnd::kDeadEnd));
  CHECK(kept > 0);  // the legend
  CHECK(kept < whole);
  RolloutFigure boxes = figure_of(RolloutPlot::kBoxes);
  const int all = draw_rollouts(boxes).height;
  boxes.measures = {learning::RolloutMeasure::kSteps};
  CHECK(draw_rollouts(boxes).height < all);
  CHECK_FALSE(learning::has_spread(learning::RolloutMeasure::kEnd));
  CHECK(learning::has_spread(learning::RolloutMeasure::kSteps));
}

TEST_CASE("rollouts are saved as drawings only, whatever the case of the ending") {
  const testing::ScratchFolder folder;
  const RolloutFigure made = figure_of(RolloutPlot::kAxes);
  CHECK(save_rollouts(made, folder.path() / "a.SVG").has_value());
  CHECK(read_file(folder.path() / "a.SVG")->starts_with("<?xml"));
  CHECK(save_rollouts(made, folder.path() / "a.csv").error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("a band about a curve is drawn, and is two more lines of its numbers") {
  const testing::ScratchFolder folder;
  const auto curve = [](double by) {
    return std::make_shared<const plot::Curve>(std::vector<double>{0.0, 1.0, 2.0},
                                               std::vector<double>{by, 2.0 * by, 3.0 * by});
  };
  CurveFigure made;
  made.end_s = 2.0;
  made.plots.push_back({"Deviation", "mm", {{"one", curve(2.0)}}, {}, true});
  const Image bare = draw_curves(made);
  made.plots[0].lines[0].bands.push_back({"p05", "p95", curve(1.0), curve(3.0)});
  const Image banded = draw_curves(made);
  CHECK(pixels_of(banded, {255, 255, 255, 255}) + 2000 < pixels_of(bare, {255, 255, 255, 255}));
  REQUIRE(save_curves_csv(made, folder.path() / "c.csv").has_value());
  const std::string csv = *read_file(folder.path() / "c.csv");
  CHECK(csv.find("\n2,Deviation,mm,one,6\n") != std::string::npos);
  CHECK(csv.find("\n2,Deviation,mm,one p05,3\n") != std::string::npos);
  CHECK(csv.find("\n2,Deviation,mm,one p95,9\n") != std::string::npos);
  made.plots[0].lines = {{"a, b", curve(2.0)}};
  REQUIRE(save_curves_csv(made, folder.path() / "q.csv").has_value());
  CHECK(read_file(folder.path() / "q.csv")->find("\n2,Deviation,mm,\"a, b\",6\n") != std::string::npos);
}
