#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/workbench/edit.h"

namespace trocar::workbench {
namespace {

using nlohmann::json;

tl::unexpected<Error> corrupt(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

struct Printer {
  template <typename StackEdit>
  static json entry_of(const StackEdit& edit) {
    return {{"demonstration", edit.demonstration.value}, {"entry", edit.entry}};
  }
  static json with_edit(json object, const demonstration::Edit& edit) {
    object["edit"] = std::string(demonstration::name_of(edit));
    object["parameters"] = json::parse(demonstration::to_json(edit), nullptr, false);
    return object;
  }
  static json list_of(const std::vector<demonstration::Edit>& edits) {
    json list = json::array();
    for (const demonstration::Edit& each : edits) list.push_back(with_edit(json::object(), each));
    return list;
  }
  json operator()(const AddDemonstration& edit) const {
    json object{{"recording", edit.recording.value}, {"name", edit.name}};
    if (!edit.edits.empty()) object["edits"] = list_of(edit.edits);
    return object;
  }
  json operator()(const PunchIn& edit) const {
    return with_edit({{"take", (*this)(edit.take)}, {"demonstration", edit.demonstration.value}}, edit.overdub);
  }
  json operator()(const CopyDemonstrations& edit) const {
    json copies = json::array();
    for (const CopyDemonstration& copy : edit.copies) copies.push_back((*this)(copy));
    return {{"copies", std::move(copies)}};
  }
  json operator()(const ImportDemonstrations& edit) const {
    json parts = json::array();
    for (const ImportDemonstrations::Part& part : edit.parts) {
      parts.push_back({{"recording", part.recording.value}, {"name", part.name}, {"edits", list_of(part.edits)}});
    }
    return {{"file", edit.file}, {"parts", std::move(parts)}};
  }
  json operator()(const RemoveDemonstration& edit) const { return {{"demonstration", edit.demonstration.value}}; }
  json operator()(const EditDemonstration& edit) const {
    return with_edit({{"demonstration", edit.demonstration.value}}, edit.edit);
  }
  json operator()(const CopyDemonstration& edit) const {
    return {{"demonstration", edit.demonstration.value}, {"name", edit.name}, {"edits", list_of(edit.edits)}};
  }
  json operator()(const SplitDemonstration& edit) const {
    return {{"demonstration", edit.demonstration.value}, {"at_s", edit.at_s}, {"name", edit.name}};
  }
  json operator()(const MoveStackEntry& edit) const {
    json object = entry_of(edit);
    object["place"] = edit.place;
    return object;
  }
  json operator()(const EnableStackEntry& edit) const {
    json object = entry_of(edit);
    object["enabled"] = edit.enabled;
    return object;
  }
  json operator()(const ReplaceStackEntry& edit) const { return with_edit(entry_of(edit), edit.edit); }
  json operator()(const NameStackEntry& edit) const {
    json object = entry_of(edit);
    object["name"] = edit.name;
    return object;
  }
  json operator()(const RemoveStackEntry& edit) const { return entry_of(edit); }
  json operator()(const RestoreDemonstration& edit) const { return {{"demonstration", edit.demonstration.value}}; }
  json operator()(const MarkDemonstration& edit) const {
    json object{{"demonstration", edit.demonstration.value}};
    const MarkChange& change = edit.change;
    if (change.flag) object["flag"] = std::string(to_string(*change.flag));
    if (change.verdict) object["verdict"] = std::string(to_string(*change.verdict));
    if (change.rating) object["rating"] = *change.rating;
    if (!change.add.empty()) object["add"] = change.add;
    if (!change.remove.empty()) object["remove"] = change.remove;
    if (change.note) object["note"] = *change.note;
    return object;
  }
  json operator()(const SaveFilter& edit) const { return {{"name", edit.name}, {"query", edit.query}}; }
  json operator()(const RemoveFilter& edit) const { return {{"name", edit.name}}; }
  json operator()(const Batch& edit) const {
    json list = json::array();
    for (const Edit& each : edit.edits) {
      list.push_back({{"name", std::string(name_of(each))}, {"parameters", std::visit(*this, each)}});
    }
    return {{"title", edit.title}, {"edits", std::move(list)}};
  }
  json operator()(const AddModel& edit) const { return {{"object", edit.object}}; }
  json operator()(const AddTrial& edit) const {
    return {
        {"recording", edit.recording.value}, {"name", edit.name}, {"record", json::parse(trial::to_json(edit.record))}};
  }
  json operator()(const JudgeTrial& edit) const {
    return {{"trial", edit.trial.value}, {"excluded", edit.excluded}, {"reason", edit.reason}};
  }
  json operator()(const RemoveModel& edit) const { return {{"model", edit.model.value}}; }
};

Result<std::int64_t> id_at(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_integer()) {
    return corrupt(fmt::format("the parameter {} must be there and be a whole number", key));
  }
  return found->get<std::int64_t>();
}

Result<std::string> text_at(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) {
    return corrupt(fmt::format("the parameter {} must be there and be text", key));
  }
  return found->get<std::string>();
}

Result<demonstration::Edit> inner_edit(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::string name, text_at(object, "edit"));
  const auto parameters = object.find("parameters");
  if (parameters == object.end()) return corrupt("the edit has no parameters");
  const std::string text = parameters->dump(-1, ' ', false, json::error_handler_t::replace);
  return demonstration::edit_from_json(name, text);
}

