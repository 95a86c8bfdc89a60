#include "ui/film_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "engine/film/composition_words.h"
#include "engine/workbench/jobs/film_job.h"
#include "ui/command_text.h"
#include "ui/forms/export_parts.h"

namespace trocar::ui {
namespace {

using film::Composition;
using film::Source;

/// The command line films recordings and after them rollouts, all by one camera that has no numbers of its own.
bool words_say(const Composition& film) {
  if (film.sources.empty()) return false;
  const film::View view = film.sources.front().camera.view;
  const bool plain = std::all_of(film.sources.begin(), film.sources.end(), [view](const Source& source) {
    Source same = film::recording_of(source.of);
    same.camera.view = view;
    if (source.kind == film::SourceKind::kRollout) {
      same.kind = source.kind;
      same.start = source.start;
    }
    return source == same;
  });
  const auto is_rollout = [](const Source& source) { return source.kind == film::SourceKind::kRollout; };
  if (!std::is_partitioned(film.sources.begin(), film.sources.end(), std::not_fn(is_rollout))) return false;
  if (!plain || view == film::View::kPoses) return false;
  if (film::layout_for(film.layout, film.sources.size()) != film.layout) return false;
  const Composition usual;
  film::Pace pace;
  pace.speed = film.pace.speed;
  pace.sync = film.pace.sync;
  return film.pace == pace && film.corner == usual.corner && film.share == usual.share && film.share_keys.empty();
}

std::string overlay_words(const film::Overlays& overlays) {
  std::string list;
  bool all = true;
  for (const auto& word : film::kOverlays) {
    all = all && overlays.has(word.value);
    if (overlays.has(word.value)) list += (list.empty() ? "" : ",") + std::string(word.text);
  }
  return all ? "all" : list.empty() ? "none" : list;
}

}  // namespace

std::string film_text(const Composition& film, const workbench::WorkbenchState& state) {
  const std::string begin = "trocar video render " + shell_word(state.path.string());
  if (state.film_file && state.film_file->film == film) {
    return fmt::format("{} {}", begin, shell_word(state.film_file->path.string()));
  }
  if (!words_say(film)) return "";
  std::string text = begin;
  for (const Source& source : film.sources) {
    const std::string start = source.start ? fmt::format("@{}", fmt::join(*source.start, ",")) : "";
    text += (source.kind == film::SourceKind::kRollout ? " --rollout " : " ") + shell_word(source.of + start);
  }
  text += fmt::format(" --out {} --size {}x{} --fps {:g} --layout {}", shell_word(film.path), film.width, film.height,
                      film.fps, film::word_of(film::kLayouts, film.layout));
  const Composition usual;
  if (film.pace.sync != usual.pace.sync) text += fmt::format(" --sync {}", film::word_of(film::kSyncs, film.pace.sync));
  if (film.pace.speed != 1.0) text += fmt::format(" --speed {:g}", film.pace.speed);
  const film::View view = film.sources.front().camera.view;
  if (view != film::View::kPaper) text += fmt::format(" --camera {}", film::word_of(film::kViews, view));
  if (film.codec != usual.codec) text += " --codec " + film.codec;
  if (film.crf) text += fmt::format(" --crf {}", *film.crf);
  if (film.quality != usual.quality)
    text += fmt::format(" --quality {}", film::word_of(film::kQualities, film.quality));
  if (film.overlays != usual.overlays) text += " --overlays " + overlay_words(film.overlays);
  return text;
}

std::string film_text(const workbench::ExportVideo& video, const std::string& project) {
  constexpr std::array<const char*, 4> kCameras{"paper", "top", "side", "front"};
  std::string ids;
  for (const workbench::DemonstrationId id : video.demonstrations) ids += fmt::format(" {}", id.value);
  std::string text = fmt::format("trocar video render {}{} --out {} --fps {:g} --size {}x{} --layout {}", project, ids,
                                 shell_word(video.path.string()), video.fps, video.width, video.height,
                                 video.demonstrations.size() > 1 ? film::word_of(film::kLayouts, video.two) : "single");
  if (video.demonstrations.size() > 1 && video.sync != film::Sync::kClock) {
    text += fmt::format(" --sync {}", film::word_of(film::kSyncs, video.sync));
  }
  if (video.speed != 1.0) text += fmt::format(" --speed {:g}", video.speed);
  if (video.camera != scene::CameraPreset::kPaper) {
    text += fmt::format(" --camera {}", kCameras[static_cast<std::size_t>(video.camera)]);
  }
  if (video.codec != media::Codec::kAuto) text += fmt::format(" --codec {}", media::to_string(video.codec));
  if (!video.captions) text += " --no-captions";
  if (video.captions && video.all_overlays) text += " --overlays all";
  return text;
}

std::string film_reason(const workbench::WorkbenchState& state) {
  if (state.project == nullptr) return "Open a project first";
  const Composition& film = state.film.film;
  if (film.sources.empty()) return "Add a source: what is to be filmed";
  if (const Status fine = film::check(film); !fine) return fine.error().text();
  const auto& preview = state.film_preview;
  if (preview && !preview->error.empty() && preview->of == workbench::look_of(film)) return preview->error;
  if (std::string why = reason_against_path(film.path, state); !why.empty()) return why;
  const Status fine = workbench::check_film_file(film, film.path);
  return fine ? "" : fine.error().text();
}

}  // namespace trocar::ui
