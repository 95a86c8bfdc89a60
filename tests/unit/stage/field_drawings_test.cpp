#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"
#include "engine/stage/field_layer.h"
#include "engine/stage/iso_surface.h"
#include "engine/stage/stage.h"
#include "engine/stage/streamlines.h"

using namespace trocar;
using Eigen::Vector3d;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

const stage::Stage& shared_stage() {
  static const Result<std::shared_ptr<const stage::Stage>> kStage = stage::Stage::load();
  REQUIRE(kStage);
  return **kStage;
}

Vector3d ball_centre() {
  return spatial::Grid{}.p_WGo + Vector3d(0.0271, 0.0279, 0.0265);
}

/// Minus the distance from a point, in cells.
learning::Field ball() {
  learning::Field field;
  for (int s = 0; s < field.grid.cell_count(); ++s) {
    field.values.push_back(-(field.grid.centre({s}) - ball_centre()).norm() / field.grid.cell_m);
  }
  return field;
}

/// Each directed edge must be met by its opposite, once.
bool is_closed(const scene::Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return back != edges.end() && back->second == edge.second;
  });
}

double volume_of(const scene::Mesh& mesh) {
  double six = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) -> Vector3d { return mesh.positions[mesh.indices[i + k]].cast<double>(); };
    six += at(0).dot(at(1).cross(at(2)));
  }
  return six / 6.0;
}

/// Every cell goes along +x to the goal at the far side of its row; the cells of other rows turn in loops or stop.
struct Corridor {
  learning::Model model;
  std::vector<std::uint8_t> policy;
};

Corridor corridor() {
  Corridor made;
  learning::Model& model = made.model;
  model.grid = spatial::Grid::with_cells(7);
  const auto count = static_cast<std::size_t>(model.grid.cell_count());
  model.start = model.grid.index({0, 3, 3});
  model.goal = model.grid.index({6, 3, 3});
  model.safe = spatial::CellSet(model.grid, true);
  model.q.assign(6 * count, 0.0);
  made.policy.assign(count, learning::kNoAction);
  const auto set = [&](int x, int y, int z, spatial::Action action) {
    const auto cell = static_cast<std::size_t>(model.grid.index({x, y, z}).value);
    made.policy[cell] = static_cast<std::uint8_t>(action);
    model.q[6 * cell + static_cast<std::size_t>(action)] = 1.0;
  };
  for (int x = 0; x < 6; ++x) set(x, 3, 3, spatial::Action::kPlusX);
  set(2, 2, 3, spatial::Action::kPlusY);  // joins the corridor
  set(0, 0, 0, spatial::Action::kPlusX);  // into a loop of four
  set(1, 0, 0, spatial::Action::kPlusX);
  set(2, 0, 0, spatial::Action::kPlusY);
  set(2, 1, 0, spatial::Action::kMinusX);
  set(1, 1, 0, spatial::Action::kMinusY);
  set(4, 6, 6, spatial::Action::kPlusX);  // to a dead end
  return made;
}

stage::FieldLayer layer_of(const Corridor& of) {
  stage::FieldLayer layer;
  auto field = std::make_shared<learning::Field>();
  field->grid = of.model.grid;
  field->values.assign(of.policy.size(), 0.5);
  layer.field = field;
  layer.model = std::make_shared<const learning::Model>(of.model);
  layer.policy = std::make_shared<const std::vector<std::uint8_t>>(of.policy);
  return layer;
}

}  // namespace

TEST_CASE("the surface of a ball is closed, on the level, and faces outwards") {
  const learning::Field field = ball();
  const double radius_m = 6.3 * field.grid.cell_m;
  const scene::Mesh mesh = stage::iso_surface(field, -6.3);
  REQUIRE_FALSE(mesh.indices.empty());
  CHECK(is_closed(mesh));
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector3d from_centre = mesh.positions[i].cast<double>() - ball_centre();
    // Values are linear between the middles of cells; a ball's are not quite.
    REQUIRE(from_centre.norm() == doctest::Approx(radius_m).epsilon(0.01));
    REQUIRE(mesh.normals[i].norm() == doctest::Approx(1.0F));
    REQUIRE(mesh.normals[i].cast<double>().dot(from_centre.normalized()) > 0.98);
  }
  constexpr double kPi = 3.14159265358979;
  CHECK(volume_of(mesh) == doctest::Approx(4.0 / 3.0 * kPi * std::pow(radius_m, 3.0)).epsilon(0.02));
}

