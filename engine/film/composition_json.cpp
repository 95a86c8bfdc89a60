#include "engine/film/composition_json.h"

#include <fmt/format.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "engine/film/composition_words.h"
#include "engine/film/property.h"

namespace trocar::film {
namespace {

using nlohmann::ordered_json;
using Json = ordered_json;

/// Takes the members of an object; the first thing that is wrong with it is kept.
class Reader {
 public:
  Reader(const Json& object, std::string where) : object_(object), where_(std::move(where)) {
    if (!object.is_object()) wrong("is no object");
  }

  void number(const char* key, double& value) {
    if (const Json* found = find(key)) {
      if (!found->is_number()) return wrong(fmt::format("needs a number as \"{}\"", key));
      value = found->get<double>();
    }
  }
  void number(const char* key, std::optional<double>& value) {
    if (find(key) == nullptr) return;
    value.emplace(0.0);
    number(key, *value);
  }
  void whole(const char* key, std::optional<int>& value) {
    if (find(key) == nullptr) return;
    int read = 0;
    whole(key, read);
    value = read;
  }
  void whole(const char* key, int& value) {
    double read = value;
    number(key, read);
    if (!(read >= -1e6 && read <= 1e6) || read != static_cast<int>(read)) {
      return wrong(fmt::format("needs a whole number as \"{}\"", key));
    }
    value = static_cast<int>(read);
  }
  void text(const char* key, std::string& value) {
    if (const Json* found = find(key)) {
      if (!found->is_string()) return wrong(fmt::format("needs a text as \"{}\"", key));
      value = found->get<std::string>();
    }
  }
  template <typename Value, std::size_t kCount>
  void word(const char* key, const std::array<Word<Value>, kCount>& words, Value& value) {
    std::string read(word_of(words, value));
    text(key, read);
    const std::optional<Value> known = value_of(words, read);
    if (!known) return wrong(fmt::format("needs one of {} as \"{}\", not \"{}\"", list_of(words), key, read));
    value = *known;
  }
  void point(const char* key, std::array<double, 3>& value) {
    const Json* found = find(key);
    if (found == nullptr) return;
    if (!found->is_array() || found->size() != 3) return wrong(fmt::format("needs three numbers as \"{}\"", key));
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(*found)[i].is_number()) return wrong(fmt::format("needs three numbers as \"{}\"", key));
      value[i] = (*found)[i].get<double>();
    }
  }
  void cell(const char* key, std::optional<std::array<int, 3>>& value) {
    if (find(key) == nullptr) return;
    std::array<double, 3> read{};
    point(key, read);
    std::array<int, 3> cell{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(read[i] >= -1e6 && read[i] <= 1e6) || read[i] != static_cast<int>(read[i])) {
        return wrong(fmt::format("needs three whole numbers as \"{}\"", key));
      }
      cell[i] = static_cast<int>(read[i]);
    }
    value = cell;
  }
  /// `read` gets a reader of each object and its place in the list.
  template <typename Item, typename Read>
  void list(const char* key, std::vector<Item>& items, const Read& read) {
    const Json* found = find(key);
    if (found == nullptr) return;
    if (!found->is_array()) return wrong(fmt::format("needs a list as \"{}\"", key));
    items.clear();
    for (const Json& each : *found) {
      Reader reader(each, fmt::format("{} {} of {}", key, items.size() + 1, where_));
      Item item;
      if (reader.error_.empty()) read(reader, item);
      reader.end();
      if (!reader.error_.empty()) {
        if (error_.empty()) error_ = reader.error_;
        return;
      }
      items.push_back(std::move(item));
    }
  }
  template <typename Read>
  void part(const char* key, const Read& read) {
    const Json* found = find(key);
    if (found == nullptr) return;
    Reader reader(*found, fmt::format("\"{}\" of {}", key, where_));
    if (reader.error_.empty()) read(reader);
    reader.end();
    if (error_.empty()) error_ = reader.error_;
  }
  const Json* find(const char* key) {
    known_.insert(key);
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }
  void wrong(const std::string& what) {
    if (error_.empty()) error_ = fmt::format("{} {}", where_, what);
  }
  /// Whatever is there and was not asked for is wrong.
  void end() {
    if (!object_.is_object()) return;
    for (const auto& [key, value] : object_.items()) {
      if (known_.count(key) == 0) wrong(fmt::format("has no \"{}\"", key));
    }
  }
  const std::string& error() const { return error_; }

 private:
  const Json& object_;
  std::string where_;
  std::string error_;
  std::set<std::string> known_;
};

