// Bridge: a new motion from one instant to another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/peg_board/peg_board.h"

namespace trocar::demonstration {
namespace {

double smoothly(double x) {
  return x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);  // Flash and Hogan, 1985
}
/// The peak speed relative to the mean.
double peak_of(BridgeShape shape) {
  return shape == BridgeShape::kStraight ? 1.0 : 1.875;
}

/// A polyline by arc length.
class Polyline {
 public:
  explicit Polyline(std::vector<Eigen::Vector3d> points) : points_(std::move(points)) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      lengths_m_.push_back(lengths_m_.back() + (points_[i] - points_[i - 1]).norm());
    }
  }
  double length_m() const { return lengths_m_.back(); }
  /// The share of the way at the share `x` of the time.
  double way(BridgeShape shape, double x) const {
    if (shape == BridgeShape::kStraight) return x;
    if (shape != BridgeShape::kOver || length_m() <= 0.0) return smoothly(x);
    // To rest at each corner: times share out as lengths do, so that each leg is as fast.
    const double wanted_m = x * length_m();
    const auto after = std::upper_bound(lengths_m_.begin() + 1, lengths_m_.end() - 1, wanted_m);
    const double begin = *(after - 1) / length_m();
    const double run = *after / length_m() - begin;
    return run > 0.0 ? begin + run * smoothly(std::clamp((x - begin) / run, 0.0, 1.0)) : begin;
  }
  Eigen::Vector3d at(double share) const {
    const double wanted_m = share * length_m();
    const auto after = std::upper_bound(lengths_m_.begin() + 1, lengths_m_.end() - 1, wanted_m);
    const auto i = static_cast<std::size_t>(after - lengths_m_.begin());
    const double run_m = lengths_m_[i] - lengths_m_[i - 1];
    const double part = run_m > 0.0 ? std::clamp((wanted_m - lengths_m_[i - 1]) / run_m, 0.0, 1.0) : share;
    return points_[i - 1] + part * (points_[i] - points_[i - 1]);
  }

 private:
  std::vector<Eigen::Vector3d> points_;
  std::vector<double> lengths_m_{0.0};
};

/// Above everything on the board, with a block held and 3 mm to spare.
double height_over(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kSpare_m = 0.003;
  const double pegs_m = peg_board::kPegHeight_m + peg_board::kBlockHeight_m + kSpare_m;
  return std::max({a.z(), b.z(), pegs_m});
}

Polyline line_of(const Sample& from, const Sample& to, std::size_t arm, const Bridge& edit) {
  std::vector<Eigen::Vector3d> points{measured_tip(from, arm)};
  const Eigen::Vector3d end = measured_tip(to, arm);
  if (edit.shape == BridgeShape::kOver) {
    const double z_m = height_over(points.front(), end);
    points.emplace_back(points.front().x(), points.front().y(), z_m);
    points.emplace_back(end.x(), end.y(), z_m);
  } else if (arm == indices_of(edit.arms).front()) {
    points.insert(points.end(), edit.via_m.begin(), edit.via_m.end());
  }
  points.push_back(end);
  return Polyline(std::move(points));
}

/// The last sample at or before the begin, and the first at or after the end.
Result<std::pair<std::size_t, std::size_t>> ends_of(const Demonstration& document, const Bridge& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  const std::size_t after_from = document.samples.lower_bound(document.tick_after(edit.from_s));
  const std::size_t to = document.samples.lower_bound(document.tick_from(edit.to_s));
  if (after_from > 0 && to < document.samples.size() && after_from - 1 < to) return std::pair{after_from - 1, to};
  return fail(ErrorCode::kInvalidArgument, "a bridge needs a sample before its begin and one after its end");
}

/// From one new sample to the next, in ticks. Errors: kInvalidArgument.
Result<std::int64_t> step_of(const Bridge& edit, const SampleTrack& track, std::size_t first, std::size_t last) {
  if (edit.rate_hz == 0.0) return step_between(track, first, last);
  constexpr double kSlowest_hz = 0.1;
  if (!(edit.rate_hz >= kSlowest_hz && edit.rate_hz <= Tick::kPerSecond)) {
    return fail(ErrorCode::kInvalidArgument, "the rate of a bridge must be 0 or from 0.1 to 1000 Hz");
  }
  return std::max<std::int64_t>(std::llround(Tick::kPerSecond / edit.rate_hz), 1);
}

