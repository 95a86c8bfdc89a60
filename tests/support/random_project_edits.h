/// Edits of a project at random, most of them ones that can be applied: for property tests of the history.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/workbench/edit.h"
#include "tests/support/random_edits.h"

namespace trocar::testing {

/// What random edits of a project may put into it: both were stored before.
struct StoredThings {
  std::vector<demonstration::RecordingId> recordings;  ///< At least one.
  std::int64_t model = 0;                              ///< 0: none.
};

/// A key of a map that is not empty.
template <typename Map>
typename Map::key_type one_of(Random& random, const Map& map) {
  auto chosen = map.begin();
  std::advance(chosen, random.below(static_cast<std::uint32_t>(map.size())));
  return chosen->first;
}

inline std::string random_word(Random& random) {
  return "word" + std::to_string(random.below(20));
}

/// Every kind of edit of one demonstration comes up. A splice takes its clip from a demonstration of the project as it
/// is or, half of the time, as it was at `earlier`, a point of the history (0: as it is).
inline demonstration::Edit random_edit_of(Random& random, const workbench::Project& project,
                                          workbench::DemonstrationId id, std::int64_t earlier) {
  demonstration::Edit edit = random_edit(random, project.demonstrations.at(id)->full_duration_s());
  if (auto* splice = std::get_if<demonstration::Splice>(&edit)) {
    splice->source = one_of(random, project.demonstrations).value;
    splice->as_of = random.below(2) == 0 ? 0 : earlier;
    splice->clip_to_s = std::min(splice->clip_to_s, splice->clip_from_s + 0.25);
  }
  if (auto* overdub = std::get_if<demonstration::Overdub>(&edit)) {
    overdub->source = one_of(random, project.demonstrations).value;
    overdub->as_of = random.below(2) == 0 ? 0 : earlier;
    overdub->clip_to_s = std::min(overdub->clip_to_s, overdub->clip_from_s + 0.25);
  }
  const auto& notes = project.demonstrations.at(id)->notes;
  if (auto* removal = std::get_if<demonstration::RemoveNote>(&edit); removal != nullptr && !notes.empty()) {
    removal->note = notes[random.below(static_cast<std::uint32_t>(notes.size()))].id;
  }
  return edit;
}

/// Every kind of edit of a project comes up, and with it every kind of edit of a demonstration. What has grown long or
/// been edited much is removed, so that a walk of any length stays quick.
inline workbench::Edit random_project_edit(Random& random, const workbench::Project& project,
                                           const StoredThings& stored, std::int64_t earlier) {
  using namespace workbench;
  const auto recording = [&] {
    return stored.recordings[random.below(static_cast<std::uint32_t>(stored.recordings.size()))];
  };
  if (project.demonstrations.empty()) return AddDemonstration{recording(), random_word(random)};
  for (const auto& [id, document] : project.demonstrations) {
    if (document->full_duration_s() > 3.0 || document->stack->size() > 12) return RemoveDemonstration{id};
  }
  if (project.demonstrations.size() > 8) return RemoveDemonstration{one_of(random, project.demonstrations)};
  const DemonstrationId id = one_of(random, project.demonstrations);
  const demonstration::Demonstration& document = *project.demonstrations.at(id);
  const auto anything = [&] { return random_edit_of(random, project, id, earlier); };
  const std::uint32_t kind = random.below(40);
  if (kind >= 22) return EditDemonstration{id, anything()};
  if (kind >= 12 && !document.stack->empty()) {
    const auto count = static_cast<std::uint32_t>(document.stack->size());
    const std::int64_t entry = (*document.stack)[random.below(count)].id;
    switch (kind % 5) {
      case 0:
        return MoveStackEntry{id, entry, static_cast<int>(random.below(count))};
      case 1:
        return EnableStackEntry{id, entry, random.below(2) == 0};
      case 2:
        return ReplaceStackEntry{id, entry, anything()};
      case 3:
        return NameStackEntry{id, entry, random_word(random)};
      default:
        return RemoveStackEntry{id, entry};
    }
  }
  switch (kind) {
    case 0:
      return RemoveDemonstration{id};
    case 1:
    case 2:
      if (!project.trash.empty()) return RestoreDemonstration{one_of(random, project.trash)};
      return AddDemonstration{recording(), random_word(random)};
    case 3:
      return CopyDemonstration{id, "", {anything()}};
    case 4:
      return SplitDemonstration{id, random.uniform(0.0, document.full_duration_s()), ""};
    case 5: {
      MarkChange change;
      change.flag = kFlags[random.below(4)];
      change.rating = static_cast<int>(random.below(6));
      change.add = {random_word(random)};
      change.remove = {random_word(random)};
      return MarkDemonstration{id, std::move(change)};
    }
    case 6:
      return SaveFilter{random_word(random), "length>" + std::to_string(random.below(10))};
    case 7:
      if (project.filters.empty()) return SaveFilter{random_word(random), "flag:bad"};
      return RemoveFilter{project.filters.begin()->first};
    case 8:
      if (stored.model != 0 && project.models.size() < 3) return AddModel{stored.model};
      return RemoveModel{{project.models.empty() ? 1 : project.models.begin()->first.value}};
    case 9:
      if (project.models.empty()) return RemoveModel{{1}};
      return RemoveModel{project.models.begin()->first};
    case 10:
      return ImportDemonstrations{"table.csv", {{recording(), random_word(random), {}}, {recording(), "two", {}}}};
    default: {
      Batch batch{"Two at once", {}};
      for (int i = 0; i < 2; ++i) {
        batch.edits.push_back(EditDemonstration{one_of(random, project.demonstrations), demonstration::Mirror{}});
      }
      batch.edits.push_back(EditDemonstration{id, anything()});
      return batch;
    }
  }
}

}  // namespace trocar::testing
