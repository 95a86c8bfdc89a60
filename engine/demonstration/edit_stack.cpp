#include "engine/demonstration/edit_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "engine/demonstration/edits.h"

namespace trocar::demonstration {
namespace {

Result<std::size_t> place_of(const EditStack& stack, std::int64_t entry) {
  const auto found = std::find_if(stack.begin(), stack.end(), [&](const StackEntry& each) { return each.id == entry; });
  if (found != stack.end()) return static_cast<std::size_t>(found - stack.begin());
  return fail(ErrorCode::kNotFound, fmt::format("the demonstration has no edit {}", entry));
}

template <typename Change>
Result<EditStack> changed(const EditStack& stack, std::int64_t entry, Change change) {
  TROCAR_ASSIGN_OR_RETURN(const std::size_t place, place_of(stack, entry));
  EditStack edited = stack;
  change(edited[place]);
  return edited;
}

}  // namespace

Demonstration with_stack(const Demonstration& document, EditStack stack) {
  Demonstration made = original_of(document);
  for (StackEntry& entry : stack) {
    entry.conflict.clear();
    if (!entry.enabled) continue;
    Result<Demonstration> next = transformed(made, *entry.edit, entry.id);
    if (next) {
      made = std::move(*next);
    } else {
      entry.conflict = next.error().text();
    }
  }
  made.stack = std::make_shared<const EditStack>(std::move(stack));
  return made;
}

std::string entry_words(std::int64_t entry) {
  const std::int64_t nth = entry >> 32;
  const std::int64_t row = entry - (nth << 32);
  return nth > 0 ? fmt::format("{}.{}", row, nth) : fmt::format("{}", entry);
}

std::optional<std::int64_t> entry_from(std::string_view words) {
  const auto number = [](std::string_view digits) -> std::optional<std::int64_t> {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size() || value < 0) return {};
    return value;
  };
  const std::size_t dot = words.find('.');
  const std::optional<std::int64_t> row = number(words.substr(0, dot));
  if (!row || dot == std::string_view::npos) return row;
  const std::optional<std::int64_t> nth = number(words.substr(dot + 1));
  constexpr std::int64_t kMost = std::int64_t{1} << 30;
  if (!nth || *nth > kMost || *row >= (std::int64_t{1} << 32)) return {};
  return entry_id(*row, static_cast<std::size_t>(*nth));
}

Result<EditStack> entry_moved(const EditStack& stack, std::int64_t entry, int place) {
  TROCAR_ASSIGN_OR_RETURN(const std::size_t from, place_of(stack, entry));
  EditStack edited = stack;
  StackEntry moved = std::move(edited[from]);
  edited.erase(edited.begin() + static_cast<std::ptrdiff_t>(from));
  edited.insert(edited.begin() + std::clamp<std::ptrdiff_t>(place, 0, std::ssize(edited)), std::move(moved));
  return edited;
}

Result<EditStack> entry_enabled(const EditStack& stack, std::int64_t entry, bool enabled) {
  return changed(stack, entry, [&](StackEntry& each) { each.enabled = enabled; });
}

Result<EditStack> entry_replaced(const EditStack& stack, std::int64_t entry, Edit edit) {
  if (!stacks(edit)) return fail(ErrorCode::kInvalidArgument, fmt::format("{} does not stack", name_of(edit)));
  return changed(stack, entry, [&](StackEntry& each) { each.edit = std::make_shared<const Edit>(std::move(edit)); });
}

Result<EditStack> entry_named(const EditStack& stack, std::int64_t entry, std::string name) {
  return changed(stack, entry, [&](StackEntry& each) { each.name = std::move(name); });
}

Result<EditStack> entry_removed(const EditStack& stack, std::int64_t entry) {
  TROCAR_ASSIGN_OR_RETURN(const std::size_t place, place_of(stack, entry));
  EditStack edited = stack;
  edited.erase(edited.begin() + static_cast<std::ptrdiff_t>(place));
  return edited;
}

}  // namespace trocar::demonstration
