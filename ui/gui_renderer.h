/// Draws what ImGui made, on any OpenGL 3.3 context through our own function table; also keeps pictures as textures.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/render/gl_functions.h"
#include "ui/gui_runs.h"
#include "ui/textures.h"

namespace trocar::ui {

/// Precondition: the context that `gl` was loaded for is current in each call, the destructor included, and outlives
/// this. Threads: that of the context.
class GuiRenderer final : public TextureStore {
 public:
  /// Errors: kUnsupported when the driver refuses the shaders.
  static Result<std::unique_ptr<GuiRenderer>> create(const render::GlFunctions& gl);
  ~GuiRenderer() override;
  GuiRenderer(const GuiRenderer&) = delete;
  GuiRenderer& operator=(const GuiRenderer&) = delete;

  void upload_fonts(ImFontAtlas& atlas);
  ImTextureID texture(std::string_view key, const Image& image, std::uint64_t version, Sampling sampling) override;

  /// Draws into frame buffer 0 unless the frame equals the last one drawn; returns whether it drew. `force` draws
  /// always (a benchmark, a window that lost its content).
  bool draw(const ImDrawData& data, Rgba ground, bool force = false);

 private:
  struct Texture {
    GLuint name = 0;
    int width = 0;
    int height = 0;
    std::uint64_t version = 0;
    std::int64_t last_used = 0;
  };
  explicit GuiRenderer(const render::GlFunctions& gl) : gl_(gl) {}

  struct Program {
    GLuint name = 0;
    GLint to_clip = -1;
  };
  Status set_up();
  void set_state(const ImDrawData& data);
  void set_look(GuiLook look);
  /// A picture's command is drawn in one look.
  std::vector<GuiRun> whole_run(const ImDrawList& list, const ImDrawCmd& command) const;
  void draw_list(const ImDrawList& list, const ImDrawData& data);
  std::uint64_t hash_of(const ImDrawData& data, Rgba ground) const;
  void drop_unused_textures();
  void upload(Texture& texture, const Image& image, Sampling sampling) const;

  const render::GlFunctions& gl_;
  std::array<Program, 4> programs_;  ///< By GuiLook.
  GLuint array_ = 0;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLuint font_texture_ = 0;
  ImVec2 white_{0.0F, 0.0F};          ///< Where the letters' texture is white.
  std::set<GLuint> opaque_textures_;  ///< Pictures without a see-through pixel.
  GuiLook look_ = GuiLook::kTextured;
  std::map<std::string, Texture, std::less<>> textures_;
  std::uint64_t uploads_ = 0;  ///< Part of the hash: a new picture is a new frame.
  std::uint64_t last_hash_ = 0;
  std::int64_t frame_ = 0;
};

}  // namespace trocar::ui
