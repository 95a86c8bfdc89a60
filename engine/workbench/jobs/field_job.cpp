#include "engine/workbench/jobs/field_job.h"

#include "engine/figure/field_figure.h"
#include "engine/media/picture_file.h"

namespace trocar::workbench {

Status export_field(const FieldExport& request) {
  const learning::Field field = learning::field(*request.model->model, request.layer);
  figure::FieldFigureOptions options = figure::suggested_options(field, *request.model->model);
  if (!request.slice.empty()) {
    TROCAR_ASSIGN_OR_RETURN(options.slice, figure::slice_from(request.slice, field.grid));
  }
  if (request.path.extension() == ".png") return media::write_png(request.path, figure::draw_field(field, options));
  return figure::save_field(field, options, request.path);
}

}  // namespace trocar::workbench
