#include "engine/workbench/film_draft.h"

#include <algorithm>
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

}  // namespace trocar::workbench
