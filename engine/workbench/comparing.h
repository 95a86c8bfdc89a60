/// The selected demonstration against its original, another one, or itself at a point of the history.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/comparison.h"
#include "engine/plot/curve.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// What a demonstration is compared with.
struct Against {
  enum class Kind : std::uint8_t { kOriginal, kDemonstration, kHistory };
  Kind kind = Kind::kOriginal;         ///< The original is the demonstration as it was recorded.
  DemonstrationId demonstration = {};  ///< Of kDemonstration.
  std::int64_t node = 0;               ///< Of kHistory: the same demonstration as it was at that point.
  bool operator==(const Against&) const = default;
};
/// As the command line takes it: "original", "3", "history:12".
std::string to_words(const Against& against);
/// The number in "history:12". Errors: kInvalidArgument for anything else that begins with "history:"; nothing for what
/// does not.
Result<std::optional<std::int64_t>> history_point_from(std::string_view text);

using ProjectAt = std::function<Result<std::shared_ptr<const Project>>(std::int64_t node)>;
/// What `against` names, for `after`. Errors: kNotFound if there is no such demonstration, or none at that point.
Result<std::shared_ptr<const demonstration::Demonstration>> counterpart(const demonstration::Demonstration& after,
                                                                        const Against& against, const Project& project,
                                                                        const ProjectAt& project_at);
/// "its original", "Novice 2", "itself at point 12 of the history".
std::string described(const Against& against, const demonstration::Demonstration& before);

struct ComparisonSettings {
  Against against;
  demonstration::Alignment alignment = demonstration::Alignment::kTime;
  bool in_view = true;  ///< The other path and the whiskers between are drawn in the 3-D view.
  bool operator==(const ComparisonSettings&) const = default;
};

struct ComparisonRequest {
  std::shared_ptr<const demonstration::Demonstration>
      before;  ///< Null: nothing is to be compared, or `error` says why.
  std::shared_ptr<const demonstration::Demonstration> after;
  ComparisonSettings settings;
  std::string error;
};

struct ComparisonView {
  ComparisonRequest of;
  std::optional<demonstration::Comparison> comparison;  ///< None if it cannot be made.
  /// Of each arm in mm over the time of `after`, with a gap where nothing answers to it. Null without a comparison.
  std::array<std::shared_ptr<const plot::Curve>, 2> deviation_mm;
  std::string error;  ///< Why it cannot.
};

/// Null for a request without a demonstration and without an error. Threads: any.
std::shared_ptr<const ComparisonView> comparison_of(const ComparisonRequest& request);

}  // namespace trocar::workbench
