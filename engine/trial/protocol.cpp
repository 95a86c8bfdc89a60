#include "engine/trial/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/file.h"
#include "engine/core/random.h"

namespace trocar::trial {
namespace {

using nlohmann::json;

tl::unexpected<Error> corrupt(std::string why) {
  return fail(ErrorCode::kCorrupt, "a protocol " + std::move(why));
}

Result<std::string> text_at(const json& object, const char* key, const std::string& otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_string()) return corrupt(fmt::format("has a {} that is no text", key));
  return found->get<std::string>();
}

Result<std::optional<double>> number_at(const json& object, const char* key, double low, double high) {
  const auto found = object.find(key);
  if (found == object.end()) return std::optional<double>();
  if (!found->is_number()) return corrupt(fmt::format("has a {} that is no number", key));
  const double value = found->get<double>();
  if (!(value >= low && value <= high))
    return corrupt(fmt::format("has a {} that is not in {:g} … {:g}", key, low, high));
  return std::optional<double>(value);
}

Result<std::optional<int>> count_at(const json& object, const char* key) {
  TROCAR_ASSIGN_OR_RETURN(const std::optional<double> value, number_at(object, key, 1.0, 10'000.0));
  if (!value) return std::optional<int>();
  if (*value != std::floor(*value)) return corrupt(fmt::format("has a {} that is no whole number", key));
  return std::optional<int>(static_cast<int>(*value));
}

Result<ProtocolBlock> block_from(const json& object) {
  if (!object.is_object()) return corrupt("has a block that is no object");
  ProtocolBlock block;
  TROCAR_ASSIGN_OR_RETURN(block.name, text_at(object, "name", ""));
  TROCAR_ASSIGN_OR_RETURN(block.instructions, text_at(object, "instructions", ""));
  TROCAR_ASSIGN_OR_RETURN(const std::string mode, text_at(object, "mode", "MT"));
  TROCAR_ASSIGN_OR_RETURN(block.mode, mode_from(mode));
  TROCAR_ASSIGN_OR_RETURN(block.delay, text_at(object, "delay", "0"));
  TROCAR_ASSIGN_OR_RETURN(block.time_s, number_at(object, "time_s", 1.0, 86'400.0));
  TROCAR_ASSIGN_OR_RETURN(block.transfers, count_at(object, "transfers"));
  TROCAR_ASSIGN_OR_RETURN(block.successes, count_at(object, "successes"));
  TROCAR_ASSIGN_OR_RETURN(const auto rest_s, number_at(object, "rest_s", 0.0, 86'400.0));
  block.rest_s = rest_s.value_or(0.0);
  if (const auto counts = object.find("counts"); counts != object.end()) {
    if (!counts->is_boolean()) return corrupt("has a counts that is neither true nor false");
    block.counts = counts->get<bool>();
  }
  if (!block.time_s && !block.transfers && !block.successes) {
    return corrupt("has a block without time_s, transfers or successes, which would never end");
  }
  return block;
}

}  // namespace

std::vector<ProtocolBlock> order_for(const Protocol& protocol, int subject_number, std::uint64_t seed) {
  std::vector<ProtocolBlock> blocks = protocol.blocks;
  const auto first = blocks.begin() + std::clamp<std::ptrdiff_t>(protocol.fixed, 0, std::ssize(blocks));
  // In each pair of subjects one of either order; which of the two is drawn.
  const bool drawn = Random(seed).child(static_cast<std::uint64_t>(subject_number / 2)).uniform() < 0.5;
  const bool manual_first = (subject_number % 2 == 0) == drawn;
  std::stable_partition(first, blocks.end(),
                        [&](const ProtocolBlock& block) { return (block.mode == Mode::kManual) == manual_first; });
  return blocks;
}

bool block_over(const ProtocolBlock& block, int transfers, int successes, double elapsed_s) {
  return (block.time_s && elapsed_s >= *block.time_s) || (block.transfers && transfers >= *block.transfers) ||
         (block.successes && successes >= *block.successes);
}

Result<Protocol> protocol_from_json(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt("must be a JSON object");
  Protocol protocol;
  TROCAR_ASSIGN_OR_RETURN(protocol.name, text_at(object, "name", "Protocol"));
  TROCAR_ASSIGN_OR_RETURN(protocol.about, text_at(object, "about", ""));
  TROCAR_ASSIGN_OR_RETURN(const auto transfer_s, number_at(object, "transfer_s", 1.0, 3600.0));
  protocol.transfer_s = transfer_s.value_or(120.0);
  const auto blocks = object.find("blocks");
  if (blocks == object.end() || !blocks->is_array() || blocks->empty()) return corrupt("must have a list of blocks");
  if (blocks->size() > 100) return corrupt("has more than 100 blocks");
  for (const json& each : *blocks) {
    TROCAR_ASSIGN_OR_RETURN(protocol.blocks.emplace_back(), block_from(each));
  }
  TROCAR_ASSIGN_OR_RETURN(const auto fixed, number_at(object, "fixed", 0.0, static_cast<double>(blocks->size())));
  protocol.fixed = static_cast<int>(fixed.value_or(0.0));
  return protocol;
}

std::string to_json(const Protocol& protocol) {
  json blocks = json::array();
  for (const ProtocolBlock& block : protocol.blocks) {
    json object = {{"name", block.name},
                   {"instructions", block.instructions},
                   {"mode", to_string(block.mode)},
                   {"counts", block.counts},
                   {"rest_s", block.rest_s},
                   {"delay", block.delay}};
    if (block.time_s) object["time_s"] = *block.time_s;
    if (block.transfers) object["transfers"] = *block.transfers;
    if (block.successes) object["successes"] = *block.successes;
    blocks.push_back(std::move(object));
  }
  const json object = {{"name", protocol.name},
                       {"about", protocol.about},
                       {"fixed", protocol.fixed},
                       {"transfer_s", protocol.transfer_s},
                       {"blocks", std::move(blocks)}};
  return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<Protocol> find_protocol(const std::string& name) {
  const bool ships = name == "sim" || name == "dvrk";
  const std::filesystem::path file =
      ships ? share_path("assets/protocols/" + name + ".json") : std::filesystem::path(name);
  TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(file));
  auto protocol = protocol_from_json(text);
  if (!protocol) return tl::unexpected(std::move(protocol).error().at(file.string()));
  return protocol;
}

}  // namespace trocar::trial
