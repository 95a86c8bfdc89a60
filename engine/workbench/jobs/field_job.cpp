#include "engine/workbench/jobs/field_job.h"

#include <fmt/format.h>

#include "engine/media/picture_file.h"

namespace trocar::workbench {

figure::FieldFigureOptions figure_options(const ModelEntry& entry, const learning::Field& field) {
  figure::FieldFigureOptions options = figure::suggested_options(field, *entry.model);
  options.subtitle =
      fmt::format("{}  ·  segment {}  ·  {}", entry.name, demonstration::letter(entry.segment), options.subtitle);
  return options;
}

Status export_field(const FieldExport& request) {
  const learning::Field field = learning::field(*request.model->model, request.layer);
  figure::FieldFigureOptions options = figure_options(*request.model, field);
  if (!request.slice.empty()) {
    TROCAR_ASSIGN_OR_RETURN(options.slice, figure::slice_from(request.slice, field.grid));
  }
  if (request.path.extension() == ".png") return media::write_png(request.path, figure::draw_field(field, options));
  return figure::save_field(field, options, request.path);
}

}  // namespace trocar::workbench
