#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/lookup.h"
#include "app/options.h"
#include "engine/figure/field_figure.h"
#include "engine/figure/legend.h"
#include "engine/learning/rollout.h"
#include "engine/learning/start_set.h"
#include "engine/media/picture_file.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/studio.h"

namespace trocar::app {
namespace {

/// How a field of a model is drawn: as in the panel Fields.
struct FieldArguments {
  std::string layer = "value";
  std::string scale;
  std::string map;
  std::string vision = "full";
  std::optional<double> voxels;
  std::optional<double> iso;
  bool volume = false;
  std::string glyphs = "none";
  std::string streamlines;
  bool no_slices = false;
  std::vector<std::string> slices;
  std::vector<double> limits;
  std::vector<int> slabs;
  float opacity = 0.8F;
};

void bind_field(CLI::App& verb, FieldArguments& arguments, CLI::Option* model) {
  const auto share = CLI::Range(0.0, 1.0);
  verb.add_option("--layer", arguments.layer, "Which field of the model")->capture_default_str()->needs(model);
  verb.add_option("--scale", arguments.scale, "linear, log, symlog, percentile or rank (else linear)")->needs(model);
  verb.add_option("--map", arguments.map, "Colour map (else what suits the layer)")->needs(model);
  verb.add_option("--vision", arguments.vision, "The colours as seen by full, protan, deutan, tritan or grey vision")
      ->capture_default_str()
      ->needs(model);
  verb.add_option("--voxels", arguments.voxels, "Draw cells from this share of the scale on, 0 to 1")
      ->check(share)
      ->needs(model);
  verb.add_option("--iso", arguments.iso, "Draw the surface at this share of the scale, 0 to 1")
      ->check(share)
      ->needs(model);
  verb.add_flag("--volume", arguments.volume, "Draw the field as a cloud")->needs(model);
  verb.add_option("--glyphs", arguments.glyphs, "On the slices: none, best (action) or stars (of Q)")
      ->check(CLI::IsMember({"none", "best", "stars"}))
      ->capture_default_str()
      ->needs(model);
  verb.add_option("--streamlines", arguments.streamlines,
                  "Draw where the policy leads from these starts, such as around:2 or face:z1")
      ->needs(model);
  CLI::Option* none = verb.add_flag("--no-slices", arguments.no_slices, "Draw no slice")->needs(model);
  verb.add_option("--slice", arguments.slices, "A slice, x=I, y=J or z=K; at most one for each axis (else the goal's)")
      ->needs(model)
      ->excludes(none);
  verb.add_option("--limits", arguments.limits, "Values at which the colours end (else the field's)")
      ->expected(2)
      ->needs(model);
  verb.add_option("--slab", arguments.slabs,
                  "Cells that slices are thick, one number or X,Y,Z: the largest value is shown (else 1)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000))
      ->needs(model);
  verb.add_option("--opacity", arguments.opacity, "Of the field, 0.05 to 1")
      ->check(CLI::Range(0.05, 1.0))
      ->capture_default_str()
      ->needs(model);
}

struct ViewArguments {
  std::string project;
  std::string demonstration;
  std::optional<double> at_s;
  std::string camera = "paper";
  std::string size = "960x540";
  std::string model;
  std::string beside;
  FieldArguments field;
  bool path = false;
  int samples = 4;
  std::string out;
};

void bind_view(CLI::App& verb, ViewArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Demonstration by id or name")->required();
  verb.add_option("--at", arguments.at_s, "Seconds since the recording began (default: the middle)");
  verb.add_option("--camera", arguments.camera, "paper, top, side or front")
      ->check(CLI::IsMember({"paper", "top", "side", "front"}))
      ->capture_default_str();
  verb.add_option("--size", arguments.size, "Width and height in pixels")->capture_default_str();
  verb.add_option("--samples", arguments.samples, "Samples for each pixel")
      ->check(CLI::IsMember({1, 2, 4}))
      ->capture_default_str();
  verb.add_flag("--path", arguments.path, "Draw both tools' paths, coloured by segment");
  CLI::Option* model = verb.add_option("--model", arguments.model, "Draw a field of this model through its goal");
  verb.add_option("--beside", arguments.beside, "Another model's field, in the right half, on one scale with the first")
      ->needs(model);
  bind_field(verb, arguments.field, model);
  verb.add_option("--out", arguments.out, "F.png")->required();
}

scene::CameraPreset preset_from(const std::string& text) {
  if (text == "top") return scene::CameraPreset::kTop;
  if (text == "side") return scene::CameraPreset::kSide;
  return text == "front" ? scene::CameraPreset::kFront : scene::CameraPreset::kPaper;
}

/// Errors: kInvalidArgument naming the option at fault.
Result<workbench::FieldSettings> settings_from(const FieldArguments& arguments, const learning::Model& model) {
  workbench::FieldSettings settings;
  TROCAR_ASSIGN_OR_RETURN(settings.layer, learning::layer_from(arguments.layer));
  if (!arguments.scale.empty()) {
    TROCAR_ASSIGN_OR_RETURN(settings.scale, plot::scale_kind_from(arguments.scale));
  }
  if (!arguments.map.empty()) {
    TROCAR_ASSIGN_OR_RETURN(settings.map, plot::colour_map_from(arguments.map));
  }
  TROCAR_ASSIGN_OR_RETURN(settings.vision, plot::colour_vision_from(arguments.vision));
  TROCAR_ASSIGN_OR_RETURN(settings.glyphs, stage::glyphs_from(arguments.glyphs));
  for (const std::string& text : arguments.slices) {
    TROCAR_ASSIGN_OR_RETURN(const figure::Slice slice, figure::slice_from(text, model.grid));
    settings.slices[static_cast<std::size_t>(slice.axis)] = slice.index;
  }
  if (!arguments.limits.empty()) {
    if (!(arguments.limits[0] < arguments.limits[1])) {
      return fail(ErrorCode::kInvalidArgument, "--limits takes the low one first, then a higher one");
    }
    settings.limits = {arguments.limits[0], arguments.limits[1]};
  }
  if (!arguments.no_slices && arguments.slices.empty()) {
    const spatial::CellCoordinates goal = model.grid.coordinates(model.goal);
    settings.slices = {goal.x, goal.y, goal.z};
  }
  if (arguments.slabs.size() == 1) settings.slabs.fill(arguments.slabs[0]);
  if (arguments.slabs.size() == 3) std::copy_n(arguments.slabs.begin(), 3, settings.slabs.begin());
  if (arguments.slabs.size() == 2 || arguments.slabs.size() > 3) {
    return fail(ErrorCode::kInvalidArgument, "--slab takes one number, or three: X,Y,Z");
  }
  settings.voxels = arguments.voxels.has_value();
  settings.voxel_threshold = arguments.voxels.value_or(settings.voxel_threshold);
  settings.iso_surface = arguments.iso.has_value();
  settings.iso_level = arguments.iso.value_or(settings.iso_level);
  settings.volume = arguments.volume;
  settings.opacity = arguments.opacity;
  settings.streamlines = !arguments.streamlines.empty();
  if (settings.streamlines) settings.streamline_starts = arguments.streamlines;
  return settings;
}

/// Errors: those of `settings_from`; kInvalidArgument for starts that the model cannot have, and for a surface or a
/// volume of classes.
Result<stage::FieldLayer> layer_of(const workbench::ModelEntry& entry, const FieldArguments& arguments) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::FieldSettings settings, settings_from(arguments, *entry.model));
  if (settings.streamlines) {
    TROCAR_ASSIGN_OR_RETURN(const auto ignored, learning::starts_from(settings.streamline_starts, *entry.model));
  }
  auto field = std::make_shared<const learning::Field>(workbench::field_of(*entry.model, settings.layer));
  if (field->categorical && (settings.iso_surface || settings.volume)) {
    return fail(ErrorCode::kInvalidArgument,
                "the layer " + arguments.layer + " is of classes, which have neither surface nor volume");
  }
  const auto policy = std::make_shared<const std::vector<std::uint8_t>>(learning::greedy_policy(*entry.model));
  return workbench::field_layer(std::move(field), settings, {entry.model, policy});
}

/// The second model's field to the right of the first's, which is in `request`, on the scale of both.
Status add_beside(const workbench::ModelEntry& first, const workbench::ModelEntry& second,
                  const FieldArguments& arguments, workbench::ViewRequest& request) {
  if (first.model->grid != second.model->grid) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} and {} have different lattices", first.name, second.name));
  }
  TROCAR_ASSIGN_OR_RETURN(stage::FieldLayer layer, layer_of(second, arguments));
  TROCAR_ASSIGN_OR_RETURN(const workbench::FieldSettings settings, settings_from(arguments, *first.model));
  stage::FieldLayer& left = request.fields.front();
  // Cut where the first is cut, also where its goal is another.
  layer.slices = left.slices;
  left.colouring = workbench::shared_colouring(*left.field, *layer.field, settings);
  layer.colouring = left.colouring;
  request.beside = {request.pose, request.paths, {std::move(layer)}};
  return {};
}

