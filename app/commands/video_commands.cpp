#include <fmt/format.h>

#include "app/commands/film_arguments.h"
#include "app/lookup.h"
#include "app/options.h"
#include "engine/core/file.h"
#include "engine/film/composition_json.h"
#include "engine/workbench/film_draft.h"
#include "engine/workbench/jobs/film_job.h"
#include "engine/workbench/jobs/film_sink.h"

namespace trocar::app {
namespace {

struct RenderArguments {
  std::string project;
  FilmArguments film;
  std::string out;
  std::string write_job;
  bool session = false;
};

void bind_render(CLI::App& verb, RenderArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  bind_film(verb, arguments.film);
  verb.add_option("--out", arguments.out, "F.mp4 (or .mkv, .webm, .avi, .gif), or pictures: F_%05d.png");
  verb.add_option("--write-job", arguments.write_job, "F.json: write what the options mean as a job, and no film");
  verb.add_flag("--all-of-session", arguments.session,
                "Of a film of one trial: one like it of each trial of its session, F_SC_1.mp4 and so on");
}

/// In the words of the other commands, with what may have been meant.
Status check_sources(const film::Composition& film, const workbench::Project& project, Console& console) {
  for (const film::Source& source : film.sources) {
    const bool of_model = source.kind == film::SourceKind::kField || source.kind == film::SourceKind::kRollout;
    if (!of_model) TROCAR_RETURN_IF_ERROR(find_shown(project, source.of));
    for (const std::string& name : {of_model ? source.of : "", source.field ? source.field->of : ""}) {
      if (name.empty()) continue;
      TROCAR_ASSIGN_OR_RETURN(const auto model, find_model(project, name));
      warn_if_stale(project, *model, console);
    }
  }
  return {};
}

Result<Answer> written(const RenderArguments& arguments, const film::Composition& film) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.write_job, arguments.project, {".json"}));
  TROCAR_RETURN_IF_ERROR(write_file(arguments.write_job, film::to_json(film)));
  Answer answer;
  answer.json = {{"job", arguments.write_job}, {"sources", film.sources.size()}};
  answer.summary = fmt::format("a job of {}", counted(film.sources.size(), "source"));
  answer.text = fmt::format("Wrote {}: {}", arguments.write_job, answer.summary);
  return answer;
}

Result<Answer> rendered(const film::Composition& film, const std::shared_ptr<const workbench::Project>& project,
                        Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::FilmReport report,
                          workbench::render_film({film, project, {}}, console.progress()));
  for (const std::string& warning : report.warnings) console.diagnostics.warn(warning);

  std::error_code ignored;
  Answer answer;
  answer.json = {{"frames", report.frames}, {"seconds", report.frames / film.fps},
                 {"codec", report.codec},   {"wall_seconds", report.seconds},
                 {"width", report.width},   {"height", report.height}};
  if (!workbench::is_picture_row(report.path)) {
    answer.json["size_bytes"] = std::filesystem::file_size(report.path, ignored);
  }
  answer.json["srt"] = report.subtitles.empty() ? Json(nullptr) : Json(report.subtitles.string());
  answer.json["vtt"] = report.web_subtitles.empty() ? Json(nullptr) : Json(report.web_subtitles.string());
  answer.json["out"] = film.path;
  answer.summary = fmt::format("{} frames of {}×{}, {:.1f} s, {}", report.frames, report.width, report.height,
                               report.frames / film.fps, report.codec);
  answer.text = fmt::format("Wrote {}: {}", film.path, answer.summary);
  for (const std::filesystem::path& path : {report.subtitles, report.web_subtitles}) {
    if (!path.empty()) answer.text += fmt::format("\nWrote {}", path.string());
  }
  return answer;
}

Result<Answer> run_render(const RenderArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(film::Composition film, film_from(arguments.film));
  if (!arguments.out.empty()) film.path = arguments.out;
  if (film.path.empty() && arguments.write_job.empty()) {
    return fail(ErrorCode::kInvalidArgument, "where does the film go: say --out F.mp4");
  }
  if (!film.path.empty()) {
    TROCAR_RETURN_IF_ERROR(check_output(film.path, arguments.project));
    for (const char* ending : {".srt", ".vtt"}) {
      if (!film.overlays.has(film::Overlay::kCaptions)) break;
      TROCAR_RETURN_IF_ERROR(check_output(workbench::subtitles_beside(film.path, ending), arguments.project));
    }
  }
  TROCAR_ASSIGN_OR_RETURN(
      const workbench::ProjectFile file,
      open_to_read(arguments.project, console, workbench::needs_models(film) ? Models::kWhole : Models::kDescribed));
  TROCAR_RETURN_IF_ERROR(check_sources(film, *file.project(), console));
  if (!arguments.write_job.empty()) return written(arguments, film);
  if (!arguments.session) return rendered(film, file.project(), console);
  TROCAR_ASSIGN_OR_RETURN(const auto films, workbench::films_of_session(*file.project(), film));
  Answer all;
  all.json["films"] = Json::array();
  for (const film::Composition& one : films) {
    TROCAR_ASSIGN_OR_RETURN(const Answer answer, rendered(one, file.project(), console));
    all.json["films"].push_back(answer.json);
    all.text += answer.text + "\n";
  }
  all.summary = counted(films.size(), "film");
  all.text += all.summary;
  return all;
}

}  // namespace

void add_video_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("video", "Films of demonstrations, trials and rollouts")->require_subcommand(1);
  add_verb<RenderArguments>(noun, chosen, "render", "Film demonstrations, trials and rollouts, or a job", bind_render,
                            run_render);
}

}  // namespace trocar::app