Result<Edit> edit_demonstration(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "demonstration"));
  TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, inner_edit(object));
  return EditDemonstration{DemonstrationId{id}, std::move(edit)};
}

Result<std::vector<demonstration::Edit>> edits_at(const json& object) {
  const auto list = object.find("edits");
  if (list == object.end() || !list->is_array()) return corrupt("the parameter edits must be there and be a list");
  std::vector<demonstration::Edit> edits;
  for (const json& each : *list) {
    if (!each.is_object()) return corrupt("each of the edits must be a JSON object");
    TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, inner_edit(each));
    edits.push_back(std::move(edit));
  }
  return edits;
}

Result<AddDemonstration> add_demonstration(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t recording, id_at(object, "recording"));
  TROCAR_ASSIGN_OR_RETURN(std::string name, text_at(object, "name"));
  AddDemonstration added{demonstration::RecordingId{recording}, std::move(name)};
  if (object.contains("edits")) {
    TROCAR_ASSIGN_OR_RETURN(added.edits, edits_at(object));
  }
  return added;
}

Result<CopyDemonstration> copy_demonstration(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "demonstration"));
  TROCAR_ASSIGN_OR_RETURN(std::string name, text_at(object, "name"));
  TROCAR_ASSIGN_OR_RETURN(std::vector<demonstration::Edit> edits, edits_at(object));
  return CopyDemonstration{DemonstrationId{id}, std::move(name), std::move(edits)};
}

Result<Edit> copy_demonstrations(const json& object) {
  const auto list = object.find("copies");
  if (list == object.end() || !list->is_array()) return corrupt("the parameter copies must be there and be a list");
  CopyDemonstrations edit;
  for (const json& each : *list) {
    if (!each.is_object()) return corrupt("each of the copies must be a JSON object");
    TROCAR_ASSIGN_OR_RETURN(CopyDemonstration copy, copy_demonstration(each));
    edit.copies.push_back(std::move(copy));
  }
  return edit;
}

Result<Edit> punch_in(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "demonstration"));
  const auto take = object.find("take");
  if (take == object.end() || !take->is_object()) return corrupt("the parameter take must be there and be an object");
  TROCAR_ASSIGN_OR_RETURN(AddDemonstration added, add_demonstration(*take));
  TROCAR_ASSIGN_OR_RETURN(const demonstration::Edit edit, inner_edit(object));
  const auto* overdub = std::get_if<demonstration::Overdub>(&edit);
  if (overdub == nullptr) return corrupt("what a punch-in does must be an overdub");
  return PunchIn{std::move(added), DemonstrationId{id}, *overdub};
}

