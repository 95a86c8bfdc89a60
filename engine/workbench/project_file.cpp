#include "engine/workbench/project_file.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "engine/demonstration/edits.h"
#include "engine/workbench/policy_bridge.h"
#include "engine/workbench/project_file_impl.h"
#include "engine/workbench/recovery.h"

namespace trocar::workbench {
namespace {

/// The document of every 64th node of a branch stays in memory: an undo applies at most 63 edits.
constexpr int kKeyframeDistance = 64;

/// For the history; a model has its name only after the edit that adds it.
std::string said(const Edit& edit, const Project& before, const Project& after, std::int64_t id) {
  const auto added = after.models.find(ModelId{id});
  if (std::holds_alternative<AddModel>(edit) && added != after.models.end()) return "Add model " + added->second->name;
  return describe(edit, before);
}

/// An edit that somebody asks for now.
Result<demonstration::Edit> kept_within(demonstration::Edit edit, DemonstrationId id, const Project& project) {
  auto* trim = std::get_if<demonstration::Trim>(&edit);
  const auto found = project.demonstrations.find(id);
  if (trim == nullptr || found == project.demonstrations.end()) return edit;
  TROCAR_ASSIGN_OR_RETURN(*trim, demonstration::kept_trim(*found->second, *trim));
  return edit;
}

}  // namespace

Status ProjectFile::Impl::take_rows(std::vector<store::JournalRow> rows) {
  for (store::JournalRow& row : rows) {
    TROCAR_RETURN_IF_ERROR(tree.add({row.id, row.parent, row.name, std::move(row.description), std::move(row.time)}));
    entries[row.id] = {std::move(row.name), std::move(row.parameters)};
  }
  return {};
}

Status ProjectFile::Impl::take_redo() {
  TROCAR_ASSIGN_OR_RETURN(const auto redo, store.redo());
  for (const store::RedoRow& row : redo) {
    if (row.child != 0 && tree.contains(row.child) && tree.parent(row.child) == row.parent) {
      tree.set_redo(row.parent, row.child);
    }
  }
  return {};
}

/// To where the store's HEAD is, whoever moved it there.
Status ProjectFile::Impl::follow_head() {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t node, store.head());
  if (!tree.contains(node)) {
    return fail(ErrorCode::kCorrupt, fmt::format("the project stands at an unknown point {} of its history", node));
  }
  TROCAR_ASSIGN_OR_RETURN(project, document_at(node));
  head = node;
  return {};
}

Status ProjectFile::Impl::load() {
  return store.snapshot([this]() -> Status {
    TROCAR_ASSIGN_OR_RETURN(auto rows, store.journal());
    TROCAR_RETURN_IF_ERROR(take_rows(std::move(rows)));
    TROCAR_RETURN_IF_ERROR(take_redo());
    TROCAR_RETURN_IF_ERROR(take_facts());
    return follow_head();
  });
}

/// Takes in what other programs have done since. Call it inside a transaction, so that all is of one moment.
Status ProjectFile::Impl::catch_up() {
  TROCAR_ASSIGN_OR_RETURN(const bool changed, store.changed_elsewhere());
  behind = behind || changed;
  if (!behind) return {};
  TROCAR_ASSIGN_OR_RETURN(auto rows, store.journal_after(tree.newest()));
  TROCAR_RETURN_IF_ERROR(take_rows(std::move(rows)));
  TROCAR_RETURN_IF_ERROR(take_redo());
  TROCAR_RETURN_IF_ERROR(take_facts());
  TROCAR_RETURN_IF_ERROR(follow_head());
  behind = false;
  return {};
}

Result<ProjectPointer> ProjectFile::Impl::step(const ProjectPointer& before, std::int64_t node) const {
  const JournalEntry& entry = entries.at(node);
  Result<Edit> edit = edit_from_json(entry.name, entry.parameters);
  Result<ProjectPointer> after = edit ? apply(*before, *edit, node, blobs) : tl::unexpected(std::move(edit).error());
  if (after) return after;
  return tl::unexpected(Error(ErrorCode::kCorrupt, fmt::format("the history's entry {} ({}) cannot be applied: {}",
                                                               node, entry.name, after.error().text()))
                            .at(store.path().string()));
}

