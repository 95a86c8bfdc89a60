#include "engine/workbench/jobs/film_job.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/core/file.h"
#include "engine/film/composition_json.h"
#include "engine/film/subtitles.h"
#include "engine/workbench/jobs/film_renderer.h"
#include "engine/workbench/jobs/film_sink.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {
namespace {

Status write_subtitles(const FilmRenderer& renderer, double fps, FilmReport& report) {
  std::vector<std::string> texts;
  for (int frame = 0; frame < renderer.frame_count(); ++frame) texts.push_back(renderer.caption_text(frame));
  const std::vector<film::Cue> cues = film::cues_of(texts, fps);
  report.subtitles = subtitles_beside(report.path, ".srt");
  report.web_subtitles = subtitles_beside(report.path, ".vtt");
  TROCAR_RETURN_IF_ERROR(write_file(report.subtitles, film::srt_of(cues)));
  return write_file(report.web_subtitles, film::vtt_of(cues));
}

/// Who made what is shown, with its hashes, and the job that makes the same film again; where it went is left out.
std::string comment_of(const FilmRenderer& renderer, film::Composition film) {
  std::string text;
  for (const std::string& credit : renderer.credits()) text += credit + "\n";
  film.path.clear();
  return text + "trocar video render, job: " + film::to_json(film);
}

Status draw_all(FilmRenderer& renderer, Studio& studio, FilmSink& sink, Progress& progress) {
  const int frames = renderer.frame_count();
  for (int frame = 0; frame < frames; ++frame) {
    progress.wait_while_paused();
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the film was cancelled");
    TROCAR_ASSIGN_OR_RETURN(Image picture, renderer.frame(studio, frame));
    TROCAR_RETURN_IF_ERROR(sink.add(std::move(picture)));
    progress.count(frame + 1, frames);
  }
  if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the film was cancelled");
  return {};
}

}  // namespace

bool needs_models(const film::Composition& film) {
  return std::any_of(film.sources.begin(), film.sources.end(), [](const film::Source& source) {
    const bool of_model = source.kind == film::SourceKind::kField || source.kind == film::SourceKind::kRollout;
    return of_model || source.field.has_value();
  });
}

Status check_film_file(const film::Composition& film, const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const media::Codec codec, media::codec_from(film.codec));
  const media::VideoOptions even{film.width + film.width % 2, film.height + film.height % 2, film.fps, codec};
  return check_film_sink(path, even, {film.crf, "", ""});
}

Result<FilmReport> render_film(const FilmJob& job, Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  FilmReport report;
  report.path = job.path.empty() ? std::filesystem::path(job.film.path) : job.path;
  if (report.path.empty()) return fail(ErrorCode::kInvalidArgument, "the film's job does not say where it goes");
  TROCAR_RETURN_IF_ERROR(film::check(job.film));
  TROCAR_RETURN_IF_ERROR(check_film_file(job.film, report.path));
  TROCAR_ASSIGN_OR_RETURN(const media::Codec codec, media::codec_from(job.film.codec));
  Diagnostics diagnostics;
  RolloutShelf shelf(progress);
  TROCAR_ASSIGN_OR_RETURN(FilmRenderer renderer, FilmRenderer::create(job.film, *job.project, diagnostics, &shelf));
  report.width = renderer.width();
  report.height = renderer.height();
  report.frames = renderer.frame_count();
  TROCAR_ASSIGN_OR_RETURN(const std::unique_ptr<FilmSink> sink,
                          open_film_sink(report.path, {report.width, report.height, job.film.fps, codec},
                                         {job.film.crf, renderer.title(), comment_of(renderer, job.film)}));
  TROCAR_ASSIGN_OR_RETURN(Studio studio, Studio::create());
  TROCAR_RETURN_IF_ERROR(draw_all(renderer, studio, *sink, progress));
  TROCAR_RETURN_IF_ERROR(sink->finish());
  if (job.film.overlays.has(film::Overlay::kCaptions)) {
    TROCAR_RETURN_IF_ERROR(write_subtitles(renderer, job.film.fps, report));
  }
  report.codec = sink->codec();
  report.warnings = diagnostics.warnings();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

}  // namespace trocar::workbench