Result<Edit> import_demonstrations(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(std::string file, text_at(object, "file"));
  const auto parts = object.find("parts");
  if (parts == object.end() || !parts->is_array()) return corrupt("the parameter parts must be there and be a list");
  ImportDemonstrations import{std::move(file), {}};
  for (const json& part : *parts) {
    if (!part.is_object()) return corrupt("each of the parts must be a JSON object");
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t recording, id_at(part, "recording"));
    TROCAR_ASSIGN_OR_RETURN(std::string name, text_at(part, "name"));
    TROCAR_ASSIGN_OR_RETURN(std::vector<demonstration::Edit> edits, edits_at(part));
    import.parts.push_back({demonstration::RecordingId{recording}, std::move(name), std::move(edits)});
  }
  return import;
}

Result<Edit> split_demonstration(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "demonstration"));
  TROCAR_ASSIGN_OR_RETURN(std::string name, text_at(object, "name"));
  const auto at = object.find("at_s");
  if (at == object.end() || !at->is_number()) return corrupt("the parameter at_s must be there and be a number");
  return SplitDemonstration{DemonstrationId{id}, at->get<double>(), std::move(name)};
}

/// The edits of a stack: all name a demonstration and an entry of it.
Result<Edit> stack_edit(std::string_view name, const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t demonstration, id_at(object, "demonstration"));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t entry, id_at(object, "entry"));
  const DemonstrationId id{demonstration};
  if (name == MoveStackEntry::kName) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t place, id_at(object, "place"));
    return MoveStackEntry{id, entry, static_cast<int>(std::clamp<std::int64_t>(place, 0, 1 << 30))};
  }
  if (name == EnableStackEntry::kName) {
    const auto enabled = object.find("enabled");
    if (enabled == object.end() || !enabled->is_boolean()) {
      return corrupt("the parameter enabled must be there and be true or false");
    }
    return EnableStackEntry{id, entry, enabled->get<bool>()};
  }
  if (name == ReplaceStackEntry::kName) {
    TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, inner_edit(object));
    return ReplaceStackEntry{id, entry, std::move(edit)};
  }
  if (name == NameStackEntry::kName) {
    TROCAR_ASSIGN_OR_RETURN(std::string given, text_at(object, "name"));
    return NameStackEntry{id, entry, std::move(given)};
  }
  return RemoveStackEntry{id, entry};
}

template <typename Value>
Status read_word(const json& object, const char* key, Result<Value> (*from)(std::string_view),
                 std::optional<Value>& value) {
  if (!object.contains(key)) return {};
  TROCAR_ASSIGN_OR_RETURN(const std::string word, text_at(object, key));
  const Result<Value> read = from(word);
  if (!read) return corrupt(read.error().text());
  value = *read;
  return {};
}

Status read_tags(const json& object, const char* key, std::vector<std::string>& tags) {
  const auto list = object.find(key);
  if (list == object.end()) return {};
  if (!list->is_array()) return corrupt(fmt::format("the parameter {} must be a list", key));
  for (const json& each : *list) {
    if (!each.is_string()) return corrupt(fmt::format("each of {} must be text", key));
    tags.push_back(each.get<std::string>());
  }
  return {};
}

Result<Edit> mark_demonstration(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "demonstration"));
  MarkChange change;
  TROCAR_RETURN_IF_ERROR(read_word(object, "flag", flag_from, change.flag));
  TROCAR_RETURN_IF_ERROR(read_word(object, "verdict", verdict_from, change.verdict));
  if (object.contains("rating")) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t rating, id_at(object, "rating"));
    change.rating = static_cast<int>(std::clamp<std::int64_t>(rating, -1, 6));
  }
  TROCAR_RETURN_IF_ERROR(read_tags(object, "add", change.add));
  TROCAR_RETURN_IF_ERROR(read_tags(object, "remove", change.remove));
  if (object.contains("note")) {
    TROCAR_ASSIGN_OR_RETURN(change.note, text_at(object, "note"));
  }
  return MarkDemonstration{DemonstrationId{id}, std::move(change)};
}

Result<Edit> save_filter(const json& object) {
  TROCAR_ASSIGN_OR_RETURN(std::string name, text_at(object, "name"));
  TROCAR_ASSIGN_OR_RETURN(std::string query, text_at(object, "query"));
  return SaveFilter{std::move(name), std::move(query)};
}

