#include "engine/workbench/jobs/film_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/workbench/trial_results.h"

namespace trocar::workbench {
namespace {

/// The one with that id, else the one with that name; null if there is none.
template <typename Map>
Result<typename Map::mapped_type> find_in(const Map& map, const std::string& text) {
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error == std::errc() && end == text.data() + text.size()) {
    if (const auto found = map.find(typename Map::key_type{id}); found != map.end()) return found->second;
  }
  typename Map::mapped_type only;
  for (const auto& [key, entry] : map) {
    if (entry->name != text) continue;
    if (only) return fail(ErrorCode::kInvalidArgument, fmt::format("several are named \"{}\": say the id", text));
    only = entry;
  }
  return only;
}

std::string hash_words(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

/// Who made it, never to be mistaken for a person.
std::string provenance_of(const demonstration::Demonstration& shown) {
  const demonstration::Provenance& provenance = shown.recording->provenance;
  std::string line = provenance.operator_kind;
  if (!provenance.skill.empty()) line += " " + provenance.skill;
  if (provenance.operator_kind == "scripted") line += fmt::format(", seed {}", provenance.seed);
  if (!provenance.software.empty()) line += ", " + provenance.software;
  return line + ", " + hash_words(shown.hash());
}

bool is_scripted(const demonstration::Demonstration& shown) {
  return shown.recording->provenance.operator_kind == "scripted";
}

/// Those of the trials before it that belong together with it.
void count_before(const Project& project, FilmSource& source) {
  const trial::TrialRecord& own = source.trial->record;
  for (const auto& [id, other] : project.trials) {
    if (id == source.trial->id) return;
    if (other->excluded || other->record.mode != own.mode || other->record.session != own.session) continue;
    // As in the results: neither rehearsals nor what was stopped.
    if (other->record.in_results != own.in_results || was_stopped(other->record)) continue;
    ++source.before;
    if (other->record.outcome == demonstration::Outcome::kSuccess) ++source.successes;
  }
}

/// What of it is filmed.
Status keep_gates(FilmSource& source) {
  const demonstration::Demonstration& shown = *source.shown;
  if (shown.gated().empty()) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" has no samples to film", shown.name));
  }
  source.in_s = std::max(shown.begin_s, source.said.in_s.value_or(shown.begin_s));
  source.out_s = std::min(shown.end_s, source.said.out_s.value_or(shown.end_s));
  if (source.in_s < source.out_s) return {};
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("\"{}\" lasts from {:.3f} to {:.3f} s: its gates in the film leave nothing", shown.name,
                          shown.begin_s, shown.end_s));
}

Status find_recording(const Project& project, FilmSource& source) {
  TROCAR_ASSIGN_OR_RETURN(source.trial, find_in(project.trials, source.said.of));
  if (source.trial) {
    source.shown = source.trial->shown;
    const bool shared = source.trial->record.mode == trial::Mode::kShared;
    source.title = fmt::format("{} · {}", source.trial->name, shared ? "shared control" : "manual");
    count_before(project, source);
  } else {
    TROCAR_ASSIGN_OR_RETURN(source.shown, find_in(project.demonstrations, source.said.of));
    if (!source.shown) {
      return fail(ErrorCode::kNotFound, fmt::format("no demonstration or trial is \"{}\"", source.said.of));
    }
    source.title = source.shown->name;
  }
  TROCAR_RETURN_IF_ERROR(keep_gates(source));
  source.scripted = is_scripted(*source.shown) || (source.trial && source.trial->record.operator_kind == "scripted");
  source.provenance = provenance_of(*source.shown);
  if (source.trial && !source.scripted && source.trial->record.assistant == "scripted") {
    source.provenance += ", right arm by a script";
  }
  return {};
}
/// One that was read whole.
Result<std::shared_ptr<const ModelEntry>> whole_model(const Project& project, const std::string& text) {
  TROCAR_ASSIGN_OR_RETURN(std::shared_ptr<const ModelEntry> model, find_in(project.models, text));
  if (!model) return fail(ErrorCode::kNotFound, fmt::format("no model is \"{}\"", text));
  if (!model->model) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("the model \"{}\" was not read", model->name));
  }
  return model;
}

bool by_scripts(const Project& project, const ModelEntry& model) {
  return std::any_of(model.demonstrations.begin(), model.demonstrations.end(), [&](DemonstrationId id) {
    const auto found = project.demonstrations.find(id);
    return found != project.demonstrations.end() && is_scripted(*found->second);
  });
}

Status find_field(const Project& project, FilmSource& source) {
  TROCAR_ASSIGN_OR_RETURN(source.model, whole_model(project, source.said.of));
  source.title = source.model->name;
  source.scripted = by_scripts(project, *source.model);
  source.provenance = fmt::format("{}, {}", source.scripted ? "learned from scripted demonstrations" : "learned",
                                  hash_words(source.model->model->hash()));
  return {};
}

Status find_rollout(const Project& project, FilmSource& source, RolloutShelf& shelf) {
  TROCAR_ASSIGN_OR_RETURN(source.model, whole_model(project, source.said.of));
  TROCAR_ASSIGN_OR_RETURN(const FilmedRollout rollout, shelf.rollout(project, *source.model, source.said.start));
  source.shown = rollout.shown;
  source.title = fmt::format("{} from {}", source.model->name, fmt::join(rollout.start, ","));
  source.ending = trial::to_string(rollout.result.end);
  source.ends_s = rollout.result.duration_s;
  source.scripted = by_scripts(project, *source.model);
  source.provenance =
      fmt::format("rollout in the simulator, seed {}, {}{}, {}", rollout.shown->recording->provenance.seed,
                  source.scripted ? "learned from scripted demonstrations, " : "",
                  rollout.shown->recording->provenance.software, hash_words(source.model->model->hash()));
  return keep_gates(source);
}

Status find_source(const Project& project, FilmSource& source, RolloutShelf& shelf) {
  switch (source.said.kind) {
    case film::SourceKind::kField:
      return find_field(project, source);
    case film::SourceKind::kRollout:
      return find_rollout(project, source, shelf);
    case film::SourceKind::kRecording:
    case film::SourceKind::kCurve:
      break;
  }
  return find_recording(project, source);
}

/// Whose field is in the scene: what a script taught it makes the whole of it scripted.
Status find_scene_field(const Project& project, FilmSource& source) {
  if (!source.said.field) return {};
  TROCAR_ASSIGN_OR_RETURN(source.field_model, whole_model(project, source.said.field->of));
  const bool by_script = by_scripts(project, *source.field_model);
  source.scripted = source.scripted || by_script;
  source.provenance += fmt::format("; field {}{}", by_script ? "learned from scripted demonstrations, " : "",
                                   hash_words(source.field_model->model->hash()));
  return {};
}

}  // namespace

std::string credit_of(const FilmSource& source) {
  std::string line = fmt::format("{}: {}", source.title, source.provenance);
  if (!source.trial) return line;
  for (const trial::TrialRecord::ModelUsed& model : source.trial->record.models) {
    line += fmt::format("; model {} {}", model.name, hash_words(model.hash));
  }
  return line;
}

Result<std::vector<FilmSource>> film_sources(const Project& project, const film::Composition& film,
                                             RolloutShelf& shelf) {
  std::vector<FilmSource> sources;
  for (const film::Source& said : film.sources) {
    FilmSource source;
    source.said = said;
    TROCAR_RETURN_IF_ERROR(find_source(project, source, shelf));
    TROCAR_RETURN_IF_ERROR(find_scene_field(project, source));
    if (!said.title.empty()) source.title = said.title;
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace trocar::workbench
