/// The colours and surfaces of the stage, in one place.
#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/core/image.h"
#include "engine/peg_board/peg_board.h"
#include "engine/scene/scene.h"

namespace trocar::stage::palette {

inline Eigen::Vector4f vector(Rgba colour) {
  return Eigen::Vector4f(static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b),
                         static_cast<float>(colour.a)) /
         255.0F;
}

inline scene::Material material(Rgba colour, float roughness, float metallic) {
  scene::Material made;
  made.base_colour = vector(colour);
  made.roughness = roughness;
  made.metallic = metallic;
  return made;
}

/// Shown in its own colour, whatever the light; casts no shadow.
inline scene::Material drawn(Rgba colour) {
  scene::Material made = material(colour, 1.0F, 0.0F);
  made.emission = 1.0F;
  made.casts_shadow = false;
  return made;
}

inline scene::Material board() {
  return material({79, 85, 95, 255}, 0.92F, 0.0F);
}
constexpr Rgba kLightTop{206, 211, 218, 255};  // Of the background.
constexpr Rgba kLightBottom{236, 238, 241, 255};
inline scene::Material table(bool light) {
  scene::Material made = material(light ? Rgba{190, 193, 199, 255} : Rgba{65, 68, 76, 255}, 0.95F, 0.0F);
  made.casts_shadow = false;
  return made;
}
inline scene::Material peg() {
  return material({205, 209, 214, 255}, 0.34F, 1.0F);
}
inline scene::Material shaft() {
  return material({58, 62, 69, 255}, 0.42F, 0.0F);
}
inline scene::Material steel() {
  return material({196, 200, 206, 255}, 0.36F, 1.0F);
}
inline scene::Material pin() {
  return material({120, 124, 130, 255}, 0.45F, 1.0F);
}

/// The left arm is the user's, the right one the assistant's.
constexpr std::array<Rgba, 2> kArms{Rgba{86, 160, 240, 255}, Rgba{240, 168, 60, 255}};

/// Rubber: told apart by lightness as well as by hue.
constexpr std::array<Rgba, peg_board::kBlockCount> kBlocks{Rgba{222, 92, 78, 255},   Rgba{236, 176, 72, 255},
                                                           Rgba{116, 186, 112, 255}, Rgba{64, 150, 168, 255},
                                                           Rgba{92, 118, 200, 255},  Rgba{174, 116, 190, 255}};
inline scene::Material block(int number, bool highlighted) {
  scene::Material made = material(kBlocks[static_cast<std::size_t>(number)], 0.55F, 0.0F);
  if (highlighted) made.emission = 0.25F;
  return made;
}

/// The tube's upper end fades, so that a picture from above shows what is under it.
constexpr std::array<Rgba, 2> kShaftFade{Rgba{255, 255, 255, 255}, Rgba{255, 255, 255, 0}};

constexpr Rgba kHighlight{255, 236, 150, 255};
constexpr Rgba kFrame{176, 186, 200, 255};
constexpr Rgba kRuler{236, 239, 243, 255};
constexpr Rgba kText{232, 235, 240, 255};
constexpr Rgba kQuietText{190, 197, 207, 255};
constexpr std::array<Rgba, 3> kAxes{Rgba{232, 98, 92, 255}, Rgba{120, 200, 110, 255}, Rgba{100, 156, 246, 255}};

}  // namespace trocar::stage::palette
