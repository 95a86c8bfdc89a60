#include "engine/exchange/mapped_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/exchange/mapped_arm.h"

#include "engine/exchange/plausible.h"

namespace trocar::exchange {
namespace {

using demonstration::Sample;

/// Rows that are left out for one reason.
struct LeftOut {
  const char* why;
  std::size_t count = 0;
  std::string first{};

  void add(const std::string& place) {
    if (count++ == 0) first = place;
  }
};

class TableReader {
 public:
  TableReader(const NumberTable& table, const ColumnMap& map) : table_(table), map_(map) {}

  Result<Imported> read() {
    TROCAR_RETURN_IF_ERROR(resolve());
    for (std::size_t row = 0; row < table_.rows(); ++row) TROCAR_RETURN_IF_ERROR(take(row));
    const std::vector<Sample>& samples = imported_.recording.samples;
    if (samples.size() < 2) return fail(ErrorCode::kCorrupt, "fewer than 2 rows can be samples" + reasons());
    if (2 * samples.size() < table_.rows()) {
      return fail(ErrorCode::kCorrupt,
                  fmt::format("only {} of {} rows can be samples{}", samples.size(), table_.rows(), reasons()));
    }
    TROCAR_RETURN_IF_ERROR(demonstration::check_samples(samples));
    say();
    return std::move(imported_);
  }

 private:
  Status resolve() {
    if (!map_.time.column.empty()) {
      TROCAR_ASSIGN_OR_RETURN(const std::size_t column, table_.find(map_.time.column));
      time_ = {column};
    }
    for (const kinematics::ArmSide side : kinematics::kArmSides) {
      TROCAR_ASSIGN_OR_RETURN(MappedArm arm,
                              MappedArm::resolve(table_, map_.arms[kinematics::index_of(side)], map_.frame, side));
      arms_.push_back(std::move(arm));
    }
    return {};
  }

  Status take(std::size_t row) {
    Sample sample;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      TROCAR_ASSIGN_OR_RETURN(const MappedArm::Outcome outcome, arms_[arm].take(table_, row, sample.arms[arm]));
      if (outcome == MappedArm::Outcome::kNumberMissing) return leave_out(missing_, row);
      if (outcome == MappedArm::Outcome::kNoRotation) return leave_out(no_rotation_, row);
      demonstration::ArmSample& into = sample.arms[arm];
      into.measured = demonstration::CompactPose::from(into.setpoint());
      into.jaw_rad = static_cast<float>(into.setpoint_jaw_rad);
    }
    TROCAR_ASSIGN_OR_RETURN(const double t_s, time_at(row));
    if (std::isnan(t_s)) return leave_out(missing_, row);
    std::vector<Sample>& samples = imported_.recording.samples;
    if (!samples.empty() && t_s == last_s_) return leave_out(same_time_, row);
    if (!samples.empty() && t_s < last_s_) return leave_out(backward_, row);
    sample.tick = std::llround(t_s * Tick::kPerSecond);
    if (!samples.empty() && sample.tick <= samples.back().tick) return leave_out(too_close_, row);
    last_s_ = t_s;
    samples.push_back(sample);
    return {};
  }

  /// Since the first sample; NaN if there is none. A rate counts rows that are left out too: they are gaps.
  Result<double> time_at(std::size_t row) {
    if (time_.empty()) return static_cast<double>(row) / map_.time.rate_hz;
    std::vector<double> value;
    TROCAR_RETURN_IF_ERROR(table_.read(row, time_, value));
    if (!std::isfinite(value[0])) return std::numeric_limits<double>::quiet_NaN();
    if (imported_.recording.samples.empty()) first_time_ = value[0];
    const double t_s = (value[0] - first_time_) * unit_factor(map_.time.unit);
    if (std::abs(t_s) <= kLongest_s) return t_s;
    return fail(ErrorCode::kCorrupt,
                fmt::format("{}: the time is more than a month from the first one, is its unit {}?", table_.place(row),
                            map_.time.unit));
  }

  Status leave_out(LeftOut& reason, std::size_t row) {
    reason.add(table_.place(row));
    return {};
  }

  std::vector<const LeftOut*> left_out() const {
    std::vector<const LeftOut*> all;
    for (const LeftOut* reason : {&missing_, &no_rotation_, &same_time_, &backward_, &too_close_}) {
      if (reason->count > 0) all.push_back(reason);
    }
    return all;
  }

  std::string reasons() const {
    std::string text;
    for (const LeftOut* reason : left_out()) {
      text +=
          fmt::format("{}{} from {} on ({})", text.empty() ? ": " : ", ", reason->count, reason->first, reason->why);
    }
    return text;
  }

  void say() {
    demonstration::Recording& recording = imported_.recording;
    recording.provenance.operator_kind = "imported";
    recording.provenance.block = demonstration::kUnknownPlace;
    recording.provenance.goal = demonstration::kUnknownPlace;
    recording.outcome = demonstration::Outcome::kUnknown;
    for (const LeftOut* reason : left_out()) {
      imported_.found.push_back(fmt::format("{} {} left out, the first is {}: {}", reason->count,
                                            reason->count == 1 ? "row is" : "rows are", reason->first, reason->why));
    }
    if (std::string wide = table_.too_wide(); !wide.empty()) imported_.found.push_back(std::move(wide));
    for (const MappedArm& arm : arms_) {
      for (std::string& sentence : arm.found()) imported_.found.push_back(std::move(sentence));
      for (std::string& lost : arm.lossy()) imported_.lossy.push_back(std::move(lost));
    }
    imported_.found.emplace_back(time_.empty() ? fmt::format("times are those of {:g} rows a second", map_.time.rate_hz)
                                               : "times count from the first sample, in whole milliseconds");
    say_unused();
    for (const char* lost :
         {"setpoints (what the table has stands in for both)", "the blocks", "segments (all is labelled A)",
          "its block, goal and outcome", "a simulated world (it cannot be replayed)"}) {
      imported_.lossy.emplace_back(lost);
    }
  }

  void say_unused() {
    constexpr std::size_t kShown = 20;
    std::vector<bool> used(table_.width(), false);
    for (const std::size_t column : time_) used[column] = true;
    for (const MappedArm& arm : arms_) {
      for (const std::size_t column : arm.used()) used[column] = true;
    }
    std::vector<std::string> names;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) names.push_back(table_.shown(i));
    }
    if (names.empty()) return;
    const std::size_t shown = std::min(names.size(), kShown);
    std::string text = fmt::format("columns that nothing is made of: {}",
                                   fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
    if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
    imported_.found.push_back(std::move(text));
  }

  const NumberTable& table_;
  const ColumnMap& map_;
  std::vector<std::size_t> time_;  ///< One column, or none.
  std::vector<MappedArm> arms_;
  double first_time_ = 0.0;
  double last_s_ = 0.0;
  LeftOut missing_{"a number is missing"};
  LeftOut no_rotation_{"its quaternion is far from length 1, or its matrix is no rotation"};
  LeftOut same_time_{"the time is that of the row before"};
  LeftOut backward_{"the time goes backward"};
  LeftOut too_close_{"less than a millisecond after the row before"};
  Imported imported_;
};

}  // namespace

Result<Imported> from_table(const NumberTable& table, const ColumnMap& map) {
  if (map.arms[0].empty() && map.arms[1].empty()) {
    return fail(ErrorCode::kInvalidArgument, "the map says of neither tool which columns it is in");
  }
  return TableReader(table, map).read();
}

}  // namespace trocar::exchange
