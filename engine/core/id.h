/// Strong ids: a demonstration's number is not a model's.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace trocar {

/// A positive number, unique within its kind in one project; 0 means none.
template <typename Tag>
struct Id {
  std::int64_t value = 0;

  explicit operator bool() const { return value != 0; }
  // clang-tidy 14 takes the 0 inside of the defaulted operator for a null pointer.
  auto operator<=>(const Id&) const = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace trocar

template <typename Tag>
struct std::hash<trocar::Id<Tag>> {
  std::size_t operator()(const trocar::Id<Tag>& id) const noexcept { return std::hash<std::int64_t>{}(id.value); }
};