Result<Edit> edit_from(std::string_view name, const json& object);

Result<Edit> batch(const json& object) {
  Batch read;
  TROCAR_ASSIGN_OR_RETURN(read.title, text_at(object, "title"));
  const auto list = object.find("edits");
  if (list == object.end() || !list->is_array()) return corrupt("the parameter edits must be there and be a list");
  for (const json& each : *list) {
    if (!each.is_object()) return corrupt("each of the edits must be a JSON object");
    TROCAR_ASSIGN_OR_RETURN(const std::string name, text_at(each, "name"));
    const auto parameters = each.find("parameters");
    if (parameters == each.end() || !parameters->is_object()) return corrupt("the edit has no parameters");
    // Refused here already, so that no file can make this go deep.
    if (name == Batch::kName) return corrupt("a batch cannot hold a batch");
    TROCAR_ASSIGN_OR_RETURN(Edit edit, edit_from(name, *parameters));
    read.edits.push_back(std::move(edit));
  }
  return read;
}

Result<Edit> add_trial(const json& object) {
  AddTrial added;
  TROCAR_ASSIGN_OR_RETURN(added.recording.value, id_at(object, "recording"));
  TROCAR_ASSIGN_OR_RETURN(added.name, text_at(object, "name"));
  const auto record = object.find("record");
  if (record == object.end()) return corrupt("a trial must have a record");
  TROCAR_ASSIGN_OR_RETURN(added.record, trial::record_from_json(record->dump()));
  return added;
}

Result<Edit> edit_from(std::string_view name, const json& object) {
  if (name == AddDemonstration::kName) {
    TROCAR_ASSIGN_OR_RETURN(AddDemonstration added, add_demonstration(object));
    return added;
  }
  if (name == ImportDemonstrations::kName) return import_demonstrations(object);
  if (name == EditDemonstration::kName) return edit_demonstration(object);
  if (name == CopyDemonstration::kName) {
    TROCAR_ASSIGN_OR_RETURN(CopyDemonstration copy, copy_demonstration(object));
    return copy;
  }
  if (name == CopyDemonstrations::kName) return copy_demonstrations(object);
  if (name == PunchIn::kName) return punch_in(object);
  if (name == SplitDemonstration::kName) return split_demonstration(object);
  if (name == MoveStackEntry::kName || name == EnableStackEntry::kName || name == ReplaceStackEntry::kName ||
      name == NameStackEntry::kName || name == RemoveStackEntry::kName) {
    return stack_edit(name, object);
  }
  if (name == RemoveDemonstration::kName || name == RestoreDemonstration::kName) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t value, id_at(object, "demonstration"));
    const DemonstrationId id{value};
    return name == RemoveDemonstration::kName ? Edit(RemoveDemonstration{id}) : Edit(RestoreDemonstration{id});
  }
  if (name == MarkDemonstration::kName) return mark_demonstration(object);
  if (name == SaveFilter::kName) return save_filter(object);
  if (name == RemoveFilter::kName) {
    TROCAR_ASSIGN_OR_RETURN(std::string filter, text_at(object, "name"));
    return RemoveFilter{std::move(filter)};
  }
  if (name == Batch::kName) return batch(object);
  if (name == AddModel::kName) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "object"));
    return AddModel{id};
  }
  if (name == AddTrial::kName) return add_trial(object);
  if (name == JudgeTrial::kName) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "trial"));
    TROCAR_ASSIGN_OR_RETURN(std::string reason, text_at(object, "reason"));
    return JudgeTrial{TrialId{id}, object.value("excluded", json(false)) == json(true), std::move(reason)};
  }
  if (name == RemoveModel::kName) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, id_at(object, "model"));
    return RemoveModel{ModelId{id}};
  }
  return corrupt(fmt::format("no edit is named {}", name));
}

}  // namespace

std::string to_json(const Edit& edit) {
  return std::visit(Printer{}, edit).dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<Edit> edit_from_json(std::string_view name, std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt("the parameters of an edit must be a JSON object");
  return edit_from(name, object);
}

}  // namespace trocar::workbench
