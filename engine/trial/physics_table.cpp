// Physics rollouts as rows of a file, and back: what a run that was stopped goes on from.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "engine/trial/physics_rollout.h"

namespace trocar::trial {
namespace {

using spatial::CellIndex;

constexpr std::string_view kHeader =
    "i,j,k,end,steps,outside_steps,duration_s,length_m,pushed_m,state_hash,model_hash,seed,continuous,segment,block,"
    "goal,epsilon,"
    "delay_s,noise_m,time_limit_s";
constexpr std::size_t kFields = 20;

std::vector<std::string_view> pieces(std::string_view text, char separator) {
  std::vector<std::string_view> found;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    found.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return found;
}

template <typename T>
bool read_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}
bool read_hash(std::string_view text, std::uint64_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return error == std::errc{} && end == text.data() + text.size();
}

std::optional<PhysicsEnd> end_from(std::string_view text) {
  for (int i = 0; i < kPhysicsEnds; ++i) {
    if (to_string(static_cast<PhysicsEnd>(i)) == text) return static_cast<PhysicsEnd>(i);
  }
  return std::nullopt;
}

/// What a file says of whose rollouts these are.
std::string origin(const learning::Model& model, const PhysicsOptions& options) {
  const Perturbation& how = options.perturbed;
  return fmt::format("{:016x},{},{:d},{},{},{},{},{},{},{}", model.hash(), options.seed, options.continuous,
                     demonstration::letter(options.segment), options.block, options.goal, how.epsilon, how.delay_s,
                     how.noise_m, options.time_limit_s);
}

}  // namespace

std::string physics_csv(const learning::Model& model, const std::vector<CellIndex>& starts,
                        const PhysicsOptions& options, const PhysicsRollouts& rollouts) {
  const std::string whose = origin(model, options);
  std::string csv(kHeader);
  csv += '\n';
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (!rollouts[i]) continue;
    const PhysicsRollout& r = *rollouts[i];
    const spatial::CellCoordinates c = model.grid.coordinates(starts[i]);
    // All digits: what is read again is the same number.
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{:016x},{}\n", c.x, c.y, c.z, to_string(r.end), r.steps,
                       r.outside_steps, r.duration_s, r.length_m, r.pushed_m, r.state_hash, whose);
  }
  return csv;
}

Result<PhysicsRollouts> parse_physics_csv(std::string_view csv, const learning::Model& model,
                                          const std::vector<CellIndex>& starts, const PhysicsOptions& options) {
  const std::vector<std::string_view> lines = pieces(csv, '\n');
  if (lines.front() != kHeader) return fail(ErrorCode::kCorrupt, "this is no table of physics rollouts");
  const std::string whose = origin(model, options);
  std::map<std::int32_t, PhysicsRollout> by_cell;
  for (std::size_t n = 1; n < lines.size(); ++n) {
    if (lines[n].empty()) continue;
    const std::vector<std::string_view> fields = pieces(lines[n], ',');
    spatial::CellCoordinates cell;
    PhysicsRollout r;
    const auto end = fields.size() == kFields ? end_from(fields[3]) : std::nullopt;
    if (!end || !read_number(fields[0], cell.x) || !read_number(fields[1], cell.y) || !read_number(fields[2], cell.z) ||
        !model.grid.contains(cell) || !read_number(fields[4], r.steps) || !read_number(fields[5], r.outside_steps) ||
        !read_number(fields[6], r.duration_s) || !read_number(fields[7], r.length_m) ||
        !read_number(fields[8], r.pushed_m) || !read_hash(fields[9], r.state_hash)) {
      return fail(ErrorCode::kCorrupt, fmt::format("line {} is no physics rollout", n + 1));
    }
    if (!lines[n].ends_with("," + whose)) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("line {} is of another model, seed, block or other options", n + 1));
    }
    r.end = *end;
    by_cell[model.grid.index(cell).value] = r;
  }
  PhysicsRollouts rollouts(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (const auto found = by_cell.find(starts[i].value); found != by_cell.end()) rollouts[i] = found->second;
  }
  return rollouts;
}

}  // namespace trocar::trial
