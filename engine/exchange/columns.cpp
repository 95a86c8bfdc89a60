#include "engine/exchange/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/exchange/plausible.h"

namespace trocar::exchange {
namespace {

using demonstration::CompactPose;
using demonstration::Sample;

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
constexpr std::array<const char*, 4> kParts{"w", "x", "y", "z"};

class Table {
 public:
  std::vector<Column> take() { return std::move(columns_); }

  template <typename Access>
  void number(std::string name, bool required, Access access) {
    using Number = std::remove_reference_t<decltype(access(std::declval<Sample&>()))>;
    columns_.push_back({std::move(name), required, 0.0,
                        // The same accessor serves both ways; reading changes nothing.
                        [access](const Sample& sample) {
                          Sample copy = sample;
                          return static_cast<double>(access(copy));
                        },
                        [access](Sample& sample, double value) { access(sample) = static_cast<Number>(value); }});
  }

  void setpoint(const std::string& arm_name, std::size_t arm) {
    for (std::size_t i = 0; i < 3; ++i) {
      number(fmt::format("{}_setpoint_{}_m", arm_name, kAxes[i]), true,
             [arm, i](Sample& s) -> double& { return s.arms[arm].setpoint_p[i]; });
    }
    for (std::size_t i = 0; i < 4; ++i) {
      number(fmt::format("{}_setpoint_q_{}", arm_name, kParts[i]), true,
             [arm, i](Sample& s) -> double& { return s.arms[arm].setpoint_q_wxyz[i]; });
    }
    number(arm_name + "_setpoint_jaw_rad", true, [arm](Sample& s) -> double& { return s.arms[arm].setpoint_jaw_rad; });
  }

  template <typename Access>
  void pose(const std::string& name, Access access) {
    for (std::size_t i = 0; i < 3; ++i) {
      number(fmt::format("{}_{}_m", name, kAxes[i]), false,
             [access, i](Sample& s) -> float& { return access(s).p[i]; });
    }
    for (std::size_t i = 0; i < 4; ++i) {
      number(fmt::format("{}_q_{}", name, kParts[i]), false,
             [access, i](Sample& s) -> float& { return access(s).q_wxyz[i]; });
    }
  }

  void arm(const std::string& name, std::size_t arm) {
    setpoint(name, arm);
    pose(name + "_measured", [arm](Sample& s) -> CompactPose& { return s.arms[arm].measured; });
    number(name + "_jaw_rad", false, [arm](Sample& s) -> float& { return s.arms[arm].jaw_rad; });
    for (std::size_t i = 0; i < 6; ++i) {
      number(fmt::format("{}_joint_{}", name, i + 1), false,
             [arm, i](Sample& s) -> float& { return s.arms[arm].joints[i]; });
    }
  }

  void flag(std::string name, std::uint32_t bit) {
    columns_.push_back({std::move(name), false, 1.0,
                        [bit](const Sample& sample) { return (sample.flags & bit) != 0 ? 1.0 : 0.0; },
                        [bit](Sample& sample, double value) {
                          sample.flags = value != 0.0 ? sample.flags | bit : sample.flags & ~bit;
                        }});
  }

  void add(Column column) { columns_.push_back(std::move(column)); }

 private:
  std::vector<Column> columns_;
};

std::vector<Column> make_columns() {
  Table table;
  table.add({"t_s", true, 0.0, [](const Sample& sample) { return sample.t_s(); },
             [](Sample& sample, double value) { sample.tick = tick_at(value).count; }});
  table.arm("left", 0);
  table.arm("right", 1);
  for (std::size_t i = 0; i < Sample().blocks.size(); ++i) {
    table.pose(fmt::format("block_{}", i), [i](Sample& s) -> CompactPose& { return s.blocks[i]; });
  }
  table.flag("agent_pedal", demonstration::kAgentPedal);
  table.flag("clutch_pedal", demonstration::kClutchPedal);
  table.flag("left_holds", demonstration::kLeftHolds);
  table.flag("right_holds", demonstration::kRightHolds);
  table.add({"authority", false, 3.0, [](const Sample& s) { return static_cast<double>(s.authority); },
             [](Sample& s, double value) { s.authority = static_cast<demonstration::Authority>(value); }});
  table.add({"segment", false, 4.0, [](const Sample& s) { return static_cast<double>(s.segment); },
             [](Sample& s, double value) { s.segment = static_cast<demonstration::Segment>(value); }});
  return table.take();
}

bool has(const std::vector<const Column*>& order, std::string_view name) {
  return std::any_of(order.begin(), order.end(), [&](const Column* column) { return column->name == name; });
}

Status check_value(const Column& column, double value) {
  if (!std::isfinite(value)) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} is not a finite number", column.name));
  }
  const bool whole = value == std::floor(value) && value >= 0.0 && value <= column.whole_limit;
  if (column.whole_limit != 0.0 && !whole) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} must be a whole number from 0 to {}", column.name, column.whole_limit));
  }
  if (column.name == "t_s" && (value < 0.0 || value > kLongest_s)) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("t_s must be from 0 to {} s", kLongest_s));
  }
  if (std::abs(value) > 1e30) return fail(ErrorCode::kInvalidArgument, column.name + " is out of range");
  return {};
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> table = make_columns();
  return table;
}

