#include "engine/workbench/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace trocar::workbench {
namespace {

constexpr std::string_view kVerified = "verified";
constexpr std::string_view kDiverged = "diverged at ";

}  // namespace

std::string unused_name(const Checkpoints& taken) {
  for (std::size_t number = 1;; ++number) {
    std::string name = fmt::format("Checkpoint {}", number);
    if (std::none_of(taken.begin(), taken.end(), [&](const auto& each) { return each.second == name; })) return name;
  }
}

ReplayFound found_of(const trial::ReplayResult& result) {
  return {result.verified, result.verified ? 0.0 : result.diverged_at_s.value_or(0.0)};
}

std::string to_text(const ReplayFound& found) {
  return found.verified ? std::string(kVerified) : fmt::format("{}{}", kDiverged, found.diverged_at_s);
}

Result<ReplayFound> replay_found_from(std::string_view text) {
  if (text == kVerified) return ReplayFound{true, 0.0};
  if (text.starts_with(kDiverged)) {
    const std::string number(text.substr(kDiverged.size()));
    char* end = nullptr;
    const double at_s = std::strtod(number.c_str(), &end);
    if (!number.empty() && *end == '\0' && std::isfinite(at_s)) return ReplayFound{false, at_s};
  }
  return fail(ErrorCode::kCorrupt, fmt::format("\"{}\" is not what a replay finds", text));
}

}  // namespace trocar::workbench
