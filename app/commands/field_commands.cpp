#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/print_arguments.h"
#include "app/lookup.h"
#include "app/options.h"
#include "engine/workbench/jobs/field_job.h"

namespace trocar::app {
namespace {

struct ExportFieldArguments {
  std::string project;
  std::string model;
  std::string layer = "reward";
  std::string mask = "none";
  std::string against;
  std::string contrast = "difference";
  std::string slice;
  bool montage = false;
  std::string scale;
  std::string map;
  std::string vision = "full";
  std::vector<double> limits;
  int width = 1000;
  std::string preset;
  bool transparent = false;
  int slab = 1;
  std::string through = "largest";
  double dpi = 0.0;
  std::string out;
  std::vector<const CLI::Option*> of_pictures;  ///< What says how a picture looks, and numbers cannot heed.
};

void bind_field_export(CLI::App& verb, ExportFieldArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.model, "Id or name")->required();
  std::string layers;
  for (const learning::Layer layer : learning::all_layers()) {
    layers += (layers.empty() ? "" : ", ") + std::string(learning::to_string(layer));
  }
  verb.add_option("--layer", arguments.layer, "One of " + layers)->capture_default_str();
  verb.add_option("--mask", arguments.mask, "Write cells of none (all), safe, expert, visited or arrives alone")
      ->capture_default_str();
  CLI::Option* against =
      verb.add_option("--against", arguments.against, "Write what this model (B) changes against MODEL (A)");
  verb.add_option("--show", arguments.contrast, "Of the two: difference (of the layer, B − A), policy or outcomes")
      ->capture_default_str()
      ->needs(against);
  CLI::Option* slice = verb.add_option("--slice", arguments.slice, "One slice: x=I, y=J or z=K");
  arguments.of_pictures = {
      verb.add_flag("--montage", arguments.montage, "All slices along z (without --slice)")->excludes(slice),
      verb.add_option("--scale", arguments.scale,
                      "linear, log, symlog, percentile or rank (else what suits the layer)"),
      verb.add_option("--map", arguments.map, "Colour map (else what suits the layer)"),
      verb.add_option("--limits", arguments.limits, "Values at which the colours end (else the field's)")->expected(2),
      verb.add_option("--vision", arguments.vision,
                      "The colours as seen by full, protan, deutan, tritan or grey vision")
          ->capture_default_str(),
      verb.add_option("--preset", arguments.preset, kPresetHelp),
      verb.add_flag("--transparent", arguments.transparent, kTransparentHelp),
      verb.add_option("--dpi", arguments.dpi, kDpiHelp)->check(CLI::Range(kLeastDpi, kMostDpi))};
  verb.add_option("--slab", arguments.slab, "Cells that the slice is thick, in pictures and numbers (else 1)")
      ->check(CLI::Range(1, 1000))
      ->needs(slice);
  verb.add_option("--through", arguments.through, "What is written of a thick slice: the largest value, or the mean")
      ->check(CLI::IsMember({"largest", "mean"}))
      ->capture_default_str()
      ->needs("--slab");
  CLI::Option* width = verb.add_option("--width", arguments.width, "Width of the picture in pixels")
                           ->check(CLI::Range(100, 8192))
                           ->capture_default_str()
                           ->excludes("--preset");
  arguments.of_pictures.push_back(width);
  verb.add_option("--out", arguments.out,
                  "F.png, F.svg or F.pdf; or the numbers: F.csv, F.npy, F.vti (VTK) or F.h5 (HDF5)")
      ->required();
}

/// Errors: kInvalidArgument for an option that would be ignored.
Status check_heeded(const ExportFieldArguments& arguments) {
  const std::filesystem::path out = arguments.out;
  if (workbench::is_drawn(out)) return check_dpi(arguments.dpi, out);
  for (const CLI::Option* option : arguments.of_pictures) {
    if (option->count() == 0) continue;
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, option->get_name() + " is of pictures; this file holds numbers")
            .at(arguments.out));
  }
  return {};
}

