/// One act on several demonstrations: what it would do to each, and the one step of the history that does it.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/progress.h"
#include "engine/workbench/edit.h"

namespace trocar::workbench {

struct Removal {
  bool operator==(const Removal&) const = default;
};
/// Marks, an edit of the motion or its labels, or into the trash.
using BatchAct = std::variant<MarkChange, demonstration::Edit, Removal>;

/// As people type it: "flag bad", "tag slow", "untag slow", "rate 4", "verdict failure", "remove", or an edit with its
/// parameters as `trocar demo edit` takes it, "trim-idle --inside". Errors: kInvalidArgument.
Result<BatchAct> act_from_words(const std::vector<std::string>& words);
/// The words again, each as one would type it.
std::vector<std::string> to_words(const BatchAct& act);

struct BatchRequest {
  std::shared_ptr<const Project> project;  ///< Null: nothing is wanted.
  std::vector<DemonstrationId> demonstrations;
  std::vector<std::string> words;
  bool operator==(const BatchRequest&) const = default;
};

/// What would become of one of them.
struct BatchLine {
  DemonstrationId id;
  std::string name;
  std::string change;   ///< "12.40 s → 11.02 s", "+bad".
  std::string problem;  ///< Why it is left out: it cannot be made, or changes nothing; empty: it is in the batch.
};
struct BatchPlan {
  BatchRequest of;
  std::vector<BatchLine> lines;  ///< In the order that was asked for.
  Batch edit;                    ///< Of those that it changes.
  std::string error;             ///< What is wrong with the words or the choice; then there are no lines.
};

/// The fixes of a demonstration's problems, each an entry of its stack, as one step of the history.
Batch mending(const demonstration::Demonstration& shown, const std::vector<demonstration::Edit>& fixes);

/// Applies the act to each and looks at what comes of it; nothing is changed. Of an edit whose effect is to move gates
/// the batch holds the gates, so that it is quick to make and to undo. Null for a request without a project; what
/// `progress` cut off has an error. Threads: any.
std::shared_ptr<const BatchPlan> plan_batch(const BatchRequest& request, Progress& progress);

}  // namespace trocar::workbench
