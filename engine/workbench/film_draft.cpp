#include "engine/workbench/film_draft.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "engine/core/check.h"

namespace trocar::workbench {

film::Composition look_of(film::Composition film) {
  film.path.clear();
  film.codec = film::Composition().codec;
  return film;
}

FilmDraft with_source(FilmDraft draft, film::Source source) {
  draft.film.sources.push_back(std::move(source));
  draft.source = draft.film.sources.size() - 1;
  draft.film.layout = film::layout_for(draft.film.layout, draft.film.sources.size());
  return draft;
}

FilmDraft without_source(FilmDraft draft) {
  TROCAR_CHECK(draft.source < draft.film.sources.size());
  draft.film.sources.erase(draft.film.sources.begin() + static_cast<std::ptrdiff_t>(draft.source));
  const std::size_t left = draft.film.sources.size();
  if (left > 0) draft.film.layout = film::layout_for(draft.film.layout, left);
  draft.source = std::min(draft.source, left == 0 ? 0 : left - 1);
  return draft;
}

FilmDraft with_key(FilmDraft draft, const scene::OrbitCamera& view) {
  TROCAR_CHECK(draft.source < draft.film.sources.size());
  film::CameraPath& path = draft.film.sources[draft.source].camera;
  const Eigen::Vector3d eye = view.camera().X_WC.p;
  film::CameraKey key;
  key.t_s = draft.at_s;
  key.eye_m = {eye.x(), eye.y(), eye.z()};
  key.target_m = {view.target.x(), view.target.y(), view.target.z()};
  // Two keys within a frame would be one that jumps.
  const double apart_s = 0.5 / draft.film.fps;
  std::erase_if(path.keys, [&](const film::CameraKey& other) { return std::abs(other.t_s - key.t_s) < apart_s; });
  const auto after = std::upper_bound(path.keys.begin(), path.keys.end(), key.t_s,
                                      [](double t_s, const film::CameraKey& other) { return t_s < other.t_s; });
  path.keys.insert(after, key);
  path.view = film::View::kPoses;
  return draft;
}

Result<std::vector<film::Composition>> films_of_session(const Project& project, const film::Composition& film) {
  std::size_t place = 0;
  std::vector<std::shared_ptr<const TrialEntry>> filmed;
  for (std::size_t i = 0; i < film.sources.size(); ++i) {
    if (film.sources[i].kind != film::SourceKind::kRecording) continue;
    for (const auto& [id, trial] : project.trials) {
      if (trial->name != film.sources[i].of && std::to_string(id.value) != film.sources[i].of) continue;
      filmed.push_back(trial);
      place = i;
    }
  }
  if (filmed.size() != 1) {
    return fail(ErrorCode::kInvalidArgument, "the films of a session are like a film of one of its trials");
  }
  const std::filesystem::path path = film.path;
  if (film.path.find('%') != std::string::npos) {
    return fail(ErrorCode::kInvalidArgument, "the films of a session are no rows of pictures");
  }
  std::vector<film::Composition> films;
  for (const auto& [id, trial] : project.trials) {
    if (trial->record.session != filmed.front()->record.session || trial->excluded) continue;
    std::string name = trial->name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    film::Composition one = film;
    one.sources[place].of = std::to_string(id.value);
    one.path = path.parent_path() / (path.stem().string() + "_" + name + path.extension().string());
    films.push_back(std::move(one));
  }
  return films;
}

}  // namespace trocar::workbench
