#include "engine/scene/mesh_import.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "engine/core/file.h"

namespace trocar::scene {
namespace {

constexpr std::size_t kLimit_bytes = std::size_t{64} << 20;
constexpr std::uint32_t kCornerLimit = 64;
constexpr int kPropertyLimit = 64;

tl::unexpected<Error> corrupt(std::string what) {
  return fail(ErrorCode::kCorrupt, "the mesh " + std::move(what));
}

/// Words between blanks; a line ends with a newline, perhaps after a carriage return.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// Empty at the end.
  std::string_view next() {
    const std::size_t begin = rest_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return rest_ = {};
    const std::size_t end = std::min(rest_.find_first_of(" \t\r\n", begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }
  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
  std::size_t remaining() const { return rest_.size(); }

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

/// Which column of a vertex's line holds x, y, z, nx, ny, nz; −1 where there is none.
struct Header {
  std::array<int, 6> columns{-1, -1, -1, -1, -1, -1};
  int column_count = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t face_count = 0;

  bool has_normals() const { return columns[3] >= 0 && columns[4] >= 0 && columns[5] >= 0; }
};

enum class Element { kNone, kVertex, kFace };

Status parse_element(Words& words, Header& header, Element& element) {
  const std::string_view name = words.next();
  const std::optional<std::uint32_t> count = words.number<std::uint32_t>();
  if (!count) return corrupt("counts its elements in no number");
  if (name == "vertex" && element == Element::kNone) {
    element = Element::kVertex;
    header.vertex_count = *count;
  } else if (name == "face" && element == Element::kVertex) {
    element = Element::kFace;
    header.face_count = *count;
  } else {
    return corrupt("has other elements than vertices before faces");
  }
  return {};
}

Status parse_property(Words& words, Header& header, Element element) {
  const std::string_view type = words.next();
  if (element == Element::kFace) {
    words.next();
    words.next();
    const std::string_view name = words.next();
    if (type == "list" && (name == "vertex_indices" || name == "vertex_index")) return {};
    return corrupt("has faces that are more than lists of vertices");
  }
  if (element != Element::kVertex || type == "list" || header.column_count >= kPropertyLimit) {
    return corrupt("has a property where none can be");
  }
  constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "nx", "ny", "nz"};
  const auto* const found = std::find(kNames.begin(), kNames.end(), words.next());
  if (found != kNames.end()) header.columns[static_cast<std::size_t>(found - kNames.begin())] = header.column_count;
  ++header.column_count;
  return {};
}

Result<Header> parse_header(Words& words) {
  if (words.next() != "ply") return corrupt("does not begin as PLY");
  if (words.next() != "format") return corrupt("does not say its format");
  if (words.next() != "ascii") return fail(ErrorCode::kUnsupported, "the mesh is binary PLY; only text PLY is read");
  words.skip_line();
  Header header;
  Element element = Element::kNone;
  for (std::string_view word = words.next(); word != "end_header"; word = words.next()) {
    if (word == "comment" || word == "obj_info") {
      words.skip_line();
    } else if (word == "element") {
      TROCAR_RETURN_IF_ERROR(parse_element(words, header, element));
    } else if (word == "property") {
      TROCAR_RETURN_IF_ERROR(parse_property(words, header, element));
    } else {
      return corrupt(word.empty() ? "has no end of its header" : "has a line in its header that PLY does not know");
    }
  }
  if (header.columns[0] < 0 || header.columns[1] < 0 || header.columns[2] < 0) return corrupt("has no coordinates");
  // Every number takes a digit and a blank: what is promised must fit into what is there before room is made for it.
  const std::size_t least = std::size_t{2} * header.vertex_count * static_cast<std::size_t>(header.column_count) +
                            std::size_t{8} * header.face_count;
  if (least > words.remaining() + 1) return corrupt("is cut short");
  return header;
}

Status parse_vertices(Words& words, const Header& header, Mesh& mesh) {
  std::array<float, kPropertyLimit> line{};
  const auto at = [&](std::size_t k) { return line[static_cast<std::size_t>(header.columns[k])]; };
  for (std::uint32_t i = 0; i < header.vertex_count; ++i) {
    for (int column = 0; column < header.column_count; ++column) {
      const std::optional<float> value = words.number<float>();
      if (!value || !std::isfinite(*value)) return corrupt(fmt::format("has no finite number at vertex {}", i));
      line[static_cast<std::size_t>(column)] = *value;
    }
    mesh.positions.emplace_back(at(0), at(1), at(2));
    if (header.has_normals()) mesh.normals.emplace_back(at(3), at(4), at(5));
  }
  return {};
}

Status parse_faces(Words& words, const Header& header, Mesh& mesh) {
  std::array<std::uint32_t, kCornerLimit> corners{};
  for (std::uint32_t face = 0; face < header.face_count; ++face) {
    const std::optional<std::uint32_t> count = words.number<std::uint32_t>();
    if (!count || *count < 3 || *count > kCornerLimit) return corrupt(fmt::format("has no polygon at face {}", face));
    for (std::uint32_t k = 0; k < *count; ++k) {
      const std::optional<std::uint32_t> index = words.number<std::uint32_t>();
      if (!index || *index >= header.vertex_count) {
        return corrupt(fmt::format("has a vertex that is not there at face {}", face));
      }
      corners[k] = *index;
    }
    for (std::uint32_t k = 1; k + 1 < *count; ++k) {
      mesh.indices.insert(mesh.indices.end(), {corners[0], corners[k], corners[k + 1]});
    }
  }
  if (mesh.indices.empty()) return corrupt("has no faces");
  if (!words.next().empty()) return corrupt("goes on after its last face");
  return {};
}

/// Area-weighted means of the triangles around each vertex.
void add_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Eigen::Vector3f& a = mesh.positions[mesh.indices[i]];
    const Eigen::Vector3f normal =
        (mesh.positions[mesh.indices[i + 1]] - a).cross(mesh.positions[mesh.indices[i + 2]] - a);
    for (std::size_t k = 0; k < 3; ++k) mesh.normals[mesh.indices[i + k]] += normal;
  }
}

void normalise(Mesh& mesh) {
  for (Eigen::Vector3f& normal : mesh.normals) {
    const float length = normal.stableNorm();
    // A vertex of empty triangles only has no normal; any will do.
    if (length > 0.0F && std::isfinite(length)) {
      normal /= length;
    } else {
      normal = Eigen::Vector3f::UnitZ();
    }
  }
}

}  // namespace

Result<Mesh> parse_mesh(std::string_view bytes) {
  Words words(bytes);
  TROCAR_ASSIGN_OR_RETURN(const Header header, parse_header(words));
  Mesh mesh;
  TROCAR_RETURN_IF_ERROR(parse_vertices(words, header, mesh));
  TROCAR_RETURN_IF_ERROR(parse_faces(words, header, mesh));
  if (!header.has_normals()) add_normals(mesh);
  normalise(mesh);
  return mesh;
}

Result<std::shared_ptr<const Mesh>> import_mesh(const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path, kLimit_bytes));
  Result<Mesh> mesh = parse_mesh(bytes);
  if (!mesh) return tl::unexpected(std::move(mesh).error().at(path.string()));
  return std::make_shared<const Mesh>(std::move(*mesh));
}

}  // namespace trocar::scene
