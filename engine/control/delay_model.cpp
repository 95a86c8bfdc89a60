#include "engine/control/delay_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/core/file.h"

namespace trocar::control {
namespace {

constexpr double kLongest_s = 10.0;
constexpr std::string_view kForms =
    "a delay is 40, normal:20:5, lognormal:20:5, ar1:20:5 or trace:FILE in milliseconds, and may end in "
    ",stall:0.01:200";

Error bad(std::string_view text) {
  return Error(ErrorCode::kInvalidArgument, fmt::format("{}; \"{}\" is none", kForms, text));
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (!whole || !std::isfinite(value) || value < 0.0) return std::nullopt;
  return value;
}

std::vector<std::string_view> pieces(std::string_view text, char separator) {
  std::vector<std::string_view> found;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    found.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return found;
}

Result<std::vector<double>> read_trace(const std::string& file) {
  TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(file));
  std::vector<double> trace;
  int line = 0;
  for (std::string_view each : pieces(text, '\n')) {
    ++line;
    if (!each.empty() && each.back() == '\r') each.remove_suffix(1);
    if (each.empty()) continue;
    const auto ms = number(each);
    if (!ms || *ms > 1e3 * kLongest_s) {
      return tl::unexpected(
          Error(ErrorCode::kCorrupt, fmt::format("line {} is no delay in milliseconds", line)).at(file));
    }
    trace.push_back(1e-3 * *ms);
  }
  if (trace.empty()) return tl::unexpected(Error(ErrorCode::kCorrupt, "there is no delay in the file").at(file));
  return trace;
}

constexpr std::array<std::pair<std::string_view, DelayKind>, 3> kSpread{
    {{"normal", DelayKind::kNormal}, {"lognormal", DelayKind::kLogNormal}, {"ar1", DelayKind::kAutoregressive}}};

}  // namespace

Result<DelayOptions> delay_from(std::string_view text) {
  DelayOptions options;
  const std::size_t comma = text.find(",stall:");
  std::string_view main = text.substr(0, comma);
  if (comma != std::string_view::npos) {
    const auto stall = pieces(text.substr(comma + 7), ':');
    const auto chance = stall.size() == 2 ? number(stall[0]) : std::nullopt;
    const auto ms = stall.size() == 2 ? number(stall[1]) : std::nullopt;
    if (!chance || *chance > 1.0 || !ms || *ms > 1e3 * kLongest_s) return tl::unexpected(bad(text));
    options.stall_chance = *chance;
    options.stall_s = 1e-3 * *ms;
  }
  if (main.starts_with("trace:")) {
    options.kind = DelayKind::kTrace;
    options.file = main.substr(6);
    TROCAR_ASSIGN_OR_RETURN(options.trace_s, read_trace(std::string(main.substr(6))));
    return options;
  }
  const auto words = pieces(main, ':');
  if (words.size() == 1) {
    const auto ms = number(words[0]);
    if (!ms || *ms > 1e3 * kLongest_s) return tl::unexpected(bad(text));
    options.mean_s = 1e-3 * *ms;
    return options;
  }
  const auto kind = std::find_if(kSpread.begin(), kSpread.end(), [&](const auto& k) { return k.first == words[0]; });
  const auto mean = words.size() == 3 ? number(words[1]) : std::nullopt;
  const auto deviation = words.size() == 3 ? number(words[2]) : std::nullopt;
  if (kind == kSpread.end() || !mean || !deviation || *mean > 1e3 * kLongest_s || *deviation > 1e3 * kLongest_s) {
    return tl::unexpected(bad(text));
  }
  options.kind = kind->second;
  options.mean_s = 1e-3 * *mean;
  options.deviation_s = 1e-3 * *deviation;
  return options;
}

std::string to_string(const DelayOptions& options) {
  std::string text;
  if (options.kind == DelayKind::kConstant) text = fmt::format("{:g}", 1e3 * options.mean_s);
  if (options.kind == DelayKind::kTrace) text = "trace:" + options.file;
  for (const auto& [name, kind] : kSpread) {
    if (kind == options.kind) text = fmt::format("{}:{:g}:{:g}", name, 1e3 * options.mean_s, 1e3 * options.deviation_s);
  }
  if (options.stall_chance > 0.0) text += fmt::format(",stall:{:g}:{:g}", options.stall_chance, 1e3 * options.stall_s);
  return text;
}

DelayModel::DelayModel(DelayOptions options) : options_(std::move(options)), random_(options_.seed) {}

double DelayModel::draw() {
  const double mean = options_.mean_s;
  const double sigma = options_.deviation_s;
  switch (options_.kind) {
    case DelayKind::kConstant:
      return mean;
    case DelayKind::kNormal:
      return mean + sigma * random_.normal();
    case DelayKind::kLogNormal: {
      if (mean <= 0.0) return 0.0;
      // So that mean and deviation are those asked for.
      const double s2 = std::log1p(sigma * sigma / (mean * mean));
      return std::exp(std::log(mean) - 0.5 * s2 + std::sqrt(s2) * random_.normal());
    }
    case DelayKind::kAutoregressive: {
      const double phi = options_.correlation;
      state_ = begun_ ? phi * state_ + std::sqrt(1.0 - phi * phi) * random_.normal() : random_.normal();
      begun_ = true;
      return mean + sigma * state_;
    }
    case DelayKind::kTrace:
      return options_.trace_s[next_++ % options_.trace_s.size()];
  }
  return mean;
}

double DelayModel::arrival_s(double sent_s) {
  double delay = std::clamp(draw(), 0.0, kLongest_s);
  if (options_.stall_chance > 0.0 && random_.uniform() < options_.stall_chance) delay += options_.stall_s;
  last_arrival_s_ = std::max(last_arrival_s_, sent_s + delay);
  return last_arrival_s_;
}

}  // namespace trocar::control
