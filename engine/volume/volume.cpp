#include "engine/volume/volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <thread>

#include "engine/core/check.h"

namespace trocar::volume {
namespace {

using Eigen::Array3f;
using Eigen::Vector3d;
using Eigen::Vector4f;

constexpr int kColours = 256;
/// Of a cell where the curve is highest, before the layer's own opacity.
constexpr float kThickest = 0.75F;
/// Below this height of the curve a value hides nothing that could be seen.
constexpr double kLeastHeight = 0.02;
constexpr float kFineStep = 0.5F;  ///< Cells.
constexpr float kCoarseStep = 0.8F;
/// What is behind can no longer be seen.
constexpr float kFull = 0.985F;
/// Rays that end so near to each other see the same.
constexpr float kSameDepth_m = 0.003F;

/// Premultiplied colours by position, each of a step through cells that have it.
std::vector<Vector4f> transfer(const plot::Colouring& colouring, const plot::OpacityCurve& curve, float opacity,
                               float step) {
  std::vector<Vector4f> table(kColours);
  for (int i = 0; i < kColours; ++i) {
    const float position = static_cast<float>(i) / (kColours - 1);
    const auto height = static_cast<float>(curve.at(static_cast<double>(position)));
    const float of_cell = std::min(kThickest * opacity * height * height, 0.999F);
    const float alpha = 1.0F - std::pow(1.0F - of_cell, step);
    const Rgba colour = colouring.colour_at(static_cast<double>(position));
    table[static_cast<std::size_t>(i)] =
        Vector4f(alpha * static_cast<float>(colour.r), alpha * static_cast<float>(colour.g),
                 alpha * static_cast<float>(colour.b), alpha);
  }
  return table;
}

/// Calls `row(y)` for all rows below `count`, spread over threads.
template <typename Row>
void for_rows(int count, int threads, const Row& row) {
  const auto every = [&](int first) {
    for (int y = first; y < count; y += threads) row(y);
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(every, i);
  every(0);
}

/// A ray in the coordinates of the padded cells: whole numbers are their middles. The parameter is depth in metres.
struct Ray {
  Array3f origin;
  Array3f direction;
};

/// From where to where it is within `low` … `high` on each axis; empty if never.
std::array<float, 2> clip(const Ray& ray, float low, float high) {
  std::array<float, 2> span{0.0F, std::numeric_limits<float>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    const float o = ray.origin[axis];
    const float d = ray.direction[axis];
    if (std::abs(d) < 1e-9F) {
      if (o < low || o > high) return {1.0F, 0.0F};
      continue;
    }
    const float a = (low - o) / d;
    const float b = (high - o) / d;
    span[0] = std::max(span[0], std::min(a, b));
    span[1] = std::min(span[1], std::max(a, b));
  }
  return span;
}

/// One of them for each pixel of a coarser picture.
class Rays {
 public:
  Rays(const scene::Camera& camera, int width, int height, const spatial::Grid& grid)
      : camera_(camera), width_(width), height_(height), grid_(grid) {}

  Ray at(double x, double y) const {
    auto [from, along] = camera_.ray(x, y, width_, height_);
    const Vector3d forward = camera_.X_WC.q * Vector3d::UnitZ();
    along /= along.dot(forward);  // so that the parameter is depth
    const Vector3d origin = (from - grid_.p_WGo) / grid_.cell_m + Vector3d::Constant(0.5);
    return {origin.cast<float>().array(), (along / grid_.cell_m).cast<float>().array()};
  }

 private:
  const scene::Camera& camera_;
  int width_;
  int height_;
  const spatial::Grid& grid_;
};

void blend(std::uint8_t* pixel, const Vector4f& over) {
  const float through = 1.0F - over.w();
  for (int c = 0; c < 3; ++c) {
    const float mixed = over[c] + through * static_cast<float>(pixel[c]);
    pixel[c] = static_cast<std::uint8_t>(std::clamp(mixed + 0.5F, 0.0F, 255.0F));
  }
}

/// What was seen along each ray of a coarse picture, and how far.
struct Seen {
  int columns = 0;
  int divisor = 1;
  std::vector<Vector4f> colours;
  std::vector<float> depth_m;

  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
};

/// Between the four rays around a pixel; nothing where one of them ends elsewhere than the pixel's own would, as at the
/// edges of things.
std::optional<Vector4f> between(const Seen& seen, int rows, int x, int y, float depth_m) {
  const float scale = 1.0F / static_cast<float>(seen.divisor);
  const float u = std::max((static_cast<float>(x) + 0.5F) * scale - 0.5F, 0.0F);
  const float v = std::max((static_cast<float>(y) + 0.5F) * scale - 0.5F, 0.0F);
  const int column = std::min(static_cast<int>(u), seen.columns - 1);
  const int row = std::min(static_cast<int>(v), rows - 1);
  const int next_column = std::min(column + 1, seen.columns - 1);
  const int next_row = std::min(row + 1, rows - 1);
  const std::array<std::size_t, 4> near{seen.at(column, row), seen.at(next_column, row), seen.at(column, next_row),
                                        seen.at(next_column, next_row)};
  for (const std::size_t i : near) {
    if (std::abs(seen.depth_m[i] - depth_m) > kSameDepth_m) return std::nullopt;
  }
  const float right = u - static_cast<float>(column);
  const Vector4f upper = seen.colours[near[0]] + right * (seen.colours[near[1]] - seen.colours[near[0]]);
  const Vector4f lower = seen.colours[near[2]] + right * (seen.colours[near[3]] - seen.colours[near[2]]);
  return upper + (v - static_cast<float>(row)) * (lower - upper);
}

bool same(const plot::Colouring& a, const plot::Colouring& b) {
  return a.map == b.map && a.vision == b.vision && a.scale.kind == b.scale.kind && a.scale.low == b.scale.low &&
         a.scale.high == b.scale.high && a.scale.linear == b.scale.linear && a.scale.sorted == b.scale.sorted;
}

}  // namespace

void Marcher::prepare(const std::shared_ptr<const learning::Field>& field, const plot::Colouring& colouring) {
  if (field == field_ && same(colouring, colouring_)) return;
  field_ = field;
  colouring_ = colouring;
  const int n = field->grid.n;
  side_ = n + 2;
  const auto side = static_cast<std::size_t>(side_);
  const auto flat = [side](int x, int y, int z) {
    return (static_cast<std::size_t>(x) * side + static_cast<std::size_t>(y)) * side + static_cast<std::size_t>(z);
  };
  cells_.assign(side * side * side, {});
  for (int s = 0; s < field->grid.cell_count(); ++s) {
    const double value = field->values[static_cast<std::size_t>(s)];
    if (!std::isfinite(value)) continue;
    const spatial::CellCoordinates c = field->grid.coordinates({s});
    cells_[flat(c.x + 1, c.y + 1, c.z + 1)] = {static_cast<float>(colouring.scale.position(value)), 1.0F};
  }
  fitted_ = plot::fitted_opacity(colouring, field->values);
  of_empty_.reset();
}

void Marcher::leave_out(const plot::OpacityCurve& curve) {
  if (of_empty_ == curve) return;
  of_empty_ = curve;
  const auto side = static_cast<std::size_t>(side_);
  const auto flat = [side](int x, int y, int z) {
    return (static_cast<std::size_t>(x) * side + static_cast<std::size_t>(y)) * side + static_cast<std::size_t>(z);
  };
  empty_.assign(cells_.size(), 1);
  for (int x = 0; x + 1 < side_; ++x) {
    for (int y = 0; y + 1 < side_; ++y) {
      for (int z = 0; z + 1 < side_; ++z) {
        float low = 1.0F;
        float high = 0.0F;
        for (int corner = 0; corner < 8; ++corner) {
          const Cell& cell = cells_[flat(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2))];
          if (cell.known == 0.0F) continue;
          low = std::min(low, cell.weighted);
          high = std::max(high, cell.weighted);
        }
        if (low > high) continue;
        const double most = curve.highest(static_cast<double>(low), static_cast<double>(high));
        if (most >= kLeastHeight) empty_[flat(x, y, z)] = 0;
      }
    }
  }
}

void Marcher::draw(Image& picture, const std::vector<float>& depth_m, const scene::Camera& camera,
                   const std::shared_ptr<const learning::Field>& field, const plot::Colouring& colouring,
                   const MarchOptions& options) {
  TROCAR_CHECK(field != nullptr && !field->categorical && options.divisor >= 1 && options.threads >= 1);
  TROCAR_CHECK(field->values.size() == static_cast<std::size_t>(field->grid.cell_count()));
  TROCAR_CHECK(4 * depth_m.size() == picture.rgba.size());
  prepare(field, colouring);
  const plot::OpacityCurve& curve = options.curve ? *options.curve : fitted_;
  leave_out(curve);
  const float step = options.divisor > 1 ? kCoarseStep : kFineStep;
  const std::vector<Vector4f> table = transfer(colouring, curve, options.opacity, step);
  const int columns = (picture.width + options.divisor - 1) / options.divisor;
  const int rows = (picture.height + options.divisor - 1) / options.divisor;
  const Rays rays(camera, picture.width, picture.height, field->grid);
  const auto side = static_cast<std::size_t>(side_);
  const std::array<std::size_t, 3> stride{side * side, side, 1};
  const float high = static_cast<float>(side_) - 1.5F;

  // Depth at which a slice that is drawn lets nothing through, or what was.
  const auto stopped_by_slices = [&](const Ray& ray, float begin, float end) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int slice = options.slices[axis];
      const float along = ray.direction[static_cast<Eigen::Index>(axis)];
      if (slice < 0 || slice >= field->grid.n || std::abs(along) < 1e-9F) continue;
      const float t = (static_cast<float>(slice + 1) - ray.origin[static_cast<Eigen::Index>(axis)]) / along;
      if (t <= begin || t >= end) continue;
      const Array3f at = ray.origin + t * ray.direction;
      std::size_t nearest = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto cell = static_cast<std::size_t>(std::lround(at[static_cast<Eigen::Index>(i)]));
        nearest += std::min(cell, side - 1) * stride[i];
      }
      if (cells_[nearest].known > 0.0F) end = t;
    }
    return end;
  };

  const auto through = [&](const Ray& ray, float depth) {
    Vector4f sum = Vector4f::Zero();
    auto [begin, end] = clip(ray, 0.5F, high);
    end = std::min(end, depth);
    if (!(begin < end)) return sum;
    end = stopped_by_slices(ray, begin, end);
    const float dt = step / ray.direction.matrix().norm();
    for (float t = begin + 0.5F * dt; t < end; t += dt) {
      const Array3f at = ray.origin + t * ray.direction;
      const auto x = static_cast<std::size_t>(at.x());
      const auto y = static_cast<std::size_t>(at.y());
      const auto z = static_cast<std::size_t>(at.z());
      const std::size_t base = x * stride[0] + y * stride[1] + z;
      if (empty_[base] != 0) continue;
      const float fx = at.x() - static_cast<float>(x);
      const float fy = at.y() - static_cast<float>(y);
      const float fz = at.z() - static_cast<float>(z);
      const auto along_z = [&](std::size_t from) {
        const Cell& a = cells_[from];
        const Cell& b = cells_[from + 1];
        return Cell{a.weighted + fz * (b.weighted - a.weighted), a.known + fz * (b.known - a.known)};
      };
      const auto mixed = [](const Cell& a, const Cell& b, float f) {
        return Cell{a.weighted + f * (b.weighted - a.weighted), a.known + f * (b.known - a.known)};
      };
      const Cell low_x = mixed(along_z(base), along_z(base + stride[1]), fy);
      const Cell high_x = mixed(along_z(base + stride[0]), along_z(base + stride[0] + stride[1]), fy);
      const Cell cell = mixed(low_x, high_x, fx);
      if (cell.known < 1e-3F) continue;
      const float position = cell.weighted / cell.known;
      const auto i = static_cast<std::size_t>(position * (kColours - 1) + 0.5F);
      sum += (1.0F - sum.w()) * cell.known * table[std::min(i, table.size() - 1)];
      if (sum.w() > kFull) break;
    }
    return sum;
  };

  // Nothing of the lattice is farther than this, so that all that lies behind it is alike.
  float farthest = 0.0F;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d p_G = field->grid.n * field->grid.cell_m * Vector3d(corner & 1, corner >> 1 & 1, corner >> 2);
    const Vector3d at = camera.project(field->grid.p_WGo + p_G, picture.width, picture.height);
    farthest = std::max(farthest, static_cast<float>(at.z()));
  }
  const auto depth_at = [&](int x, int y) {
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
    return std::min(depth_m[pixel], farthest);
  };

  Seen seen;
  seen.columns = columns;
  seen.divisor = options.divisor;
  if (options.divisor > 1) {
    seen.colours.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    seen.depth_m.resize(seen.colours.size());
    for_rows(rows, options.threads, [&](int row) {
      const double y = std::min((row + 0.5) * options.divisor, picture.height - 0.5);
      for (int column = 0; column < columns; ++column) {
        const double x = std::min((column + 0.5) * options.divisor, picture.width - 0.5);
        const float depth = depth_at(static_cast<int>(x), static_cast<int>(y));
        seen.colours[seen.at(column, row)] = through(rays.at(x, y), depth);
        seen.depth_m[seen.at(column, row)] = depth;
      }
    });
  }
  for_rows(picture.height, options.threads, [&](int y) {
    std::uint8_t* pixel =
        picture.rgba.data() + std::size_t{4} * static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
    for (int x = 0; x < picture.width; ++x, pixel += 4) {
      const float depth = depth_at(x, y);
      std::optional<Vector4f> over;
      if (options.divisor > 1) over = between(seen, rows, x, y, depth);
      if (!over) over = through(rays.at(x + 0.5, y + 0.5), depth);
      if (over->w() > 0.0F) blend(pixel, *over);
    }
  });
}

}  // namespace trocar::volume
