#include "engine/workbench/policy_bridge.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/demonstration/edit_stack.h"
#include "engine/learning/rollout.h"

namespace trocar::workbench {
namespace {

using demonstration::Arms;
using demonstration::Bridge;
using demonstration::BridgeShape;
using demonstration::Demonstration;
using Points = std::vector<Eigen::Vector3d>;

bool needs_way(const demonstration::Edit& edit) {
  const auto* bridge = std::get_if<Bridge>(&edit);
  return bridge != nullptr && bridge->shape == BridgeShape::kPolicy && bridge->via_m.empty();
}

Result<std::shared_ptr<const ModelEntry>> model_for(const Bridge& bridge, const Demonstration& document,
                                                    const Project& project) {
  std::shared_ptr<const ModelEntry> found;
  if (bridge.model != 0) {
    const auto named = project.models.find(ModelId{bridge.model});
    if (named == project.models.end()) {
      return fail(ErrorCode::kNotFound, fmt::format("the project has no model {}", bridge.model));
    }
    found = named->second;
  } else {
    const auto span = std::find_if(document.segments.begin(), document.segments.end(), [&](const auto& one) {
      return one.begin_s <= bridge.from_s && bridge.from_s < one.end_s;
    });
    if (span == document.segments.end()) {
      return fail(ErrorCode::kNotFound,
                  fmt::format("no segment is labelled at {:.2f} s; say whose policy it shall be", bridge.from_s));
    }
    for (const auto& [id, entry] : project.models) found = entry->segment == span->label ? entry : found;
    if (!found) {
      return fail(ErrorCode::kNotFound,
                  fmt::format("the project has no model of segment {}", demonstration::letter(span->label)));
    }
  }
  if (found->model == nullptr) return fail(ErrorCode::kNotFound, fmt::format("{} was not read", found->name));
  return found;
}

/// Chaikin's corner cutting; first and last stay.
Points rounded(const Points& points) {
  Points cut{points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (i > 0) cut.push_back(0.75 * points[i] + 0.25 * points[i + 1]);
    if (i + 2 < points.size()) cut.push_back(0.25 * points[i] + 0.75 * points[i + 1]);
  }
  cut.push_back(points.back());
  return cut;
}

/// The document as it is when the edit at `entry` is made.
Result<Demonstration> before_entry(const Demonstration& document, std::int64_t entry) {
  demonstration::EditStack earlier;
  for (const demonstration::StackEntry& each : *document.stack) {
    if (each.id == entry) return demonstration::with_stack(document, std::move(earlier));
    earlier.push_back(each);
  }
  return fail(ErrorCode::kNotFound, fmt::format("{} has no edit {}", document.name, entry));
}

}  // namespace

Result<Bridge> with_policy_way(Bridge bridge, const Demonstration& document, const Project& project) {
  if (!needs_way(bridge)) return bridge;
  TROCAR_ASSIGN_OR_RETURN(const auto entry, model_for(bridge, document, project));
  const learning::Model& model = *entry->model;
  const std::size_t arm = bridge.arms == Arms::kRight ? 1 : 0;
  const Eigen::Vector3d begin = document.sample_at(bridge.from_s).arms[arm].measured.pose().p;
  const Eigen::Vector3d end = document.sample_at(bridge.to_s).arms[arm].measured.pose().p;
  TROCAR_ASSIGN_OR_RETURN(const spatial::CellIndex start, model.grid.cell_at(begin));
  const learning::Rollout rollout = learning::rollout(model, learning::greedy_policy(model), start);
  const auto distance_m = [&](spatial::CellIndex cell) { return (model.grid.centre(cell) - end).norm(); };
  const auto nearest = std::min_element(rollout.cells.begin(), rollout.cells.end(),
                                        [&](auto a, auto b) { return distance_m(a) < distance_m(b); });
  if (nearest == rollout.cells.begin()) {
    return fail(ErrorCode::kCheckFailed,
                fmt::format("the policy of {} does not lead from {:.2f} s towards where the bridge ends", entry->name,
                            bridge.from_s));
  }
  Points points{begin};
  for (auto cell = rollout.cells.begin() + 1; cell <= nearest; ++cell) points.push_back(model.grid.centre(*cell));
  points.push_back(end);
  points = rounded(rounded(points));
  bridge.via_m.assign(points.begin() + 1, points.end() - 1);
  bridge.model = entry->id.value;
  return bridge;
}

Result<demonstration::Edit> with_ways(demonstration::Edit edit, DemonstrationId demonstration, std::int64_t entry,
                                      const Project& project) {
  if (!needs_way(edit)) return edit;
  const auto found = project.demonstrations.find(demonstration);
  if (found == project.demonstrations.end()) {
    return fail(ErrorCode::kNotFound, fmt::format("the project has no demonstration {}", demonstration.value));
  }
  if (entry == 0) return with_policy_way(std::get<Bridge>(edit), *found->second, project);
  TROCAR_ASSIGN_OR_RETURN(const Demonstration before, before_entry(*found->second, entry));
  return with_policy_way(std::get<Bridge>(edit), before, project);
}

Result<Edit> with_ways(Edit edit, const Project& project) {
  if (auto* change = std::get_if<EditDemonstration>(&edit)) {
    TROCAR_ASSIGN_OR_RETURN(change->edit, with_ways(change->edit, change->demonstration, 0, project));
  } else if (auto* replace = std::get_if<ReplaceStackEntry>(&edit)) {
    TROCAR_ASSIGN_OR_RETURN(replace->edit, with_ways(replace->edit, replace->demonstration, replace->entry, project));
  } else if (auto* copy = std::get_if<CopyDemonstration>(&edit)) {
    for (demonstration::Edit& each : copy->edits) {
      TROCAR_ASSIGN_OR_RETURN(each, with_ways(each, copy->demonstration, 0, project));
    }
  }
  return edit;
}

}  // namespace trocar::workbench