void read_key(Reader& reader, Key& key) {
  reader.number("t", key.t_s);
  reader.number("value", key.value);
  reader.word("ease", kEases, key.ease);
}

void read_track(Reader& reader, Track& track) {
  reader.text("property", track.property);
  reader.list("keys", track.keys, read_key);
}

void read_camera(Reader& reader, CameraPath& camera) {
  reader.word("view", kViews, camera.view);
  reader.number("yaw_rad", camera.yaw_rad);
  reader.number("elevation_rad", camera.elevation_rad);
  reader.number("distance_m", camera.distance_m);
  reader.number("turn_s", camera.turn_s);
  reader.number("zoom", camera.zoom);
  reader.list("keys", camera.keys, [](Reader& key_reader, CameraKey& key) {
    key_reader.number("t", key.t_s);
    key_reader.point("eye_m", key.eye_m);
    key_reader.point("target_m", key.target_m);
    key_reader.word("ease", kEases, key.ease);
  });
}

void read_source(Reader& reader, Source& source) {
  reader.word("kind", kSourceKinds, source.kind);
  reader.text("of", source.of);
  reader.text("title", source.title);
  reader.number("in_s", source.in_s);
  reader.number("out_s", source.out_s);
  reader.text("layer", source.layer);
  reader.text("slice", source.slice);
  reader.text("curve", source.curve);
  reader.part("camera", [&](Reader& camera) { read_camera(camera, source.camera); });
  reader.cell("start", source.start);
  if (reader.find("field") != nullptr) source.field.emplace();
  reader.part("field", [&](Reader& field) {
    field.text("of", source.field->of);
    field.text("layer", source.field->layer);
    field.text("slice", source.field->slice);
    field.number("opacity", source.field->opacity);
  });
  reader.number("trail_s", source.trail_s);
  reader.number("ghost", source.ghost);
  reader.number("brightness", source.brightness);
  reader.list("tracks", source.tracks, read_track);
}

void read_pace(Reader& reader, Pace& pace) {
  reader.number("speed", pace.speed);
  reader.list("holds", pace.holds, [](Reader& hold_reader, Hold& hold) {
    hold_reader.number("at_s", hold.at_s);
    hold_reader.number("for_s", hold.for_s);
  });
  reader.whole("loops", pace.loops);
  reader.word("sync", kSyncs, pace.sync);
}

void read_overlays(Reader& reader, Overlays& overlays) {
  const Json* found = reader.find("overlays");
  if (found == nullptr) return;
  overlays = {};
  if (!found->is_array()) return reader.wrong("needs a list as \"overlays\"");
  for (const Json& each : *found) {
    const auto known = each.is_string() ? value_of(kOverlays, each.get<std::string>()) : std::nullopt;
    if (!known) return reader.wrong(fmt::format("has overlays other than {}", list_of(kOverlays)));
    overlays.set(*known);
  }
}

void read_film(Reader& reader, Composition& film) {
  reader.text("path", film.path);
  reader.whole("width", film.width);
  reader.whole("height", film.height);
  reader.number("fps", film.fps);
  reader.text("codec", film.codec);
  reader.whole("crf", film.crf);
  reader.word("quality", kQualities, film.quality);
  reader.word("layout", kLayouts, film.layout);
  reader.word("corner", kCorners, film.corner);
  reader.number("share", film.share);
  reader.list("sources", film.sources, read_source);
  reader.part("time", [&](Reader& pace) { read_pace(pace, film.pace); });
  read_overlays(reader, film.overlays);
  std::vector<Track> tracks;
  reader.list("tracks", tracks, read_track);
  for (Track& track : tracks) {
    if (track.property != speed_property().name && track.property != share_property().name) {
      return reader.wrong(fmt::format("has no property \"{}\" of its own: only speed and share", track.property));
    }
    set_keys(film, track.property, std::move(track.keys));
  }
}

Json json_of(const std::vector<Key>& keys) {
  Json list = Json::array();
  for (const Key& key : keys) {
    list.push_back({{"t", key.t_s}, {"value", key.value}, {"ease", word_of(kEases, key.ease)}});
  }
  return list;
}

