#include "engine/media/picture_file.h"

#include <string>

#include "engine/core/file.h"
#include "engine/media/media_library.h"
#include "engine/media/png_check.h"

namespace trocar::media {
namespace {

void append(void* sink, const std::uint8_t* bytes, std::size_t size) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(bytes), size);
}

std::uint8_t* make_room(void* sink, int width, int height) {
  auto* image = static_cast<Image*>(sink);
  *image = Image(width, height);
  return image->rgba.data();
}

constexpr std::size_t kLargestFile_bytes = std::size_t{256} << 20U;

Result<Image> decode(std::string_view bytes) {
  if (has_png_signature(bytes)) {
    TROCAR_RETURN_IF_ERROR(check_png(bytes));
  } else if (!has_jpeg_signature(bytes)) {
    return fail(ErrorCode::kCorrupt, "the file is neither a PNG nor a JPEG picture");
  }
  TROCAR_ASSIGN_OR_RETURN(const trocar_media_api* api, media_library());
  Image image;
  if (api->picture_decode(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), &image, make_room) == 0) {
    return fail(ErrorCode::kCorrupt, "the picture cannot be decoded");
  }
  return image;
}

}  // namespace

Status write_png(const std::filesystem::path& path, const Image& image, std::optional<double> dpi) {
  if (image.empty()) {
    return tl::unexpected(Error(ErrorCode::kInvalidArgument, "the picture has no pixels").at(path.string()));
  }
  TROCAR_ASSIGN_OR_RETURN(const trocar_media_api* api, media_library());
  std::string bytes;
  if (api->png_encode(image.rgba.data(), image.width, image.height, &bytes, append) == 0) {
    return tl::unexpected(Error(ErrorCode::kIo, "the picture cannot be encoded").at(path.string()));
  }
  if (dpi) add_resolution(bytes, *dpi);
  return write_file(path, bytes);
}

Result<Image> read_picture(const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path, kLargestFile_bytes));
  Result<Image> image = decode(bytes);
  if (!image) return tl::unexpected(std::move(image).error().at(path.string()));
  return image;
}

}  // namespace trocar::media