TEST_CASE("a surface is closed where what is known ends, and at the lattice") {
  learning::Field field = ball();
  for (int s = 0; s < field.grid.cell_count(); ++s) {
    if (field.grid.coordinates({s}).x < 9) field.values[static_cast<std::size_t>(s)] = kUnknown;
  }
  const scene::Mesh cut = stage::iso_surface(field, -6.3);
  CHECK(is_closed(cut));
  const double face_m = field.grid.p_WGo.x() + 9 * field.grid.cell_m;
  for (const Eigen::Vector3f& p : cut.positions) REQUIRE(static_cast<double>(p.x()) >= face_m - 1e-6);
  field.values.assign(field.values.size(), 1.0);
  const scene::Mesh whole = stage::iso_surface(field, 0.5);
  CHECK(is_closed(whole));
  CHECK(volume_of(whole) > 0.9 * std::pow(field.grid.n * field.grid.cell_m, 3.0));
  CHECK(stage::iso_surface(field, 1.5).indices.empty());
  field.values.assign(field.values.size(), kUnknown);
  CHECK(stage::iso_surface(field, 0.5).indices.empty());
}

TEST_CASE("streamlines end where the policy does, and no step is drawn twice") {
  const Corridor of = corridor();
  const spatial::Grid& grid = of.model.grid;
  const std::vector<spatial::CellIndex> starts{grid.index({0, 3, 3}), grid.index({2, 2, 3}), grid.index({0, 0, 0}),
                                               grid.index({4, 6, 6}), grid.index({1, 3, 3})};
  const std::vector<stage::Streamline> lines = stage::streamlines(of.model, of.policy, starts);
  REQUIRE(lines.size() == 5);  // the last start lies on the first line; the third gives two
  CHECK(lines[0].end == learning::RolloutEnd::kArrives);
  CHECK(lines[0].cells.size() == 7);
  CHECK(lines[0].cells.back() == of.model.goal);
  CHECK(lines[1].end == learning::RolloutEnd::kArrives);
  CHECK(lines[1].cells == learning::CellSequence{grid.index({2, 2, 3}), grid.index({2, 3, 3})});
  CHECK(lines[2].end == learning::RolloutEnd::kLoops);
  CHECK_FALSE(lines[2].in_loop);
  CHECK(lines[2].cells == learning::CellSequence{grid.index({0, 0, 0}), grid.index({1, 0, 0})});
  CHECK(lines[3].in_loop);
  CHECK(lines[3].cells.size() == 5);
  CHECK(lines[3].cells.front() == lines[3].cells.back());
  CHECK(lines[4].end == learning::RolloutEnd::kDeadEnd);
  CHECK(lines[4].cells.back() == grid.index({5, 6, 6}));
  std::set<std::pair<std::int32_t, std::int32_t>> steps;
  for (const stage::Streamline& line : lines) {
    for (std::size_t i = 0; i + 1 < line.cells.size(); ++i) {
      CHECK(steps.insert({line.cells[i].value, line.cells[i + 1].value}).second);
    }
  }
}

TEST_CASE("a loop is drawn dashed and red, what arrives whole and blue, and a dead end has its mark") {
  const Corridor of = corridor();
  const spatial::Grid& grid = of.model.grid;
  const auto mesh_of = [&](const spatial::CellCoordinates& start) {
    scene::Scene scene;
    stage::add_streamlines(grid, stage::streamlines(of.model, of.policy, {grid.index(start)}), scene);
    REQUIRE(scene.nodes.size() == 1);
    return scene.nodes[0].mesh;
  };
  const auto nearest_m = [&](const scene::Mesh& mesh, const spatial::CellCoordinates& cell) {
    double nearest = 1.0;
    const Vector3d middle = grid.centre(grid.index(cell));
    for (const auto& p : mesh.positions) nearest = std::min(nearest, (p.cast<double>() - middle).norm());
    return nearest / grid.cell_m;
  };
  const auto arrives = mesh_of({0, 3, 3});
  CHECK(nearest_m(*arrives, {6, 3, 3}) < 0.2);
  CHECK(arrives->colours.front().b > 200);
  const auto loop = mesh_of({1, 1, 0});
  CHECK(loop->colours.front().r > 200);
  CHECK(loop->colours.front().g < 100);
  CHECK(nearest_m(*loop, {2, 0, 0}) > 0.2);  // no dash at the middles of cells
  const auto dead = mesh_of({5, 6, 6});      // no move at all: only its mark
  CHECK(dead->positions.size() == 24);
  CHECK(dead->colours.front().b < 100);
}

