/// What the sources of a film are in a project.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/film/composition.h"
#include "engine/workbench/jobs/film_rollout.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FilmSource {
  film::Source said;
  std::shared_ptr<const demonstration::Demonstration> shown;  ///< Of a recording, rollout or curve …
  std::shared_ptr<const TrialEntry> trial;                    ///< … if it is that of a trial.
  std::shared_ptr<const ModelEntry> model;                    ///< Of a field or rollout.
  std::shared_ptr<const ModelEntry> field_model;              ///< Whose field is in the scene; null: none is.
  double in_s = 0.0;                                          ///< Of `shown`, within its gates.
  double out_s = 0.0;
  std::string title;
  std::string provenance;  ///< "scripted expert, seed 1, trocar 0.1.0, 0123456789abcdef": who made it, and its hash.
  std::string ending;      ///< How a rollout ends …
  double ends_s = 0.0;     ///< … and when, of its own time.
  bool scripted = false;   ///< Some of it was made by a script.
  int before = 0;          ///< Trials of the same session and mode that came before …
  int successes = 0;       ///< … and how many of them succeeded.
};

/// Its title, who made it, and the hashes of it and of the models that moved the arm: a line of the file's comment.
std::string credit_of(const FilmSource& source);

/// By id, or by a name that only one has. Rollouts are run, unless they lie on the shelf. Errors: kNotFound;
/// kInvalidArgument for a name that several have, for gates that leave nothing and for a model that is described only;
/// those of `RolloutShelf`.
Result<std::vector<FilmSource>> film_sources(const Project& project, const film::Composition& film,
                                             RolloutShelf& shelf);

}  // namespace trocar::workbench
