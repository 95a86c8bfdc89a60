#include "engine/trial/trial_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/hash.h"

namespace trocar::trial {
namespace {

using demonstration::Outcome;
using demonstration::Segment;
using nlohmann::json;

constexpr std::array<TrialEventKind, 7> kKinds{
    TrialEventKind::kPedal,   TrialEventKind::kState, TrialEventKind::kGuard,   TrialEventKind::kSegment,
    TrialEventKind::kOutcome, TrialEventKind::kAgent, TrialEventKind::kIncident};
constexpr std::array<Outcome, 6> kOutcomes{Outcome::kUnfinished, Outcome::kSuccess, Outcome::kDropped,
                                           Outcome::kAborted,    Outcome::kFault,   Outcome::kUnknown};

tl::unexpected<Error> corrupt(std::string why) {
  return fail(ErrorCode::kCorrupt, "a trial's record " + std::move(why));
}

/// Reads members that may be missing; the first that is of another kind spoils it.
class Reader {
 public:
  explicit Reader(const json& object) : object_(object) {}

  template <typename T>
  void read(const char* key, T& value) {
    const auto found = object_.find(key);
    if (found == object_.end() || !bad_.empty()) return;
    if constexpr (std::is_same_v<T, std::string>) {
      found->is_string() ? void(value = found->template get<std::string>()) : spoil(key);
    } else if constexpr (std::is_same_v<T, bool>) {
      found->is_boolean() ? void(value = found->template get<bool>()) : spoil(key);
    } else if constexpr (std::is_floating_point_v<T>) {
      found->is_number() && std::isfinite(found->template get<double>()) ? void(value = found->template get<double>())
                                                                         : spoil(key);
    } else {
      found->is_number_integer() ? void(value = found->template get<T>()) : spoil(key);
    }
  }
  const json* list(const char* key) {
    const auto found = object_.find(key);
    if (found == object_.end()) return nullptr;
    if (!found->is_array()) return spoil(key), nullptr;
    return &*found;
  }
  void spoil(const std::string& key) {
    if (bad_.empty()) bad_ = key;
  }
  const std::string& bad() const { return bad_; }

