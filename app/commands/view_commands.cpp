#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/drawn_field.h"
#include "app/commands/print_arguments.h"
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

struct ViewArguments {
  std::string project;
  std::string demonstration;
  std::optional<double> at_s;
  std::string camera = "paper";
  std::string size = "960x540";
  std::string model;
  std::string beside;
  std::vector<std::string> also;
  FieldArguments field;
  bool path = false;
  int samples = 4;
  std::string preset;
  double dpi = 0.0;  ///< 0: not said.
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
  verb.add_option("--preset", arguments.preset,
                  "For print: column (88 mm wide) or page (180 mm), as high as --size says, with letters of 8 pt");
  verb.add_option("--dpi", arguments.dpi, kDpiHelp)->check(CLI::Range(kLeastDpi, kMostDpi));
  verb.add_option("--samples", arguments.samples, "Samples for each pixel")
      ->check(CLI::IsMember({1, 2, 4}))
      ->capture_default_str();
  verb.add_flag("--path", arguments.path, "Draw both tools' paths, coloured by segment");
  CLI::Option* model = verb.add_option("--model", arguments.model, "Draw a field of this model through its goal");
  verb.add_option("--beside", arguments.beside, "Another model's field, in the right half, on one scale with the first")
      ->needs(model);
  bind_field(verb, arguments.field, model);
  verb.add_option("--also", arguments.also,
                  "Another field besides, such as visits,voxels=0.6,opacity=0.3,mask=safe; any number of them")
      ->take_all()
      ->needs(model);
  verb.add_option("--out", arguments.out, "F.png")->required();
}

scene::CameraPreset preset_from(const std::string& text) {
  if (text == "top") return scene::CameraPreset::kTop;
  if (text == "side") return scene::CameraPreset::kSide;
  return text == "front" ? scene::CameraPreset::kFront : scene::CameraPreset::kPaper;
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
  request.camera = workbench::half_camera(request.camera);
  request.beside = {request.pose, request.paths, {std::move(layer)}};
  return {};
}

struct PictureSize {
  int width = 0;
  int height = 0;
  std::optional<double> letters_px;  ///< Of print.
  std::optional<double> dpi;         ///< What the picture says of itself.
};

/// Errors: kInvalidArgument for a size or a preset that is none, or more pixels than can be drawn.
Result<PictureSize> picture_size_of(const ViewArguments& arguments) {
  TROCAR_ASSIGN_OR_RETURN(const auto said, size_from(arguments.size));
  PictureSize size{said.first, said.second, {}, {}};
  if (arguments.dpi > 0.0) size.dpi = arguments.dpi;
  if (arguments.preset.empty()) return size;
  TROCAR_ASSIGN_OR_RETURN(figure::Print print, figure::print_from(arguments.preset));
  print.dpi = size.dpi.value_or(print.dpi);
  const double width = std::round(print.width_mm * figure::px_per_mm(print.dpi));
  const double height = std::round(width * said.second / said.first);
  TROCAR_ASSIGN_OR_RETURN(const auto drawn, size_from(fmt::format("{:.0f}x{:.0f}", width, height)));
  return PictureSize{drawn.first, drawn.second, print.text_pt / figure::pt_per_px(print.dpi), print.dpi};
}

Result<Answer> run_view(const ViewArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".png"}));
  TROCAR_ASSIGN_OR_RETURN(const PictureSize size, picture_size_of(arguments));
  TROCAR_ASSIGN_OR_RETURN(
      const workbench::ProjectFile file,
      open_to_read(arguments.project, console, arguments.model.empty() ? Models::kDescribed : Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_shown(*file.project(), arguments.demonstration));
  const double at_s = arguments.at_s.value_or(0.5 * (demonstration->begin_s + demonstration->end_s));
  if (!(at_s >= demonstration->begin_s && at_s <= demonstration->end_s)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("--at must lie in {:.2f} … {:.2f} s", demonstration->begin_s, demonstration->end_s));
  }

  workbench::ViewRequest request;
  request.pose = stage::pose_of(demonstration->sample_at(at_s));
  request.camera = scene::camera(preset_from(arguments.camera));
  request.options.highlighted_block = demonstration->recording->provenance.block;
  request.render = {.width = size.width, .height = size.height, .samples = arguments.samples};
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
    std::vector<stage::FieldLayer> besides;
    for (const std::string& text : arguments.also) {
      TROCAR_ASSIGN_OR_RETURN(const workbench::FieldSettings also, also_from(text));
      TROCAR_ASSIGN_OR_RETURN(stage::FieldLayer other, drawn_layer(*entry, also));
      besides.push_back(std::move(other));
    }
    request.options.lattice_frame = true;
    owner = fmt::format("{}, segment {}", entry->name, demonstration::letter(entry->segment));
    const stage::FieldLayer& drawn = request.fields.front();
    const int thickest = *std::max_element(drawn.slabs.begin(), drawn.slabs.end());
    if (thickest > 1) owner += fmt::format(", slices: {} of {}", learning::to_string(drawn.through), thickest);
    if (!arguments.beside.empty()) {
      TROCAR_ASSIGN_OR_RETURN(const auto second, find_model(*file.project(), arguments.beside));
      warn_if_stale(*file.project(), *second, console);
      TROCAR_RETURN_IF_ERROR(add_beside(*entry, *second, arguments.field, request));
      owner = fmt::format("left: {}, right: {}", owner, second->name);
    }
    // As in the window, what is besides comes first.
    request.fields.insert(request.fields.begin(), besides.begin(), besides.end());
  }
  TROCAR_ASSIGN_OR_RETURN(workbench::Studio studio, workbench::Studio::create());
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_ASSIGN_OR_RETURN(Image picture, studio.picture(request));
  // One below the other, what --layer says first.
  double below_px = 0.0;
  for (auto layer = request.fields.rbegin(); layer != request.fields.rend(); ++layer) {
    picture = figure::with_legend(picture, *layer->field, layer->colouring,
                                  layer == request.fields.rbegin() ? owner : std::string(), below_px, size.letters_px);
  }
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_RETURN_IF_ERROR(media::write_png(arguments.out, picture, size.dpi));

  Answer answer;
  answer.json = {{"out", arguments.out},
                 {"width", size.width},
                 {"height", size.height},
                 {"camera", arguments.camera},
                 {"at_s", at_s}};
  answer.summary = fmt::format("{}×{} at {:.2f} s, camera {}", size.width, size.height, at_s, arguments.camera);
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_view_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("view", "Pictures of the scene")->require_subcommand(1);
  add_verb<ViewArguments>(noun, chosen, "render", "Draw one moment of a demonstration", bind_view, run_view);
}

}  // namespace trocar::app
