#include "engine/film/composition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/film/composition_words.h"
#include "engine/film/property.h"

namespace trocar::film {
namespace {

constexpr double kLongest_s = 1e6;  // Of any time that a job says.

bool within(double value, double low, double high) {
  return std::isfinite(value) && value >= low && value <= high;
}

Status refused(std::string sentence) {
  return fail(ErrorCode::kInvalidArgument, std::move(sentence));
}

/// By increasing time, each value within the limits.
Status check_keys(const std::vector<Key>& keys, std::string_view property, double low, double high) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!within(keys[i].t_s, 0.0, kLongest_s) || (i > 0 && keys[i].t_s <= keys[i - 1].t_s)) {
      return refused(fmt::format("the keys of {} do not come one after the other", property));
    }
    if (!within(keys[i].value, low, high)) {
      return refused(fmt::format("{} must be {} to {}, not {}", property, low, high, keys[i].value));
    }
  }
  return {};
}

Status check_keys(const std::vector<Key>& keys, const Property& property) {
  return check_keys(keys, property.name, property.low, property.high);
}

Status check_tracks(const Source& source) {
  for (const Track& track : source.tracks) {
    const Property* known = source_property(track.property);
    if (known == nullptr) {
      std::vector<std::string_view> names;
      for (const Property& each : all_source_properties()) names.push_back(each.name);
      return refused(
          fmt::format("no property of a source is named \"{}\": there are {}", track.property, fmt::join(names, ", ")));
    }
    TROCAR_RETURN_IF_ERROR(check_keys(track.keys, *known));
    const auto same = [&](const Track& other) { return other.property == track.property; };
    if (std::count_if(source.tracks.begin(), source.tracks.end(), same) > 1) {
      return refused(fmt::format("{} has two tracks of {}", source.of, track.property));
    }
  }
  return {};
}

/// The numbers of a source that can have keys, where they have none.
Status check_fixed(const Source& source) {
  for (const Property& property : all_source_properties()) {
    if (!has_property(source, property)) continue;
    const double value = fixed_value(source, property.name);
    if (!within(value, property.low, property.high)) {
      return refused(fmt::format("{} must be {} to {}, not {}", property.name, property.low, property.high, value));
    }
  }
  return {};
}

Status check_camera(const CameraPath& camera) {
  if (!within(camera.yaw_rad, -1000.0, 1000.0) || !within(camera.elevation_rad, -1.55, 1.55) ||
      !within(camera.distance_m, 0.02, 1.0)) {
    return refused("a camera's yaw, elevation (within ±1.55 rad) or distance (0.02 to 1 m) is out of range");
  }
  if (!within(std::abs(camera.turn_s), 0.1, kLongest_s)) return refused("a turntable takes at least 0.1 s for a turn");
  if (camera.view == View::kPoses && camera.keys.empty()) return refused("a camera of poses has no keys");
  for (std::size_t i = 0; i < camera.keys.size(); ++i) {
    const CameraKey& key = camera.keys[i];
    if (!within(key.t_s, 0.0, kLongest_s) || (i > 0 && key.t_s <= camera.keys[i - 1].t_s)) {
      return refused("the poses of a camera do not come one after the other");
    }
    double apart = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!within(key.eye_m[axis], -10.0, 10.0) || !within(key.target_m[axis], -10.0, 10.0)) {
        return refused("a camera's eye and target are within ±10 m");
      }
      apart += std::abs(key.eye_m[axis] - key.target_m[axis]);
    }
    if (apart < 1e-6) return refused("a camera's eye and target are the same point");
  }
  return {};
}

Status check_source(const Source& source) {
  if (source.of.empty()) return refused("a source of the film does not say what it is of");
  const double in_s = source.in_s.value_or(0.0);
  const double out_s = source.out_s.value_or(kLongest_s);
  if (!within(in_s, 0.0, kLongest_s) || !within(out_s, 0.0, kLongest_s) || in_s >= out_s) {
    return refused(fmt::format("the gates of {} leave nothing", source.of));
  }
  TROCAR_RETURN_IF_ERROR(check_camera(source.camera));
  const bool scene = source.kind == SourceKind::kRecording || source.kind == SourceKind::kRollout;
  if (source.field && !scene) return refused(fmt::format("{} is no scene that a field could be in", source.of));
  if (source.field && source.field->of.empty()) return refused("a field in a scene does not say of which model it is");
  if (source.start && source.kind != SourceKind::kRollout) {
    return refused(fmt::format("{} is no rollout: it has no start", source.of));
  }
  for (const int cell : source.start.value_or(std::array<int, 3>{})) {
    if (cell < 0 || cell > 1000)
      return refused(fmt::format("a rollout of {} starts outside of any lattice", source.of));
  }
  TROCAR_RETURN_IF_ERROR(check_fixed(source));
  return check_tracks(source);
}

