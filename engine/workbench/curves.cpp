#include "engine/workbench/curves.h"

#include <limits>
#include <utility>

#include "engine/demonstration/jaw_limits.h"
#include "engine/demonstration/motion.h"
#include "engine/review/review.h"
#include "engine/spatial/units.h"

namespace trocar::workbench {
namespace {

constexpr double kDegreesPerRadian = 1.0 / spatial::kRadiansPerDegree;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr std::array<CurveLook, demonstration::kCurveKindCount> kLooks{{{"x", "mm", 1e3, false},
                                                                        {"y", "mm", 1e3, false},
                                                                        {"z", "mm", 1e3, false},
                                                                        {"Speed", "mm/s", 1e3, true},
                                                                        {"Acceleration", "m/s²", 1.0, true},
                                                                        {"Jerk", "m/s³", 1.0, true},
                                                                        {"Jaw", "°", kDegreesPerRadian, false},
                                                                        {"Clearance", "mm", 1e3, true}}};

constexpr std::size_t kProblemsAtOnce_samples = 50'000;

}  // namespace

const CurveLook& look_of(CurveKind kind) {
  return kLooks[static_cast<std::size_t>(kind)];
}

std::string_view arm_title(int arm) {
  return arm == 0 ? "Left" : "Right";
}

std::vector<plot::Band> limits_of(CurveKind kind) {
  using demonstration::MotionBounds;
  const double per_si = look_of(kind).per_si;
  const MotionBounds bounds;
  const auto below = [per_si](double high, std::string label) {
    return std::vector<plot::Band>{{-kInfinite, high * per_si, std::move(label)}};
  };
  switch (kind) {
    case CurveKind::kSpeed:
      return below(bounds.speed_m_s, "speed limit");
    case CurveKind::kAcceleration:
      return below(bounds.acceleration_m_s2, "acceleration limit");
    case CurveKind::kJerk:
      return below(bounds.jerk_m_s3, "jerk limit");
    case CurveKind::kJaw:
      return {{demonstration::kJawLow_rad * per_si, demonstration::kJawHigh_rad * per_si, "jaw limit"}};
    case CurveKind::kClearance:
      return {{review::ReviewOptions().clearance_m * per_si, kInfinite, "least clearance"}};
    case CurveKind::kX:
    case CurveKind::kY:
    case CurveKind::kZ:
      break;
  }
  const spatial::Grid grid;
  const double low_m = grid.p_WGo[static_cast<Eigen::Index>(kind)];
  return {{low_m * per_si, (low_m + grid.n * grid.cell_m) * per_si, "learning cube"}};
}

std::shared_ptr<const plot::Curve> plotted(const demonstration::SampleTrack& samples, std::int64_t first_tick,
                                           CurveKind kind, int arm) {
  demonstration::MotionCurve curve = demonstration::curve_of(samples, first_tick, kind, static_cast<std::size_t>(arm));
  for (double& value : curve.values) value *= look_of(kind).per_si;
  return std::make_shared<const plot::Curve>(std::move(curve.t_s), std::move(curve.values));
}

std::shared_ptr<const plot::Curve> plotted_clearance(const demonstration::Demonstration& shown, int arm,
                                                     review::ClearanceMaker& maker) {
  const review::ClearanceCurve clearance = maker.make(shown);
  const auto samples = shown.gated();
  std::vector<double> t_s;
  std::vector<double> values;
  t_s.reserve(clearance.size());
  values.reserve(clearance.size());
  const double gap_s = demonstration::motion_gap_s(samples);
  for (std::size_t i = 0; i < clearance.size(); ++i) {
    const double now_s = Tick{samples.tick(i) - shown.first_tick()}.seconds();
    if (!t_s.empty() && now_s - t_s.back() > gap_s) {
      t_s.push_back(0.5 * (t_s.back() + now_s));
      values.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    t_s.push_back(now_s);
    values.push_back(look_of(CurveKind::kClearance).per_si * clearance[i][static_cast<std::size_t>(arm)].least_m());
  }
  return std::make_shared<const plot::Curve>(std::move(t_s), std::move(values));
}

const ShownCurve* CurveSet::find(CurveKind kind, int arm) const {
  for (const ShownCurve& curve : curves) {
    if (curve.kind == kind && curve.arm == arm) return &curve;
  }
  return nullptr;
}

std::shared_ptr<const plot::Curve> CurveMaker::kept_or_made(const demonstration::SampleTrack& samples,
                                                            std::uint64_t hash, std::int64_t first_tick, CurveKind kind,
                                                            int arm, Curves& kept) const {
  const Key key{hash, first_tick, kind, arm};
  const auto found = curves_.find(key);
  auto& curve = kept[key];
  curve = found != curves_.end() ? found->second : plotted(samples, first_tick, kind, arm);
  return curve;
}

void CurveMaker::add_clearance(const CurvesRequest& request, CurveSet& set) {
  const demonstration::Demonstration& shown = *request.shown;
  demonstration::Demonstration before = request.before ? *request.before : shown;
  if (!request.before) before.samples = shown.recorded;
  const bool changed = before.samples.hash() != shown.samples.hash() && !before.gated().empty();
  for (int arm = 0; arm < 2; ++arm) {
    ShownCurve curve{CurveKind::kClearance, arm, nullptr, nullptr};
    // What was before comes first, so that the newest is what is remembered.
    if (changed) curve.before = plotted_clearance(before, arm, clearance_);
    curve.now = plotted_clearance(shown, arm, clearance_);
    set.curves.push_back(std::move(curve));
  }
}

std::shared_ptr<const CurveSet> CurveMaker::make(const CurvesRequest& request) {
  if (request.shown == nullptr) return nullptr;
  auto set = std::make_shared<CurveSet>();
  set->of = request;
  const demonstration::Demonstration& shown = *request.shown;
  const demonstration::SampleTrack& before = request.before ? request.before->samples : shown.recorded;
  const std::uint64_t hash = shown.samples.hash();
  const std::uint64_t hash_before = before.hash();
  Curves kept;
  for (const CurveKind kind : demonstration::kCurveKinds) {
    if ((request.kinds & bit(kind)) == 0 || kind == CurveKind::kClearance) continue;
    for (int arm = 0; arm < 2; ++arm) {
      ShownCurve curve{kind, arm, nullptr, nullptr};
      curve.now = kept_or_made(shown.samples, hash, shown.first_tick(), kind, arm, kept);
      if (hash_before != hash) {
        curve.before = kept_or_made(before, hash_before, shown.first_tick(), kind, arm, kept);
      }
      set->curves.push_back(std::move(curve));
    }
  }
  if ((request.kinds & bit(CurveKind::kClearance)) != 0) add_clearance(request, *set);
  curves_ = std::move(kept);
  if (checked_ != request.shown) {
    checked_ = request.shown;
    // Those of a long one come with the review, which works them out anyway.
    problems_.clear();
    if (shown.samples.size() <= kProblemsAtOnce_samples) problems_ = demonstration::problems(shown, spatial::Grid{});
  }
  set->problems = problems_;
  return set;
}

}  // namespace trocar::workbench
