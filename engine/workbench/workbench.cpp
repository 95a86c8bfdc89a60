#include "engine/workbench/workbench.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <variant>

#include "engine/store/project_store.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

Workbench::Impl::Impl(Options options_in)
    : options(std::move(options_in)),
      insight([] {
        auto maker = std::make_shared<InsightMaker>();
        return [maker](const InsightRequest& request) { return maker->make(request); };
      }),
      seeds([] { return seed_insight; }),
      preview([] { return [](const PreviewRequest& request) { return preview_of(request); }; }),
      review([distances = distances] {
        auto maker = std::make_shared<ReviewMaker>(distances);
        return [maker](const ReviewRequest& request) { return maker->make(request); };
      }),
      preview_review([distances = distances] {
        auto maker = std::make_shared<ReviewMaker>(distances);
        return [maker](const ReviewRequest& request) { return maker->make(request); };
      }),
      curves([distances = distances] {
        auto maker = std::make_shared<CurveMaker>(distances);
        return [maker](const CurvesRequest& request) { return maker->make(request); };
      }),
      comparison([] { return comparison_of; }),
      library([distances = distances] {
        auto maker = std::make_shared<LibraryMaker>(distances);
        return [maker](const LibraryRequest& request) { return maker->make(request, kLibraryPiece_samples); };
      }),
      batch([] {
        return [](const BatchRequest& request) {
          Progress progress;
          return plan_batch(request, progress);
        };
      }) {
  if (!options.clock) options.clock = std::make_shared<SystemClock>();
  if (options.picture) view.emplace();
  last_poll_s = options.clock->now_s();
}

void Workbench::Impl::log(Severity severity, std::string text) {
  constexpr std::size_t kKept = 500;
  const std::string time = iso_time(options.clock->unix_s());
  // What was asked for and cannot be is said where what was done is said.
  if (severity == Severity::kError) state.done = text;
  state.log.push_back({time.substr(11, 8), severity, std::move(text)});
  if (state.log.size() > kKept) state.log.erase(state.log.begin());
  dirty = true;
}

bool Workbench::Impl::succeeded(const Status& status) {
  if (!status) log(Severity::kError, status.error().text());
  return status.has_value();
}

bool Workbench::Impl::project_open() {
  if (state.load == LoadState::kLoading) {
    log(Severity::kWarning, "Wait until the project is open");
    return false;
  }
  if (!file) log(Severity::kWarning, "Open a project first");
  return file != nullptr;
}

bool Workbench::Impl::document_free() {
  if (recording) log(Severity::kWarning, "A transfer is being recorded");
  return !recording;
}

bool Workbench::Impl::is_output(const std::filesystem::path& path) {
  if (!file || !store::is_part_of_project(path, file->path())) return true;
  log(Severity::kError, "That is the project itself: " + path.string());
  return false;
}

void Workbench::Impl::keep_project(const std::string& why) {
  state.load = opening.busy() ? LoadState::kLoading : file ? LoadState::kReady : LoadState::kFailed;
  if (file) state.path = file->path();
  state.load_error = why;
  log(Severity::kError, why);
}

void Workbench::Impl::take_project(std::shared_ptr<ProjectFile> opened) {
  // The recording writes into the project that is open.
  if (recording) return keep_project("Stop the recording before opening another project");
  if (!waiting_writes.empty()) log(Severity::kError, "What waited for the other project was given up");
  waiting_writes.clear();
  file = std::move(opened);
  state.clipboard.reset();
  state.selection.reset();
  state.film = {};
  state.film_preview.reset();
  state.film_file.reset();
  state.monte_carlo.reset();
  state.physics.reset();
  state.rollouts.selected.reset();
  state.rollouts.brushed.clear();
  state.history.clear();
  state.sketches.clear();
  sketches_wanted.clear();
  state.load = opening.busy() ? LoadState::kLoading : LoadState::kReady;
  state.load_error.clear();
  state.path = file->path();
  refresh_document();
}

void Workbench::Impl::refresh_document() {
  dirty = true;
  state.project = file->project();
  // It only ever grows.
  const auto& nodes = file->history();
  state.history.insert(state.history.end(), nodes.begin() + std::ssize(state.history), nodes.end());
  state.checkpoints = file->checkpoints();
  state.replays = file->replays();
  state.head = file->head();
  state.undoable = file->undoable();
  state.redoable = file->redoable();
  const auto& demonstrations = state.project->demonstrations;
  if (demonstration(state.demonstration) == nullptr) {
    state.demonstration = demonstrations.empty() ? DemonstrationId{} : demonstrations.begin()->first;
    state.play_speed = 0.0;
  }
  const auto& models = state.project->models;
  if (!models.contains(state.model)) state.model = models.empty() ? ModelId{} : models.rbegin()->first;
  // A preview is of what the document was.
  if (state.preview && state.preview->before != demonstration(state.demonstration)) on(EndPreview{});
  on(SetPlayhead{state.playhead_s});
  on(SetSelection{state.selection});
  request_insight();
}

