#include "engine/scene/ply_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trocar::scene {
namespace {

constexpr std::uint32_t kCornerLimit = 64;
constexpr std::size_t kPropertyLimit = 64;
/// The importer keeps a line in a buffer of four thousand characters.
constexpr std::size_t kLineLimit = 2000;

tl::unexpected<Error> corrupt_ply(std::string what) {
  return fail(ErrorCode::kCorrupt, "the mesh " + std::move(what));
}

/// The words of one line.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  /// Empty at the end.
  std::string_view next() {
    const std::size_t begin = rest_.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return rest_ = {};
    const std::size_t end = std::min(rest_.find_first_of(" \t", begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }
  bool at_end() const { return rest_.find_first_not_of(" \t") == std::string_view::npos; }

  template <typename Number>
  std::optional<Number> number() {
    const std::string_view word = next();
    Number value{};
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
    return value;
  }

 private:
  std::string_view rest_;
};

class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  std::size_t remaining() const { return rest_.size(); }
  /// Errors: a line too long, or with a character that no line of a text has.
  Result<std::string_view> next() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const auto strange = [](char c) { return c != '\t' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7F); };
    if (line.size() > kLineLimit || std::any_of(line.begin(), line.end(), strange)) {
      return corrupt_ply("has a line that is no line of text");
    }
    return line;
  }

 private:
  std::string_view rest_;
};

struct Header {
  std::vector<bool> whole_numbers;  ///< For each property of a vertex: an integer, else a floating number.
  std::array<bool, 6> known{};      ///< x, y, z, nx, ny, nz.
  PlyCounts counts;
  bool has_list = false;
};

enum class Element { kNone, kVertex, kFace };

bool is_whole(std::string_view type) {
  constexpr std::array<std::string_view, 12> kTypes{"char", "uchar", "short", "ushort", "int",   "uint",
                                                    "int8", "uint8", "int16", "uint16", "int32", "uint32"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

bool is_floating(std::string_view type) {
  return type == "float" || type == "double" || type == "float32" || type == "float64";
}

Status check_element(Words words, Header& header, Element& element) {
  const std::string_view name = words.next();
  const std::optional<std::uint32_t> count = words.number<std::uint32_t>();
  if (!count || !words.at_end()) return corrupt_ply("counts its elements in no number");
  if (name == "vertex" && element == Element::kNone) {
    element = Element::kVertex;
    header.counts.vertices = *count;
  } else if (name == "face" && element == Element::kVertex) {
    element = Element::kFace;
    header.counts.faces = *count;
  } else {
    return corrupt_ply("has other elements than vertices before faces");
  }
  return {};
}

Status check_list(Words words, Header& header) {
  const bool is_list = words.next() == "list" && is_whole(words.next()) && is_whole(words.next());
  const std::string_view name = words.next();
  if (!is_list || header.has_list || (name != "vertex_indices" && name != "vertex_index") || !words.at_end()) {
    return corrupt_ply("has faces that are more than lists of vertices");
  }
  header.has_list = true;
  return {};
}

Status check_property(Words words, Header& header, Element element) {
  if (element == Element::kFace) return check_list(words, header);
  const std::string_view type = words.next();
  const std::string_view name = words.next();
  const bool whole = is_whole(type);
  if (element != Element::kVertex || (!whole && !is_floating(type)) || name.empty() || !words.at_end() ||
      header.whole_numbers.size() >= kPropertyLimit) {
    return corrupt_ply("has a property where none can be");
  }
  constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "nx", "ny", "nz"};
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found != kNames.end()) {
    bool& known = header.known[static_cast<std::size_t>(found - kNames.begin())];
    if (known || whole) return corrupt_ply("has coordinates twice, or in whole numbers");
    known = true;
  }
  header.whole_numbers.push_back(whole);
  return {};
}

