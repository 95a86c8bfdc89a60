#include "ui/gizmo.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace trocar::ui {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;

constexpr std::array<const char*, 3> kLetters{"X", "Y", "Z"};
/// A handle seen more sharply than this from its end (an axis) or its edge (a plane, a ring) is of no use.
constexpr double kTooSteep = 0.15;
/// About a grip, of the gizmo's length.
constexpr float kMargin = 0.2F;

Vector3d axis_of(const spatial::Pose& X_WG, int axis) {
  return X_WG.rotation().col(axis);
}

Vector3d toward_eye(const ViewPort& view, const Vector3d& p_W) {
  const Vector3d back = -view.camera.X_WC.rotation().col(2);
  if (view.camera.orthographic) return back;
  return (view.camera.X_WC.p - p_W).normalized();
}

double distance_to_segment(const Vector2f& p, const Vector2f& a, const Vector2f& b) {
  const Vector2f along = b - a;
  const float length2 = along.squaredNorm();
  const float share = length2 > 0.0F ? std::clamp((p - a).dot(along) / length2, 0.0F, 1.0F) : 0.0F;
  return static_cast<double>((a + share * along - p).norm());
}

double distance_to_line(const Vector2f& p, const std::vector<Vector2f>& points, bool closed) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment(p, points[i], points[i + 1]));
  }
  if (closed && points.size() > 2) nearest = std::min(nearest, distance_to_segment(p, points.back(), points.front()));
  return nearest;
}

bool inside(const Vector2f& p, const std::vector<Vector2f>& outline) {
  bool within = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vector2f& a = outline[i];
    const Vector2f& b = outline[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      within = !within;
    }
  }
  return within;
}

/// The pixels of points in W; nothing if one of them is behind the camera.
std::optional<std::vector<Vector2f>> pixels(const ViewPort& view, const std::vector<Vector3d>& points) {
  std::vector<Vector2f> list;
  for (const Vector3d& p_W : points) {
    const auto pixel = view.pixel(p_W);
    if (!pixel) return std::nullopt;
    list.push_back(*pixel);
  }
  return list;
}

struct Builder {
  const spatial::Pose& X_WG;
  const ViewPort& view;
  double length_m;
  float margin_px;  ///< What a hand needs about a grip.
  Vector3d eye;
  std::vector<HandleShape> shapes = {};
  std::array<double, 3> reach{1.0, 1.0, 1.0};  ///< Of the arrows, of their length; negative: the other way.

  bool in_reach(const Vector3d& p_W) const {
    const auto at = view.pixel(p_W);
    if (!at) return false;
    const Rect& rect = view.rect;
    return at->x() - margin_px >= rect.x0 && at->x() + margin_px <= rect.x1 && at->y() - margin_px >= rect.y0 &&
           at->y() + margin_px <= rect.y1;
  }
  /// An arrow that would end beyond the picture is shorter, or points the other way; where nothing helps, it is as it
  /// was.
  void keep_in_reach(int axis) {
    constexpr std::array<double, 8> kTried{1.0, 0.85, 0.7, -1.0, -0.85, -0.7, 0.55, -0.55};
    for (const double tried : kTried) {
      if (!in_reach(X_WG.p + tried * length_m * axis_of(X_WG, axis))) continue;
      reach[static_cast<std::size_t>(axis)] = tried;
      return;
    }
  }
  /// The arrow's direction.
  Vector3d out(int axis) const {
    return std::copysign(1.0, reach[static_cast<std::size_t>(axis)]) * axis_of(X_WG, axis);
  }

