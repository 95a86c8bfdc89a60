#include "ui/fonts.h"

#include <imgui_freetype.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace trocar::ui {
namespace {

// Latin with its supplements, Greek, general punctuation, arrows, mathematical operators, geometric shapes.
constexpr std::array<ImWchar, 17> kTextRanges{0x0020, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2044, 0x2070, 0x209F, 0x2190,
                                              0x21FF, 0x2200, 0x226F, 0x25A0, 0x25FF, 0x2713, 0x2717, 0};
constexpr std::array<ImWchar, 3> kIconRanges{0xF000, 0xF2E0, 0};

struct Faces {
  FontFile regular;
  FontFile strong;
  FontFile mono;
  FontFile fallback;
  std::filesystem::path icons;  ///< Empty: none installed.
};

Result<Faces> find_faces() {
  const std::vector<std::filesystem::path> folders = font_folders();
  Faces faces;
  TROCAR_ASSIGN_OR_RETURN(faces.regular,
                          find_font({"opentype/inter/Inter-Regular.otf", "truetype/dejavu/DejaVuSans.ttf"}, folders));
  TROCAR_ASSIGN_OR_RETURN(faces.strong,
                          find_font({"opentype/inter/Inter-SemiBold.otf", "truetype/dejavu/DejaVuSans-Bold.ttf",
                                     "truetype/dejavu/DejaVuSans.ttf"},
                                    folders));
  TROCAR_ASSIGN_OR_RETURN(faces.mono, find_font({"truetype/dejavu/DejaVuSansMono.ttf"}, folders));
  TROCAR_ASSIGN_OR_RETURN(faces.fallback, find_font({"truetype/dejavu/DejaVuSans.ttf"}, folders));
  if (auto icons = find_font({"opentype/font-awesome/FontAwesome.otf", "truetype/font-awesome/fontawesome-webfont.ttf"},
                             folders)) {
    faces.icons = icons->path;
  }
  return faces;
}

ImFont* add_font(ImFontAtlas& atlas, const Faces& faces, const FontFile& face, float size_px) {
  ImFontConfig config;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  const float size = std::round(size_px);
  ImFont* font = atlas.AddFontFromFileTTF(face.path.c_str(), size, &config, kTextRanges.data());
  config.MergeMode = true;
  if (face.path != faces.fallback.path) {
    atlas.AddFontFromFileTTF(faces.fallback.path.c_str(), size, &config, kTextRanges.data());
  }
  if (!faces.icons.empty()) {
    config.GlyphMinAdvanceX = std::round(size * 1.1F);
    config.GlyphOffset = {0.0F, 0.0F};
    atlas.AddFontFromFileTTF(faces.icons.c_str(), std::round(size * 0.95F), &config, kIconRanges.data());
  }
  return font;
}

}  // namespace

std::vector<std::filesystem::path> font_folders() {
  std::vector<std::filesystem::path> folders;
  if (const char* home = std::getenv("HOME")) folders.emplace_back(std::filesystem::path(home) / ".local/share/fonts");
  folders.emplace_back("/usr/local/share/fonts");
  folders.emplace_back("/usr/share/fonts");
  return folders;
}

Result<FontFile> find_font(const std::vector<std::string>& candidates,
                           const std::vector<std::filesystem::path>& folders) {
  for (const std::string& candidate : candidates) {
    for (const std::filesystem::path& folder : folders) {
      std::error_code error;
      const std::filesystem::path path = folder / candidate;
      if (std::filesystem::is_regular_file(path, error)) return FontFile{path, &candidate != &candidates.front()};
    }
  }
  return fail(ErrorCode::kNotFound, "no font for the window is installed; install fonts-inter or fonts-dejavu-core");
}

Result<Fonts> build_fonts(ImFontAtlas& atlas, float scale) {
  TROCAR_ASSIGN_OR_RETURN(const Faces faces, find_faces());
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.Flags |= ImFontAtlasFlags_NoBakedLines | ImFontAtlasFlags_NoPowerOfTwoHeight;
  Fonts fonts;
  fonts.scale = scale;
  fonts.body = add_font(atlas, faces, faces.regular, 15.0F * scale);
  fonts.small = add_font(atlas, faces, faces.regular, 13.0F * scale);
  fonts.strong = add_font(atlas, faces, faces.strong, 15.0F * scale);
  fonts.large = add_font(atlas, faces, faces.strong, 21.0F * scale);
  fonts.mono = add_font(atlas, faces, faces.mono, 13.0F * scale);
  if (!atlas.Build()) return fail(ErrorCode::kUnsupported, "the fonts could not be rasterised");
  return fonts;
}

}  // namespace trocar::ui
