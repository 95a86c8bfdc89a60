#include <fmt/format.h>

#include "app/lookup.h"
#include "app/options.h"
#include "engine/workbench/jobs/film_job.h"

namespace trocar::app {
namespace {

struct RenderArguments {
  std::string project;
  std::vector<std::string> demonstrations;
  std::string out;
  double fps = 30.0;
  double speed = 1.0;
  std::string size = "1280x720";
  std::string layout;
  std::string camera = "paper";
  std::string codec = "auto";
  bool no_captions = false;
};

const std::map<std::string, scene::CameraPreset> kCameras = {{"paper", scene::CameraPreset::kPaper},
                                                             {"top", scene::CameraPreset::kTop},
                                                             {"side", scene::CameraPreset::kSide},
                                                             {"front", scene::CameraPreset::kFront}};

void bind_render(CLI::App& verb, RenderArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstrations, "One demonstration, or two side by side")
      ->required()
      ->expected(1, 2);
  verb.add_option("--out", arguments.out, "F.mp4 (or .mkv, .avi)")->required();
  verb.add_option("--fps", arguments.fps, "Frames a second")->capture_default_str();
  verb.add_option("--speed", arguments.speed, "Demonstration seconds for each second of film")->capture_default_str();
  verb.add_option("--size", arguments.size, "Width and height in pixels, both even")->capture_default_str();
  verb.add_option("--layout", arguments.layout, "single or side-by-side")
      ->check(CLI::IsMember({"single", "side-by-side"}));
  verb.add_option("--camera", arguments.camera, "paper, top, side or front")
      ->check(CLI::IsMember(kCameras))
      ->capture_default_str();
  verb.add_option("--codec", arguments.codec, "auto, or one of `trocar doctor`'s")->capture_default_str();
  verb.add_flag("--no-captions", arguments.no_captions, "Leave the picture bare");
}

Result<Answer> run_render(const RenderArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project));
  const std::size_t count = arguments.demonstrations.size();
  if (!arguments.layout.empty() && (arguments.layout == "single") != (count == 1)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the layout {} does not fit {}", arguments.layout, counted(count, "demonstration")));
  }
  workbench::FilmJob job;
  TROCAR_ASSIGN_OR_RETURN(const auto size, size_from(arguments.size));
  std::tie(job.width, job.height) = size;
  if (arguments.codec != "auto") {
    TROCAR_ASSIGN_OR_RETURN(job.codec, media::codec_from(arguments.codec));
  }
  job.path = arguments.out;
  job.fps = arguments.fps;
  job.speed = arguments.speed;
  job.camera = kCameras.at(arguments.camera);
  job.captions = !arguments.no_captions;
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  for (const std::string& text : arguments.demonstrations) {
    TROCAR_ASSIGN_OR_RETURN(auto demonstration, find_shown(*file.project(), text));
    job.demonstrations.push_back(std::move(demonstration));
  }
  TROCAR_ASSIGN_OR_RETURN(const workbench::FilmReport report, workbench::render_film(job, console.progress()));

  const std::string codec(media::to_string(report.codec));
  std::error_code ignored;
  Answer answer;
  answer.json = {{"frames", report.frames},
                 {"seconds", report.frames / arguments.fps},
                 {"codec", codec},
                 {"wall_seconds", report.seconds},
                 {"width", job.width},
                 {"height", job.height},
                 {"size_bytes", std::filesystem::file_size(job.path, ignored)},
                 {"out", arguments.out}};
  answer.summary = fmt::format("{} frames of {}×{}, {:.1f} s, {}", report.frames, job.width, job.height,
                               report.frames / arguments.fps, codec);
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_video_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("video", "Films of demonstrations")->require_subcommand(1);
  add_verb<RenderArguments>(noun, chosen, "render", "Film one demonstration, or two side by side", bind_render,
                            run_render);
}

}  // namespace trocar::app
