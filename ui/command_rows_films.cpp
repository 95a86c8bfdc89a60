// Rows of films: keys of a camera, and the film that is being made into the queue.
#include "ui/command_rows.h"
#include "ui/film_text.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

std::string cannot_add_key(const State& state) {
  const FilmDraft& draft = state.film;
  if (draft.source >= draft.film.sources.size()) return "The film has no source yet";
  const film::SourceKind kind = draft.film.sources[draft.source].kind;
  const bool scene = kind == film::SourceKind::kRecording || kind == film::SourceKind::kRollout;
  return scene ? "" : "Only a recording or a rollout has a camera";
}

Requests add_key(const State& state) {
  return one(Command{SetFilm{with_key(state.film, state.orbit)}});
}
Requests queue_film(const State& state) {
  return {Command{RenderFilm{state.film.film}}, ShowPanel{PanelId::kExport}};
}

constexpr std::array<RowData, 2> kFilmRows{{
    {"film.queue",
     "Edit",
     "Add film to the queue",
     "The film in the panel Export is rendered, behind what runs already",
     icon::kFilm,
     {},
     true,
     film_reason,
     queue_film},
    {"film.key",
     "Edit",
     "Add key from view",
     "The camera of the film's source is where the 3-D view's is, at the instant that Export shows",
     icon::kCamera,
     {"Ctrl+Shift+K"},
     false,
     cannot_add_key,
     add_key},
}};

}  // namespace

std::span<const RowData> film_rows() {
  return kFilmRows;
}

}  // namespace trocar::ui
