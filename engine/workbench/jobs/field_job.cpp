#include "engine/workbench/jobs/field_job.h"

#include <fmt/format.h>

#include "engine/core/ending.h"
#include "engine/exchange/field_hdf5.h"
#include "engine/learning/model_comparison.h"
#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"
#include "engine/media/picture_file.h"
#include "engine/workbench/insight.h"

namespace trocar::workbench {
namespace {

Result<learning::Field> contrast_of(const FieldExport& request) {
  const learning::Model& a = *request.model->model;
  const learning::Model& b = *request.against->model;
  if (a.grid != b.grid) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} and {} have different lattices", request.model->name, request.against->name));
  }
  const std::vector<std::uint8_t> policy_a = learning::greedy_policy(a);
  const std::vector<std::uint8_t> policy_b = learning::greedy_policy(b);
  if (request.contrast == FieldContrast::kPolicy) return learning::policy_change(a.grid, policy_a, policy_b);
  const learning::Basin basin_a = learning::basin(a, policy_a);
  const learning::Basin basin_b = learning::basin(b, policy_b);
  if (request.contrast == FieldContrast::kOutcomes) return learning::paired_outcomes(a.grid, basin_a, basin_b);
  return learning::difference(learning::masked(field_of(a, request.layer), a, basin_a, request.mask),
                              learning::masked(field_of(b, request.layer), b, basin_b, request.mask));
}

Result<learning::Field> wanted_field(const FieldExport& request) {
  if (request.against) return contrast_of(request);
  const learning::Model& model = *request.model->model;
  return learning::masked(field_of(model, request.layer), model, learning::basin(model, learning::greedy_policy(model)),
                          request.mask);
}

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
  if (request.against) {
    options.subtitle = fmt::format("A {}  \u00b7  B {}  \u00b7  segment {}", request.model->name, request.against->name,
                                   demonstration::letter(request.model->segment));
    if (!field.categorical) options.map = plot::ColourMap::kDiverging;
  }
  options.scale = look.scale.value_or(options.scale);
  options.map = look.map.value_or(options.map);
  options.limits = look.limits;
  options.vision = look.vision;
  options.width_px = look.width_px;
  if (look.transparent) options.ground = figure::kNoPaper;
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
  const std::string extension = ending_of(path);
  return extension == ".png" || extension == ".svg" || extension == ".pdf";
}

Status write_field(const learning::Field& field, const figure::FieldFigureOptions& options,
                   const std::filesystem::path& path) {
  const std::string extension = ending_of(path);
  if (extension == ".png") {
    return media::write_png(path, figure::draw_field(field, options),
                            options.print ? std::optional(options.print->dpi) : std::nullopt);
  }
  if (extension == ".h5" || extension == ".hdf5") return exchange::write_field_hdf5(field, {}, path);
  return figure::save_field(field, options, path);
}

Result<learning::Field> export_field(const FieldExport& request) {
  const std::string extension = ending_of(request.path);
  TROCAR_ASSIGN_OR_RETURN(learning::Field field, wanted_field(request));
  TROCAR_ASSIGN_OR_RETURN(const figure::FieldFigureOptions options, file_options(request, field));
  if (request.slab > 1) {
    if (!options.slice || field.categorical) {
      return fail(ErrorCode::kInvalidArgument,
                  field.categorical ? "classes have no thick slices" : "a slab is of one slice: say which");
    }
    field = learning::with_slab(field, options.slice->axis, options.slice->index, request.slab, request.through);
    field.title += fmt::format(", {} of {} slices", learning::to_string(request.through), request.slab);
  }
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
