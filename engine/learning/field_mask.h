/// Which cells of a field are shown; the others count as unknown.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/learning/field.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {

enum class FieldMask : std::uint8_t {
  kNone,     ///< All are.
  kSafe,     ///< Those of the safe set.
  kExpert,   ///< Those that a demonstration goes through.
  kVisited,  ///< Those that training entered.
  kArrives,  ///< Those from which the greedy policy arrives.
};
std::string_view to_string(FieldMask mask);  ///< "none", "safe", "expert", "visited", "arrives"
/// Errors: kInvalidArgument with the names that there are.
Result<FieldMask> field_mask_from(std::string_view text);
const std::vector<FieldMask>& all_field_masks();

/// The field of `model` with NaN where the mask hides it; `outcomes` are those of the model's greedy policy.
Field masked(Field field, const Model& model, const Basin& outcomes, FieldMask mask);

}  // namespace trocar::learning
