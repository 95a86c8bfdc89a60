/// The document: what a project holds at one point of its history. Immutable, shared piece by piece.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/id.h"
#include "engine/demonstration/demonstration.h"
#include "engine/learning/model.h"
#include "engine/trial/trial_record.h"
#include "engine/workbench/marks.h"

namespace trocar::workbench {

using demonstration::DemonstrationId;
using ModelId = Id<struct ModelTag>;

/// A trained model in the project, and what it came from.
struct ModelEntry {
  ModelId id;
  std::string name;
  demonstration::Segment segment = demonstration::Segment::kA;
  std::shared_ptr<const learning::Model> model;  ///< Null in a project that was opened with its models described only.
  std::uint64_t model_hash = 0;                  ///< Of that model, where it is null.
  std::vector<DemonstrationId> demonstrations;
  std::vector<std::uint64_t> demonstration_hashes;  ///< As they were when it was trained.
  std::string created;                              ///< ISO 8601.
};

using TrialId = Id<struct TrialTag>;

/// A trial that was run: its recording, seen as a demonstration that nobody edits, and its record.
struct TrialEntry {
  TrialId id;
  std::string name;  ///< "SC 3"
  std::shared_ptr<const demonstration::Demonstration> shown;
  trial::TrialRecord record;
  bool excluded = false;
  std::string reason;  ///< Why it was excluded.
};

struct Project {
  std::map<DemonstrationId, std::shared_ptr<const demonstration::Demonstration>> demonstrations;
  std::map<ModelId, std::shared_ptr<const ModelEntry>> models;
  std::map<TrialId, std::shared_ptr<const TrialEntry>> trials;
  /// What was deleted and can be restored.
  std::map<DemonstrationId, std::shared_ptr<const demonstration::Demonstration>> trash;
  /// Of those that something was said of, in the trash too; never null.
  std::map<DemonstrationId, std::shared_ptr<const Marks>> marks;
  std::map<std::string, std::string> filters;  ///< Saved queries of the library by name.

  /// Without any marks for one that nothing was said of.
  const Marks& marks_of(DemonstrationId id) const;
  /// True if a demonstration of the model has been edited or removed since training.
  bool stale(const ModelEntry& model) const;
  std::uint64_t hash() const;
};

}  // namespace trocar::workbench
