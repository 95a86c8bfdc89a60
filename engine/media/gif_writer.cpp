#include "engine/media/gif_writer.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>
#include <vector>

#include "engine/core/check.h"
#include "engine/media/palette.h"

namespace trocar::media {
namespace {

/// Pixels; `right` and `bottom` are the first ones outside.
struct Area {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

bool same_at(const Image& a, const Image& b, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x));
  return std::memcmp(a.rgba.data() + at, b.rgba.data() + at, 3) == 0;
}

/// Where two pictures differ; one pixel if they do not, for a frame has to show something.
Area changed_area(const Image& before, const Image& now) {
  Area area{now.width, now.height, 0, 0};
  for (int y = 0; y < now.height; ++y) {
    for (int x = 0; x < now.width; ++x) {
      if (same_at(before, now, x, y)) continue;
      area = {std::min(area.left, x), std::min(area.top, y), std::max(area.right, x + 1), y + 1};
    }
  }
  return area.right == 0 ? Area{0, 0, 1, 1} : area;
}

using ColourMap = std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)>;

/// With room for one more, which is transparent.
ColourMap colour_map_of(const std::vector<Rgba>& colours) {
  const int size = 1 << GifBitSize(static_cast<int>(colours.size()) + 1);
  ColourMap map(GifMakeMapObject(size, nullptr), GifFreeMapObject);
  if (!map) return map;
  for (std::size_t i = 0; i < colours.size(); ++i) map->Colors[i] = {colours[i].r, colours[i].g, colours[i].b};
  return map;
}

}  // namespace

struct GifWriter::Impl {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{nullptr, std::fclose};
  GifFileType* gif = nullptr;
  double fps = 0.0;
  bool good = true;  ///< giflib does not look at all that it writes.
  int added = 0;
  Image before;
  std::vector<Rgba> changed;
  std::vector<GifByteType> row;

  ~Impl() { close(); }

  bool close() {
    if (gif != nullptr && EGifCloseFile(gif, nullptr) != GIF_OK) good = false;
    gif = nullptr;
    if (file && std::fclose(file.release()) != 0) good = false;
    return good;
  }

  bool begin(int width, int height) {
    EGifSetGifVersion(gif, true);
    constexpr int kBitsOfAChannel = 8;
    if (EGifPutScreenDesc(gif, width, height, kBitsOfAChannel, 0, nullptr) != GIF_OK) return false;
    // Netscape's extension, which every player knows: loop 0 times, which means for ever.
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    return EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
           EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0") == GIF_OK &&
           EGifPutExtensionBlock(gif, static_cast<int>(kForEver.size()), kForEver.data()) == GIF_OK &&
           EGifPutExtensionTrailer(gif) == GIF_OK;
  }

  /// From instant to instant in hundredths, so that rounding does not add up.
  int delay_cs() const {
    const auto instant_cs = [this](int frame) { return static_cast<int>(std::lround(100.0 * frame / fps)); };
    return instant_cs(added + 1) - instant_cs(added);
  }

  bool put_control(int transparent) {
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay_cs(), transparent};
    std::array<GifByteType, 4> bytes{};
    const std::size_t size = EGifGCBToExtension(&control, bytes.data());
    return EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size), bytes.data()) == GIF_OK;
  }

  bool put_pixels(const Image& frame, const Area& area, std::span<const std::uint8_t> indices, int transparent) {
    std::size_t next = 0;
    for (int y = area.top; y < area.bottom; ++y) {
      row.clear();
      for (int x = area.left; x < area.right; ++x) {
        const bool kept = added > 0 && same_at(before, frame, x, y);
        row.push_back(kept ? static_cast<GifByteType>(transparent) : indices[next++]);
      }
      if (EGifPutLine(gif, row.data(), static_cast<int>(row.size())) != GIF_OK) return false;
    }
    return true;
  }

  bool put(const Image& frame) {
    const Area area = added == 0 ? Area{0, 0, frame.width, frame.height} : changed_area(before, frame);
    changed.clear();
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        if (added == 0 || !same_at(before, frame, x, y)) changed.push_back(frame.at(x, y));
      }
    }
    const Palette palette = palette_of(changed, 255);
    const int transparent = static_cast<int>(palette.colours.size());
    const ColourMap map = colour_map_of(palette.colours);
    return map && put_control(transparent) &&
           EGifPutImageDesc(gif, area.left, area.top, area.right - area.left, area.bottom - area.top, false,
                            map.get()) == GIF_OK &&
           put_pixels(frame, area, palette.indices, transparent);
  }
};

GifWriter::GifWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GifWriter::~GifWriter() = default;

std::unique_ptr<GifWriter> GifWriter::open(const std::filesystem::path& path, double fps, int width, int height) {
  TROCAR_CHECK(fps >= 1.0 && fps <= kFastest_fps);
  auto impl = std::make_unique<Impl>();
  impl->file.reset(std::fopen(path.c_str(), "wbe"));
  if (!impl->file) return nullptr;
  impl->fps = fps;
  const auto write = [](GifFileType* gif, const GifByteType* bytes, int size) {
    auto* to = static_cast<Impl*>(gif->UserData);
    const std::size_t written = std::fwrite(bytes, 1, static_cast<std::size_t>(size), to->file.get());
    to->good = to->good && written == static_cast<std::size_t>(size);
    return static_cast<int>(written);
  };
  impl->gif = EGifOpen(impl.get(), write, nullptr);
  if (impl->gif == nullptr || !impl->begin(width, height)) return nullptr;
  return std::unique_ptr<GifWriter>(new GifWriter(std::move(impl)));
}

bool GifWriter::add(const Image& frame) {
  impl_->good = impl_->good && impl_->put(frame);
  impl_->before = frame;
  ++impl_->added;
  return impl_->good;
}

bool GifWriter::finish() {
  return impl_->close();
}

}  // namespace trocar::media