/// When the new samples come, in ticks from the begin; `length` is not among them.
std::vector<std::int64_t> times_of(const Bridge& edit, std::int64_t step, std::int64_t length) {
  std::vector<std::int64_t> times;
  if (edit.rate_hz != 0.0) {
    for (std::int64_t tick = step; tick < length; tick += step) times.push_back(tick);
    return times;
  }
  // Evenly, so that the last step is no shorter than the others.
  const std::int64_t count = std::max<std::int64_t>((2 * length + step) / (2 * step), 1);
  for (std::int64_t i = 1; i < count; ++i) times.push_back((2 * i * length + count) / (2 * count));
  return times;
}

/// In ticks, a whole number of samples. Errors: kInvalidArgument.
Result<std::int64_t> length_of(const Bridge& edit, const std::vector<Polyline>& lines, std::int64_t as_it_is,
                               std::int64_t step) {
  constexpr std::int64_t kLongest = 3600 * Tick::kPerSecond;
  std::int64_t length = as_it_is;
  if (edit.peak_speed_m_s != 0.0) {
    TROCAR_RETURN_IF_ERROR(check_positive(edit.peak_speed_m_s, "the peak speed"));
    double longest_m = 0.0;
    for (const Polyline& line : lines) longest_m = std::max(longest_m, line.length_m());
    const double seconds = peak_of(edit.shape) * longest_m / edit.peak_speed_m_s;
    const double steps = std::min(seconds * 1000.0 / static_cast<double>(step), 1e9);
    length = std::max<std::int64_t>(std::llround(steps), 1) * step;
  }
  if (length > kLongest) return fail(ErrorCode::kInvalidArgument, "the bridge would last for more than an hour");
  return length;
}

Status check(const Bridge& edit) {
  if (edit.shape == BridgeShape::kPolicy && edit.via_m.empty()) {
    return fail(ErrorCode::kInvalidArgument, "a bridge by policy needs the way that the policy goes");
  }
  for (const Eigen::Vector3d& point : edit.via_m) {
    if (!point.allFinite()) return fail(ErrorCode::kInvalidArgument, "a point to pass must be finite");
  }
  return {};
}

/// Puts an arm of `sample` where it is at the share `along` of its way.
void place_arm(Sample& sample, std::size_t arm, const Sample& from, const Sample& to, const Polyline& line,
               double along, int block) {
  const ArmSample& a = from.arms[arm];
  const ArmSample& b = to.arms[arm];
  const spatial::Pose now = sample.arms[arm].measured.pose();
  const Eigen::Quaterniond q = a.measured.pose().q.slerp(along, b.measured.pose().q);
  displace(sample, arm, line.at(along) - now.p, q * now.q.conjugate(), block);
  sample.arms[arm].setpoint_jaw_rad = a.setpoint_jaw_rad + along * (b.setpoint_jaw_rad - a.setpoint_jaw_rad);
  sample.arms[arm].jaw_rad =
      static_cast<float>(static_cast<double>(a.jaw_rad) + along * static_cast<double>(b.jaw_rad - a.jaw_rad));
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Bridge& edit) {
  TROCAR_ASSIGN_OR_RETURN(const auto ends, ends_of(document, edit));
  TROCAR_RETURN_IF_ERROR(check(edit));
  const auto [first, last] = ends;
  const Sample from = document.samples[first];
  const Sample to = document.samples[last];
  const std::vector<std::size_t> arms = indices_of(edit.arms);
  std::vector<Polyline> lines;
  lines.reserve(arms.size());
  for (const std::size_t arm : arms) lines.push_back(line_of(from, to, arm, edit));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t step, step_of(edit, document.samples, first, last));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t length, length_of(edit, lines, to.tick - from.tick, step));
  // What the arm that is not bridged does goes on, stretched if need be.
  const SampleTrack before = document.samples.slice(first, last + 1 - first);
  TrackReader reader(before);
  std::vector<Sample> made;
  for (const std::int64_t tick : times_of(edit, step, length)) {
    const double share = static_cast<double>(tick) / static_cast<double>(length);
    Sample sample = reader.at(static_cast<double>(from.tick) + share * static_cast<double>(to.tick - from.tick));
    for (std::size_t i = 0; i < arms.size(); ++i) {
      place_arm(sample, arms[i], from, to, lines[i], lines[i].way(edit.shape, share), document.block);
    }
    sample.tick = from.tick + tick;
    made.push_back(sample);
  }
  return with_other_length(document, first + 1, last - first - 1, SampleTrack(made), length - (to.tick - from.tick));
}

}  // namespace trocar::demonstration