Result<Answer> run_view(const ViewArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".png"}));
  TROCAR_ASSIGN_OR_RETURN(const auto size, size_from(arguments.size));
  TROCAR_ASSIGN_OR_RETURN(
      const workbench::ProjectFile file,
      open_to_read(arguments.project, console, arguments.model.empty() ? Models::kDescribed : Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_demonstration(*file.project(), arguments.demonstration));
  const double at_s = arguments.at_s.value_or(0.5 * (demonstration->begin_s + demonstration->end_s));
  if (!(at_s >= demonstration->begin_s && at_s <= demonstration->end_s)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("--at must lie in {:.2f} … {:.2f} s", demonstration->begin_s, demonstration->end_s));
  }

  workbench::ViewRequest request;
  request.pose = stage::pose_of(demonstration->sample_at(at_s));
  request.camera = scene::camera(preset_from(arguments.camera));
  request.options.highlighted_block = demonstration->recording->provenance.block;
  request.render = {.width = size.first, .height = size.second, .samples = arguments.samples};
  if (arguments.path) {
    request.paths = std::make_shared<const std::vector<stage::PathLayer>>(
        std::vector{stage::path_of(*demonstration, kinematics::ArmSide::kLeft),
                    stage::path_of(*demonstration, kinematics::ArmSide::kRight)});
  }
  std::string owner;
  if (!arguments.model.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
    warn_if_stale(*file.project(), *entry, console);
    TROCAR_ASSIGN_OR_RETURN(stage::FieldLayer layer, layer_of(*entry, arguments.field));
    request.fields.push_back(std::move(layer));
    request.options.lattice_frame = true;
    owner = fmt::format("{}, segment {}", entry->name, demonstration::letter(entry->segment));
    if (!arguments.beside.empty()) {
      TROCAR_ASSIGN_OR_RETURN(const auto second, find_model(*file.project(), arguments.beside));
      warn_if_stale(*file.project(), *second, console);
      TROCAR_RETURN_IF_ERROR(add_beside(*entry, *second, arguments.field, request));
      owner = fmt::format("left: {}, right: {}", owner, second->name);
    }
  }
  TROCAR_ASSIGN_OR_RETURN(workbench::Studio studio, workbench::Studio::create());
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_ASSIGN_OR_RETURN(Image picture, studio.picture(request));
  for (const stage::FieldLayer& layer : request.fields) {
    picture = figure::with_legend(picture, *layer.field, layer.colouring, owner);
  }
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_RETURN_IF_ERROR(media::write_png(arguments.out, picture));

  Answer answer;
  answer.json = {{"out", arguments.out},
                 {"width", size.first},
                 {"height", size.second},
                 {"camera", arguments.camera},
                 {"at_s", at_s}};
  answer.summary = fmt::format("{}×{} at {:.2f} s, camera {}", size.first, size.second, at_s, arguments.camera);
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_view_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("view", "Pictures of the scene")->require_subcommand(1);
  add_verb<ViewArguments>(noun, chosen, "render", "Draw one moment of a demonstration", bind_view, run_view);
}

}  // namespace trocar::app
