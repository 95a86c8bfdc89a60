/// Whether a weak pointer is to what a shared one owns, for caches that keep nothing alive.
#pragma once

#include <memory>

namespace trocar {

/// True also if both are empty; false for one that has expired, whatever was made since in its place.
template <typename T>
bool same_object(const std::weak_ptr<T>& weak, const std::shared_ptr<T>& shared) {
  return !weak.owner_before(shared) && !shared.owner_before(weak);
}

}  // namespace trocar