Status check_pace(const Pace& pace) {
  if (!(pace.speed > 0.0) || !within(pace.speed, 0.0, 100.0)) {
    return refused(fmt::format("the speed must be above 0 and at most 100, not {}", pace.speed));
  }
  TROCAR_RETURN_IF_ERROR(check_keys(pace.ramps, speed_property()));
  if (pace.loops < 1 || pace.loops > 1000) return refused("a film is shown 1 to 1000 times");
  for (std::size_t i = 0; i < pace.holds.size(); ++i) {
    const Hold& hold = pace.holds[i];
    if (!within(hold.at_s, 0.0, kLongest_s) || !within(hold.for_s, 0.0, 3600.0) ||
        (i > 0 && hold.at_s <= pace.holds[i - 1].at_s)) {
      return refused("the holds of a film do not come one after the other, or one is longer than an hour");
    }
  }
  return {};
}

}  // namespace

Room room_of(Layout layout) {
  switch (layout) {
    case Layout::kSingle:
      return {1, 1};
    case Layout::kSideBySide:
    case Layout::kTopBottom:
    case Layout::kPictureInPicture:
      return {2, 2};
    case Layout::kTwoByTwo:
      return {1, 4};
    case Layout::kThreeByThree:
      break;
  }
  return {1, 9};
}

Layout layout_for(Layout wanted, std::size_t sources) {
  if (sources == room_of(wanted).most) return wanted;
  if (sources <= 1) return Layout::kSingle;
  if (sources == 2) return Layout::kSideBySide;
  return sources <= 4 ? Layout::kTwoByTwo : Layout::kThreeByThree;
}

Source recording_of(std::string name) {
  Source source;
  source.of = std::move(name);
  return source;
}

Overlays Overlays::usual() {
  Overlays overlays;
  for (const Word<Overlay>& word : kOverlays) overlays.set(word.value);
  for (const Overlay off : {Overlay::kMetrics, Overlay::kTally, Overlay::kTrail, Overlay::kGhost, Overlay::kCaptions}) {
    overlays.set(off, false);
  }
  return overlays;
}

Status check(const Composition& film) {
  if (film.width < 16 || film.height < 16 || film.width > 8192 || film.height > 8192) {
    return refused(fmt::format("a film is 16 to 8192 pixels wide and high, not {} × {}", film.width, film.height));
  }
  if (!within(film.fps, 1.0, 240.0)) {
    return refused(fmt::format("a film has 1 to 240 frames a second, not {}", film.fps));
  }
  if (film.crf && (*film.crf < 1 || *film.crf > 63)) {
    return refused(fmt::format("the crf of a film is 1 to 63, not {}", *film.crf));
  }
  if (!within(film.share, 0.1, 0.5)) return refused("a picture in the picture has 0.1 to 0.5 of the width");
  TROCAR_RETURN_IF_ERROR(check_keys(film.share_keys, share_property()));
  const Room room = room_of(film.layout);
  if (film.sources.size() < room.least || film.sources.size() > room.most) {
    const std::string wanted =
        room.least == room.most ? fmt::format("{}", room.most) : fmt::format("{} to {}", room.least, room.most);
    return refused(
        fmt::format("the layout {} shows {}, not {}", word_of(kLayouts, film.layout), wanted, film.sources.size()));
  }
  for (const Source& source : film.sources) TROCAR_RETURN_IF_ERROR(check_source(source));
  return check_pace(film.pace);
}

const std::vector<std::string_view>& preset_names() {
  static const std::vector<std::string_view> kNames{"paper-1080p", "slide-720p", "mt-vs-sc", "thumbnail"};
  return kNames;
}

Result<Composition> preset_from(std::string_view name) {
  Composition film;
  if (name == "paper-1080p") {
    film.width = 1920;
    film.height = 1080;
    film.quality = Quality::kFine;
    film.overlays.set(Overlay::kCaptions);
    return film;
  }
  if (name == "slide-720p") {
    film.pace.speed = 2.0;
    film.pace.loops = 2;
    film.overlays.set(Overlay::kJaws, false);
    return film;
  }
  if (name == "mt-vs-sc") {
    film.layout = Layout::kSideBySide;
    film.pace.sync = Sync::kSegment;
    film.overlays.set(Overlay::kCaptions);
    return film;
  }
  if (name == "thumbnail") {
    film.width = 320;
    film.height = 180;
    film.fps = 10.0;
    film.pace.speed = 8.0;
    film.overlays = {};
    film.overlays.set(Overlay::kTitle);
    film.overlays.set(Overlay::kSpeed);
    return film;
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("no preset is named \"{}\": there are {}", name, fmt::join(preset_names(), ", ")));
}

}  // namespace trocar::film