void Workbench::Impl::request_insight() {
  InsightRequest request;
  request.entry = model(state.model);
  request.stale = request.entry && state.project->stale(*request.entry);
  request.shown = {state.field.layer, state.field.mask};
  for (const FieldSettings& layer : state.field_layers) request.layers.push_back({layer.layer, layer.mask});
  request.rollouts = state.rollouts;
  request.epoch = state.learning.epoch;
  request.second = model(state.learning.second);
  // What a sampling method learns anew differs by more than what was edited.
  constexpr int kMostCellsToFollow = 44 * 44 * 44;
  const bool exact = request.entry && request.entry->model &&
                     request.entry->model->options.method == learning::Method::kExact &&
                     request.entry->model->grid.cell_count() <= kMostCellsToFollow;
  const bool edited = request.stale || (state.preview && state.preview->after);
  if (state.learning.follow && exact && edited) {
    for (const DemonstrationId id : request.entry->demonstrations) {
      request.experts.push_back(id == state.demonstration ? shown() : demonstration(id));
    }
  }
  if (insight_wanted) insight_wanted->cancel();
  insight_wanted = request.wanted = std::make_shared<Progress>();
  insight.request(std::move(request));
}

std::shared_ptr<const demonstration::Demonstration> Workbench::Impl::demonstration(DemonstrationId id) const {
  if (!state.project) return nullptr;
  const auto found = state.project->demonstrations.find(id);
  if (found != state.project->demonstrations.end()) return found->second;
  // What was recorded of a trial is looked at like a demonstration.
  const auto trial = state.project->trials.find(TrialId{id.value});
  return trial == state.project->trials.end() ? nullptr : trial->second->shown;
}

std::shared_ptr<const ModelEntry> Workbench::Impl::model(ModelId id) const {
  if (!state.project) return nullptr;
  const auto found = state.project->models.find(id);
  return found == state.project->models.end() ? nullptr : found->second;
}

std::string Workbench::Impl::description_of(std::int64_t node) const {
  const auto& nodes = file->history();
  const auto found = std::find_if(nodes.begin(), nodes.end(), [node](const HistoryNode& n) { return n.id == node; });
  return found == nodes.end() ? std::string() : found->description;
}

void Workbench::Impl::poll_jobs() {
  for (JobRunner* runner : {&opening, &reading, &editing, &jobs}) {
    for (const JobView& ended : runner->poll(options.clock->now_s())) {
      if (ended.state == JobState::kFailed) log(Severity::kError, ended.title + ": " + ended.message);
      if (ended.state == JobState::kDone && !ended.hidden) log(Severity::kInfo, ended.title + ": " + ended.message);
      dirty = true;
    }
    if (runner->busy() && !runner->paused()) dirty = true;
  }
  if (trainings.poll(jobs.jobs())) {
    state.training = trainings.running();
    dirty = true;
  }
  state.jobs = jobs.jobs();
  std::erase_if(state.jobs, [](const JobView& job) { return job.hidden; });
}

Status Workbench::Impl::finish(double limit_s) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
  jobs.cancel_all();
  opening.cancel_all();
  reading.cancel_all();
  editing.cancel_all();
  if (recording && !recording->stopping()) recording->stop(true);
  state.play_speed = 0.0;
  while (recording || jobs.busy() || opening.busy() || reading.busy() || editing.busy()) {
    if (std::chrono::steady_clock::now() > deadline) {
      return fail(ErrorCode::kCancelled, "the workbench was still busy when it had to end");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    poll();
  }
  return {};
}

bool Workbench::Impl::poll() {
  const double now_s = options.clock->now_s();
  const double elapsed_s = std::clamp(now_s - last_poll_s, 0.0, 0.25);
  last_poll_s = now_s;
  advance_playhead(elapsed_s);
  poll_recording();
  poll_console();
  poll_rest();
  poll_jobs();
  retry_writes();
  poll_import();
  if (insight.update()) {
    state.insight = insight.answer();
    dirty = true;
  }
  state.insight_pending = insight.pending();
  if (preview.update()) {
    state.preview = preview.answer();
    dirty = true;
    request_insight();
  }
  follow_review();
  follow_preview_review();
  follow_curves();
  follow_comparison();
  follow_seeds();
  follow_library();
  follow_batch();
  sketch_history();
  follow_filmstrip();
  follow_film();
  if (view && view->poll(state, now_s)) dirty = true;
  return std::exchange(dirty, false);
}

Workbench::Workbench(Options options) : impl_(std::make_unique<Impl>(std::move(options))) {}

Workbench::~Workbench() = default;

void Workbench::post(Command command) {
  std::visit([this](const auto& alternative) { impl_->on(alternative); }, command);
}

bool Workbench::poll() {
  return impl_->poll();
}

bool Workbench::busy() const {
  return impl_->jobs.busy() || !impl_->waiting_writes.empty() || impl_->opening.busy() || impl_->reading.busy() ||
         impl_->editing.busy() || (impl_->recording && !impl_->recording->waits()) || impl_->state.play_speed != 0.0 ||
         impl_->insight.pending() || impl_->preview.pending() || impl_->review.pending() ||
         impl_->preview_review.pending() || impl_->curves.pending() || impl_->comparison.pending() ||
         impl_->seeds.pending() || impl_->state.library_pending || impl_->state.batch_pending ||
         !impl_->sketches_wanted.empty() || impl_->filmstrip.busy() || impl_->state.film_preview_pending ||
         (impl_->view && impl_->view->busy());
}

Status Workbench::wait_idle(double limit_s, const Progress* progress) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
  for (poll(); busy(); poll()) {
    if (progress != nullptr && progress->cancelled()) return fail(ErrorCode::kCancelled, "stopped by the user");
    if (std::chrono::steady_clock::now() > deadline) {
      return fail(ErrorCode::kCancelled, "the workbench was still busy when the waiting ended");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return {};
}

Status Workbench::finish(double limit_s) {
  return impl_->finish(limit_s);
}

const WorkbenchState& Workbench::state() const {
  return impl_->state;
}

}  // namespace trocar::workbench
