#include "engine/workbench/comparing.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <utility>
#include <vector>

#include "engine/demonstration/motion.h"
#include "engine/spatial/units.h"

namespace trocar::workbench {
namespace {

constexpr std::string_view kHistory = "history:";

std::shared_ptr<const plot::Curve> deviation_of(const demonstration::Comparison& comparison, std::size_t arm,
                                                double gap_s) {
  std::vector<double> t_s;
  std::vector<double> mm;
  for (const demonstration::Match& match : comparison.matches) {
    if (!t_s.empty() && match.t_s - t_s.back() > gap_s) {
      t_s.push_back(0.5 * (t_s.back() + match.t_s));
      mm.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    t_s.push_back(match.t_s);
    mm.push_back(spatial::to_mm(match.deviation_m(arm)));
  }
  return std::make_shared<const plot::Curve>(std::move(t_s), std::move(mm));
}

}  // namespace

std::string to_words(const Against& against) {
  if (against.kind == Against::Kind::kOriginal) return "original";
  if (against.kind == Against::Kind::kHistory) return fmt::format("{}{}", kHistory, against.node);
  return fmt::format("{}", against.demonstration.value);
}

Result<std::optional<std::int64_t>> history_point_from(std::string_view text) {
  if (!text.starts_with(kHistory)) return std::optional<std::int64_t>();
  const std::string_view digits = text.substr(kHistory.size());
  std::int64_t node = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), node);
  if (error == std::errc() && end == digits.data() + digits.size() && node >= 0) return std::optional(node);
  return fail(ErrorCode::kInvalidArgument, fmt::format("'{}' is no point of the history; write history:12", text));
}

Result<std::shared_ptr<const demonstration::Demonstration>> counterpart(const demonstration::Demonstration& after,
                                                                        const Against& against, const Project& project,
                                                                        const ProjectAt& project_at) {
  if (against.kind == Against::Kind::kOriginal) {
    return std::make_shared<const demonstration::Demonstration>(demonstration::original_of(after));
  }
  const bool past = against.kind == Against::Kind::kHistory;
  std::shared_ptr<const Project> then;
  if (past) {
    TROCAR_ASSIGN_OR_RETURN(then, project_at(against.node));
  }
  const auto& demonstrations = (then ? *then : project).demonstrations;
  const auto found = demonstrations.find(past ? after.id : against.demonstration);
  if (found != demonstrations.end()) return found->second;
  return fail(ErrorCode::kNotFound,
              past ? fmt::format("{} was not in the project at point {} of its history", after.name, against.node)
                   : fmt::format("there is no demonstration {}", against.demonstration.value));
}

std::string described(const Against& against, const demonstration::Demonstration& before) {
  if (against.kind == Against::Kind::kOriginal) return "its original";
  if (against.kind == Against::Kind::kDemonstration) return before.name;
  return fmt::format("itself at point {} of the history", against.node);
}

std::shared_ptr<const ComparisonView> comparison_of(const ComparisonRequest& request) {
  if (request.before == nullptr && request.error.empty()) return nullptr;
  auto view = std::make_shared<ComparisonView>();
  view->of = request;
  view->error = request.error;
  if (request.before == nullptr || request.after == nullptr) return view;
  auto compared = demonstration::compare(*request.before, *request.after, request.settings.alignment, spatial::Grid{});
  if (compared) {
    view->comparison = std::move(*compared);
    const double gap_s = demonstration::motion_gap_s(request.after->samples);
    for (std::size_t arm = 0; arm < 2; ++arm) view->deviation_mm[arm] = deviation_of(*view->comparison, arm, gap_s);
  } else {
    view->error = compared.error().text();
  }
  return view;
}

}  // namespace trocar::workbench
