/// What kind of file a name means.
#pragma once

#include <filesystem>
#include <string>

namespace trocar {

/// ".png" of "F.PNG": with its dot, in small letters; "" where there is none.
inline std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

}  // namespace trocar
