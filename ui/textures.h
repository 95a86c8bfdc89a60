/// Pictures that panels show, by name: the seam between panels and whatever draws them.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string_view>

#include "engine/core/image.h"

namespace trocar::ui {

enum class Sampling { kNearest, kLinear };

/// Threads: that of the window.
class TextureStore {
 public:
  virtual ~TextureStore() = default;
  /// The texture named `key` with the content `version`; uploads when the version or size is new. A texture that is
  /// not asked for during 120 frames is dropped. Precondition: the image is not empty.
  virtual ImTextureID texture(std::string_view key, const Image& image, std::uint64_t version, Sampling sampling) = 0;
};

/// Draws nothing: for logic tests.
class NullTextures final : public TextureStore {
 public:
  ImTextureID texture(std::string_view, const Image&, std::uint64_t, Sampling) override {
    return reinterpret_cast<ImTextureID>(std::uintptr_t{1});
  }
};

}  // namespace trocar::ui
