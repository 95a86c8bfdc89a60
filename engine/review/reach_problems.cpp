// Setpoints beyond the joints' limits.
#include <fmt/format.h>

#include "engine/review/problem_parts.h"
#include "engine/spatial/units.h"

namespace trocar::review {
namespace {

using namespace demonstration;

constexpr int kInsertion = 2;
/// Rounding of a pose that was typed or kept with few digits.
constexpr double kRounding = 1e-6;
/// Where no joints exist at all.
constexpr double kNowhere = 1e9;

std::string amount(int joint, double value) {
  return joint == kInsertion ? fmt::format("{:.1f} mm", spatial::to_mm(value))
                             : fmt::format("{:.1f}°", spatial::to_degrees(value));
}

std::string sentence(std::size_t arm, const ToolReview& worst) {
  if (!worst.reachable) return fmt::format("no joints lead to where the {} tool is told to be", tool_name(arm));
  const kinematics::Excess& excess = worst.excess;
  return fmt::format("the {} arm's {} joint would be {} beyond its limit of {}", tool_name(arm),
                     kinematics::joint_name(excess.joint), amount(excess.joint, excess.beyond),
                     amount(excess.joint, excess.limit));
}

}  // namespace

void add_reach_problems(const Reviewed& of, std::vector<Problem>& found) {
  // An import's arms may have stood elsewhere than ours do.
  const bool imported = of.document.recording && of.document.recording->provenance.operator_kind == "imported";
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const auto runs = runs_of(of, of.clearance.perhaps_beyond_reach(arm), [&](std::size_t i) -> std::optional<double> {
      const ToolReview tool = of.clearance[i][arm];
      if (!tool.reachable) return kNowhere;
      if (tool.excess.beyond <= kRounding) return std::nullopt;
      return tool.excess.joint == kInsertion ? spatial::to_mm(tool.excess.beyond)
                                             : spatial::to_degrees(tool.excess.beyond);
    });
    for (const ProblemRun& run : runs) {
      found.push_back({ProblemKind::kJoint, imported ? Severity::kWarning : Severity::kError, of.times_s[run.first],
                       of.times_s[run.last], sentence(arm, of.clearance[run.worst][arm]), "", static_cast<int>(arm)});
    }
  }
}

}  // namespace trocar::review
