// What a project remembers beside its history, and what its history is about.
#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "engine/demonstration/name.h"
#include "engine/workbench/project_file_impl.h"

namespace trocar::workbench {
namespace {

// Keys of settings: what they are of follows, as a number.
constexpr const char* kCheckpointKey = "checkpoint ";
constexpr const char* kReplayKey = "replay ";

std::optional<std::int64_t> number_from(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The demonstration that an edit is about; none of one that is about a model, a filter or several.
struct SubjectOf {
  std::int64_t node;
  std::optional<DemonstrationId> operator()(const AddDemonstration&) const { return DemonstrationId{node}; }
  std::optional<DemonstrationId> operator()(const CopyDemonstration&) const { return DemonstrationId{node}; }
  template <typename Other>
  std::optional<DemonstrationId> operator()(const Other& edit) const {
    if constexpr (requires { edit.demonstration; }) return edit.demonstration;
    return std::nullopt;
  }
};

}  // namespace

/// What cannot be read is left out: it is no part of the document.
Status ProjectFile::Impl::take_facts() {
  TROCAR_ASSIGN_OR_RETURN(const auto names, store.settings_under(kCheckpointKey));
  checkpoints.clear();
  for (const auto& [key, name] : names) {
    const std::optional<std::int64_t> node = number_from(key);
    if (node && !name.empty() && tree.contains(*node)) checkpoints[*node] = name;
  }
  TROCAR_ASSIGN_OR_RETURN(const auto found, store.settings_under(kReplayKey));
  replays.clear();
  for (const auto& [key, text] : found) {
    const std::optional<std::int64_t> recording = number_from(key);
    const Result<ReplayFound> read = replay_found_from(text);
    if (recording && read) replays[{*recording}] = *read;
  }
  return {};
}

Result<std::shared_ptr<const demonstration::Demonstration>> ProjectFile::subject_at(std::int64_t node) const {
  if (!impl_->tree.contains(node)) {
    return fail(ErrorCode::kNotFound, fmt::format("the history has no point {}", node));
  }
  if (node == 0) return nullptr;
  const JournalEntry& entry = impl_->entries.at(node);
  TROCAR_ASSIGN_OR_RETURN(const Edit edit, edit_from_json(entry.name, entry.parameters));
  const std::optional<DemonstrationId> id = std::visit(SubjectOf{node}, edit);
  if (!id) return nullptr;
  auto& [at, document] = impl_->last_past;
  if (at == impl_->tree.parent(node)) {
    TROCAR_ASSIGN_OR_RETURN(document, impl_->step(document, node));
  } else if (at != node) {
    TROCAR_ASSIGN_OR_RETURN(document, impl_->document_at(node));
  }
  at = node;
  const auto found = document->demonstrations.find(*id);
  return found == document->demonstrations.end() ? nullptr : found->second;
}

Status ProjectFile::name_checkpoint(std::int64_t node, const std::string& name) {
  if (!impl_->tree.contains(node)) return fail(ErrorCode::kNotFound, fmt::format("the history has no point {}", node));
  if (!name.empty()) TROCAR_RETURN_IF_ERROR(demonstration::check_name(name));
  TROCAR_RETURN_IF_ERROR(impl_->store.set_setting(fmt::format("{}{}", kCheckpointKey, node), name));
  if (name.empty()) {
    impl_->checkpoints.erase(node);
  } else {
    impl_->checkpoints[node] = name;
  }
  return {};
}

const Checkpoints& ProjectFile::checkpoints() const {
  return impl_->checkpoints;
}

Status ProjectFile::keep_replay(demonstration::RecordingId recording, const ReplayFound& found) {
  TROCAR_RETURN_IF_ERROR(impl_->store.set_setting(fmt::format("{}{}", kReplayKey, recording.value), to_text(found)));
  impl_->replays[recording] = found;
  return {};
}

const Replays& ProjectFile::replays() const {
  return impl_->replays;
}

}  // namespace trocar::workbench
