#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/demonstration/name.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/exchange/actions.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/hdf5_process.h"
#include "engine/exchange/robomimic.h"
#include "engine/exchange/robomimic_header.h"

namespace trocar::exchange {
namespace {

using demonstration::CompactPose;
using demonstration::Demonstration;
using demonstration::Sample;
using Kind = TreeNode::Kind;
using Json = nlohmann::ordered_json;

TreeNode group_node(std::string path) {
  TreeNode node;
  node.path = std::move(path);
  return node;
}

/// What a training program asks a file about its environment. There is no such environment for robomimic to make:
/// roll-outs are ours.
std::string environment(double rate_hz) {
  const Json json{{"env_name", "TrocarPegTransfer"},
                  {"type", 2},  // robomimic's number for gym, the plainest of its kinds
                  {"env_kwargs", {{"control_freq", rate_hz}, {"robots", {"PSM2 (left)", "PSM1 (right)"}}}}};
  return json.dump();
}

/// Rows of `width` numbers, `fill` putting those of one sample behind the others.
template <typename Fill>
TreeNode rows_node(const std::string& path, Kind kind, std::size_t width, const std::vector<Sample>& samples,
                   const Fill& fill) {
  std::vector<double> numbers;
  numbers.reserve(samples.size() * width);
  for (const Sample& sample : samples) fill(sample, numbers);
  return array_node(path, kind, {samples.size(), width}, numbers);
}

void push_pose(const CompactPose& pose, std::vector<double>& into) {
  into.insert(into.end(), pose.p.begin(), pose.p.end());
  for (const std::size_t part : {1U, 2U, 3U, 0U}) into.push_back(static_cast<double>(pose.q_wxyz[part]));
}

/// "left_joint_", "right_joint_" and "block_": the columns of what may never have been recorded.
std::vector<std::string> optional_channels() {
  return {"left_joint_", "right_joint_", "block_"};
}

/// All columns but those of channels in which every number is, to the bit, what a reader puts in place of none.
std::vector<const Column*> told_columns(const std::vector<Sample>& samples) {
  const Sample none;
  std::set<std::string> silent;
  for (const std::string& channel : optional_channels()) silent.insert(channel);
  const auto channel_of = [](const std::string& name) {
    for (const std::string& channel : optional_channels()) {
      if (name.starts_with(channel)) return channel;
    }
    return std::string();
  };
  for (const Column& column : columns()) {
    const std::string channel = channel_of(column.name);
    if (!silent.contains(channel)) continue;
    const auto expected = std::bit_cast<std::uint64_t>(column.read(none));
    const bool same = std::all_of(samples.begin(), samples.end(), [&](const Sample& sample) {
      return std::bit_cast<std::uint64_t>(column.read(sample)) == expected;
    });
    if (!same) silent.erase(channel);
  }
  std::vector<const Column*> told;
  for (const Column& column : columns()) {
    if (!silent.contains(channel_of(column.name))) told.push_back(&column);
  }
  return told;
}

class DemonstrationWriter {
 public:
  DemonstrationWriter(Hdf5Writer& writer, std::string group, const std::vector<Sample>& samples)
      : writer_(writer), group_(std::move(group)), samples_(samples), channels_(recorded_channels(samples)) {}

  Status write(const Demonstration& document, const ActionScale& scale) {
    TreeNode group = group_node(group_);
    group.attributes["num_samples"] = static_cast<std::int64_t>(samples_.size());
    group.attributes["name"] = document.name;
    TROCAR_RETURN_IF_ERROR(writer_.add(group));
    TROCAR_RETURN_IF_ERROR(write_actions(scale));
    TROCAR_RETURN_IF_ERROR(write_states());
    TROCAR_RETURN_IF_ERROR(write_ends(document));
    TROCAR_RETURN_IF_ERROR(writer_.add(group_node(group_ + "/obs")));
    for (std::size_t arm = 0; arm < 2; ++arm) TROCAR_RETURN_IF_ERROR(write_arm(arm));
    if (channels_.blocks) TROCAR_RETURN_IF_ERROR(write_blocks());
    return write_own(document);
  }

 private:
  Status write_actions(const ActionScale& scale) {
    TreeNode node = array_node(group_ + "/actions", Kind::kFloat64, {samples_.size(), kActionWidth},
                               exchange::actions(samples_, scale));
    const auto factor = scale.factor();
    const auto offset = scale.offset();
    node.attributes["columns"] = action_names();
    node.attributes["scale"] = std::vector<double>(factor.begin(), factor.end());
    node.attributes["offset"] = std::vector<double>(offset.begin(), offset.end());
    node.attributes["meaning"] = std::string(
        "scale * action + offset: the setpoint's step to the next sample in the board frame, metres and "
        "axis times angle in radians; the jaw's setpoint at the next sample, radians");
    return writer_.add(node);
  }