std::vector<Sample> table_samples(const demonstration::Demonstration& document) {
  std::vector<Sample> samples;
  samples.reserve(document.gated().size());
  const Status all = visit_table_samples(document, [&samples](const Sample& sample) {
    samples.push_back(sample);
    return Status();
  });
  TROCAR_CHECK(all.has_value());
  return samples;
}

Status visit_table_samples(const demonstration::Demonstration& document,
                           const std::function<Status(const Sample&)>& take) {
  const std::int64_t first = document.first_tick();
  auto span = document.segments.begin();
  for (Sample sample : document.gated()) {
    sample.tick -= first;
    const double t_s = sample.t_s();
    while (span != document.segments.end() && t_s >= span->end_s) ++span;
    if (span != document.segments.end() && t_s >= span->begin_s) sample.segment = span->label;
    TROCAR_RETURN_IF_ERROR(take(sample));
  }
  return {};
}

Status sample_from_row(const std::vector<const Column*>& order, const std::vector<double>& values, Sample& sample) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    TROCAR_RETURN_IF_ERROR(check_value(*order[i], values[i]));
    order[i]->write(sample, values[i]);
  }
  const std::array<const char*, 2> names{"left", "right"};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const spatial::Pose setpoint = sample.arms[arm].setpoint();
    if (setpoint.q.norm() < 0.5) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("{}_setpoint_q is no rotation", names[arm]));
    }
    if (!has(order, fmt::format("{}_measured_x_m", names[arm]))) {
      sample.arms[arm].measured = CompactPose::from(setpoint);
    }
    if (!has(order, fmt::format("{}_jaw_rad", names[arm]))) {
      sample.arms[arm].jaw_rad = static_cast<float>(sample.arms[arm].setpoint_jaw_rad);
    }
  }
  return {};
}

Result<std::vector<const Column*>> columns_named(const std::vector<std::string>& names) {
  std::vector<const Column*> order;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(columns().begin(), columns().end(), [&](const Column& column) { return column.name == name; });
    if (found == columns().end()) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("no column is named \"{}\"", name.substr(0, 60)));
    }
    if (has(order, name)) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("the column {} is there twice", name));
    }
    order.push_back(&*found);
  }
  for (const Column& column : columns()) {
    if (column.required && !has(order, column.name)) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("the column {} is missing", column.name));
    }
  }
  return order;
}

Channels recorded_channels(const std::vector<Sample>& samples) {
  Channels channels;
  for (const Sample& sample : samples) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const auto& joints = sample.arms[arm].joints;
      if (std::any_of(joints.begin(), joints.end(), [](float q) { return q != 0.0F; })) channels.joints[arm] = true;
    }
    const CompactPose& first = sample.blocks.front();
    channels.blocks |= std::any_of(sample.blocks.begin(), sample.blocks.end(), [&first](const CompactPose& block) {
      return block.p != first.p || block.q_wxyz != first.q_wxyz;
    });
  }
  return channels;
}

std::vector<std::string> not_recorded(const Channels& channels) {
  std::vector<std::string> missing;
  if (!channels.joints[0]) missing.emplace_back("the joints of the left arm");
  if (!channels.joints[1]) missing.emplace_back("the joints of the right arm");
  if (!channels.blocks) missing.emplace_back("the blocks");
  return missing;
}

std::string kept_samples(const Channels& channels) {
  const bool joints = channels.joints[0] || channels.joints[1];
  return fmt::format("every sample to the bit (times, setpoints, measured poses,{} jaws,{} pedals, labels)",
                     joints ? " joints," : "", channels.blocks ? " blocks," : "");
}

std::vector<std::string> kept_by_export(const demonstration::Demonstration& document) {
  return {kept_samples(recorded_channels(table_samples(document)))};
}

std::vector<std::string> lost_by_export(const demonstration::Demonstration& document) {
  std::vector<std::string> lossy{"who recorded it and how (provenance)", "its block, goal and outcome"};
  const demonstration::RecordingInfo& recording = *document.recording;
  if (!recording.initial_world.empty()) lossy.emplace_back("the simulated world before the first sample");
  if (!recording.hashes.empty()) lossy.emplace_back("the state hashes that a replay is checked against");
  if (document.gated().size() < document.samples.size()) lossy.emplace_back("the samples outside of the gates");
  for (const std::string& missing : not_recorded(recorded_channels(table_samples(document)))) {
    lossy.push_back(missing + " (never recorded: its columns say nothing)");
  }
  return lossy;
}

std::vector<std::string> lost_by_import(const std::vector<const Column*>& order) {
  std::vector<std::string> lossy;
  for (const char* arm : {"left", "right"}) {
    if (!has(order, fmt::format("{}_measured_x_m", arm))) {
      lossy.push_back(fmt::format("the measured pose of the {} arm (its setpoint stands in)", arm));
    }
    if (!has(order, fmt::format("{}_joint_1", arm))) lossy.push_back(fmt::format("the joints of the {} arm", arm));
  }
  if (!has(order, "block_0_x_m")) lossy.emplace_back("the blocks");
  if (!has(order, "segment")) lossy.emplace_back("segments (all is labelled A)");
  lossy.emplace_back("its block, goal and outcome");
  lossy.emplace_back("a simulated world (it cannot be replayed)");
  return lossy;
}

}  // namespace trocar::exchange
