/// Every edit of the project as one variant, and the pure function that applies it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/demonstration/edits.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// Puts a finished recording into the project as a demonstration; its id is the journal row's id.
struct AddDemonstration {
  static constexpr std::string_view kName = "add demonstration";
  demonstration::RecordingId recording;
  std::string name;
  std::vector<demonstration::Edit> edits{};  ///< Made on it at once, such as notes on pauses.
};

/// Puts a finished recording into the project likewise, and has `overdub` take from it: a part of another demonstration
/// is replaced by it, as one step. What a person had said of how that one ends is no longer said.
struct PunchIn {
  static constexpr std::string_view kName = "punch in";
  AddDemonstration take;
  DemonstrationId demonstration;
  demonstration::Overdub overdub;  ///< Its source and point of the history are the row's own, whatever it says.
};

/// Puts the recordings of one foreign file into the project, as one step. Its journal row takes as many ids as there
/// are demonstrations: the last has that of the row, those before it the numbers before.
struct ImportDemonstrations {
  static constexpr std::string_view kName = "import demonstrations";
  struct Part {
    demonstration::RecordingId recording;
    std::string name;
    std::vector<demonstration::Edit> edits;  ///< Made on it at once, such as notes from the file.
  };
  std::string file;  ///< What people call it.
  std::vector<Part> parts;
};

/// Into the project's trash, from which it can be restored.
struct RemoveDemonstration {
  static constexpr std::string_view kName = "remove demonstration";
  DemonstrationId demonstration;
};

struct RestoreDemonstration {
  static constexpr std::string_view kName = "restore demonstration";
  DemonstrationId demonstration;
};

/// Flags, tags and the like.
struct MarkDemonstration {
  static constexpr std::string_view kName = "mark demonstration";
  DemonstrationId demonstration;
  MarkChange change;
};

struct EditDemonstration {
  static constexpr std::string_view kName = "edit demonstration";
  DemonstrationId demonstration;
  demonstration::Edit edit;
};

/// Another demonstration with the same recording and the same edits, and then `edits`; its id is the journal row's id.
/// One of one edit, "perturb", is how one demonstration becomes several.
struct CopyDemonstration {
  static constexpr std::string_view kName = "copy demonstration";
  DemonstrationId demonstration;
  std::string name;  ///< "": "Expert 1 copy", numbered if need be.
  std::vector<demonstration::Edit> edits;
};

/// Several at once, as one step. The row takes as many ids as there are copies: the last has that of the row.
struct CopyDemonstrations {
  static constexpr std::string_view kName = "copy demonstrations";
  std::vector<CopyDemonstration> copies;
};

/// Makes two of one: the gates of the first end where those of the second, which is new, begin.
struct SplitDemonstration {
  static constexpr std::string_view kName = "split demonstration";
  DemonstrationId demonstration;
  double at_s = 0.0;
  std::string name;  ///< Of the second; "": "Expert 1 rest", numbered if need be.
};

/// Changes the stack of a demonstration: what was done to it, afterwards.
struct MoveStackEntry {
  static constexpr std::string_view kName = "move edit";
  DemonstrationId demonstration;
  std::int64_t entry = 0;
  int place = 0;  ///< From 0.
};
struct EnableStackEntry {
  static constexpr std::string_view kName = "enable edit";
  DemonstrationId demonstration;
  std::int64_t entry = 0;
  bool enabled = true;
};
struct ReplaceStackEntry {
  static constexpr std::string_view kName = "change edit";
  DemonstrationId demonstration;
  std::int64_t entry = 0;
  demonstration::Edit edit;
};
struct NameStackEntry {
  static constexpr std::string_view kName = "name edit";
  DemonstrationId demonstration;
  std::int64_t entry = 0;
  std::string name;
};
struct RemoveStackEntry {
  static constexpr std::string_view kName = "remove edit";
  DemonstrationId demonstration;
  std::int64_t entry = 0;
};

/// Puts a stored model into the project; its id is the journal row's id.
struct AddModel {
  static constexpr std::string_view kName = "add model";
  std::int64_t object = 0;  ///< In the store.
};

