// What the workbench does about the library and the history: follows rows, batches and small pictures.
#include <algorithm>
#include <utility>

#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {
namespace {

/// Each costs as much as an undo where it is no neighbour of the one before.
constexpr int kSketchesAtOnce = 2;
/// Kept at most; each takes about two kilobytes.
constexpr std::size_t kMostSketches = 4096;

}  // namespace

void Workbench::Impl::on(const ShowLibrary& command) {
  state.library_on = command.on;
  dirty = true;
}

void Workbench::Impl::follow_library() {
  LibraryRequest wanted;
  if (state.library_on && state.project) wanted = {state.project, state.replays};
  if (wanted != library_wanted) {
    library_wanted = wanted;
    library.request(std::move(wanted));
  }
  if (library.update()) {
    state.library = library.answer();
    dirty = true;
    // Piece by piece, so that what is there is seen and what is wanted by then comes first.
    const bool more = state.library && state.library->unmeasured > 0 && !library.pending();
    if (more) library.request(library_wanted);
  }
  state.library_pending = library.pending();
}

void Workbench::Impl::on(const PlanBatch& command) {
  batch_wanted.demonstrations = command.demonstrations;
  batch_wanted.words = command.words;
  batch_wanted.project = nullptr;  // Asked for anew, below.
  dirty = true;
  if (command.words.empty()) {
    batch.request({});
    state.batch.reset();
  }
  follow_batch();
}

void Workbench::Impl::follow_batch() {
  if (!batch_wanted.words.empty() && batch_wanted.project != state.project) {
    batch_wanted.project = state.project;
    batch.request(batch_wanted);
  }
  if (batch.update()) {
    state.batch = batch.answer();
    dirty = true;
  }
  state.batch_pending = batch.pending();
}

void Workbench::Impl::on(const NameCheckpoint& command) {
  write([this, command] {
    return move([this, command]() -> Status {
      const std::string name = command.name ? *command.name : unused_name(file->checkpoints());
      TROCAR_RETURN_IF_ERROR(file->name_checkpoint(command.node, name));
      const std::string point = command.node == 0 ? "the empty project" : description_of(command.node);
      tell(name.empty() ? "No longer a checkpoint: " + point : name + ": " + point);
      return {};
    });
  });
}

void Workbench::Impl::keep_replay(const std::shared_ptr<ProjectFile>& owner, demonstration::RecordingId id,
                                  const ReplayFound& found) {
  write([this, owner, id, found] {
    const Status kept = owner->keep_replay(id, found);
    if (!kept && owner->held_elsewhere()) return false;
    if (succeeded(kept) && owner == file) refresh_document();
    return true;
  });
}

void Workbench::Impl::on(const SketchHistory& command) {
  if (state.sketches.size() > kMostSketches) state.sketches.clear();  // Those that are seen are asked for again.
  sketches_wanted = command.nodes;
  std::erase_if(sketches_wanted, [this](std::int64_t node) { return state.sketches.contains(node); });
  std::sort(sketches_wanted.begin(), sketches_wanted.end(), std::greater<>());
}

void Workbench::Impl::sketch_history() {
  if (!file) sketches_wanted.clear();
  for (int i = 0; i < kSketchesAtOnce && !sketches_wanted.empty(); ++i) {
    // The oldest first: each is one edit from its neighbour.
    const std::int64_t node = sketches_wanted.back();
    sketches_wanted.pop_back();
    const auto subject = file->subject_at(node);
    const bool drawn = subject && *subject != nullptr;
    state.sketches[node] = drawn ? std::make_shared<const PathSketch>(path_sketch(**subject)) : nullptr;
    dirty = true;
  }
}

}  // namespace trocar::workbench