  Status write_states() {
    const std::vector<const Column*> told = told_columns(samples_);
    std::vector<std::string> names;
    for (const Column* column : told) names.push_back(column->name);
    TreeNode node = rows_node(group_ + "/states", Kind::kFloat64, names.size(), samples_,
                              [&told](const Sample& sample, std::vector<double>& into) {
                                for (const Column* column : told) into.push_back(column->read(sample));
                              });
    node.attributes["columns"] = std::move(names);
    return writer_.add(node);
  }

  /// The last sample ends the episode; a transfer that is known to have succeeded is worth 1 then.
  Status write_ends(const Demonstration& document) {
    std::vector<double> ends(samples_.size(), 0.0);
    ends.back() = 1.0;
    TROCAR_RETURN_IF_ERROR(writer_.add(array_node(group_ + "/dones", Kind::kInt64, {ends.size()}, ends)));
    ends.back() = document.outcome() == demonstration::Outcome::kSuccess ? 1.0 : 0.0;
    return writer_.add(array_node(group_ + "/rewards", Kind::kFloat64, {ends.size()}, ends));
  }

  template <typename Fill>
  Status write_observation(const std::string& name, std::size_t width, const char* units, const Fill& fill) {
    TreeNode node = rows_node(group_ + "/obs/" + name, Kind::kFloat32, width, samples_, fill);
    node.attributes["units"] = std::string(units);
    if (name.ends_with("quat")) node.attributes["quaternion_order"] = std::string("xyzw");
    return writer_.add(node);
  }

  Status write_arm(std::size_t arm) {
    const std::string robot = fmt::format("robot{}_", arm);
    const auto of = [arm](const Sample& sample) -> const demonstration::ArmSample& { return sample.arms[arm]; };
    TROCAR_RETURN_IF_ERROR(write_observation(robot + "eef_pos", 3, "m", [&](const Sample& sample, auto& into) {
      into.insert(into.end(), of(sample).measured.p.begin(), of(sample).measured.p.end());
    }));
    TROCAR_RETURN_IF_ERROR(write_observation(robot + "eef_quat", 4, "1", [&](const Sample& sample, auto& into) {
      std::vector<double> pose;
      push_pose(of(sample).measured, pose);
      into.insert(into.end(), pose.begin() + 3, pose.end());
    }));
    TROCAR_RETURN_IF_ERROR(write_observation(robot + "gripper_qpos", 1, "rad", [&](const Sample& sample, auto& into) {
      into.push_back(static_cast<double>(of(sample).jaw_rad));
    }));
    if (!channels_.joints[arm]) return {};
    return write_observation(robot + "joint_pos", 6, "rad, the third m", [&](const Sample& sample, auto& into) {
      into.insert(into.end(), of(sample).joints.begin(), of(sample).joints.end());
    });
  }

  Status write_blocks() {
    const std::size_t width = 7 * Sample().blocks.size();
    return write_observation("object", width, "for each block: position in m, quaternion xyzw",
                             [](const Sample& sample, std::vector<double>& into) {
                               for (const CompactPose& block : sample.blocks) push_pose(block, into);
                             });
  }

  Status write_own(const Demonstration& document) {
    TROCAR_RETURN_IF_ERROR(writer_.add(group_node(group_ + "/trocar")));
    TROCAR_RETURN_IF_ERROR(writer_.add(texts_node(group_ + "/trocar/header", {robomimic_header(document, samples_)})));
    const std::string& world = document.recording->initial_world;
    if (world.empty() || !is_as_recorded(document, samples_)) return {};
    TreeNode node = array_node(group_ + "/trocar/initial_world", Kind::kUint8, {world.size()}, {});
    node.data = world;
    return writer_.add(node);
  }

  Hdf5Writer& writer_;
  std::string group_;
  const std::vector<Sample>& samples_;
  Channels channels_;
};

/// What every export can be filtered by: who made a recording, with which skill, and how it ended.
Masks own_masks(const Documents& documents) {
  Masks masks;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const demonstration::RecordingInfo& recording = *documents[i]->recording;
    std::set<std::string> keys{"all", fmt::format("outcome_{}", to_string(documents[i]->outcome()))};
    if (!recording.provenance.operator_kind.empty()) keys.insert("operator_" + recording.provenance.operator_kind);
    if (!recording.provenance.skill.empty()) keys.insert("skill_" + recording.provenance.skill);
    for (const std::string& key : keys) masks[key].push_back(i);
  }
  return masks;
}

Status check_key(const std::string& key) {
  TROCAR_RETURN_IF_ERROR(demonstration::check_name(key));
  if (key.find('/') == std::string::npos && key != "." && key != "..") return {};
  return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no filter key: it has a slash or is only dots", key));
}

Status write_masks(Hdf5Writer& writer, const Documents& documents, Masks masks) {
  for (std::size_t i = 0; i < documents.size(); ++i) {
    for (const demonstration::Note& note : documents[i]->notes) {
      if (note.tag == "mask") masks[note.text].push_back(i);
    }
  }
  TreeNode group = group_node("mask");
  std::vector<std::string> made;
  for (auto& [key, places] : own_masks(documents)) {
    if (masks.try_emplace(key, places).second) made.push_back(key);
  }
  group.attributes["made_by_trocar"] = std::move(made);
  TROCAR_RETURN_IF_ERROR(writer.add(group));
  for (const auto& [key, places] : masks) {
    TROCAR_RETURN_IF_ERROR(check_key(key));
    std::vector<std::string> names;
    for (const std::size_t place : std::set<std::size_t>(places.begin(), places.end())) {
      names.push_back(fmt::format("demo_{}", place));
    }
    TROCAR_RETURN_IF_ERROR(writer.add(texts_node("mask/" + key, std::move(names))));
  }
  return {};
}

}  // namespace

