#include "engine/workbench/jobs/film_pane.h"

#include "engine/workbench/jobs/film_panels.h"
#include "engine/workbench/jobs/film_recording.h"

namespace trocar::workbench {

Result<std::unique_ptr<FilmPane>> make_pane(const FilmSource& source, const PaneLook& look) {
  switch (source.said.kind) {
    case film::SourceKind::kField:
      return FieldPane::create(source, look);
    case film::SourceKind::kCurve:
      return CurvePane::create(source, look);
    case film::SourceKind::kRecording:
    case film::SourceKind::kRollout:
      break;
  }
  return RecordingPane::create(source, look);
}

}  // namespace trocar::workbench
