#include "app/commands/film_arguments.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/lookup.h"
#include "engine/core/file.h"
#include "engine/film/composition_json.h"
#include "engine/film/composition_words.h"
#include "engine/spatial/cell_text.h"

namespace trocar::app {
namespace {

constexpr std::size_t kLargestJob_bytes = std::size_t{1} << 20;

template <typename Value, std::size_t kCount>
std::vector<std::string> texts(const std::array<film::Word<Value>, kCount>& words) {
  std::vector<std::string> list;
  for (const film::Word<Value>& word : words) list.emplace_back(word.text);
  return list;
}

/// All views but that of poses, which only a job can list.
std::vector<std::string> cameras() {
  std::vector<std::string> list;
  for (const auto& word : film::kViews) {
    if (word.value != film::View::kPoses) list.emplace_back(word.text);
  }
  return list;
}

/// "title,timer"; "all"; "none".
Result<film::Overlays> overlays_from(const std::string& text) {
  film::Overlays overlays;
  if (text == "none") return overlays;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    const auto known = film::value_of(film::kOverlays, word);
    if (!known && word != "all") {
      return fail(ErrorCode::kInvalidArgument, fmt::format("no overlay is named \"{}\": there are {}, all and none",
                                                           word, film::list_of(film::kOverlays)));
    }
    for (const auto& each : film::kOverlays) {
      if (word == "all" || each.value == *known) overlays.set(each.value);
    }
  }
  return overlays;
}

/// "A exact@3,4,5".
film::Source rollout_from(const std::string& text) {
  film::Source source = film::recording_of(text);
  source.kind = film::SourceKind::kRollout;
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) return source;
  const auto cell = spatial::coordinates_from(std::string_view(text).substr(at + 1));
  // A name may have an @ of its own.
  if (!cell) return source;
  source.of = text.substr(0, at);
  source.start = {cell->x, cell->y, cell->z};
  return source;
}

Status apply(const FilmArguments& arguments, film::Composition& film) {
  if (arguments.size) {
    TROCAR_ASSIGN_OR_RETURN(const auto size, size_from(*arguments.size));
    std::tie(film.width, film.height) = size;
  }
  if (arguments.overlays) {
    TROCAR_ASSIGN_OR_RETURN(film.overlays, overlays_from(*arguments.overlays));
  }
  if (arguments.no_captions) film.overlays = {};
  film.fps = arguments.fps.value_or(film.fps);
  film.pace.speed = arguments.speed.value_or(film.pace.speed);
  film.codec = arguments.codec.value_or(film.codec);
  if (arguments.crf) film.crf = arguments.crf;
  if (arguments.layout) film.layout = *film::value_of(film::kLayouts, *arguments.layout);
  if (arguments.sync) film.pace.sync = *film::value_of(film::kSyncs, *arguments.sync);
  if (arguments.quality) film.quality = *film::value_of(film::kQualities, *arguments.quality);
  return {};
}

}  // namespace

void bind_film(CLI::App& verb, FilmArguments& arguments) {
  verb.add_option("DEMO", arguments.sources, "Demonstrations or trials, up to nine; or a job: F.json")->expected(1, 9);
  verb.add_option("--rollout", arguments.rollouts,
                  "MODEL or MODEL@I,J,K, more than once: what a model does in the simulator from a cell, or from where "
                  "its first expert began; after the demonstrations")
      ->allow_extra_args(false);
  std::vector<std::string> presets;
  for (const std::string_view name : film::preset_names()) presets.emplace_back(name);
  verb.add_option("--preset", arguments.preset, "What the other options begin from")->check(CLI::IsMember(presets));
  verb.add_option("--fps", arguments.fps, "Frames a second (30)");
  verb.add_option("--speed", arguments.speed, "Demonstration seconds for each second of film (1)");
  verb.add_option("--size", arguments.size, "Width and height in pixels, made even (1280x720)");
  verb.add_option("--layout", arguments.layout, "How the sources lie; without it, by their number")
      ->check(CLI::IsMember(texts(film::kLayouts)));
  verb.add_option("--sync", arguments.sync, "What begins together: all, each of A to E, or the grasp (clock)")
      ->check(CLI::IsMember(texts(film::kSyncs)));
  verb.add_option("--camera", arguments.camera, "Of all sources (paper)")->check(CLI::IsMember(cameras()));
  verb.add_option("--codec", arguments.codec, "auto, or one of `trocar doctor`'s");
  verb.add_option(
      "--crf", arguments.crf,
      "How much the file may lose: 1 to 51 for h264 (20), to 63 for vp9 (30) and av1 (32); less looks better");
  verb.add_option("--quality", arguments.quality, "fast, or fine: four samples a pixel")
      ->check(CLI::IsMember(texts(film::kQualities)));
  verb.add_option("--overlays", arguments.overlays,
                  "Such as title,timer,segment,authority; all; none. What a script made is marked in any case");
  verb.add_flag("--no-captions", arguments.no_captions, "The same as --overlays none");
}

bool is_film_job(const FilmArguments& arguments) {
  return arguments.sources.size() == 1 && std::filesystem::path(arguments.sources[0]).extension() == ".json";
}

Result<film::Composition> film_from(const FilmArguments& arguments) {
  film::Composition film;
  if (is_film_job(arguments)) {
    if (arguments.preset) return fail(ErrorCode::kInvalidArgument, "a job has no preset: it says all itself");
    if (!arguments.rollouts.empty()) {
      return fail(ErrorCode::kInvalidArgument, "a job lists its rollouts itself: --rollout is not for it");
    }
    TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(arguments.sources[0], kLargestJob_bytes));
    Result<film::Composition> job = film::composition_from_json(text);
    if (!job) return tl::unexpected(std::move(job).error().at(arguments.sources[0]));
    film = std::move(*job);
  } else {
    if (arguments.preset) {
      TROCAR_ASSIGN_OR_RETURN(film, film::preset_from(*arguments.preset));
    }
    for (const std::string& text : arguments.sources) film.sources.push_back(film::recording_of(text));
    for (const std::string& text : arguments.rollouts) film.sources.push_back(rollout_from(text));
    if (film.sources.empty()) {
      return fail(ErrorCode::kInvalidArgument, "what is filmed: say a demonstration, a trial, a --rollout or a job");
    }
    film.layout = film::layout_for(film.layout, film.sources.size());
  }
  TROCAR_RETURN_IF_ERROR(apply(arguments, film));
  if (arguments.camera) {
    for (film::Source& source : film.sources) source.camera.view = *film::value_of(film::kViews, *arguments.camera);
  }
  TROCAR_RETURN_IF_ERROR(film::check(film));
  return film;
}

}  // namespace trocar::app
