/// The numbers of a film that can have keys: what they are called, what they can be, and what they are at an instant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/film/composition.h"

namespace trocar::film {

/// Values are in the units of a job; the window shows `factor` times as much, with `unit`.
struct Property {
  std::string_view name;   ///< In a job: "orbit.yaw".
  std::string_view shown;  ///< "Yaw"
  std::string_view needs;  ///< Which sources have it, said where one has not.
  double low = 0.0;
  double high = 1.0;
  double factor = 1.0;
  std::string_view unit = {};
  int decimals = 0;
  std::string_view help = {};
};

std::span<const Property> all_source_properties();
/// Null if there is none of that name.
const Property* source_property(std::string_view name);
/// Of the film: how fast it goes, and how wide the picture in the picture is.
const Property& speed_property();
const Property& share_property();

bool has_property(const Source& source, const Property& property);
/// Keys that change nothing, a sentence each: a job may keep them for another camera or layout.
std::vector<std::string> idle_keys(const Composition& film);

/// What it is where it has no keys. Precondition: there is such a property.
double fixed_value(const Source& source, std::string_view name);
void set_fixed_value(Source& source, std::string_view name, double value);
double fixed_value(const Composition& film, std::string_view name);
void set_fixed_value(Composition& film, std::string_view name, double value);

/// By increasing time; empty without a track. Setting none takes the track away.
std::vector<Key> keys_of(const Source& source, std::string_view name);
void set_keys(Source& source, std::string_view name, std::vector<Key> keys);
std::vector<Key> keys_of(const Composition& film, std::string_view name);
void set_keys(Composition& film, std::string_view name, std::vector<Key> keys);

/// With a key there, in the place of one that is nearer than `apart_s`.
std::vector<Key> with_key_at(std::vector<Key> keys, Key key, double apart_s);

/// At an instant of the film, by keys or without.
double value_of(const Source& source, std::string_view name, double film_s);
double value_of(const Composition& film, std::string_view name, double film_s);

/// "z=", of "z=11": the slice without its number. Empty if it has none.
std::string_view slice_axis(std::string_view slice);

}  // namespace trocar::film