Json json_of(const CameraPath& camera) {
  Json json = {{"view", word_of(kViews, camera.view)}};
  const CameraPath usual;
  if (camera.yaw_rad != usual.yaw_rad) json["yaw_rad"] = camera.yaw_rad;
  if (camera.elevation_rad != usual.elevation_rad) json["elevation_rad"] = camera.elevation_rad;
  if (camera.distance_m != usual.distance_m) json["distance_m"] = camera.distance_m;
  if (camera.turn_s != usual.turn_s) json["turn_s"] = camera.turn_s;
  if (camera.zoom != usual.zoom) json["zoom"] = camera.zoom;
  for (const CameraKey& key : camera.keys) {
    json["keys"].push_back(
        {{"t", key.t_s}, {"eye_m", key.eye_m}, {"target_m", key.target_m}, {"ease", word_of(kEases, key.ease)}});
  }
  return json;
}

Json json_of(const Source& source) {
  const Source usual;
  Json json = {{"kind", word_of(kSourceKinds, source.kind)}, {"of", source.of}};
  if (!source.title.empty()) json["title"] = source.title;
  if (source.in_s) json["in_s"] = *source.in_s;
  if (source.out_s) json["out_s"] = *source.out_s;
  if (source.layer != usual.layer) json["layer"] = source.layer;
  if (source.slice != usual.slice) json["slice"] = source.slice;
  if (source.curve != usual.curve) json["curve"] = source.curve;
  if (source.camera != usual.camera) json["camera"] = json_of(source.camera);
  if (source.start) json["start"] = *source.start;
  if (source.field) {
    json["field"] = {{"of", source.field->of},
                     {"layer", source.field->layer},
                     {"slice", source.field->slice},
                     {"opacity", source.field->opacity}};
  }
  if (source.trail_s != usual.trail_s) json["trail_s"] = source.trail_s;
  if (source.ghost != usual.ghost) json["ghost"] = source.ghost;
  if (source.brightness != usual.brightness) json["brightness"] = source.brightness;
  for (const Track& track : source.tracks) {
    json["tracks"].push_back({{"property", track.property}, {"keys", json_of(track.keys)}});
  }
  return json;
}

}  // namespace

std::string to_json(const Composition& film) {
  Json json = Json::object();
  if (!film.path.empty()) json["path"] = film.path;
  json["width"] = film.width;
  json["height"] = film.height;
  json["fps"] = film.fps;
  json["codec"] = film.codec;
  if (film.crf) json["crf"] = *film.crf;
  json["quality"] = word_of(kQualities, film.quality);
  json["layout"] = word_of(kLayouts, film.layout);
  if (film.layout == Layout::kPictureInPicture || film.corner != Corner::kBottomRight || film.share != 0.3) {
    json["corner"] = word_of(kCorners, film.corner);
    json["share"] = film.share;
  }
  json["sources"] = Json::array();
  for (const Source& source : film.sources) json["sources"].push_back(json_of(source));
  json["time"] = {{"speed", film.pace.speed}, {"loops", film.pace.loops}, {"sync", word_of(kSyncs, film.pace.sync)}};
  for (const Hold& hold : film.pace.holds) {
    json["time"]["holds"].push_back({{"at_s", hold.at_s}, {"for_s", hold.for_s}});
  }
  json["overlays"] = Json::array();
  for (const Word<Overlay>& word : kOverlays) {
    if (film.overlays.has(word.value)) json["overlays"].push_back(word.text);
  }
  for (const Property* property : {&speed_property(), &share_property()}) {
    const std::vector<Key> keys = keys_of(film, property->name);
    if (!keys.empty()) json["tracks"].push_back({{"property", property->name}, {"keys", json_of(keys)}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Composition> composition_from_json(std::string_view text) {
  const Json object = Json::parse(text, nullptr, false);
  if (object.is_discarded()) return fail(ErrorCode::kCorrupt, "the film's job is no JSON");
  Composition film;
  Reader reader(object, "the film's job");
  read_film(reader, film);
  reader.end();
  if (!reader.error().empty()) return fail(ErrorCode::kCorrupt, reader.error());
  TROCAR_RETURN_IF_ERROR(check(film));
  return film;
}

}  // namespace trocar::film
