#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/demonstration/name.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/hdf5_process.h"
#include "engine/exchange/robomimic.h"
#include "engine/exchange/robomimic_foreign.h"
#include "engine/exchange/robomimic_header.h"
#include "engine/exchange/row_reader.h"

namespace trocar::exchange {
namespace {

using Json = nlohmann::ordered_json;
using Nodes = std::map<std::string, TreeNode>;

/// robosuite's usual one.
constexpr double kRobomimicRate_hz = 20.0;

const TreeNode* find(const Nodes& nodes, const std::string& path) {
  const auto found = nodes.find(path);
  return found == nodes.end() ? nullptr : &found->second;
}

/// "demo_2" before "demo_10".
bool comes_before(const std::string& a, const std::string& b) {
  const auto number = [](const std::string& name) {
    std::uint64_t value = 0;
    const std::size_t digits = name.find_first_of("0123456789");
    if (digits != std::string::npos) std::from_chars(name.data() + digits, name.data() + name.size(), value);
    return value;
  };
  return std::pair(number(a), std::string_view(a)) < std::pair(number(b), std::string_view(b));
}

/// Its samples as `states` has them.
Result<Imported> read_states(const TreeNode& states) {
  const auto names = states.attributes.find("columns");
  const auto* listed =
      names == states.attributes.end() ? nullptr : std::get_if<std::vector<std::string>>(&names->second);
  if (listed == nullptr || !states.holds_numbers() || states.shape.size() != 2 || states.shape[1] != listed->size()) {
    return fail(ErrorCode::kCorrupt, "states has no columns, or other ones than it names");
  }
  const Result<std::vector<const Column*>> order = columns_named(*listed);
  if (!order) return fail(ErrorCode::kCorrupt, order.error().text());
  RowReader reader(*order);
  std::vector<double> values(order->size());
  for (std::size_t row = 0; row < states.shape[0]; ++row) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = states.number(row * values.size() + i);
    const Status added = reader.add(values);
    if (!added) return fail(ErrorCode::kCorrupt, fmt::format("row {} of states: {}", row + 1, added.error().text()));
  }
  return reader.finish();
}

/// `env_args` of the file; 0 if they do not tell.
double rate_told(const Nodes& nodes) {
  const TreeNode* data = find(nodes, "data");
  if (data == nullptr || !data->attributes.contains("env_args")) return 0.0;
  const auto* text = std::get_if<std::string>(&data->attributes.at("env_args"));
  const Json arguments = text == nullptr ? Json() : Json::parse(*text, nullptr, false);
  const auto inside = [](const Json& object, const char* key) {
    return object.is_object() && object.contains(key) ? object.at(key) : Json();
  };
  const Json rate = inside(inside(arguments, "env_kwargs"), "control_freq");
  return rate.is_number() ? rate.get<double>() : 0.0;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 8;
  const std::size_t shown = std::min(names.size(), kShown);
  std::string text =
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  return names.size() > shown ? fmt::format("{} and {} more", text, names.size() - shown) : text;
}

std::vector<std::string> demonstrations_of(const Nodes& nodes) {
  std::vector<std::string> names;
  for (auto at = nodes.lower_bound("data/"); at != nodes.end() && at->first.starts_with("data/"); ++at) {
    const std::string name = at->first.substr(5);
    if (at->second.kind == TreeNode::Kind::kGroup && name.find('/') == std::string::npos) names.push_back(name);
  }
  std::sort(names.begin(), names.end(), comes_before);
  return names;
}

}  // namespace

Status RobomimicReader::take(TreeNode&& node) {
  const std::vector<std::string> parts = [&] {
    std::vector<std::string> all;
    std::string_view rest = node.path;
    for (std::size_t slash = 0; slash != std::string_view::npos;) {
      slash = rest.find('/');
      all.emplace_back(rest.substr(0, slash));
      if (slash != std::string_view::npos) rest.remove_prefix(slash + 1);
    }
    return all;
  }();
  if (parts[0] != "data" && parts[0] != "mask") return {};
  const bool used = parts.size() < 4 || (parts.size() == 4 && (parts[2] == "obs" || parts[2] == "trocar"));
  if (!used) return {};
  // Of all else it is enough to know that it is there.
  const bool own = parts.size() == 3 && parts[2] == "states" && node.attributes.contains("columns");
  const bool known = parts.size() == 4 && (parts[2] == "trocar" || is_known_observation(parts[3]));
  if (!own && !known) node.data.clear();
  nodes_[node.path] = std::move(node);
  return {};
}

std::vector<std::string> RobomimicReader::masks_of(const std::string& name) const {
  std::vector<std::string> made;
  if (const TreeNode* group = find(nodes_, "mask"); group != nullptr && group->attributes.contains("made_by_trocar")) {
    if (const auto* texts = std::get_if<std::vector<std::string>>(&group->attributes.at("made_by_trocar")))
      made = *texts;
  }
  std::vector<std::string> keys;
  for (auto at = nodes_.lower_bound("mask/"); at != nodes_.end() && at->first.starts_with("mask/"); ++at) {
    const std::string key = at->first.substr(5);
    const std::vector<std::string>& texts = at->second.texts;
    if (std::find(texts.begin(), texts.end(), name) == texts.end()) continue;
    const bool named = demonstration::check_name(key).has_value();
    if (named && std::find(made.begin(), made.end(), key) == made.end()) keys.push_back(key);
  }
  return keys;
}

