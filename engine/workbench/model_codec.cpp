#include "engine/workbench/model_codec.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "engine/core/hash.h"

namespace trocar::workbench {
namespace {

using learning::CellSequence;
using learning::Model;
using nlohmann::json;

constexpr int kFormat = 1;
constexpr int kLargestGrid = 256;

tl::unexpected<Error> corrupt(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

template <typename T>
void write(std::string& bytes, const std::vector<T>& numbers) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::uint64_t count = numbers.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
}

template <typename T>
bool read(std::string_view& bytes, std::vector<T>& numbers) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count > bytes.size() / sizeof(T)) return false;
  numbers.resize(count);
  if (count > 0) std::memcpy(numbers.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

json options_to_json(const learning::TrainOptions& options) {
  return {{"method", std::string(to_string(options.method))},
          {"theta_rate", options.theta_rate},
          {"q_rate", options.q_rate},
          {"discount", options.discount},
          {"epsilon", options.epsilon},
          {"episodes", options.episodes},
          {"seed", options.seed},
          {"safe_radius", options.safe_radius},
          {"start_spread", options.start_spread},
          {"theta_prior", options.theta_prior},
          {"regularisation", options.regularisation}};
}

/// Takes typed values out of nested objects; `good()` turns false at the first that does not fit.
class Taker {
 public:
  bool good() const { return good_; }
  double number(const json& object, const char* key) {
    const json* found = find(object, key);
    if (found == nullptr || !found->is_number()) return failed(0.0);
    return found->get<double>();
  }
  std::int64_t whole(const json& object, const char* key, std::int64_t low, std::int64_t high) {
    const json* found = find(object, key);
    if (found == nullptr || !found->is_number_integer()) return failed(low);
    const auto value = found->get<std::int64_t>();
    return value < low || value > high ? failed(low) : value;
  }
  std::uint64_t seed(const json& object, const char* key) {
    const json* found = find(object, key);
    if (found == nullptr || !found->is_number_unsigned()) return failed(std::uint64_t{0});
    return found->get<std::uint64_t>();
  }
  std::string text(const json& object, const char* key) {
    const json* found = find(object, key);
    if (found == nullptr || !found->is_string()) return failed(std::string());
    return found->get<std::string>();
  }
  json list(const json& object, const char* key) {
    const json* found = find(object, key);
    if (found == nullptr || !found->is_array()) return failed(json::array());
    return *found;
  }
  template <typename T>
  T failed(T value) {
    good_ = false;
    return value;
  }

 private:
  static const json* find(const json& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }
  bool good_ = true;
};

learning::TrainOptions take_options(Taker& taker, const json& meta) {
  const json object = meta.is_object() ? meta.value("options", json::object()) : json::object();
  constexpr std::int64_t kMany = 2'000'000'000;
  learning::TrainOptions options;
  const Result<learning::Method> method = learning::method_from(taker.text(object, "method"));
  options.method = method ? *method : taker.failed(learning::Method::kEgMaxent);
  options.theta_rate = taker.number(object, "theta_rate");
  options.q_rate = taker.number(object, "q_rate");
  options.discount = taker.number(object, "discount");
  options.epsilon = taker.number(object, "epsilon");
  options.episodes = static_cast<int>(taker.whole(object, "episodes", 0, kMany));
  options.seed = taker.seed(object, "seed");
  options.safe_radius = static_cast<int>(taker.whole(object, "safe_radius", -kMany, kMany));
  options.start_spread = static_cast<int>(taker.whole(object, "start_spread", -kMany, kMany));
  options.theta_prior = taker.number(object, "theta_prior");
  options.regularisation = taker.number(object, "regularisation");
  return options;
}

void take_lattice(Taker& taker, const json& meta, Model& model) {
  model.grid.n = static_cast<int>(taker.whole(meta, "grid_n", 1, kLargestGrid));
  model.grid.cell_m = taker.number(meta, "grid_cell_m");
  const json origin = taker.list(meta, "grid_p_WGo");
  for (std::size_t i = 0; i < 3; ++i) {
    const bool fits = origin.size() == 3 && origin[i].is_number();
    model.grid.p_WGo[static_cast<Eigen::Index>(i)] = fits ? origin[i].get<double>() : taker.failed(0.0);
  }
  const std::int64_t last = model.grid.cell_count() - 1;
  model.start.value = static_cast<std::int32_t>(taker.whole(meta, "start", 0, last));
  model.goal.value = static_cast<std::int32_t>(taker.whole(meta, "goal", 0, last));
  model.seconds = taker.number(meta, "seconds");
}

void take_entry(Taker& taker, const json& meta, ModelEntry& entry) {
  entry.name = taker.text(meta, "name");
  entry.created = taker.text(meta, "created");
  const std::string segment = taker.text(meta, "segment");
  if (segment.size() == 1 && segment[0] >= 'A' && segment[0] <= 'E') {
    entry.segment = static_cast<demonstration::Segment>(segment[0] - 'A');
  } else {
    taker.failed(0);
  }
  for (const json& id : taker.list(meta, "demonstrations")) {
    entry.demonstrations.push_back({id.is_number_integer() ? id.get<std::int64_t>() : taker.failed(std::int64_t{0})});
  }
  for (const json& item : taker.list(meta, "demonstration_hashes")) {
    const std::string text = item.is_string() ? item.get<std::string>() : taker.failed(std::string());
    std::uint64_t hash = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
    if (parsed.ec != std::errc()) taker.failed(0);
    entry.demonstration_hashes.push_back(hash);
  }
}

bool cells_fit(const std::vector<std::int32_t>& cells, int cell_count) {
  for (const std::int32_t cell : cells) {
    if (cell < 0 || cell >= cell_count) return false;
  }
  return true;
}

bool take_experts(std::string_view& bytes, Model& model) {
  std::vector<std::uint64_t> lengths;
  std::vector<std::int32_t> cells;
  if (!read(bytes, lengths) || !read(bytes, cells) || !cells_fit(cells, model.grid.cell_count())) return false;
  std::size_t at = 0;
  for (const std::uint64_t length : lengths) {
    if (length > cells.size() - at) return false;
    CellSequence sequence;
    for (std::uint64_t i = 0; i < length; ++i) sequence.push_back({cells[at++]});
    model.experts.push_back(std::move(sequence));
  }
  return at == cells.size();
}

/// Each field of the model is there for all cells, or (what a method does not make) for none.
bool take_arrays(std::string_view bytes, Model& model) {
  std::vector<std::uint8_t> safe;
  if (!take_experts(bytes, model) || !read(bytes, safe) || !read(bytes, model.theta) || !read(bytes, model.q) ||
      !read(bytes, model.value) || !read(bytes, model.visits) || !read(bytes, model.tried) ||
      !read(bytes, model.curve) || !bytes.empty()) {
    return false;
  }
  const auto cells = static_cast<std::size_t>(model.grid.cell_count());
  const auto fits = [](std::size_t size, std::size_t full) { return size == 0 || size == full; };
  if (!fits(safe.size(), cells) || !fits(model.theta.size(), cells) || !fits(model.q.size(), 6 * cells) ||
      !fits(model.value.size(), cells) || !fits(model.visits.size(), cells) || !fits(model.tried.size(), cells)) {
    return false;
  }
  if (!safe.empty()) model.safe = spatial::CellSet(model.grid);
  for (std::size_t i = 0; i < safe.size(); ++i) {
    if (safe[i] != 0) model.safe.insert({static_cast<std::int32_t>(i)});
  }
  return true;
}

}  // namespace

EncodedModel encode_model(const ModelEntry& entry) {
  const Model& model = *entry.model;
  json hashes = json::array();
  for (const std::uint64_t hash : entry.demonstration_hashes) hashes.push_back(to_hex(hash));
  json ids = json::array();
  for (const DemonstrationId id : entry.demonstrations) ids.push_back(id.value);
  const json meta = {{"format", kFormat},
                     {"name", entry.name},
                     {"segment", std::string(1, demonstration::letter(entry.segment))},
                     {"created", entry.created},
                     {"demonstrations", ids},
                     {"demonstration_hashes", hashes},
                     {"options", options_to_json(model.options)},
                     {"grid_p_WGo", {model.grid.p_WGo.x(), model.grid.p_WGo.y(), model.grid.p_WGo.z()}},
                     {"grid_cell_m", model.grid.cell_m},
                     {"grid_n", model.grid.n},
                     {"start", model.start.value},
                     {"goal", model.goal.value},
                     {"seconds", model.seconds}};
  EncodedModel encoded{meta.dump(-1, ' ', false, json::error_handler_t::replace), {}};
  std::vector<std::uint64_t> lengths;
  std::vector<std::int32_t> cells;
  for (const CellSequence& sequence : model.experts) {
    lengths.push_back(sequence.size());
    for (const spatial::CellIndex cell : sequence) cells.push_back(cell.value);
  }
  write(encoded.bytes, lengths);
  write(encoded.bytes, cells);
  write(encoded.bytes, model.safe.flags());
  write(encoded.bytes, model.theta);
  write(encoded.bytes, model.q);
  write(encoded.bytes, model.value);
  write(encoded.bytes, model.visits);
  write(encoded.bytes, model.tried);
  write(encoded.bytes, model.curve);
  return encoded;
}

Result<ModelEntry> decode_model(std::string_view meta_text, std::string_view bytes) {
  const json meta = json::parse(meta_text, nullptr, false);
  if (!meta.is_object()) return corrupt("the model's description is not a JSON object");
  Taker taker;
  if (taker.whole(meta, "format", 0, kLargestGrid) != kFormat && taker.good()) {
    return fail(ErrorCode::kUnsupported, "the model has a layout that this version cannot read");
  }
  ModelEntry entry;
  Model model;
  take_entry(taker, meta, entry);
  model.options = take_options(taker, meta);
  take_lattice(taker, meta, model);
  if (!taker.good()) return corrupt("the model's description misses a value or has one out of range");
  if (!take_arrays(bytes, model)) return corrupt("the model's arrays do not fit its lattice");
  entry.model = std::make_shared<const Model>(std::move(model));
  return entry;
}

}  // namespace trocar::workbench
