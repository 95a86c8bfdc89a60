#include "ui/gui_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>

namespace trocar::ui {
namespace {

constexpr const char* kVertexSource = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
uniform vec4 to_clip;
// Nothing is farther away than anything else: without that division a pixel costs less.
noperspective out vec2 fragment_uv;
noperspective out vec4 fragment_colour;
flat out vec4 one_colour;
void main() {
  fragment_uv = uv;
  fragment_colour = colour;
  one_colour = colour;
  gl_Position = vec4(position * to_clip.xy + to_clip.zw, 0.0, 1.0);
}
)";

constexpr const char* kFragmentSource = R"(#version 330 core
uniform sampler2D image;
noperspective in vec2 fragment_uv;
noperspective in vec4 fragment_colour;
out vec4 result;
void main() { result = fragment_colour * texture(image, fragment_uv); }
)";

/// What needs no texture is spared the look-up, which in software costs as much as the rest.
constexpr const char* kPlainFragmentSource = R"(#version 330 core
noperspective in vec4 fragment_colour;
out vec4 result;
void main() { result = fragment_colour; }
)";

constexpr const char* kSolidFragmentSource = R"(#version 330 core
flat in vec4 one_colour;
out vec4 result;
void main() { result = one_colour; }
)";

constexpr const char* kPictureFragmentSource = R"(#version 330 core
uniform sampler2D image;
noperspective in vec2 fragment_uv;
out vec4 result;
void main() { result = texture(image, fragment_uv); }
)";

constexpr std::int64_t kKeptFrames = 120;

ImTextureID to_id(GLuint name) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

bool opaque(const Image& image) {
  std::uint8_t all = 0xFF;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) all &= image.rgba[i];
  return all == 0xFF;
}

// Eight bytes at a time; equality of two frames is all that is asked of it.
std::uint64_t mix_bytes(std::uint64_t hash, const void* bytes, std::size_t count) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  const auto stir = [&hash](std::uint64_t word) {
    hash = std::rotl(hash ^ (word * 0x9E3779B97F4A7C15ULL), 27) * 0xD6E8FEB86659FD93ULL;
  };
  for (; count >= 8; count -= 8, at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, 8);
    stir(word);
  }
  std::uint64_t rest = count;
  std::memcpy(&rest, at, count);
  stir(rest + 1);
  return hash;
}

}  // namespace

Result<std::unique_ptr<GuiRenderer>> GuiRenderer::create(const render::GlFunctions& gl) {
  std::unique_ptr<GuiRenderer> renderer(new GuiRenderer(gl));
  TROCAR_RETURN_IF_ERROR(renderer->set_up());
  return renderer;
}

Status GuiRenderer::set_up() {
  // In the order of `GuiLook`.
  const std::array sources{kFragmentSource, kPlainFragmentSource, kSolidFragmentSource, kPictureFragmentSource};
  for (std::size_t i = 0; i < programs_.size(); ++i) {
    TROCAR_ASSIGN_OR_RETURN(programs_[i].name, render::link_program(gl_, kVertexSource, sources[i]));
    programs_[i].to_clip = gl_.GetUniformLocation(programs_[i].name, "to_clip");
  }
  gl_.GenVertexArrays(1, &array_);
  gl_.GenBuffers(1, &vertices_);
  gl_.GenBuffers(1, &indices_);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  constexpr GLsizei stride = sizeof(ImDrawVert);
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  for (GLuint slot = 0; slot < 3; ++slot) gl_.EnableVertexAttribArray(slot);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, pos)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, uv)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(ImDrawVert, col)));
  return {};
}

GuiRenderer::~GuiRenderer() {
  for (const auto& [key, texture] : textures_) gl_.DeleteTextures(1, &texture.name);
  if (font_texture_ != 0) gl_.DeleteTextures(1, &font_texture_);
  if (array_ != 0) gl_.DeleteVertexArrays(1, &array_);
  for (const GLuint buffer : {vertices_, indices_}) {
    if (buffer != 0) gl_.DeleteBuffers(1, &buffer);
  }
  for (const Program& program : programs_) {
    if (program.name != 0) gl_.DeleteProgram(program.name);
  }
}

void GuiRenderer::upload(Texture& texture, const Image& image, Sampling sampling) const {
  const bool same_size = texture.name != 0 && texture.width == image.width && texture.height == image.height;
  if (texture.name == 0) gl_.GenTextures(1, &texture.name);
  gl_.BindTexture(GL_TEXTURE_2D, texture.name);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (same_size) {
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    return;
  }
  const GLint filter = sampling == Sampling::kNearest ? GL_NEAREST : GL_LINEAR;
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
  texture.width = image.width;
  texture.height = image.height;
}

void GuiRenderer::upload_fonts(ImFontAtlas& atlas) {
  Image image;
  unsigned char* pixels = nullptr;
  atlas.GetTexDataAsRGBA32(&pixels, &image.width, &image.height);
  image.rgba.assign(pixels, pixels + static_cast<std::ptrdiff_t>(4) * image.width * image.height);
  if (font_texture_ != 0) gl_.DeleteTextures(1, &font_texture_);
  // Glyphs lie on whole pixels and lines are drawn as geometry, so the nearest texel is exact, and cheap in software.
  Texture texture;
  upload(texture, image, Sampling::kNearest);
  font_texture_ = texture.name;
  white_ = atlas.TexUvWhitePixel;
  ++uploads_;
  atlas.SetTexID(to_id(font_texture_));
}

