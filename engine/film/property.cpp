#include "engine/film/property.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/core/check.h"

namespace trocar::film {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::string_view kCircles = "its camera is neither orbit, turntable nor follow";
constexpr std::string_view kScene = "it is no scene";

constexpr std::array<Property, 9> kSource{{
    {"orbit.yaw", "Yaw", kCircles, -1000.0, 1000.0, kDegrees, "°", 0, "Of the camera, about what it circles"},
    {"orbit.elevation", "Elevation", kCircles, -1.55, 1.55, kDegrees, "°", 0, "Of the camera, above the board"},
    {"orbit.distance", "Distance", kCircles, 0.02, 1.0, 1e3, " mm", 0, "Of the camera, from what it circles"},
    {"zoom", "Zoom", kScene, 0.1, 20.0, 1.0, "×", 2, "How much larger than the camera alone has it"},
    {"slice", "Slice", "it shows no field", 0.0, 1000.0, 1.0, "", 0, "Of the field: the index of its cells"},
    {"field.opacity", "Opacity", "there is no field in its scene", 0.0, 1.0, 100.0, " %", 0,
     "Of the field in the scene"},
    {"trail", "Trail", kScene, 0.0, 60.0, 1.0, " s", 1, "How long the tips' trail is, where that overlay is on"},
    {"ghost", "Ghost", kScene, 0.0, 1.0, 100.0, " %", 0,
     "How dense the other side's arms are, where that overlay is on"},
    {"brightness", "Brightness", "", 0.0, 1.0, 100.0, " %", 0, "0 % is black: to come from and go to black"},
}};
constexpr Property kSpeed{
    "speed", "Speed", "", 0.01, 100.0, 1.0, "×", 2, "Seconds of the sources for each second of film"};
constexpr Property kShare{"share", "Share", "", 0.1, 0.5, 100.0, " %", 0, "How much of the width the inset has"};

bool is_scene(const Source& source) {
  return source.kind == SourceKind::kRecording || source.kind == SourceKind::kRollout;
}

const std::string& slice_of(const Source& source) {
  return source.kind == SourceKind::kField || !source.field ? source.slice : source.field->slice;
}

double index_of_slice(std::string_view slice) {
  int index = 0;
  const std::string_view number = slice.substr(slice_axis(slice).size());
  std::from_chars(number.data(), number.data() + number.size(), index);
  return index;
}

/// Where it is kept as a number of its own; null: it is part of a text.
template <typename Of>
auto place_of(Of& source, std::string_view name) -> decltype(&source.brightness) {
  if (name == "orbit.yaw") return &source.camera.yaw_rad;
  if (name == "orbit.elevation") return &source.camera.elevation_rad;
  if (name == "orbit.distance") return &source.camera.distance_m;
  if (name == "zoom") return &source.camera.zoom;
  if (name == "trail") return &source.trail_s;
  if (name == "ghost") return &source.ghost;
  if (name == "brightness") return &source.brightness;
  if (name == "field.opacity" && source.field) return &source.field->opacity;
  return nullptr;
}

}  // namespace

std::span<const Property> all_source_properties() {
  return kSource;
}

const Property* source_property(std::string_view name) {
  const auto* found =
      std::find_if(kSource.begin(), kSource.end(), [&](const Property& property) { return property.name == name; });
  return found == kSource.end() ? nullptr : found;
}

const Property& speed_property() {
  return kSpeed;
}

const Property& share_property() {
  return kShare;
}

bool has_property(const Source& source, const Property& property) {
  if (property.needs == kCircles) {
    const View view = source.camera.view;
    return is_scene(source) && (view == View::kOrbit || view == View::kTurntable || view == View::kFollow);
  }
  if (property.name == "slice") return source.kind == SourceKind::kField || source.field.has_value();
  if (property.name == "field.opacity") return source.field.has_value();
  return property.needs.empty() || is_scene(source);
}

std::vector<std::string> idle_keys(const Composition& film) {
  std::vector<std::string> sentences;
  for (const Source& source : film.sources) {
    for (const Track& track : source.tracks) {
      const Property* known = source_property(track.property);
      if (known == nullptr || has_property(source, *known)) continue;
      sentences.push_back(fmt::format("the keys of {} change nothing of {}: {}", known->name, source.of, known->needs));
    }
  }
  if (!film.share_keys.empty() && film.layout != Layout::kPictureInPicture) {
    sentences.emplace_back("the keys of share change nothing: only a picture in the picture has one");
  }
  return sentences;
}

double fixed_value(const Source& source, std::string_view name) {
  if (name == "slice") return index_of_slice(slice_of(source));
  const double* place = place_of(source, name);
  TROCAR_CHECK(place != nullptr);
  return *place;
}

void set_fixed_value(Source& source, std::string_view name, double value) {
  if (name == "slice") {
    std::string& slice = source.kind == SourceKind::kField || !source.field ? source.slice : source.field->slice;
    slice = fmt::format("{}{}", slice_axis(slice), std::lround(value));
    return;
  }
  double* place = place_of(source, name);
  TROCAR_CHECK(place != nullptr);
  *place = value;
}

double fixed_value(const Composition& film, std::string_view name) {
  TROCAR_CHECK(name == kSpeed.name || name == kShare.name);
  return name == kSpeed.name ? film.pace.speed : film.share;
}

void set_fixed_value(Composition& film, std::string_view name, double value) {
  TROCAR_CHECK(name == kSpeed.name || name == kShare.name);
  (name == kSpeed.name ? film.pace.speed : film.share) = value;
}

std::vector<Key> keys_of(const Source& source, std::string_view name) {
  for (const Track& track : source.tracks) {
    if (track.property == name) return track.keys;
  }
  return {};
}

void set_keys(Source& source, std::string_view name, std::vector<Key> keys) {
  const auto found = std::find_if(source.tracks.begin(), source.tracks.end(),
                                  [&](const Track& track) { return track.property == name; });
  if (keys.empty()) {
    if (found != source.tracks.end()) source.tracks.erase(found);
  } else if (found != source.tracks.end()) {
    found->keys = std::move(keys);
  } else {
    source.tracks.push_back({std::string(name), std::move(keys)});
  }
}

std::vector<Key> keys_of(const Composition& film, std::string_view name) {
  return name == kSpeed.name ? film.pace.ramps : name == kShare.name ? film.share_keys : std::vector<Key>();
}

void set_keys(Composition& film, std::string_view name, std::vector<Key> keys) {
  TROCAR_CHECK(name == kSpeed.name || name == kShare.name);
  (name == kSpeed.name ? film.pace.ramps : film.share_keys) = std::move(keys);
}

std::vector<Key> with_key_at(std::vector<Key> keys, Key key, double apart_s) {
  std::erase_if(keys, [&](const Key& other) { return std::abs(other.t_s - key.t_s) < apart_s; });
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), key.t_s, [](double t_s, const Key& other) { return t_s < other.t_s; });
  keys.insert(after, key);
  return keys;
}

double value_of(const Source& source, std::string_view name, double film_s) {
  return value_at(keys_of(source, name), film_s, fixed_value(source, name));
}

double value_of(const Composition& film, std::string_view name, double film_s) {
  return value_at(keys_of(film, name), film_s, fixed_value(film, name));
}

std::string_view slice_axis(std::string_view slice) {
  const std::size_t equals = slice.find('=');
  return equals == std::string_view::npos ? std::string_view() : slice.substr(0, equals + 1);
}

}  // namespace trocar::film
