#include "engine/workbench/jobs/field_job.h"

#include <fmt/format.h>

#include "engine/exchange/field_hdf5.h"
#include "engine/media/picture_file.h"
#include "engine/workbench/insight.h"

namespace trocar::workbench {
namespace {

Result<figure::FieldFigureOptions> file_options(const FieldExport& request, const learning::Field& field) {
  figure::FieldFigureOptions options = figure_options(*request.model, field);
  const FieldFileLook& look = request.look;
  if (!request.slice.empty()) {
    TROCAR_ASSIGN_OR_RETURN(options.slice, figure::slice_from(request.slice, field.grid));
  }
  if (!look.preset.empty()) {
    TROCAR_ASSIGN_OR_RETURN(options.print, figure::print_from(look.preset));
    options.print->dpi = look.dpi.value_or(options.print->dpi);
  }
  options.scale = look.scale.value_or(options.scale);
  options.map = look.map.value_or(options.map);
  options.vision = look.vision;
  options.width_px = look.width_px;
  return options;
}

Status write_hdf5(const FieldExport& request, const learning::Field& field) {
  if (!request.slice.empty()) {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "an .h5 holds the whole lattice, and no slice").at(request.path.string()));
  }
  const ModelEntry& entry = *request.model;
  return exchange::write_field_hdf5(field,
                                    {{"model", entry.name},
                                     {"method", std::string(learning::to_string(entry.model->options.method))},
                                     {"segment", std::string(1, demonstration::letter(entry.segment))}},
                                    request.path);
}

}  // namespace

figure::FieldFigureOptions figure_options(const ModelEntry& entry, const learning::Field& field) {
  figure::FieldFigureOptions options = figure::suggested_options(field, *entry.model);
  options.subtitle =
      fmt::format("{}  ·  segment {}  ·  {}", entry.name, demonstration::letter(entry.segment), options.subtitle);
  return options;
}

bool is_drawn(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".png" || extension == ".svg" || extension == ".pdf";
}

Result<learning::Field> export_field(const FieldExport& request) {
  const std::string extension = request.path.extension().string();
  learning::Field field = field_of(*request.model->model, request.layer);
  TROCAR_ASSIGN_OR_RETURN(const figure::FieldFigureOptions options, file_options(request, field));
  if (extension == ".png") {
    const std::optional<double> dpi = options.print ? std::optional(options.print->dpi) : request.look.dpi;
    TROCAR_RETURN_IF_ERROR(media::write_png(request.path, figure::draw_field(field, options), dpi));
  } else if (extension == ".h5" || extension == ".hdf5") {
    TROCAR_RETURN_IF_ERROR(write_hdf5(request, field));
  } else {
    TROCAR_RETURN_IF_ERROR(figure::save_field(field, options, request.path));
  }
  return field;
}

}  // namespace trocar::workbench