void ProjectFile::Impl::keep(std::int64_t node, const ProjectPointer& document) {
  const bool station = tree.depth(node) % kKeyframeDistance == 0;
  if (station) documents.keep(node, document, DocumentCache::For::kGood);
}

Result<ProjectPointer> ProjectFile::Impl::document_at(std::int64_t node) {
  std::int64_t from = node;
  while (from != head && !documents.contains(from)) from = tree.parent(from);
  ProjectPointer document = from == head ? project : documents.find(from);
  for (const std::int64_t next : tree.path(from, node)) {
    TROCAR_ASSIGN_OR_RETURN(document, step(document, next));
    keep(next, document);
  }
  return document;
}

/// Where we come from and where we are stay at hand for undo and redo.
void ProjectFile::Impl::stand_at(std::int64_t node, const ProjectPointer& document) {
  documents.keep(head, project, DocumentCache::For::kAWhile);
  documents.keep(node, document, DocumentCache::For::kAWhile);
  head = node;
  project = document;
  documents.bound(*project);
}

/// For edits that take from the past. Kept, or a chain of such edits would be gone through again at every link.
Result<ProjectPointer> ProjectFile::Impl::past(std::int64_t node) {
  if (!tree.contains(node)) {
    return fail(ErrorCode::kNotFound, fmt::format("the history has no point {}", node));
  }
  TROCAR_ASSIGN_OR_RETURN(ProjectPointer document, document_at(node));
  documents.keep(node, document, DocumentCache::For::kGood);
  documents.bound(*project);
  return document;
}

/// Redo of each node that is left on the way up leads back down to where we came from.
std::vector<store::RedoRow> ProjectFile::Impl::redo_back_from(std::int64_t node) const {
  std::vector<store::RedoRow> left;
  for (std::int64_t at = head; at != 0 && at != node; at = tree.parent(at)) {
    const std::int64_t above = tree.parent(at);
    if (tree.redo(above) != at) left.push_back({above, at});
  }
  return left;
}

/// `where` is asked after what others did has been taken in.
Status ProjectFile::Impl::move(const std::function<Result<std::int64_t>()>& where) {
  std::int64_t node = 0;
  ProjectPointer document;
  std::vector<store::RedoRow> left;
  const Status done = store.transaction([&]() -> Status {
    TROCAR_RETURN_IF_ERROR(catch_up());
    TROCAR_ASSIGN_OR_RETURN(node, where());
    TROCAR_ASSIGN_OR_RETURN(document, document_at(node));
    left = redo_back_from(node);
    return store.set_head(node, left);
  });
  TROCAR_RETURN_IF_ERROR(done);
  for (const store::RedoRow& row : left) tree.set_redo(row.parent, row.child);
  stand_at(node, document);
  return {};
}

/// One transaction: what others did is taken in, `prepare` stores what the edit needs and gives it, the edit is applied
/// to the document as it is by then. Without success nothing of it stays.
Result<std::int64_t> ProjectFile::Impl::commit(const std::function<Result<Edit>()>& prepare) {
  store::JournalRow row;
  ProjectPointer edited;
  const Status done = store.transaction([&]() -> Status {
    TROCAR_RETURN_IF_ERROR(catch_up());
    TROCAR_ASSIGN_OR_RETURN(Edit edit, prepare());
    TROCAR_ASSIGN_OR_RETURN(edit, with_ways(std::move(edit), *project));
    const std::int64_t id = tree.newest() + ids_taken(edit);
    TROCAR_ASSIGN_OR_RETURN(edited, apply(*project, edit, id, blobs));
    row = {id,
           head,
           iso_time(clock->unix_s()),
           std::string(name_of(edit)),
           to_json(edit),
           said(edit, *project, *edited, id)};
    return store.append(row).map([](std::int64_t) {});
  });
  TROCAR_RETURN_IF_ERROR(done);
  const std::int64_t id = row.id;
  TROCAR_RETURN_IF_ERROR(take_rows({std::move(row)}));
  keep(id, edited);
  stand_at(id, edited);
  return id;
}

