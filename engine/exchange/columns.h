/// The columns of a demonstration as a table, the same in CSV and NPY: one row for each sample, SI units.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::exchange {

/// One number of a sample. In order: `t_s` (time since the recording's first sample); for each arm, left then right,
/// `ARM_setpoint_x_m … z_m`, `ARM_setpoint_q_w … z`, `ARM_setpoint_jaw_rad`, `ARM_measured_x_m … z_m`,
/// `ARM_measured_q_w … z`, `ARM_jaw_rad`, `ARM_joint_1 … 6` (radians, the third metres); for each block
/// `block_0_x_m … z_m`, `block_0_q_w … z`; `agent_pedal`, `clutch_pedal`, `left_holds`, `right_holds` (0 or 1);
/// `authority` (0 operator, 1 agent, 2 assistant, 3 hold); `segment` (0 … 4: A … E). Positions are p_WT, in metres.
struct Column {
  std::string name;
  bool required = false;     ///< Time and both arms' setpoints; the rest can be left out of an import.
  double whole_limit = 0.0;  ///< Not 0: a whole number from 0 to this.
  std::function<double(const demonstration::Sample&)> read;
  std::function<void(demonstration::Sample&, double)> write;
};

/// `t_s` is the first; its `read` and `write` count from tick 0.
const std::vector<Column>& columns();

/// The gated samples as they are to be written: labels as edited, time counted from the recording's first sample.
std::vector<demonstration::Sample> table_samples(const demonstration::Demonstration& document);
/// The same one by one, for who does not need them all at once. Errors: those of `take`, which end it.
Status visit_table_samples(const demonstration::Demonstration& document,
                           const std::function<Status(const demonstration::Sample&)>& take);

/// What a demonstration has beside its tools; an import may be without.
struct Channels {
  std::array<bool, 2> joints{};  ///< By arm, left first.
  bool blocks = false;
};
/// Of `samples`: joints that are all zero all the time and blocks that are all at one place were never recorded.
Channels recorded_channels(const std::vector<demonstration::Sample>& samples);
/// "the joints of the left arm", for each channel that is not there.
std::vector<std::string> not_recorded(const Channels& channels);
/// "every sample to the bit (times, …)".
std::string kept_samples(const Channels& channels);

/// Sets `sample` from one row, columns by their place in `columns()`. What has no column follows the setpoint, or
/// stays as it is by default.
/// Errors: kInvalidArgument naming the column whose value is not finite or out of range.
Status sample_from_row(const std::vector<const Column*>& order, const std::vector<double>& values,
                       demonstration::Sample& sample);

/// Errors: kInvalidArgument naming an unknown, doubled or missing column.
Result<std::vector<const Column*>> columns_named(const std::vector<std::string>& names);

/// What an export as a table brings back to the bit when it is imported.
std::vector<std::string> kept_by_export(const demonstration::Demonstration& document);
/// What an export leaves out, and what an import of `order` has to do without; each reads on after "without".
std::vector<std::string> lost_by_export(const demonstration::Demonstration& document);
std::vector<std::string> lost_by_import(const std::vector<const Column*>& order);

}  // namespace trocar::exchange