  void add(Handle handle, const std::vector<Vector3d>& points, const Vector3d& grip) {
    auto outline = pixels(view, points);
    const auto at = view.pixel(grip);
    if (outline && at) shapes.push_back({handle, std::move(*outline), *at});
  }
  void add_axis(int axis) {
    const Vector3d along = axis_of(X_WG, axis);
    if (along.cross(eye).norm() < kTooSteep) return;
    const Vector3d tip = X_WG.p + reach[static_cast<std::size_t>(axis)] * length_m * along;
    add({HandleKind::kAxis, axis}, {X_WG.p + 0.18 * length_m * out(axis), tip}, tip);
  }
  void add_plane(int normal) {
    if (std::abs(axis_of(X_WG, normal).dot(eye)) < kTooSteep) return;
    const Vector3d u = out((normal + 1) % 3);
    const Vector3d v = out((normal + 2) % 3);
    const auto corner = [&](double a, double b) -> Vector3d { return X_WG.p + length_m * (a * u + b * v); };
    add({HandleKind::kPlane, normal}, {corner(0.36, 0.36), corner(0.58, 0.36), corner(0.58, 0.58), corner(0.36, 0.58)},
        corner(0.47, 0.47));
  }
  void add_ring(int axis) {
    if (std::abs(axis_of(X_WG, axis).dot(eye)) < kTooSteep) return;
    constexpr int kPoints = 48;
    const Vector3d u = axis_of(X_WG, (axis + 1) % 3);
    const Vector3d v = axis_of(X_WG, (axis + 2) % 3);
    std::vector<Vector3d> ring;
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kPoints;
      ring.emplace_back(X_WG.p + length_m * (std::cos(angle) * u + std::sin(angle) * v));
    }
    // Taken where it is not crossed by the two others, and within the picture if it can be.
    constexpr std::array<std::array<double, 2>, 4> kQuarters{{{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}};
    const auto grip_in = [&](const std::array<double, 2>& quarter) -> Vector3d {
      return X_WG.p + length_m * std::numbers::sqrt2 / 2.0 * (quarter[0] * u + quarter[1] * v);
    };
    const auto* found = std::find_if(kQuarters.begin(), kQuarters.end(),
                                     [&](const auto& quarter) { return in_reach(grip_in(quarter)); });
    add({HandleKind::kRing, axis}, ring, grip_in(found == kQuarters.end() ? kQuarters[0] : *found));
  }
};

std::optional<Vector3d> on_plane(const std::array<Vector3d, 2>& ray, const Vector3d& p_W, const Vector3d& normal) {
  const double slope = ray[1].dot(normal);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  const double along = (p_W - ray[0]).dot(normal) / slope;
  if (along <= 0.0) return std::nullopt;
  return ray[0] + along * ray[1];
}

/// Where a line through `p_W` comes nearest to a ray, as a distance along the line.
std::optional<double> along_line(const std::array<Vector3d, 2>& ray, const Vector3d& p_W, const Vector3d& axis) {
  const double cosine = axis.dot(ray[1]);
  const double sine2 = 1.0 - cosine * cosine;
  if (sine2 < 1e-4) return std::nullopt;
  const Vector3d offset = ray[0] - p_W;
  return (offset.dot(axis) - cosine * offset.dot(ray[1])) / sine2;
}

}  // namespace

std::optional<Vector2f> ViewPort::pixel(const Vector3d& p_W) const {
  const Vector3d seen = camera.project(p_W, static_cast<int>(rect.width()), static_cast<int>(rect.height()));
  if (seen.z() <= 0.0) return std::nullopt;
  return Vector2f(rect.x0 + static_cast<float>(seen.x()), rect.y0 + static_cast<float>(seen.y()));
}

std::array<Vector3d, 2> ViewPort::ray(const Vector2f& pixel) const {
  return camera.ray(static_cast<double>(pixel.x() - rect.x0), static_cast<double>(pixel.y() - rect.y0),
                    static_cast<int>(rect.width()), static_cast<int>(rect.height()));
}

double ViewPort::pixel_m(const Vector3d& p_W) const {
  const double height_px = static_cast<double>(std::max(rect.height(), 1.0F));
  if (camera.orthographic) return camera.orthographic_height_m / height_px;
  const double depth_m = (p_W - camera.X_WC.p).dot(camera.X_WC.rotation().col(2));
  return 2.0 * std::max(depth_m, camera.near_m) * std::tan(0.5 * camera.vertical_fov_rad) / height_px;
}

std::string name_of(const Handle& handle) {
  const auto letter = [](int axis) { return std::string(kLetters[static_cast<std::size_t>(axis % 3)]); };
  if (handle.kind == HandleKind::kAxis) return letter(handle.axis);
  if (handle.kind == HandleKind::kRing) return "Turn " + letter(handle.axis);
  if (handle.kind == HandleKind::kCentre) return "Centre";
  const int first = std::min((handle.axis + 1) % 3, (handle.axis + 2) % 3);
  const int second = std::max((handle.axis + 1) % 3, (handle.axis + 2) % 3);
  return letter(first) + letter(second);
}