/// What a figure of it shows: the range of numbers, or how many cells each category has.
std::string contents(const learning::Field& field) {
  const auto known = [](double value) { return std::isfinite(value); };
  if (std::none_of(field.values.begin(), field.values.end(), known)) return field.title + ": no cell is known";
  if (!field.categorical) return fmt::format("{} from {:.4g} to {:.4g}", field.title, field.low(), field.high());
  std::string text = field.title;
  for (std::size_t category = 0; category < field.categories.size(); ++category) {
    const auto count = std::count(field.values.begin(), field.values.end(), static_cast<double>(category));
    text += fmt::format("{}{} {}", category == 0 ? ": " : ", ", field.categories[category], count);
  }
  return text;
}

Result<workbench::FieldExport> request_of(const ExportFieldArguments& arguments) {
  workbench::FieldExport request;
  TROCAR_ASSIGN_OR_RETURN(request.layer, learning::layer_from(arguments.layer));
  TROCAR_ASSIGN_OR_RETURN(request.mask, learning::field_mask_from(arguments.mask));
  TROCAR_ASSIGN_OR_RETURN(request.contrast, workbench::field_contrast_from(arguments.contrast));
  request.slice = arguments.slice;
  request.path = arguments.out;
  if (!arguments.scale.empty()) {
    TROCAR_ASSIGN_OR_RETURN(request.look.scale, plot::scale_kind_from(arguments.scale));
  }
  if (!arguments.map.empty()) {
    TROCAR_ASSIGN_OR_RETURN(request.look.map, plot::colour_map_from(arguments.map));
  }
  if (!arguments.limits.empty()) {
    if (!(arguments.limits[0] < arguments.limits[1])) {
      return fail(ErrorCode::kInvalidArgument, "--limits takes the low one first, then a higher one");
    }
    request.look.limits = {arguments.limits[0], arguments.limits[1]};
  }
  TROCAR_ASSIGN_OR_RETURN(request.look.vision, plot::colour_vision_from(arguments.vision));
  request.slab = arguments.slab;
  TROCAR_ASSIGN_OR_RETURN(request.through, learning::through_from(arguments.through));
  request.look.width_px = arguments.width;
  request.look.preset = arguments.preset;
  request.look.transparent = arguments.transparent;
  if (arguments.dpi > 0.0) request.look.dpi = arguments.dpi;
  return request;
}

Result<Answer> run_field_export(const ExportFieldArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(
      check_output(arguments.out, arguments.project, {".png", ".svg", ".pdf", ".csv", ".npy", ".vti", ".h5", ".hdf5"}));
  TROCAR_RETURN_IF_ERROR(check_heeded(arguments));
  TROCAR_ASSIGN_OR_RETURN(workbench::FieldExport request, request_of(arguments));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(request.model, find_model(*file.project(), arguments.model));
  warn_if_stale(*file.project(), *request.model, console);
  if (!arguments.against.empty()) {
    TROCAR_ASSIGN_OR_RETURN(request.against, find_model(*file.project(), arguments.against));
    warn_if_stale(*file.project(), *request.against, console);
    warn_if_unlike(*request.model, *request.against, console);
  }
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_ASSIGN_OR_RETURN(const learning::Field field, workbench::export_field(request));
  const std::filesystem::path& out = request.path;
  std::error_code ignored;
  Answer answer;
  answer.json = {{"layer", learning::to_string(request.layer)},
                 {"out", arguments.out},
                 {"low", field.low()},
                 {"high", field.high()},
                 {"unit", field.unit},
                 {"size_bytes", std::filesystem::file_size(out, ignored)}};
  answer.summary = contents(field);
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_field_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("field", "Reward, value, Q, visits … over the lattice")->require_subcommand(1);
  add_verb<ExportFieldArguments>(noun, chosen, "export", "Write one layer as a figure or as numbers", bind_field_export,
                                 run_field_export);
}

}  // namespace trocar::app
