#include "engine/workbench/model_codec.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "engine/core/hash.h"
#include "engine/learning/model_codec.h"

namespace trocar::workbench {
namespace {

using nlohmann::json;

constexpr int kFormat = 2;

tl::unexpected<Error> corrupt_model(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

/// For those who read the project with `sqlite3`; the model's own bytes are what counts.
json summary_of(const learning::Model& model) {
  return {{"method", std::string(learning::to_string(model.options.method))},
          {"epsilon", model.options.epsilon},
          {"episodes", model.options.episodes},
          {"seed", model.options.seed},
          {"cells_a_side", model.grid.n}};
}

bool take_text(const json& meta, const char* key, std::string& text) {
  const auto found = meta.find(key);
  if (found == meta.end() || !found->is_string()) return false;
  text = found->get<std::string>();
  return true;
}

bool take_segment(const json& meta, demonstration::Segment& segment) {
  std::string text;
  if (!take_text(meta, "segment", text) || text.size() != 1 || text[0] < 'A' || text[0] > 'E') return false;
  segment = static_cast<demonstration::Segment>(text[0] - 'A');
  return true;
}

bool take_hash(const std::string& text, std::uint64_t& hash) {
  const char* last = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), last, hash, 16);
  return error == std::errc() && stop == last;
}

/// Each demonstration as {"id": 1, "hash": "00ff…"}.
bool take_sources(const json& meta, ModelEntry& entry) {
  const auto sources = meta.find("demonstrations");
  if (sources == meta.end() || !sources->is_array()) return false;
  for (const json& source : *sources) {
    std::string text;
    if (!source.is_object() || !source.contains("id") || !source["id"].is_number_integer()) return false;
    if (!take_text(source, "hash", text)) return false;
    std::uint64_t hash = 0;
    if (!take_hash(text, hash)) return false;
    entry.demonstrations.push_back({source["id"].get<std::int64_t>()});
    entry.demonstration_hashes.push_back(hash);
  }
  return true;
}

}  // namespace

EncodedModel encode_model(const ModelEntry& entry) {
  json sources = json::array();
  for (std::size_t i = 0; i < entry.demonstrations.size(); ++i) {
    sources.push_back({{"id", entry.demonstrations[i].value}, {"hash", to_hex(entry.demonstration_hashes[i])}});
  }
  std::string bytes = learning::encode_model(*entry.model);
  const json meta = {{"format", kFormat},
                     {"hash", to_hex(entry.model->hash())},
                     {"size_bytes", bytes.size()},
                     {"name", entry.name},
                     {"segment", std::string(1, demonstration::letter(entry.segment))},
                     {"created", entry.created},
                     {"demonstrations", sources},
                     {"seconds", entry.model->seconds},
                     {"summary", summary_of(*entry.model)}};
  return {meta.dump(-1, ' ', false, json::error_handler_t::replace), std::move(bytes)};
}

namespace {

/// All but the model.
Result<ModelEntry> entry_of(const json& meta) {
  if (!meta.is_object()) return corrupt_model("the model's description is not a JSON object");
  if (meta.value("format", json()) != json(kFormat)) {
    return fail(ErrorCode::kUnsupported, "the model has a layout that this version cannot read");
  }
  ModelEntry entry;
  const auto seconds = meta.find("seconds");
  if (!take_text(meta, "name", entry.name) || !take_text(meta, "created", entry.created) ||
      !take_segment(meta, entry.segment) || !take_sources(meta, entry) || seconds == meta.end() ||
      !seconds->is_number()) {
    return corrupt_model("the model's description misses a value or has one out of range");
  }
  return entry;
}

}  // namespace

Result<ModelEntry> decode_model(std::string_view meta_text, std::string_view bytes) {
  const json meta = json::parse(meta_text, nullptr, false);
  TROCAR_ASSIGN_OR_RETURN(ModelEntry entry, entry_of(meta));
  TROCAR_ASSIGN_OR_RETURN(learning::Model model, learning::decode_model(bytes));
  model.seconds = meta["seconds"].get<double>();
  entry.model = std::make_shared<const learning::Model>(std::move(model));
  return entry;
}

Result<std::optional<ModelEntry>> describe_model(std::string_view meta_text, std::int64_t size_bytes) {
  const json meta = json::parse(meta_text, nullptr, false);
  TROCAR_ASSIGN_OR_RETURN(ModelEntry entry, entry_of(meta));
  std::string hash;
  const auto size = meta.find("size_bytes");
  if (!take_text(meta, "hash", hash) || size == meta.end()) return std::nullopt;
  if (!take_hash(hash, entry.model_hash)) return corrupt_model("the model's description has a hash that is none");
  if (*size != json(size_bytes)) return corrupt_model("the model's length does not fit its description");
  return entry;
}

}  // namespace trocar::workbench
