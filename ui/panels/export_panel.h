/// Export: the film that is being made, how it looks at an instant, and the queue of films.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/panel.h"
#include "ui/panels/export_sources.h"

namespace trocar::ui {

class ExportPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_preview(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft);
  void draw_file(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft, Requests& requests);
  void draw_job(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft, Requests& requests);
  /// Asks for the picture anew if it is of another film, instant or document.
  void ask_for_preview(const WorkbenchState& state, Requests& requests);

  int page_ = 0;
  int keys_of_ = 0;
  AddedSource added_;
  film::Composition asked_;  ///< What the picture was last asked for of …
  double asked_at_s_ = 0.0;
  std::shared_ptr<const workbench::Project> asked_in_;  ///< … null: of nothing yet.
};

}  // namespace trocar::ui