ImTextureID GuiRenderer::texture(std::string_view key, const Image& image, std::uint64_t version, Sampling sampling) {
  auto found = textures_.find(key);
  if (found == textures_.end()) found = textures_.emplace(std::string(key), Texture{}).first;
  Texture& texture = found->second;
  const bool same =
      texture.name != 0 && texture.version == version && texture.width == image.width && texture.height == image.height;
  if (!same) {
    upload(texture, image, sampling);
    if (opaque(image)) {
      opaque_textures_.insert(texture.name);
    } else {
      opaque_textures_.erase(texture.name);
    }
    texture.version = version;
    ++uploads_;
  }
  texture.last_used = frame_;
  return to_id(texture.name);
}

void GuiRenderer::drop_unused_textures() {
  for (auto it = textures_.begin(); it != textures_.end();) {
    const bool unused = frame_ - it->second.last_used > kKeptFrames;
    if (unused) {
      gl_.DeleteTextures(1, &it->second.name);
      opaque_textures_.erase(it->second.name);
    }
    it = unused ? textures_.erase(it) : std::next(it);
  }
}

std::uint64_t GuiRenderer::hash_of(const ImDrawData& data, Rgba ground) const {
  std::uint64_t hash = mix_bytes(uploads_, &data.DisplaySize, sizeof(data.DisplaySize));
  hash = mix_bytes(hash, &ground, sizeof(ground));
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    hash = mix_bytes(hash, list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    hash = mix_bytes(hash, list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      hash = mix_bytes(hash, &command.ClipRect, sizeof(command.ClipRect));
      hash = mix_bytes(hash, &command.TextureId, sizeof(command.TextureId));
      hash = mix_bytes(hash, &command.ElemCount, sizeof(command.ElemCount));
    }
  }
  return hash;
}

void GuiRenderer::set_state(const ImDrawData& data) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, static_cast<GLsizei>(data.DisplaySize.x), static_cast<GLsizei>(data.DisplaySize.y));
  for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_STENCIL_TEST}) gl_.Disable(capability);
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const float sx = 2.0F / data.DisplaySize.x;
  const float sy = -2.0F / data.DisplaySize.y;
  const std::array<float, 4> to_clip{sx, sy, -1.0F - data.DisplayPos.x * sx, 1.0F - data.DisplayPos.y * sy};
  for (const Program& program : programs_) {
    gl_.UseProgram(program.name);
    gl_.Uniform4fv(program.to_clip, 1, to_clip.data());
  }
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
}

void GuiRenderer::set_look(GuiLook look) {
  if (look == look_) return;
  const auto mixed = [](GuiLook any) { return any == GuiLook::kPlain || any == GuiLook::kTextured; };
  gl_.UseProgram(programs_[static_cast<std::size_t>(look)].name);
  if (mixed(look) != mixed(look_)) (mixed(look) ? gl_.Enable : gl_.Disable)(GL_BLEND);
  look_ = look;
}

std::vector<GuiRun> GuiRenderer::whole_run(const ImDrawList& list, const ImDrawCmd& command) const {
  const auto name = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
  const bool opaque = opaque_textures_.contains(name) && gui_untinted(list, command);
  return {{opaque ? GuiLook::kPicture : GuiLook::kTextured, command.IdxOffset, command.ElemCount}};
}

void GuiRenderer::draw_list(const ImDrawList& list, const ImDrawData& data) {
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const float x0 = std::max(command.ClipRect.x - data.DisplayPos.x, 0.0F);
    const float y0 = std::max(command.ClipRect.y - data.DisplayPos.y, 0.0F);
    const float x1 = std::min(command.ClipRect.z - data.DisplayPos.x, data.DisplaySize.x);
    const float y1 = std::min(command.ClipRect.w - data.DisplayPos.y, data.DisplaySize.y);
    if (command.ElemCount == 0 || x1 <= x0 || y1 <= y0 || command.UserCallback != nullptr) continue;
    gl_.Scissor(static_cast<GLint>(x0), static_cast<GLint>(data.DisplaySize.y - y1), static_cast<GLsizei>(x1 - x0),
                static_cast<GLsizei>(y1 - y0));
    gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
    const bool letters = command.GetTexID() == to_id(font_texture_);
    for (const GuiRun& run : letters ? gui_runs(list, command, white_) : whole_run(list, command)) {
      set_look(run.look);
      const auto first = reinterpret_cast<const void*>(std::size_t{run.first} * sizeof(ImDrawIdx));
      gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(run.count),
                                 sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, first,
                                 static_cast<GLint>(command.VtxOffset));
    }
  }
}

bool GuiRenderer::draw(const ImDrawData& data, Rgba ground, bool force) {
  ++frame_;
  const std::uint64_t hash = hash_of(data, ground);
  if (hash == last_hash_ && !force) return false;
  last_hash_ = hash;
  set_state(data);
  gl_.Disable(GL_SCISSOR_TEST);
  const ImVec4 clear{static_cast<float>(ground.r) / 255.0F, static_cast<float>(ground.g) / 255.0F,
                     static_cast<float>(ground.b) / 255.0F, 1.0F};
  gl_.ClearColor(clear.x, clear.y, clear.z, clear.w);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.Enable(GL_SCISSOR_TEST);
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data);
  set_look(GuiLook::kTextured);
  gl_.Disable(GL_SCISSOR_TEST);
  drop_unused_textures();
  return true;
}

}  // namespace trocar::ui
