// What the workbench does about films: the one that is being made, how it looks, its job in a file, and the rendering.
#include <fmt/format.h>

#include <utility>

#include "engine/core/file.h"
#include "engine/film/composition_json.h"
#include "engine/workbench/jobs/film_camera.h"
#include "engine/workbench/jobs/film_job.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {
namespace {

constexpr std::size_t kLargestFilmJob_bytes = std::size_t{1} << 20;

}  // namespace

void Workbench::Impl::start_film(film::Composition film) {
  const std::filesystem::path path = film.path;
  const auto work = [job = FilmJob{std::move(film), state.project, path}](Progress& progress) -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(const FilmReport report, render_film(job, progress));
    std::string told = fmt::format("{} frames in {:.1f} s", report.frames, report.seconds);
    for (const std::string& warning : report.warnings) told += "; " + warning;
    return JobResult{told, {}};
  };
  jobs.start("Film " + path.filename().string(), work, false, path);
}

void Workbench::Impl::on(const ExportVideo& command) {
  if (!is_output(command.path)) return;
  film::Composition film;
  for (const DemonstrationId id : command.demonstrations) {
    if (!demonstration(id)) return log(Severity::kError, fmt::format("there is no demonstration {}", id.value));
    film::Source source = film::recording_of(fmt::format("{}", id.value));
    source.camera.view = film_view(command.camera);
    film.sources.push_back(std::move(source));
  }
  film.path = command.path.string();
  film.width = command.width;
  film.height = command.height;
  film.fps = command.fps;
  film.pace.speed = command.speed;
  film.codec = media::to_string(command.codec);
  film.layout = command.demonstrations.size() == 2 ? command.two : film::Layout::kSingle;
  if (command.demonstrations.size() == 2) film.pace.sync = command.sync;
  for (std::size_t i = 0; i < film::kOverlayCount && command.all_overlays; ++i) {
    film.overlays.set(static_cast<film::Overlay>(i));
  }
  if (!command.captions) film.overlays = {};
  start_film(std::move(film));
}

void Workbench::Impl::on(const RenderFilm& command) {
  if (command.film.path.empty()) return log(Severity::kError, "the film does not say where it goes");
  if (!project_open() || !is_output(command.film.path) || !succeeded(film::check(command.film))) return;
  start_film(command.film);
}

void Workbench::Impl::on(const SetFilm& command) {
  state.film = command.draft;
  dirty = true;
}

void Workbench::Impl::on(const PreviewFilm&) {
  if (!view) return;
  if (!film_preview) {
    film_preview = std::make_unique<FilmPreviewWorker>([] {
      auto maker = std::make_shared<FilmPreviewMaker>();
      return [maker](const FilmPreviewRequest& request) { return maker->make(request); };
    });
  }
  film_preview->request({look_of(state.film.film), state.film.at_s, state.project});
  state.film_preview_pending = true;
  dirty = true;
}

void Workbench::Impl::follow_film() {
  if (!film_preview) return;
  if (film_preview->update()) {
    state.film_preview = film_preview->answer();
    dirty = true;
  }
  state.film_preview_pending = film_preview->pending();
}

void Workbench::Impl::on(const OpenFilmJob& command) {
  const auto work = [this, path = command.path](Progress&) -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(path, kLargestFilmJob_bytes));
    Result<film::Composition> film = film::composition_from_json(text);
    if (!film) return tl::unexpected(std::move(film).error().at(path.string()));
    return JobResult{"read", [this, path, read = *film]() -> Status {
                       state.film = FilmDraft{read, 0.0, 0, path.string()};
                       state.film_file = FilmFile{path, read};
                       tell("Opened the film's job " + path.filename().string());
                       return {};
                     }};
  };
  editing.start("Open " + command.path.filename().string(), work, true);
}

void Workbench::Impl::on(const SaveFilmJob& command) {
  if (!is_output(command.path)) return;
  const auto work = [this, path = command.path, film = state.film.film](Progress&) -> Result<JobResult> {
    TROCAR_RETURN_IF_ERROR(write_file(path, film::to_json(film)));
    return JobResult{"written", [this, path, film]() -> Status {
                       state.film_file = FilmFile{path, film};
                       tell("Wrote the film's job " + path.filename().string());
                       return {};
                     }};
  };
  editing.start("Save " + command.path.filename().string(), work, true);
}

void Workbench::Impl::on(const PauseJob& command) {
  jobs.pause(command.id, command.paused);
  dirty = true;
}

}  // namespace trocar::workbench
