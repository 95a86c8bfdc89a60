#include <fmt/format.h>

#include <memory>

#include "engine/demonstration/edit_words.h"
#include "engine/learning/learning_history.h"
#include "engine/workbench/jobs/field_job.h"
#include "engine/workbench/jobs/train_job.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

void Workbench::Impl::on(const OpenProject& command) {
  if (recording) return log(Severity::kWarning, "Stop the recording before opening another project");
  state.load = LoadState::kLoading;
  state.path = command.path;
  dirty = true;
  struct Opened {
    std::shared_ptr<ProjectFile> file;
    Diagnostics diagnostics;
  };
  const auto work = [this, path = command.path, create = command.create](Progress&) -> Result<JobResult> {
    auto opened = std::make_shared<Opened>();
    auto file_opened =
        create ? ProjectFile::create(path, options.clock) : ProjectFile::open(path, options.clock, opened->diagnostics);
    if (!file_opened) {
      // A failure is shown where the project would have been, so it is a result and not a failed job.
      const std::string why = file_opened.error().text();
      return JobResult{why, [this, why]() -> Status {
                         keep_project(why);
                         return {};
                       }};
    }
    opened->file = std::make_shared<ProjectFile>(std::move(*file_opened));
    return JobResult{"", [this, opened]() -> Status {
                       take_project(std::move(opened->file));
                       for (const std::string& warning : opened->diagnostics.warnings())
                         log(Severity::kWarning, warning);
                       log(Severity::kInfo, fmt::format("Opened {}", state.path.filename().string()));
                       return {};
                     }};
  };
  opening.start("Open " + command.path.filename().string(), work, true);
}

void Workbench::Impl::on(const PreviewEdit& command) {
  // What cannot be found is missing in the preview too, which says so.
  const demonstration::Edit edit = demonstration::as_typed(command.edit);
  const Result<demonstration::Edit> whole =
      file ? file->resolved(edit, state.demonstration, command.entry) : Result<demonstration::Edit>(edit);
  const std::string why = whole ? "" : whole.error().text();
  preview.request({demonstration(state.demonstration), whole.value_or(edit), command.entry, why});
  dirty = true;
}

void Workbench::Impl::on(const EndPreview&) {
  // The answer to an older request may still come; this one replaces it.
  preview.request({});
  state.preview.reset();
  dirty = true;
}

void Workbench::Impl::on(const SetGizmo& command) {
  state.gizmo = command.settings;
  dirty = true;
}

void Workbench::Impl::on(const SelectDemonstration& command) {
  const auto shown = demonstration(command.id);
  if (!shown) return log(Severity::kError, fmt::format("there is no demonstration {}", command.id.value));
  state.demonstration = command.id;
  state.play_speed = 0.0;
  state.selection.reset();
  on(EndPreview{});
  on(SetPlayhead{shown->begin_s});
}

void Workbench::Impl::on(const SelectModel& command) {
  if (!model(command.id)) return log(Severity::kError, fmt::format("there is no model {}", command.id.value));
  state.model = command.id;
  state.learning.epoch = -1;
  request_insight();
}

void Workbench::Impl::on(const SetCamera& command) {
  state.orbit = command.orbit;
  state.camera_preset.reset();
  dirty = true;
}

void Workbench::Impl::on(const SetCameraPreset& command) {
  state.camera_preset = command.preset;
  state.orbit = scene::OrbitCamera::from(scene::camera(command.preset), state.orbit.distance_m);
  dirty = true;
}

void Workbench::Impl::on(const SetViewSize& command) {
  if (view) view->resize(command.width, command.height);
}

void Workbench::Impl::on(const SetBackdrop& command) {
  state.light_backdrop = command.light;
  dirty = true;
}

void Workbench::Impl::on(const ShowFilmstrip& command) {
  filmstrip.ask(command);
}

void Workbench::Impl::on(const SetField& command) {
  const bool other_layer = command.settings.layer != state.field.layer || command.settings.mask != state.field.mask;
  state.field = command.settings;
  dirty = true;
  if (other_layer) request_insight();
}