 private:
  const json& object_;
  std::string bad_;
};

json json_of(const TrialCounts& counts) {
  return {{"attempts", counts.attempts},
          {"misses", counts.misses},
          {"clutches", counts.clutches},
          {"clutch_s", counts.clutch_s},
          {"hand_overs", counts.hand_overs},
          {"agent_steps", counts.agent_steps},
          {"agent_s", counts.agent_s},
          {"limit_hits", counts.limit_hits},
          {"unreachable", counts.unreachable},
          {"delay_mean_s", counts.delay_mean_s},
          {"delay_worst_s", counts.delay_worst_s},
          {"segment_s", counts.segment_s}};
}

void read_counts(Reader& reader, TrialCounts& counts) {
  reader.read("attempts", counts.attempts);
  reader.read("misses", counts.misses);
  reader.read("clutches", counts.clutches);
  reader.read("clutch_s", counts.clutch_s);
  reader.read("hand_overs", counts.hand_overs);
  reader.read("agent_steps", counts.agent_steps);
  reader.read("agent_s", counts.agent_s);
  reader.read("limit_hits", counts.limit_hits);
  reader.read("unreachable", counts.unreachable);
  reader.read("delay_mean_s", counts.delay_mean_s);
  reader.read("delay_worst_s", counts.delay_worst_s);
  const json* segments = reader.list("segment_s");
  if (segments == nullptr) return;
  for (std::size_t i = 0; i < counts.segment_s.size(); ++i) {
    if (i < segments->size() && (*segments)[i].is_number()) counts.segment_s[i] = (*segments)[i].get<double>();
  }
}

void read_models(Reader& reader, std::vector<TrialRecord::ModelUsed>& models) {
  const json* list = reader.list("models");
  if (list == nullptr) return;
  for (const json& each : *list) {
    if (!each.is_object()) return reader.spoil("models");
    TrialRecord::ModelUsed model;
    std::string segment;
    std::string hash;
    Reader inner(each);
    inner.read("name", model.name);
    inner.read("segment", segment);
    inner.read("hash", hash);
    const auto [end, error] = std::from_chars(hash.data(), hash.data() + hash.size(), model.hash, 16);
    if (!inner.bad().empty() || error != std::errc{} || end != hash.data() + hash.size()) return reader.spoil("models");
    model.segment = segment == "C" ? Segment::kC : Segment::kA;
    models.push_back(std::move(model));
  }
}

void read_events(Reader& reader, std::vector<TrialEvent>& events) {
  const json* list = reader.list("events");
  if (list == nullptr) return;
  for (const json& each : *list) {
    const bool good = each.is_array() && each.size() == 3 && each[0].is_number_integer() && each[1].is_string() &&
                      each[2].is_string();
    if (!good) return reader.spoil("events");
    TrialEvent event{each[0].get<std::int64_t>(), TrialEventKind::kState, each[2].get<std::string>()};
    const auto kind = each[1].get<std::string>();
    bool known = false;
    for (const TrialEventKind k : kKinds) {
      if (to_string(k) == kind) event.kind = k, known = true;
    }
    if (!known) return reader.spoil("events");
    events.push_back(std::move(event));
  }
}

}  // namespace

std::string to_json(const TrialRecord& record) {
  json object = {{"mode", to_string(record.mode)},
                 {"operator", record.operator_kind},
                 {"skill", record.skill},
                 {"assistant", record.assistant},
                 {"subject", record.subject},
                 {"session", record.session},
                 {"block_number", record.block_number},
                 {"transfer", record.transfer},
                 {"in_results", record.in_results},
                 {"seed", record.seed},
                 {"block", record.block},
                 {"goal", record.goal},
                 {"scale", record.scale},
                 {"agent_rate_hz", record.agent_rate_hz},
                 {"anchor", to_string(record.anchor)},
                 {"delay", record.delay},
                 {"outcome", to_string(record.outcome)},
                 {"placed", record.placed},
                 {"interrupted", record.interrupted},
                 {"duration_s", record.duration_s},
                 {"counts", json_of(record.counts)},
                 {"path_length_m", record.metrics.path_length_m},
                 {"economy", record.metrics.economy},
                 {"smoothness", record.metrics.smoothness},
                 {"agent_share", record.metrics.agent_share}};
  if (record.completion_s) object["completion_s"] = *record.completion_s;
  if (record.begin_p_W) object["begin_m"] = {record.begin_p_W->x(), record.begin_p_W->y(), record.begin_p_W->z()};
  json models = json::array();
  for (const TrialRecord::ModelUsed& model : record.models) {
    models.push_back({{"name", model.name},
                      {"segment", std::string(1, demonstration::letter(model.segment))},
                      {"hash", fmt::format("{:016x}", model.hash)}});
  }
  object["models"] = std::move(models);
  json events = json::array();
  for (const TrialEvent& event : record.events) events.push_back({event.tick, to_string(event.kind), event.text});
  object["events"] = std::move(events);
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<TrialRecord> record_from_json(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt("must be a JSON object");
  TrialRecord record;
  Reader reader(object);
  std::string mode = "MT";
  std::string anchor = "board";
  std::string outcome = "unknown";
  reader.read("mode", mode);
  reader.read("operator", record.operator_kind);
  reader.read("skill", record.skill);
  reader.read("assistant", record.assistant);
  reader.read("subject", record.subject);
  reader.read("session", record.session);
  reader.read("block_number", record.block_number);
  reader.read("transfer", record.transfer);
  reader.read("in_results", record.in_results);
  reader.read("seed", record.seed);
  reader.read("block", record.block);
  reader.read("goal", record.goal);
  reader.read("scale", record.scale);
  reader.read("agent_rate_hz", record.agent_rate_hz);
  reader.read("anchor", anchor);
  reader.read("delay", record.delay);
  reader.read("outcome", outcome);
  reader.read("placed", record.placed);
  reader.read("interrupted", record.interrupted);
  reader.read("duration_s", record.duration_s);
  if (object.contains("completion_s")) {
    record.completion_s = 0.0;
    reader.read("completion_s", *record.completion_s);
  }
  if (const json* begin = reader.list("begin_m")) {
    const bool place = begin->size() == 3 && std::all_of(begin->begin(), begin->end(), [](const json& value) {
                         return value.is_number() && std::isfinite(value.get<double>());
                       });
    if (!place) reader.spoil("begin_m");
    if (place) record.begin_p_W = {(*begin)[0].get<double>(), (*begin)[1].get<double>(), (*begin)[2].get<double>()};
  }
  reader.read("path_length_m", record.metrics.path_length_m);
  reader.read("economy", record.metrics.economy);
  reader.read("smoothness", record.metrics.smoothness);
  reader.read("agent_share", record.metrics.agent_share);
  if (const auto counts = object.find("counts"); counts != object.end() && counts->is_object()) {
    Reader inner(*counts);
    read_counts(inner, record.counts);
    if (!inner.bad().empty()) return corrupt(fmt::format("has a strange {}", inner.bad()));
  }
  read_models(reader, record.models);
  read_events(reader, record.events);
  if (!reader.bad().empty()) return corrupt(fmt::format("has a strange {}", reader.bad()));
  TROCAR_ASSIGN_OR_RETURN(record.mode, mode_from(mode));
  record.anchor = anchor == "target" ? Anchor::kTarget : Anchor::kBoard;
  record.outcome = Outcome::kUnknown;
  for (const Outcome known : kOutcomes) {
    if (to_string(known) == outcome) record.outcome = known;
  }
  // Records of version 0.1.0 before this had the time of a drop there.
  if (record.outcome != Outcome::kSuccess) record.completion_s.reset();
  return record;
}

}  // namespace trocar::trial
