#include "engine/workbench/project.h"

#include <algorithm>

#include "engine/core/hash.h"

namespace trocar::workbench {

namespace {

std::uint64_t hash_of(const ModelEntry& entry) {
  return entry.model ? entry.model->hash() : entry.model_hash;
}

}  // namespace

bool Project::stale(const ModelEntry& model) const {
  for (std::size_t i = 0; i < model.demonstrations.size(); ++i) {
    const auto found = demonstrations.find(model.demonstrations[i]);
    if (found == demonstrations.end() || i >= model.demonstration_hashes.size()) return true;
    if (found->second->hash() != model.demonstration_hashes[i]) return true;
  }
  return false;
}

const Marks& Project::marks_of(DemonstrationId id) const {
  static const Marks kNothing;
  const auto found = marks.find(id);
  return found == marks.end() ? kNothing : *found->second;
}

std::uint64_t Project::hash() const {
  Hasher hasher;
  hasher.value(demonstrations.size());
  for (const auto& [id, document] : demonstrations) hasher.value(id.value).text(document->name).value(document->hash());
  hasher.value(models.size());
  for (const auto& [id, entry] : models) {
    hasher.value(id.value).text(entry->name).value(entry->segment).value(hash_of(*entry));
  }
  for (const auto& [id, trial] : trials) {
    hasher.text("trial").value(id.value).text(trial->name).value(trial->shown->hash()).value(trial->excluded);
  }
  // Only what there is, so that a project in which nobody said anything has the hash that it always had.
  for (const auto& [id, document] : trash) hasher.text("trash").value(id.value).value(document->hash());
  for (const auto& [id, said] : marks) {
    hasher.text("marks").value(id.value).value(said->flag).value(said->verdict).value(said->rating).text(said->note);
    for (const std::string& tag : said->tags) hasher.text(tag);
  }
  for (const auto& [name, query] : filters) hasher.text("filter").text(name).text(query);
  return hasher.digest();
}

}  // namespace trocar::workbench
