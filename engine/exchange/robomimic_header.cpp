#include "engine/exchange/robomimic_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/demonstration/edit_fields.h"
#include "engine/demonstration/name.h"
#include "engine/exchange/columns.h"

namespace trocar::exchange {
namespace {

using demonstration::Outcome;
using demonstration::Provenance;
using demonstration::Recording;
using demonstration::Sample;
using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
/// As far as `check_samples` goes.
constexpr std::int64_t kLastTick = 1'000'000'000'000;

std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

Json provenance_json(const Provenance& provenance, const demonstration::Demonstration& document) {
  return {{"operator", provenance.operator_kind},
          {"skill", provenance.skill},
          {"device", provenance.device},
          {"seed", provenance.seed},
          {"block", document.block},
          {"goal", document.goal},
          {"scene_hash", provenance.scene_hash},
          {"software", provenance.software},
          {"created", provenance.created}};
}

template <typename Enum>
std::string word_of(Enum value) {
  return std::string(demonstration::words_of<Enum>()[static_cast<std::size_t>(value)]);
}

/// Files of before notes had colours are without; a word that is not known is wrong.
template <typename Enum>
bool take_word(const Json& object, const char* key, Enum& into) {
  if (!object.is_object() || !object.contains(key)) return true;
  if (!object[key].is_string()) return false;
  const auto words = demonstration::words_of<Enum>();
  const auto found = std::find(words.begin(), words.end(), object[key].template get<std::string>());
  if (found == words.end()) return false;
  into = static_cast<Enum>(found - words.begin());
  return true;
}

/// Times from the first gated sample; notes that lie outside of the gates are left out.
Json notes_json(const demonstration::Demonstration& document, double first_s) {
  Json notes = Json::array();
  for (const demonstration::Note& note : document.notes) {
    if (note.end_s < document.begin_s || note.begin_s > document.end_s) continue;
    notes.push_back({{"from_s", note.begin_s - first_s},
                     {"to_s", note.end_s - first_s},
                     {"text", note.text},
                     {"tag", note.tag},
                     {"rating", note.rating},
                     {"colour", word_of(note.colour)},
                     {"glyph", word_of(note.glyph)}});
  }
  return notes;
}

/// Takes values out of an object; what is missing or of another type turns `good` off.
class Fields {
 public:
  explicit Fields(const Json& object) : object_(object), good(object.is_object()) {}

  void take(const char* key, std::string& into) {
    if (const Json* value = find(key); value != nullptr && value->is_string()) {
      into = value->get<std::string>();
    } else {
      good = false;
    }
  }
  void take(const char* key, bool& into) {
    if (const Json* value = find(key); value != nullptr && value->is_boolean()) {
      into = value->get<bool>();
    } else {
      good = false;
    }
  }
  void take(const char* key, double& into) {
    if (const Json* value = find(key); value != nullptr && value->is_number()) {
      into = value->get<double>();
    } else {
      good = false;
    }
  }
  template <typename Whole>
  void take_whole(const char* key, Whole& into, Whole low, Whole high) {
    const Json* value = find(key);
    good = good && value != nullptr && value->is_number_integer();
    if (!good) return;
    const bool negative = !value->is_number_unsigned() && value->get<std::int64_t>() < 0;
    good = negative ? std::cmp_less_equal(low, value->get<std::int64_t>())
                    : std::cmp_greater_equal(high, value->get<std::uint64_t>());
    if (good) into = value->get<Whole>();
  }

  const Json* find(const char* key) const {
    const auto found = good ? object_.find(key) : object_.end();
    return good && found != object_.end() ? &*found : nullptr;
  }

 private:
  const Json& object_;

 public:
  bool good;
};

bool parse_hash(const std::string& text, std::uint64_t& hash) {
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() && text.size() == 16;
}

bool take_provenance(const Json& object, Provenance& into) {
  Fields fields(object);
  fields.take("operator", into.operator_kind);
  fields.take("skill", into.skill);
  fields.take("device", into.device);
  fields.take_whole<std::uint64_t>("seed", into.seed, 0, ~std::uint64_t{0});
  fields.take_whole("block", into.block, demonstration::kUnknownPlace, 5);
  fields.take_whole("goal", into.goal, demonstration::kUnknownPlace, 5);
  fields.take("scene_hash", into.scene_hash);
  fields.take("software", into.software);
  fields.take("created", into.created);
  return fields.good;
}

bool take_outcome(Fields& fields, Outcome& into) {
  std::string name;
  fields.take("outcome", name);
  for (int i = 0; i <= static_cast<int>(Outcome::kUnknown); ++i) {
    if (name != to_string(static_cast<Outcome>(i))) continue;
    into = static_cast<Outcome>(i);
    return fields.good;
  }
  return false;
}

bool take_notes(const Json* array, std::vector<demonstration::AddNote>& into) {
  if (array == nullptr || !array->is_array()) return false;
  for (const Json& object : *array) {
    demonstration::AddNote note;
    Fields fields(object);
    fields.take("from_s", note.from_s);
    fields.take("to_s", note.to_s);
    fields.take("text", note.text);
    fields.take("tag", note.tag);
    fields.take_whole("rating", note.rating, 0, 5);
    const bool named =
        demonstration::check_name(note.text) && (note.tag.empty() || demonstration::check_name(note.tag));
    const bool marked = take_word(object, "colour", note.colour) && take_word(object, "glyph", note.glyph);
    if (!fields.good || !named || !marked || note.to_s < note.from_s) return false;
    into.push_back(std::move(note));
  }
  return true;
}

bool take_hashes(const Json* array, std::vector<demonstration::HashMark>& into) {
  if (array == nullptr || !array->is_array()) return false;
  for (const Json& pair : *array) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number_integer() || !pair[1].is_string()) return false;
    demonstration::HashMark mark;
    mark.tick = pair[0].get<std::int64_t>();
    if (!parse_hash(pair[1].get<std::string>(), mark.hash)) return false;
    into.push_back(mark);
  }
  return true;
}