Status check_format(Lines& lines) {
  TROCAR_ASSIGN_OR_RETURN(const std::string_view magic, lines.next());
  if (magic != "ply") return corrupt_ply("does not begin as PLY");
  TROCAR_ASSIGN_OR_RETURN(const std::string_view format, lines.next());
  if (format == "format ascii 1.0") return {};
  if (format.substr(0, 13) != "format binary") return corrupt_ply("does not say its format");
  return fail(ErrorCode::kUnsupported, "the mesh is binary PLY; only text PLY is read");
}

/// Every number takes a digit and a blank: what is promised must fit into what is there before room is made for it.
Status check_promise(const Header& header, std::size_t remaining) {
  if (!header.known[0] || !header.known[1] || !header.known[2] || !header.has_list)
    return corrupt_ply("has no coordinates");
  if (header.counts.vertices == 0 || header.counts.faces == 0) return corrupt_ply("has no faces");
  const std::size_t least =
      std::size_t{2} * header.counts.vertices * header.whole_numbers.size() + std::size_t{8} * header.counts.faces;
  if (least > remaining + 1) return corrupt_ply("is cut short");
  return {};
}

Result<Header> check_header(Lines& lines) {
  TROCAR_RETURN_IF_ERROR(check_format(lines));
  Header header;
  Element element = Element::kNone;
  while (!lines.at_end()) {
    TROCAR_ASSIGN_OR_RETURN(const std::string_view line, lines.next());
    Words words(line);
    const std::string_view word = words.next();
    if (word == "end_header" && word.size() == line.size()) {
      TROCAR_RETURN_IF_ERROR(check_promise(header, lines.remaining()));
      return header;
    }
    // The importer takes a comment among an element's properties for their end.
    if ((word == "comment" || word == "obj_info") && element == Element::kNone) continue;
    if (word == "element") {
      TROCAR_RETURN_IF_ERROR(check_element(words, header, element));
    } else if (word == "property") {
      TROCAR_RETURN_IF_ERROR(check_property(words, header, element));
    } else {
      return corrupt_ply("has a line in its header where it cannot be");
    }
  }
  return corrupt_ply("has no end of its header");
}

bool check_number(Words& words, bool whole) {
  if (whole) return words.number<std::int64_t>().has_value();
  const std::optional<double> value = words.number<double>();
  return value && std::isfinite(static_cast<float>(*value));
}

Status check_vertices(Lines& lines, const Header& header) {
  for (std::uint32_t i = 0; i < header.counts.vertices; ++i) {
    TROCAR_ASSIGN_OR_RETURN(const std::string_view line, lines.next());
    Words words(line);
    for (const bool whole : header.whole_numbers) {
      if (!check_number(words, whole)) return corrupt_ply(fmt::format("has no finite number at vertex {}", i));
    }
    if (!words.at_end()) return corrupt_ply(fmt::format("has more than it says at vertex {}", i));
  }
  return {};
}

Status check_faces(Lines& lines, const PlyCounts& counts) {
  for (std::uint32_t face = 0; face < counts.faces; ++face) {
    TROCAR_ASSIGN_OR_RETURN(const std::string_view line, lines.next());
    Words words(line);
    const std::optional<std::uint32_t> corners = words.number<std::uint32_t>();
    if (!corners || *corners < 3 || *corners > kCornerLimit) {
      return corrupt_ply(fmt::format("has no polygon at face {}", face));
    }
    for (std::uint32_t k = 0; k < *corners; ++k) {
      const std::optional<std::uint32_t> index = words.number<std::uint32_t>();
      if (!index || *index >= counts.vertices) {
        return corrupt_ply(fmt::format("has a vertex that is not there at face {}", face));
      }
    }
    if (!words.at_end()) return corrupt_ply(fmt::format("has more than it says at face {}", face));
  }
  if (!lines.at_end()) return corrupt_ply("goes on after its last face");
  return {};
}

}  // namespace

Result<PlyCounts> check_ply(std::string_view bytes) {
  Lines lines(bytes);
  TROCAR_ASSIGN_OR_RETURN(const Header header, check_header(lines));
  TROCAR_RETURN_IF_ERROR(check_vertices(lines, header));
  TROCAR_RETURN_IF_ERROR(check_faces(lines, header.counts));
  return header.counts;
}

}  // namespace trocar::scene