struct RemoveModel {
  static constexpr std::string_view kName = "remove model";
  ModelId model;
};

/// Puts the recording of a trial into the project; its id is the journal row's id.
struct AddTrial {
  static constexpr std::string_view kName = "add trial";
  demonstration::RecordingId recording;
  std::string name;
  trial::TrialRecord record;
};
/// Leaves a trial out of the results, for a reason, or takes it in again; it stays where it is.
struct JudgeTrial {
  static constexpr std::string_view kName = "judge trial";
  TrialId trial;
  bool excluded = false;
  std::string reason;
};

/// Keeps a query of the library under a name, in place of what had that name.
struct SaveFilter {
  static constexpr std::string_view kName = "save filter";
  std::string name;
  std::string query;
};
struct RemoveFilter {
  static constexpr std::string_view kName = "remove filter";
  std::string name;
};

struct Batch;

using Edit =
    std::variant<AddDemonstration, ImportDemonstrations, RemoveDemonstration, EditDemonstration, CopyDemonstration,
                 SplitDemonstration, MoveStackEntry, EnableStackEntry, ReplaceStackEntry, NameStackEntry,
                 RemoveStackEntry, AddModel, RemoveModel, RestoreDemonstration, MarkDemonstration, SaveFilter,
                 RemoveFilter, PunchIn, CopyDemonstrations, AddTrial, JudgeTrial, Batch>;

/// Several edits as one step, one after the other: all are made, or none. Those of one demonstration are entries of
/// their own in its stack. Those that add something have no place in it, nor another batch.
struct Batch {
  static constexpr std::string_view kName = "batch";
  std::string title;  ///< For the history: "Trim idle of 12 demonstrations".
  std::vector<Edit> edits;
};

/// Where `apply` finds what edits name by id and what never changes: blobs, and the past.
class BlobSource {
 public:
  virtual ~BlobSource() = default;
  struct StoredRecording {
    std::shared_ptr<const demonstration::RecordingInfo> info;
    demonstration::SampleTrack samples;  ///< At least 2, and checked.
  };
  virtual Result<StoredRecording> recording(demonstration::RecordingId id) const = 0;
  /// An entry without id; the edit gives it one.
  virtual Result<ModelEntry> model(std::int64_t object) const = 0;
  /// What an edit makes of this very demonstration, if somebody has worked it out already; else null. Its stack and the
  /// ids in it are of no account.
  virtual std::shared_ptr<const demonstration::Demonstration> prepared(
      const std::shared_ptr<const demonstration::Demonstration>& before, const demonstration::Edit& edit) const {
    (void)before;
    (void)edit;
    return nullptr;
  }
  /// The project as it was at a node of its history. Errors: kNotFound.
  virtual Result<std::shared_ptr<const Project>> project_at(std::int64_t node) const = 0;
};

/// Returns the edited project; `project` is untouched. `new_id` is the id for what the edit adds.
/// Errors: kNotFound for an unknown id; those of `demonstration::apply` and `demonstration::with_stack`.
Result<std::shared_ptr<const Project>> apply(const Project& project, const Edit& edit, std::int64_t new_id,
                                             const BlobSource& blobs);

/// The edit with what it takes from other demonstrations found, so that it can be applied and kept; `before` is the
/// project that it is for and `new_id` the id that it will have. Errors: kNotFound for an unknown demonstration or
/// point of the history; those of `clip_of`.
Result<demonstration::Edit> resolved(demonstration::Edit edit, const Project& before, const BlobSource& blobs,
                                     std::int64_t new_id);

/// How many ids the edit takes: its own journal row's, and those just before it.
std::int64_t ids_taken(const Edit& edit);

std::string_view name_of(const Edit& edit);
/// For the history: "Trim Expert 1 to 0.40–12.30 s".
std::string describe(const Edit& edit, const Project& before);
std::string to_json(const Edit& edit);
/// With the numbers of what it does to demonstrations as their words say them: `demonstration::as_typed`.
Edit as_typed(Edit edit);
Result<Edit> edit_from_json(std::string_view name, std::string_view json);

}  // namespace trocar::workbench