TEST_CASE("an arrow points where the policy goes, and a star has six arms of which the best is the longest") {
  const Corridor of = corridor();
  stage::FieldLayer layer = layer_of(of);
  layer.slices = {-1, -1, 3};
  const double cell_m = of.model.grid.cell_m;
  const auto reach = [&](stage::Glyphs glyphs, const Vector3d& along) {
    layer.glyphs = glyphs;
    const scene::Scene scene = shared_stage().field_scene({layer});
    REQUIRE(scene.nodes.size() == 1);
    double far = 0.0;
    const Vector3d middle = of.model.grid.centre(of.model.grid.index({2, 3, 3}));
    for (const auto& p : scene.nodes[0].mesh->positions) {
      const Vector3d from = (p.cast<double>() - middle) / cell_m;
      if (from.cwiseAbs().maxCoeff() < 0.5) far = std::max(far, from.dot(along));
    }
    return far;
  };
  CHECK(reach(stage::Glyphs::kBest, Vector3d::UnitX()) > 0.35);
  CHECK(reach(stage::Glyphs::kBest, Vector3d::UnitZ()) < 0.25);
  CHECK(reach(stage::Glyphs::kStars, Vector3d::UnitX()) == doctest::Approx(0.44).epsilon(0.01));
  for (const Vector3d& other :
       {Vector3d(-Vector3d::UnitX()), Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitZ())}) {
    CHECK(reach(stage::Glyphs::kStars, other) > 0.08);
    CHECK(reach(stage::Glyphs::kStars, other) < 0.2);
  }
  layer.slices = {-1, -1, 5};
  CHECK(shared_stage().field_scene({layer}).nodes.empty());  // nothing is known there
  layer.glyphs = stage::Glyphs::kNone;
  layer.slices = {-1, -1, 3};
  CHECK(shared_stage().field_scene({layer}).nodes.empty());
}

TEST_CASE("a layer draws its surface, lines and slab, and the same layer is told from another") {
  const Corridor of = corridor();
  stage::FieldLayer layer = layer_of(of);
  layer.iso_level = 0.4;
  layer.streamlines = {of.model.start};
  const scene::Scene scene = shared_stage().field_scene({layer});
  CHECK(scene.nodes.size() == 2);
  CHECK(stage::same_drawing(layer, layer));
  stage::FieldLayer other = layer;
  other.iso_level = 0.6;
  CHECK_FALSE(stage::same_drawing(layer, other));
  CHECK(shared_stage().field_scene({other}).nodes.size() == 1);  // nothing is above
  other = layer;
  other.slabs[1] = 3;
  CHECK_FALSE(stage::same_drawing(layer, other));
  other = layer;
  other.volume = true;  // is no part of the scene
  CHECK(stage::same_drawing(layer, other));
}

TEST_CASE("a slab shows the largest value across it, and is unknown only where all of it is") {
  auto field = std::make_shared<learning::Field>();
  field->grid = spatial::Grid::with_cells(4);
  field->values.assign(64, kUnknown);
  field->values[static_cast<std::size_t>(field->grid.index({1, 2, 0}).value)] = 0.25;
  field->values[static_cast<std::size_t>(field->grid.index({1, 2, 2}).value)] = 0.75;
  stage::FieldLayer layer;
  layer.field = field;
  layer.slices = {-1, -1, 1};
  const auto texel = [&](int x, int y) {
    const scene::Scene scene = shared_stage().field_scene({layer});
    REQUIRE(scene.quads.size() == 1);
    const Image& image = *scene.quads[0].texture;
    const int side = image.width / 4;
    // z-slices run along y to the right and along x up.
    return image.at(y * side + side / 2, (3 - x) * side + side / 2);
  };
  const Rgba unknown = texel(1, 2);
  layer.slabs[2] = 2;
  CHECK(texel(1, 2) == layer.colouring.colour(0.75));
  CHECK(texel(2, 2) == unknown);
  layer.slabs[2] = 3;
  CHECK(texel(1, 2) == layer.colouring.colour(0.75));
}
