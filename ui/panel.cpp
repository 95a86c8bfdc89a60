#include "ui/panel.h"

#include "ui/panels/activity_panels.h"
#include "ui/panels/curves_panel.h"
#include "ui/panels/diff_panel.h"
#include "ui/panels/edits_panel.h"
#include "ui/panels/export_panel.h"
#include "ui/panels/fields_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/library_panel.h"
#include "ui/panels/models_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/rollouts_panel.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/train_panel.h"
#include "ui/panels/trials_panel.h"
#include "ui/panels/view_panel.h"

namespace trocar::ui {

std::unique_ptr<Panel> make_panel(PanelId panel, const std::shared_ptr<SharedTime>& time) {
  switch (panel) {
    case PanelId::kLibrary:
      return std::make_unique<LibraryPanel>();
    case PanelId::kView:
      return std::make_unique<ViewPanel>();
    case PanelId::kTimeline:
      return std::make_unique<TimelinePanel>(time);
    case PanelId::kFields:
      return std::make_unique<FieldsPanel>();
    case PanelId::kRollouts:
      return std::make_unique<RolloutsPanel>();
    case PanelId::kTrain:
      return std::make_unique<TrainPanel>();
    case PanelId::kInspector:
      return std::make_unique<InspectorPanel>();
    case PanelId::kHistory:
      return std::make_unique<HistoryPanel>();
    case PanelId::kJobs:
      return std::make_unique<JobsPanel>();
    case PanelId::kLog:
      return std::make_unique<LogPanel>();
    case PanelId::kEdits:
      return std::make_unique<EditsPanel>();
    case PanelId::kProblems:
      return std::make_unique<ProblemsPanel>();
    case PanelId::kCurves:
      return std::make_unique<CurvesPanel>(time);
    case PanelId::kModels:
      return std::make_unique<ModelsPanel>();
    case PanelId::kTrials:
      return std::make_unique<TrialsPanel>();
    case PanelId::kExport:
      return std::make_unique<ExportPanel>();
    case PanelId::kDiff:
      return std::make_unique<DiffPanel>(time);
  }
  return nullptr;
}

}  // namespace trocar::ui