Result<std::vector<std::string>> RobomimicReader::chosen() const {
  const std::vector<std::string> all = demonstrations_of(nodes_);
  if (all.empty()) return fail(ErrorCode::kCorrupt, "the HDF5 file has no group data with demonstrations in it");
  if (options_.only.empty()) return all;
  std::vector<std::string> wanted;
  for (const std::string& name : options_.only) {
    const TreeNode* mask = find(nodes_, "mask/" + name);
    if (mask != nullptr) {
      wanted.insert(wanted.end(), mask->texts.begin(), mask->texts.end());
    } else if (std::find(all.begin(), all.end(), name) != all.end()) {
      wanted.push_back(name);
    } else {
      return fail(ErrorCode::kNotFound, fmt::format("the file has no demonstration or filter key \"{}\"; there is {}",
                                                    name.substr(0, 60), listed(all)));
    }
  }
  std::vector<std::string> there;
  for (const std::string& name : all) {
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) there.push_back(name);
  }
  if (there.empty()) return fail(ErrorCode::kNotFound, "the filter key names no demonstration of the file");
  return there;
}

Result<Imported> RobomimicReader::demonstration(const std::string& name) const {
  const std::string group = "data/" + name;
  const TreeNode* header = find(nodes_, group + "/trocar/header");
  const TreeNode* states = find(nodes_, group + "/states");
  if (header != nullptr && states != nullptr) {
    TROCAR_ASSIGN_OR_RETURN(Imported imported, read_states(*states));
    const TreeNode* world = find(nodes_, group + "/trocar/initial_world");
    if (header->texts.size() != 1) return fail(ErrorCode::kCorrupt, "what Trocar wrote beside its samples is damaged");
    const bool bytes = world != nullptr && world->kind == TreeNode::Kind::kUint8;
    TROCAR_RETURN_IF_ERROR(apply_robomimic_header(header->texts.front(), bytes ? world->data : "", imported));
    return imported;
  }
  const double told_hz = rate_told(nodes_);
  const bool guessed = options_.rate_hz == 0.0 && !(told_hz >= 0.1 && told_hz <= Tick::kPerSecond);
  const double rate_hz = guessed ? kRobomimicRate_hz : options_.rate_hz > 0.0 ? options_.rate_hz : told_hz;
  TROCAR_ASSIGN_OR_RETURN(Imported imported, read_foreign(nodes_, group, rate_hz));
  imported.found.push_back(
      guessed ? fmt::format("the file tells no rate; {:g} samples a second are assumed", rate_hz)
              : fmt::format("times are those of {:g} samples a second, in whole milliseconds", rate_hz));
  imported.name = name;
  return imported;
}

std::vector<std::string> RobomimicReader::masks_beyond() const {
  const std::vector<std::string> all = demonstrations_of(nodes_);
  std::vector<std::string> sentences;
  for (auto at = nodes_.lower_bound("mask/"); at != nodes_.end() && at->first.starts_with("mask/"); ++at) {
    for (const std::string& name : at->second.texts) {
      if (std::find(all.begin(), all.end(), name) != all.end()) continue;
      sentences.push_back(fmt::format("the filter key {} names {}, which the file does not hold",
                                      at->first.substr(5).substr(0, 60), name.substr(0, 60)));
    }
  }
  constexpr std::size_t kMost = 5;
  if (sentences.size() > kMost) {
    const std::size_t more = sentences.size() - kMost;
    sentences.resize(kMost);
    sentences.push_back(fmt::format("{} more are named by filter keys and not there", more));
  }
  return sentences;
}

Result<std::vector<Imported>> RobomimicReader::finish() {
  if (options_.rate_hz != 0.0 && !(options_.rate_hz >= 0.1 && options_.rate_hz <= Tick::kPerSecond)) {
    return fail(ErrorCode::kInvalidArgument, "the rate must be from 0.1 to 1000 samples a second");
  }
  TROCAR_ASSIGN_OR_RETURN(const std::vector<std::string> names, chosen());
  std::vector<Imported> all;
  for (const std::string& name : names) {
    Result<Imported> one = demonstration(name);
    if (!one) return fail(one.error().code(), fmt::format("{}: {}", name, one.error().text()));
    const std::vector<demonstration::Sample>& samples = one->recording.samples;
    const double length_s = samples.back().t_s() - samples.front().t_s();
    for (const std::string& key : masks_of(name)) {
      const bool there = std::any_of(one->notes.begin(), one->notes.end(), [&key](const demonstration::AddNote& note) {
        return note.tag == "mask" && note.text == key;
      });
      if (!there) one->notes.push_back({key, 0.0, length_s, "mask", 0});
    }
    all.push_back(std::move(*one));
  }
  for (std::string& sentence : masks_beyond()) all.front().found.push_back(std::move(sentence));
  return all;
}

Result<std::vector<Imported>> read_robomimic(const std::filesystem::path& path, const RobomimicOptions& options) {
  RobomimicReader reader(options);
  TROCAR_RETURN_IF_ERROR(read_hdf5(path, [&reader](TreeNode&& node) { return reader.take(std::move(node)); }));
  return reader.finish();
}

}  // namespace trocar::exchange
