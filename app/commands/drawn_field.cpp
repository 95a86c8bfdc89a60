#include "app/commands/drawn_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/figure/field_figure.h"
#include "engine/learning/rollout.h"
#include "engine/learning/start_set.h"
#include "engine/workbench/insight.h"

namespace trocar::app {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::optional<double> number_of(const std::string& text) {
  double value = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "voxels=0.6" into the settings. False for a word that is none. Errors: kInvalidArgument for a value out of range.
Result<bool> take_word(const std::string& word, workbench::FieldSettings& settings) {
  const std::size_t equals = word.find('=');
  const std::string key = word.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
  if (key == "mask") {
    TROCAR_ASSIGN_OR_RETURN(settings.mask, learning::field_mask_from(value));
    return true;
  }
  if (key == "scale") {
    TROCAR_ASSIGN_OR_RETURN(settings.scale, plot::scale_kind_from(value));
    return true;
  }
  if (key == "map") {
    TROCAR_ASSIGN_OR_RETURN(settings.map, plot::colour_map_from(value));
    return true;
  }
  if (key == "volume" && equals != std::string::npos) {
    settings.volume = true;
    TROCAR_ASSIGN_OR_RETURN(settings.opacity_curve, plot::opacity_curve_from(value));
    return true;
  }
  if (word == "volume") {
    settings.volume = true;
    return true;
  }
  const std::optional<double> number = number_of(value);
  if (!number) return false;
  if (key == "x" || key == "y" || key == "z") {
    settings.slices[static_cast<std::size_t>(key[0] - 'x')] = static_cast<int>(*number);
    if (*number == std::floor(*number) && *number >= 0.0 && *number < 1000.0) return true;
    return fail(ErrorCode::kInvalidArgument, fmt::format("--also takes a cell's index after {}=, not {}", key, value));
  }
  const bool is_share = key == "voxels" || key == "iso" || key == "opacity";
  if (is_share && !(*number >= 0.0 && *number <= 1.0)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("--also takes a share of 0 to 1 after {}=, not {}", key, value));
  }
  if (key == "voxels") {
    settings.voxels = true;
    settings.voxel_threshold = *number;
  } else if (key == "iso") {
    settings.iso_surface = true;
    settings.iso_level = *number;
  } else if (key == "opacity") {
    settings.opacity = static_cast<float>(*number);
  } else {
    return false;
  }
  return true;
}

}  // namespace

void bind_field(CLI::App& verb, FieldArguments& arguments, CLI::Option* model) {
  const auto share = CLI::Range(0.0, 1.0);
  verb.add_option("--layer", arguments.layer, "Which field of the model")->capture_default_str()->needs(model);
  verb.add_option("--mask", arguments.mask, "Show cells of none (all), safe, expert, visited or arrives alone")
      ->capture_default_str()
      ->needs(model);
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
  CLI::Option* volume = verb.add_flag("--volume", arguments.volume, "Draw the field as a cloud")->needs(model);
  verb.add_option("--opacity-curve", arguments.opacity_curve,
                  "What the cloud hides by place on the scale: ramp, highest, lowest, uniform, or knots, place and "
                  "height from 0 to 1, such as 0:0/0.6:0.1/1:1 (else clear where most values lie)")
      ->needs(volume);
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
  verb.add_option("--slab", arguments.slabs, "Cells that slices are thick, one number or X,Y,Z (else 1)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000))
      ->needs(model);
  verb.add_option("--through", arguments.through, "What thick slices show: the largest value, or the mean")
      ->check(CLI::IsMember({"largest", "mean"}))
      ->capture_default_str()
      ->needs(model);
  verb.add_option("--opacity", arguments.opacity, "Of the field, 0.05 to 1")
      ->check(CLI::Range(0.05, 1.0))
      ->capture_default_str()
      ->needs(model);
}

Result<workbench::FieldSettings> settings_from(const FieldArguments& arguments, const learning::Model& model) {
  workbench::FieldSettings settings;
  TROCAR_ASSIGN_OR_RETURN(settings.layer, learning::layer_from(arguments.layer));
  TROCAR_ASSIGN_OR_RETURN(settings.mask, learning::field_mask_from(arguments.mask));
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
    int& index = settings.slices[static_cast<std::size_t>(slice.axis)];
    if (index >= 0) {
      return fail(ErrorCode::kInvalidArgument,
                  "--slice takes one slice for each axis, and there are two across " + text.substr(0, 1));
    }
    index = slice.index;
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
  TROCAR_ASSIGN_OR_RETURN(settings.through, learning::through_from(arguments.through));
  if (settings.through != learning::Through::kLargest && settings.slabs == std::array{1, 1, 1}) {
    return fail(ErrorCode::kInvalidArgument, "--through says what thick slices show: say --slab, too");
  }
  settings.voxels = arguments.voxels.has_value();
  settings.voxel_threshold = arguments.voxels.value_or(settings.voxel_threshold);
  settings.iso_surface = arguments.iso.has_value();
  settings.iso_level = arguments.iso.value_or(settings.iso_level);
  settings.volume = arguments.volume;
  if (!arguments.opacity_curve.empty()) {
    TROCAR_ASSIGN_OR_RETURN(settings.opacity_curve, plot::opacity_curve_from(arguments.opacity_curve));
  }
  settings.opacity = arguments.opacity;
  settings.streamlines = !arguments.streamlines.empty();
  if (settings.streamlines) settings.streamline_starts = arguments.streamlines;
  return settings;
}

Result<stage::FieldLayer> drawn_layer(const workbench::ModelEntry& entry, const workbench::FieldSettings& settings) {
  const auto policy = std::make_shared<const std::vector<std::uint8_t>>(learning::greedy_policy(*entry.model));
  learning::Field field = learning::masked(workbench::field_of(*entry.model, settings.layer), *entry.model,
                                           learning::basin(*entry.model, *policy), settings.mask);
  if (field.categorical && (settings.iso_surface || settings.volume)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the layer {} is of classes, which have neither surface nor volume",
                            learning::to_string(settings.layer)));
  }
  return workbench::field_layer(std::make_shared<const learning::Field>(std::move(field)), settings,
                                {entry.model, policy});
}

Result<stage::FieldLayer> layer_of(const workbench::ModelEntry& entry, const FieldArguments& arguments) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::FieldSettings settings, settings_from(arguments, *entry.model));
  if (settings.streamlines) {
    TROCAR_ASSIGN_OR_RETURN(const auto ignored, learning::starts_from(settings.streamline_starts, *entry.model));
  }
  return drawn_layer(entry, settings);
}

Result<workbench::FieldSettings> also_from(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  workbench::FieldSettings settings;
  TROCAR_ASSIGN_OR_RETURN(settings.layer, learning::layer_from(words.front()));
  for (std::size_t i = 1; i < words.size(); ++i) {
    TROCAR_ASSIGN_OR_RETURN(const bool known, take_word(words[i], settings));
    if (known) continue;
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("--also does not know \"{}\"; after the layer come mask=, scale=, map=, voxels=SHARE, "
                            "iso=SHARE, volume, volume=CURVE, opacity=SHARE, x=I, y=J or z=K",
                            words[i]));
  }
  return settings;
}

}  // namespace trocar::app