void Workbench::Impl::on(const SetFieldLayers& command) {
  const auto same_field = [](const FieldSettings& a, const FieldSettings& b) {
    return a.layer == b.layer && a.mask == b.mask;
  };
  const bool same = std::equal(command.layers.begin(), command.layers.end(), state.field_layers.begin(),
                               state.field_layers.end(), same_field);
  state.field_layers = command.layers;
  dirty = true;
  if (!same) request_insight();
}

void Workbench::Impl::on(const SetRollouts& command) {
  const bool other_starts = command.settings.starts != state.rollouts.starts ||
                            command.settings.ghost_count != state.rollouts.ghost_count ||
                            command.settings.selected != state.rollouts.selected;
  state.rollouts = command.settings;
  dirty = true;
  if (other_starts) request_insight();
}

void Workbench::Impl::on(const SetLearning& command) {
  if (command.settings == state.learning) return;
  state.learning = command.settings;
  dirty = true;
  request_insight();
}

void Workbench::Impl::on(const TrainModel& command) {
  if (!project_open()) return;
  const auto feed = std::make_shared<TrainingFeed>();
  const auto work = [this, command, feed, owner = file,
                     project = state.project](Progress& progress) -> Result<JobResult> {
    progress.watch([feed](double mismatch) { feed->tell(mismatch); });
    auto trained = train_model(*project, command, progress);
    if (!trained) return tl::unexpected(std::move(trained).error());
    auto entry = std::make_shared<const ModelEntry>(std::move(*trained));
    const std::string message = fmt::format("trained in {:.2f} s", entry->model->seconds);
    return JobResult{message, [this, entry, owner] { return keep_model(owner, entry); }};
  };
  const std::string name = command.name.empty() ? model_name(command) : command.name;
  trainings.add(feed, jobs.start("Train " + name, work), name, learning::expected_epochs(command.options));
}

void Workbench::Impl::on(const VerifyReplay& command) {
  const auto shown = demonstration(command.demonstration);
  if (!shown) return log(Severity::kError, fmt::format("there is no demonstration {}", command.demonstration.value));
  const auto work = [this, owner = file, shown](Progress& progress) -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(const trial::ReplayResult replayed,
                            trial::replay(*shown->recording, shown->recorded, progress));
    return JobResult{
        "verified: every state hash is the same", [this, owner, id = shown->recording->id, replayed]() -> Status {
          keep_replay(owner, id, found_of(replayed));
          if (replayed.verified) return {};
          return fail(ErrorCode::kCheckFailed,
                      fmt::format("the replay diverged at {:.2f} s", replayed.diverged_at_s.value_or(0.0)));
        }};
  };
  jobs.start("Replay " + shown->name, work);
}

void Workbench::Impl::on(const ExportField& command) {
  if (!is_output(command.path)) return;
  const auto entry = model(command.model);
  if (!entry) return log(Severity::kError, fmt::format("there is no model {}", command.model.value));
  FieldExport wanted;
  wanted.model = entry;
  wanted.layer = command.layer;
  wanted.mask = command.mask;
  if (command.against != ModelId{}) {
    wanted.against = model(command.against);
    if (!wanted.against) return log(Severity::kError, fmt::format("there is no model {}", command.against.value));
  }
  wanted.contrast = command.contrast;
  wanted.slice = command.slice;
  wanted.slab = command.slab;
  wanted.through = command.through;
  wanted.look = command.look;
  wanted.path = command.path;
  const auto work = [request = std::move(wanted)](Progress&) -> Result<JobResult> {
    TROCAR_RETURN_IF_ERROR(export_field(request));
    return JobResult{"written", {}};
  };
  jobs.start("Export " + command.path.filename().string(), work);
}

void Workbench::Impl::on(const ImportTable& command) {
  if (!project_open()) return;
  const auto work = [this, command, owner = file, project = state.project](Progress&) -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(ModelEntry imported, import_table(*project, command));
    auto entry = std::make_shared<const ModelEntry>(std::move(imported));
    const std::string message = fmt::format("imported as \"{}\"", entry->name);
    return JobResult{message, [this, entry, owner] { return keep_model(owner, entry); }};
  };
  jobs.start("Import " + command.path.filename().string(), work);
}

void Workbench::Impl::on(const Report& command) {
  log(Severity::kWarning, command.sentence);
}

void Workbench::Impl::on(const CancelJob& command) {
  jobs.cancel(command.id);
}

}  // namespace trocar::workbench
