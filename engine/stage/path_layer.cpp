#include "engine/stage/path_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "engine/core/check.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/segment_colour.h"
#include "engine/scene/primitives.h"
#include "engine/stage/palette.h"

namespace trocar::stage {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance_m = 5e-5;
constexpr double kSpacing_m = 3.5e-4;
constexpr int kSides = 6;
/// Of a path of more samples than this, points that are near to the one before are left out, so that about so many are
/// left: an hour of motion would be millions of triangles, and a picture of it a tangle anyway.
constexpr std::size_t kMostWhole = 50'000;
constexpr double kMostPoints = 20'000.0;
constexpr double kThinned_m = 2.5e-5;
/// With more changes of colour than this the path is one tube whose colour runs along it.
constexpr std::size_t kRunLimit = 32;

struct Run {
  std::size_t begin;
  std::size_t end;  ///< Inclusive; the next run begins there too, so that the path has no gap.
};

double distance_to_segment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp(along.dot(point - a) / length2, 0.0, 1.0) : 0.0;
  return (point - a - s * along).norm();
}

std::vector<Run> runs_of(const PathLayer& layer) {
  const std::size_t last = layer.points.size() - 1;
  std::vector<Run> runs;
  if (layer.colours.size() < layer.points.size()) return {{0, last}};
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    if (layer.colours[i] == layer.colours[begin]) continue;
    runs.push_back({begin, i});
    begin = i;
  }
  if (begin < last) runs.push_back({begin, last});
  return runs;
}

void add_tube(scene::Mesh mesh, Rgba colour, scene::Scene& scene) {
  if (mesh.indices.empty()) return;
  scene::Node node;
  node.mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
  node.material = palette::material(colour, 0.7F, 0.0F);
  node.material.emission = 0.7F;
  scene.nodes.push_back(std::move(node));
}

void add_run(const PathLayer& layer, const Run& run, scene::Scene& scene) {
  const auto first = layer.points.begin() + static_cast<std::ptrdiff_t>(run.begin);
  const std::vector<Vector3d> all(first, layer.points.begin() + static_cast<std::ptrdiff_t>(run.end) + 1);
  std::vector<Vector3d> kept;
  for (const std::size_t i : simplified(all, kTolerance_m)) kept.push_back(all[i]);
  const Rgba colour = layer.colours[std::min(run.begin, layer.colours.size() - 1)];
  add_tube(scene::tube(kept, {}, layer.radius_m, kSides), colour, scene);
}

void add_shaded(const PathLayer& layer, scene::Scene& scene) {
  std::vector<Vector3d> kept;
  std::vector<Rgba> colours;
  for (std::size_t i = 0; i < layer.points.size(); ++i) {
    const bool last = i + 1 == layer.points.size();
    if (!kept.empty() && !last && (layer.points[i] - kept.back()).norm() < kSpacing_m) continue;
    kept.push_back(layer.points[i]);
    colours.push_back(layer.colours[i]);
  }
  add_tube(scene::tube(kept, colours, layer.radius_m, kSides), {255, 255, 255, 255}, scene);
}

}  // namespace

std::vector<std::size_t> simplified(const std::vector<Vector3d>& points, double tolerance_m) {
  if (points.empty()) return {};
  std::vector<std::uint8_t> keep(points.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    std::size_t farthest = a;
    double worst = tolerance_m;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double distance = distance_to_segment(points[i], points[a], points[b]);
      if (distance <= worst) continue;
      worst = distance;
      farthest = i;
    }
    if (farthest == a) continue;
    keep[farthest] = 1;
    open.emplace_back(a, farthest);
    open.emplace_back(farthest, b);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i] != 0) kept.push_back(i);
  }
  return kept;
}

void add_path(const PathLayer& layer, scene::Scene& scene) {
  if (layer.points.size() < 2) return;
  TROCAR_CHECK(layer.colours.size() == 1 || layer.colours.size() == layer.points.size());
  const std::vector<Run> runs = runs_of(layer);
  if (runs.size() > kRunLimit) {
    add_shaded(layer, scene);
    return;
  }
  for (const Run& run : runs) add_run(layer, run, scene);
}

PathLayer path_of(const demonstration::Demonstration& demonstration, kinematics::ArmSide side) {
  constexpr Rgba kUnlabelled{160, 166, 174, 255};
  PathLayer layer;
  auto span = demonstration.segments.begin();
  const demonstration::SampleTrack samples = demonstration.gated();
  const bool thinned = samples.size() > kMostWhole;
  double apart_m = 0.0;
  if (thinned) {
    const double length_m = demonstration::path_length_m(demonstration, kinematics::index_of(side));
    apart_m = std::max(kThinned_m, std::isfinite(length_m) ? length_m / kMostPoints : 0.0);
  }
  std::size_t left = samples.size();
  for (const demonstration::Sample& sample : samples) {
    const double t_s = demonstration.time_of(sample);
    while (span != demonstration.segments.end() && t_s >= span->end_s) ++span;
    const bool labelled = span != demonstration.segments.end() && t_s >= span->begin_s;
    const Vector3d p_WT = demonstration::measured_tip(sample, kinematics::index_of(side));
    const Rgba colour = labelled ? demonstration::segment_colour(span->label) : kUnlabelled;
    const bool near = !layer.points.empty() && (p_WT - layer.points.back()).norm() < apart_m;
    if (--left > 0 && thinned && near && colour == layer.colours.back()) continue;
    layer.points.push_back(p_WT);
    layer.colours.push_back(colour);
  }
  return layer;
}

}  // namespace trocar::stage
