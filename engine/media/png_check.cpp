#include "engine/media/png_check.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace trocar::media {
namespace {

using namespace std::string_view_literals;
constexpr std::uint32_t kLargestSide = 16384;

std::uint32_t big_endian(std::string_view four) {
  std::uint32_t value = 0;
  for (const char c : four.substr(0, 4)) value = value << 8U | static_cast<std::uint8_t>(c);
  return value;
}

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
    table[n] = c;
  }
  return table;
}

std::uint32_t crc(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
  std::uint32_t c = 0xFFFFFFFFU;
  for (const char byte : bytes) c = kTable[(c ^ static_cast<std::uint8_t>(byte)) & 0xFFU] ^ (c >> 8U);
  return ~c;
}

std::string big_endian_bytes(std::uint32_t value) {
  std::string bytes;
  for (unsigned shift = 32; shift > 0; shift -= 8) bytes += static_cast<char>(value >> (shift - 8) & 0xFFU);
  return bytes;
}

Status corrupt(const char* what) {
  return fail(ErrorCode::kCorrupt, what);
}

Status check_header(std::string_view type, std::string_view data) {
  if (type != "IHDR" || data.size() != 13) return corrupt("the picture has no PNG header");
  const std::uint32_t width = big_endian(data);
  const std::uint32_t height = big_endian(data.substr(4));
  if (width == 0 || height == 0) return corrupt("the picture has no pixels");
  if (width > kLargestSide || height > kLargestSide) return corrupt("the picture is larger than 16384 pixels a side");
  return {};
}

}  // namespace

bool has_png_signature(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1A\n"sv);
}

bool has_jpeg_signature(std::string_view bytes) {
  return bytes.starts_with("\xFF\xD8\xFF"sv);
}

Status check_png(std::string_view bytes) {
  if (!has_png_signature(bytes)) return corrupt("the file is no PNG picture");
  bytes.remove_prefix(8);
  bool has_pixels = false;
  for (bool first = true;; first = false) {
    if (bytes.size() < 12) return corrupt("the picture is cut short");
    const std::size_t length = big_endian(bytes);
    if (length > bytes.size() - 12) return corrupt("the picture is cut short");
    const std::string_view type = bytes.substr(4, 4);
    if (crc(bytes.substr(4, length + 4)) != big_endian(bytes.substr(8 + length))) {
      return corrupt("the picture is damaged (a checksum does not match)");
    }
    if (first) TROCAR_RETURN_IF_ERROR(check_header(type, bytes.substr(8, length)));
    has_pixels = has_pixels || type == "IDAT";
    if (type == "IEND") return has_pixels ? Status() : corrupt("the picture has no pixels");
    bytes.remove_prefix(12 + length);
  }
}

void add_resolution(std::string& png, double dpi) {
  constexpr std::size_t kHeaderEnd = 8 + 12 + 13;  // signature, and a chunk of 13 bytes
  constexpr double kInch_m = 0.0254;
  const std::string per_metre = big_endian_bytes(static_cast<std::uint32_t>(std::lround(dpi / kInch_m)));
  const std::string chunk = "pHYs" + per_metre + per_metre + '\x01';
  png.insert(kHeaderEnd, big_endian_bytes(9) + chunk + big_endian_bytes(crc(chunk)));
}

}  // namespace trocar::media