/// Recordings that nobody writes any more and no entry of the history names.
Result<std::vector<store::RecordingRow>> ProjectFile::Impl::cut_off() const {
  TROCAR_ASSIGN_OR_RETURN(std::vector<store::RecordingRow> rows, store.recordings());
  std::set<std::int64_t> named;
  for (const auto& [node, entry] : entries) {
    if (entry.name != AddDemonstration::kName && entry.name != ImportDemonstrations::kName &&
        entry.name != PunchIn::kName && entry.name != AddTrial::kName) {
      continue;
    }
    const Result<Edit> edit = edit_from_json(entry.name, entry.parameters);
    if (!edit) continue;
    if (const auto* added = std::get_if<AddDemonstration>(&*edit)) named.insert(added->recording.value);
    if (const auto* punch = std::get_if<PunchIn>(&*edit)) named.insert(punch->take.recording.value);
    if (const auto* trial = std::get_if<AddTrial>(&*edit)) named.insert(trial->recording.value);
    if (const auto* import = std::get_if<ImportDemonstrations>(&*edit)) {
      for (const ImportDemonstrations::Part& part : import->parts) named.insert(part.recording.value);
    }
  }
  std::erase_if(rows, [&named](const auto& row) { return row.writer_lives || named.contains(row.id); });
  return rows;
}

/// Says that it is recovered when that is on the disk, and not before.
void ProjectFile::Impl::recover(const store::RecordingRow& row, Diagnostics& diagnostics) {
  Result<Recovered> whole = recover_recording(store, row);
  if (whole && !whole->kept) {
    return diagnostics.warn("a recording was cut off before it had 2 samples and was dropped");
  }
  Status done = whole.map([](const Recovered&) {});
  if (done) {
    const AddDemonstration add{whole->recording, fmt::format("Recovered ({:.1f} s)", whole->duration_s)};
    done = commit([&add]() -> Result<Edit> { return add; }).map([](std::int64_t) {});
  }
  if (done) ++recovered;
  diagnostics.warn(
      done ? fmt::format("a recording was cut off after {:.1f} s and has been recovered", whole->duration_s)
           : fmt::format("recording {} was cut off and cannot be recovered now ({})", row.id, done.error().text()));
}

ProjectFile::ProjectFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProjectFile::~ProjectFile() = default;
ProjectFile::ProjectFile(ProjectFile&&) noexcept = default;
ProjectFile& ProjectFile::operator=(ProjectFile&&) noexcept = default;

Result<ProjectFile> ProjectFile::create(const std::filesystem::path& path, std::shared_ptr<const Clock> clock) {
  TROCAR_ASSIGN_OR_RETURN(store::ProjectStore store, store::ProjectStore::create(path));
  return ProjectFile(std::make_unique<Impl>(std::move(store), std::move(clock)));
}

Result<ProjectFile> ProjectFile::open(const std::filesystem::path& path, std::shared_ptr<const Clock> clock,
                                      Diagnostics& diagnostics, Purpose purpose, Models models) {
  const auto access =
      purpose == Purpose::kRead ? store::ProjectStore::Access::kRead : store::ProjectStore::Access::kWrite;
  TROCAR_ASSIGN_OR_RETURN(store::ProjectStore store, store::ProjectStore::open(path, access));
  ProjectFile file(std::make_unique<Impl>(std::move(store), std::move(clock)));
  if (models == Models::kDescribed) file.impl_->blobs.describe_models_only();
  Status loaded = file.impl_->load();
  if (!loaded) return tl::unexpected(std::move(loaded).error().at(path.string()));
  TROCAR_ASSIGN_OR_RETURN(const auto cut_off, file.impl_->cut_off());
  for (const store::RecordingRow& row : cut_off) {
    if (purpose == Purpose::kEdit) {
      file.impl_->recover(row, diagnostics);
    } else {
      diagnostics.warn("a recording was cut off; it is recovered when the project is next opened to be edited");
    }
  }
  return file;
}