Status write_robomimic(const Documents& documents, const Masks& masks, const std::filesystem::path& path) {
  ActionRange range;
  std::size_t total = 0;
  for (const auto& document : documents) {
    const std::vector<Sample> samples = table_samples(*document);
    range.add(samples);
    total += samples.size();
  }
  TROCAR_ASSIGN_OR_RETURN(Hdf5Writer writer, Hdf5Writer::create(path));
  TreeNode data = group_node("data");
  data.attributes["total"] = static_cast<std::int64_t>(total);
  data.attributes["env_args"] = environment(rate_of(documents).rate_hz);
  TROCAR_RETURN_IF_ERROR(writer.add(data));
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const std::vector<Sample> samples = table_samples(*documents[i]);
    DemonstrationWriter one(writer, fmt::format("data/demo_{}", i), samples);
    TROCAR_RETURN_IF_ERROR(one.write(*documents[i], range.scale()));
  }
  TROCAR_RETURN_IF_ERROR(write_masks(writer, documents, masks));
  return writer.finish();
}

RobomimicRate rate_of(const Documents& documents) {
  RobomimicRate rate{demonstration::usual_rate_hz(documents.front()->gated()), ""};
  const double step = static_cast<double>(Tick::kPerSecond) / rate.rate_hz;
  std::size_t others = 0;
  std::size_t irregular = 0;
  for (const auto& document : documents) {
    const demonstration::SampleTrack samples = document->gated();
    if (std::abs(demonstration::usual_rate_hz(samples) / rate.rate_hz - 1.0) > 1e-3) {
      ++others;
      continue;
    }
    for (std::size_t i = 1; i < samples.size(); ++i) {
      if (std::abs(static_cast<double>(samples.tick(i) - samples.tick(i - 1)) - step) > 1.0) ++irregular;
    }
  }
  std::string what;
  if (irregular > 0) what = fmt::format("{} of their steps are others", irregular);
  if (others > 0) {
    what += fmt::format("{}{} of the demonstrations {} another rate", what.empty() ? "" : ", ", others,
                        others == 1 ? "has" : "have");
  }
  if (what.empty()) return rate;
  rate.lost = fmt::format("times, for other programs: the file says {:.4g} samples a second, {}", rate.rate_hz, what);
  return rate;
}

std::vector<std::string> kept_by_robomimic(const Demonstration& document) {
  const bool known = document.outcome() == document.recording->outcome;
  std::vector<std::string> kept{kept_samples(recorded_channels(table_samples(document))),
                                known ? "its name, block, goal and outcome" : "its name, block and goal",
                                "who recorded it and how (provenance)"};
  if (!document.notes.empty()) kept.emplace_back("the notes between the gates");
  if (!is_as_recorded(document, table_samples(document))) return kept;
  if (!document.recording->initial_world.empty()) kept.emplace_back("the simulated world before the first sample");
  if (!document.recording->hashes.empty()) kept.emplace_back("the state hashes that a replay is checked against");
  return kept;
}

std::vector<std::string> lost_by_robomimic(const Demonstration& document) {
  std::vector<std::string> lost;
  if (document.outcome() != document.recording->outcome) {
    lost.push_back(fmt::format("its outcome ({} as recorded, but {}: written as unknown, with no reward)",
                               to_string(document.recording->outcome), document.outcome_doubt()));
  }
  for (const std::string& missing : not_recorded(recorded_channels(table_samples(document)))) {
    lost.push_back(missing + " (never recorded)");
  }
  if (document.gated().size() < document.samples.size()) lost.emplace_back("the samples outside of the gates");
  if (!document.stack->empty()) lost.emplace_back("the edits as such (what they made of it is there)");
  const bool replays = !document.recording->initial_world.empty();
  if (replays && !is_as_recorded(document, table_samples(document))) {
    lost.emplace_back("the simulated world (an edited demonstration cannot be replayed)");
  }
  return lost;
}

}  // namespace trocar::exchange