std::vector<HandleShape> handle_shapes(const workbench::GizmoSettings& settings, const spatial::Pose& X_WG,
                                       const ViewPort& view, float length_px) {
  const double length_m = static_cast<double>(length_px) * view.pixel_m(X_WG.p);
  Builder builder{X_WG, view, length_m, kMargin * length_px, toward_eye(view, X_WG.p)};
  for (int axis = 0; axis < 3; ++axis) builder.keep_in_reach(axis);
  for (int axis = 0; axis < 3; ++axis) {
    if (settings.axis >= 0 && axis != settings.axis) continue;
    if (settings.kind == workbench::GizmoKind::kTurn) builder.add_ring(axis);
    if (settings.kind == workbench::GizmoKind::kMove) builder.add_axis(axis);
  }
  const Vector3d eye = builder.eye;
  std::stable_sort(builder.shapes.begin(), builder.shapes.end(), [&](const HandleShape& a, const HandleShape& b) {
    return axis_of(X_WG, a.handle.axis).dot(eye) < axis_of(X_WG, b.handle.axis).dot(eye);
  });
  if (settings.kind == workbench::GizmoKind::kMove && settings.axis < 0) {
    for (int axis = 0; axis < 3; ++axis) builder.add_plane(axis);
    builder.add({HandleKind::kCentre, 0}, {X_WG.p}, X_WG.p);
  }
  return std::move(builder.shapes);
}

std::optional<Handle> handle_at(const std::vector<HandleShape>& shapes, const Vector2f& pixel, float reach_px) {
  std::optional<Handle> nearest;
  double distance = static_cast<double>(reach_px);
  const auto offer = [&](const HandleShape& shape, double away) {
    if (away >= distance) return;
    distance = away;
    nearest = shape.handle;
  };
  for (const HandleShape& shape : shapes) {
    if (shape.handle.kind == HandleKind::kCentre) offer(shape, static_cast<double>((shape.grip - pixel).norm()));
  }
  if (nearest) return nearest;
  for (const HandleShape& shape : shapes) {
    if (shape.handle.kind == HandleKind::kPlane && inside(pixel, shape.points)) return shape.handle;
  }
  for (const HandleShape& shape : shapes) {
    if (shape.handle.kind == HandleKind::kAxis) offer(shape, distance_to_line(pixel, shape.points, false));
    if (shape.handle.kind == HandleKind::kRing) offer(shape, distance_to_line(pixel, shape.points, true));
  }
  return nearest;
}

Vector3d dragged_by(const Handle& handle, const spatial::Pose& X_WG, const ViewPort& view, const Vector2f& from,
                    const Vector2f& to) {
  const auto begin = view.ray(from);
  const auto end = view.ray(to);
  if (handle.kind == HandleKind::kAxis) {
    const Vector3d axis = axis_of(X_WG, handle.axis);
    const auto a = along_line(begin, X_WG.p, axis);
    const auto b = along_line(end, X_WG.p, axis);
    return a && b ? Vector3d((*b - *a) * axis) : Vector3d::Zero();
  }
  const Vector3d normal =
      handle.kind == HandleKind::kPlane ? axis_of(X_WG, handle.axis) : Vector3d(view.camera.X_WC.rotation().col(2));
  const auto a = on_plane(begin, X_WG.p, normal);
  const auto b = on_plane(end, X_WG.p, normal);
  return a && b ? Vector3d(*b - *a) : Vector3d::Zero();
}

double turned_by(const Handle& handle, const spatial::Pose& X_WG, const ViewPort& view, const Vector2f& from,
                 const Vector2f& to) {
  const Vector3d axis = axis_of(X_WG, handle.axis);
  const auto a = on_plane(view.ray(from), X_WG.p, axis);
  const auto b = on_plane(view.ray(to), X_WG.p, axis);
  if (!a || !b) return 0.0;
  const Vector3d first = *a - X_WG.p;
  const Vector3d then = *b - X_WG.p;
  return std::atan2(axis.dot(first.cross(then)), first.dot(then));
}

}  // namespace trocar::ui
