#include "engine/learning/field_mask.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace trocar::learning {
namespace {

constexpr std::array<std::pair<FieldMask, std::string_view>, 5> kNames{{{FieldMask::kNone, "none"},
                                                                        {FieldMask::kSafe, "safe"},
                                                                        {FieldMask::kExpert, "expert"},
                                                                        {FieldMask::kVisited, "visited"},
                                                                        {FieldMask::kArrives, "arrives"}}};

spatial::CellSet cells_of_experts(const Model& model) {
  spatial::CellSet cells(model.grid);
  for (const CellSequence& expert : model.experts) {
    for (const spatial::CellIndex cell : expert) cells.insert(cell);
  }
  return cells;
}

}  // namespace

std::string_view to_string(FieldMask mask) {
  return kNames[static_cast<std::size_t>(mask)].second;
}

Result<FieldMask> field_mask_from(std::string_view text) {
  std::string known;
  for (const auto& [mask, name] : kNames) {
    if (name == text) return mask;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("there is no mask {}; there are {}", text, known));
}

const std::vector<FieldMask>& all_field_masks() {
  static const std::vector<FieldMask> masks{FieldMask::kNone, FieldMask::kSafe, FieldMask::kExpert, FieldMask::kVisited,
                                            FieldMask::kArrives};
  return masks;
}

Field masked(Field field, const Model& model, const Basin& outcomes, FieldMask mask) {
  if (mask == FieldMask::kNone) return field;
  const spatial::CellSet experts = mask == FieldMask::kExpert ? cells_of_experts(model) : spatial::CellSet{};
  for (std::size_t s = 0; s < field.values.size(); ++s) {
    const spatial::CellIndex cell{static_cast<std::int32_t>(s)};
    const bool shown = mask == FieldMask::kSafe      ? model.safe.contains(cell)
                       : mask == FieldMask::kExpert  ? experts.contains(cell)
                       : mask == FieldMask::kVisited ? model.visits[s] > 0
                                                     : outcomes.end[s] == RolloutEnd::kArrives;
    if (!shown) field.values[s] = std::numeric_limits<double>::quiet_NaN();
  }
  return field;
}

}  // namespace trocar::learning