std::shared_ptr<const Project> ProjectFile::project() const {
  return impl_->project;
}

Result<std::shared_ptr<const Project>> ProjectFile::project_at(std::int64_t node) const {
  return impl_->past(node);
}

std::size_t ProjectFile::recovered() const {
  return impl_->recovered;
}

Result<std::int64_t> ProjectFile::commit(const Edit& edit) {
  // A long recording is read before the transaction, so that other programs do not wait for it.
  if (const auto* added = std::get_if<AddDemonstration>(&edit)) (void)impl_->blobs.recording(added->recording);
  if (const auto* punch = std::get_if<PunchIn>(&edit)) (void)impl_->blobs.recording(punch->take.recording);
  if (const auto* trial = std::get_if<AddTrial>(&edit)) (void)impl_->blobs.recording(trial->recording);
  Result<std::int64_t> node = impl_->commit([this, &edit]() -> Result<Edit> {
    Edit kept = edit;
    if (auto* change = std::get_if<EditDemonstration>(&kept)) {
      TROCAR_ASSIGN_OR_RETURN(change->edit,
                              kept_within(std::move(change->edit), change->demonstration, *impl_->project));
    }
    return kept;
  });
  // What another program holds up is tried again.
  if (node || !held_elsewhere()) impl_->blobs.prepare(nullptr, demonstration::Edit{}, nullptr);
  return node;
}

void ProjectFile::prepare(std::shared_ptr<const demonstration::Demonstration> before, const demonstration::Edit& edit,
                          std::shared_ptr<const demonstration::Demonstration> after) {
  impl_->blobs.prepare(std::move(before), edit, std::move(after));
}

Status ProjectFile::undo() {
  return impl_->move([this]() -> Result<std::int64_t> {
    if (!undoable()) return fail(ErrorCode::kInvalidArgument, "there is nothing to undo");
    return impl_->tree.parent(impl_->head);
  });
}

Status ProjectFile::redo() {
  return impl_->move([this]() -> Result<std::int64_t> {
    const std::optional<std::int64_t> next = impl_->tree.redo(impl_->head);
    if (!next) return fail(ErrorCode::kInvalidArgument, "there is nothing to redo");
    return *next;
  });
}

bool ProjectFile::undoable() const {
  return impl_->head != 0;
}

bool ProjectFile::redoable() const {
  return impl_->tree.redo(impl_->head).has_value();
}

Status ProjectFile::go_to(std::int64_t node) {
  return impl_->move([this, node]() -> Result<std::int64_t> {
    if (impl_->tree.contains(node)) return node;
    return fail(ErrorCode::kNotFound, fmt::format("the history has no entry {}", node));
  });
}

std::int64_t ProjectFile::head() const {
  return impl_->head;
}

const std::vector<HistoryNode>& ProjectFile::history() const {
  return impl_->tree.nodes();
}

void ProjectFile::set_patience_ms(int patience_ms) {
  impl_->store.set_patience_ms(patience_ms);
}

bool ProjectFile::held_elsewhere() const {
  return impl_->store.held_elsewhere();
}

Status ProjectFile::set_setting(const std::string& key, const std::string& value) {
  return impl_->store.set_setting(key, value);
}

Result<std::optional<std::string>> ProjectFile::setting(const std::string& key) const {
  return impl_->store.setting(key);
}

std::int64_t ProjectFile::size_bytes() const {
  return impl_->store.size_bytes();
}

Result<demonstration::Edit> ProjectFile::resolved(demonstration::Edit edit, DemonstrationId demonstration,
                                                  std::int64_t entry) const {
  if (entry == 0) {
    TROCAR_ASSIGN_OR_RETURN(edit, kept_within(std::move(edit), demonstration, *impl_->project));
  }
  TROCAR_ASSIGN_OR_RETURN(edit, with_ways(std::move(edit), demonstration, entry, *impl_->project));
  return workbench::resolved(std::move(edit), *impl_->project, impl_->blobs, impl_->tree.newest() + 1);
}

const std::filesystem::path& ProjectFile::path() const {
  return impl_->store.path();
}

}  // namespace trocar::workbench