struct Header {
  Recording recording;  ///< Without samples.
  std::string name;
  std::vector<demonstration::AddNote> notes;
  std::int64_t first_tick = 0;
  std::uint64_t samples_hash = 0;
};

std::optional<Header> parse(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  Header header;
  Fields fields(json);
  int version = 0;
  fields.take_whole("trocar", version, kVersion, kVersion);
  fields.take("name", header.name);
  fields.take_whole<std::int64_t>("first_tick", header.first_tick, 0, kLastTick);
  fields.take("placed", header.recording.placed);
  fields.take("recovered", header.recording.recovered);
  std::string hash;
  fields.take("samples_hash", hash);
  const Json* provenance = fields.find("provenance");
  const bool good = take_outcome(fields, header.recording.outcome) && provenance != nullptr &&
                    take_provenance(*provenance, header.recording.provenance) &&
                    take_notes(fields.find("notes"), header.notes) &&
                    take_hashes(fields.find("hashes"), header.recording.hashes) &&
                    parse_hash(hash, header.samples_hash) && demonstration::check_name(header.name);
  return good && fields.good ? std::optional(std::move(header)) : std::nullopt;
}

}  // namespace

bool is_as_recorded(const demonstration::Demonstration& document, const std::vector<Sample>& samples) {
  if (samples.size() != document.recorded.size()) return false;
  demonstration::SampleHasher written;
  for (Sample sample : samples) {
    sample.tick += document.first_tick();
    written.add(sample);
  }
  demonstration::SampleHasher recorded;
  for (const Sample& sample : document.recorded) recorded.add(sample);
  const Provenance& made = document.recording->provenance;
  return document.block == made.block && document.goal == made.goal && written.digest() == recorded.digest();
}

std::string robomimic_header(const demonstration::Demonstration& document, const std::vector<Sample>& samples) {
  const demonstration::RecordingInfo& recording = *document.recording;
  Json hashes = Json::array();
  if (is_as_recorded(document, samples)) {
    for (const demonstration::HashMark& mark : recording.hashes) hashes.push_back({mark.tick, hash_text(mark.hash)});
  }
  const Json json{{"trocar", kVersion},
                  {"name", document.name},
                  {"first_tick", document.first_tick()},
                  {"samples_hash", hash_text(demonstration::hash_of(samples))},
                  {"outcome", to_string(document.outcome())},
                  {"placed", document.placed()},
                  {"recovered", recording.recovered},
                  {"provenance", provenance_json(recording.provenance, document)},
                  {"hashes", hashes},
                  {"notes", notes_json(document, samples.front().t_s())}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Status apply_robomimic_header(std::string_view text, std::string world, Imported& imported) {
  std::optional<Header> header = parse(text);
  if (!header) return fail(ErrorCode::kCorrupt, "what Trocar wrote beside its samples is damaged");
  imported.name = header->name;
  imported.name_is_own = true;
  imported.notes = std::move(header->notes);
  std::vector<Sample> samples = std::move(imported.recording.samples);
  if (demonstration::hash_of(samples) != header->samples_hash) {
    imported.recording.samples = std::move(samples);
    imported.found.emplace_back("its samples are no longer those that Trocar wrote, so it claims no origin or outcome");
    return {};
  }
  for (Sample& sample : samples) sample.tick += header->first_tick;
  TROCAR_RETURN_IF_ERROR(demonstration::check_samples(samples));
  imported.recording = std::move(header->recording);
  imported.recording.samples = std::move(samples);
  imported.recording.initial_world = std::move(world);
  const std::vector<std::string> lacking = std::move(imported.lossy);
  imported.lossy.clear();
  for (const std::string& missing : not_recorded({})) {
    if (std::find(lacking.begin(), lacking.end(), missing) != lacking.end()) imported.lossy.push_back(missing);
  }
  if (imported.recording.initial_world.empty()) {
    imported.lossy.emplace_back("a simulated world (it cannot be replayed)");
  }
  return {};
}

}  // namespace trocar::exchange
