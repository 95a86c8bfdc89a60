#include "engine/core/result.h"

namespace trocar {

Error Error::in(std::string_view doing) && {
  message_ = "could not " + std::string(doing) + ": " + message_;
  return std::move(*this);
}

Error Error::at(std::string path) && {
  if (path_.empty()) path_ = std::move(path);
  return std::move(*this);
}

std::string Error::text() const {
  return path_.empty() ? message_ : message_ + ": " + path_;
}

}  // namespace trocar
