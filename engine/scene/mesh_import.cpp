#include "engine/scene/mesh_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

#include "engine/core/file.h"

namespace trocar::scene {
namespace {

constexpr std::size_t kLimit_bytes = std::size_t{64} << 20;

tl::unexpected<Error> corrupt(std::string what) {
  return fail(ErrorCode::kCorrupt, "the mesh " + std::move(what));
}

/// The importer reserves room for as many elements as the header claims; each takes at least a byte.
Status check_ply_header(std::string_view bytes) {
  if (bytes.substr(0, 3) != "ply") return corrupt("does not begin as PLY");
  const std::size_t end = bytes.find("end_header");
  if (end == std::string_view::npos) return corrupt("has no end of its header");
  constexpr std::string_view kElement = "element ";
  std::size_t total = 0;
  for (std::size_t at = bytes.find(kElement); at < end; at = bytes.find(kElement, at + 1)) {
    const std::string_view line = bytes.substr(at, std::min(bytes.find('\n', at), end) - at);
    const std::size_t space = line.find_last_of(' ');
    std::size_t count = 0;
    const char* last = line.data() + line.size();
    const auto [stop, error] = std::from_chars(line.data() + space + 1, last, count);
    if (error != std::errc() || (stop != last && *stop != '\r')) return corrupt("counts its elements in no number");
    total += std::min(count, bytes.size());
  }
  if (total > bytes.size() - end) return corrupt("is cut short");
  return {};
}

bool finite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Before any post-processing, which trusts the indices.
Status check(const aiScene& scene) {
  if (scene.mNumMeshes == 0) return corrupt("has no surface");
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    if (mesh.mVertices == nullptr || mesh.mNumVertices == 0) return corrupt("has no vertices");
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      if (!finite(mesh.mVertices[i])) return corrupt("has a vertex that is not finite");
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices) return corrupt("has a triangle of a vertex that is not there");
      }
    }
  }
  return {};
}

Eigen::Vector3f vector(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

void append(const aiMesh& from, Mesh& to) {
  const auto base = static_cast<std::uint32_t>(to.positions.size());
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    to.positions.push_back(vector(from.mVertices[i]));
    const Eigen::Vector3f normal = from.HasNormals() ? vector(from.mNormals[i]) : Eigen::Vector3f::Zero();
    const float length = normal.norm();
    // A vertex of empty triangles only has no normal; any will do.
    to.normals.push_back(length > 1e-6F ? Eigen::Vector3f(normal / length) : Eigen::Vector3f(Eigen::Vector3f::UnitZ()));
  }
  for (unsigned f = 0; f < from.mNumFaces; ++f) {
    const aiFace& face = from.mFaces[f];
    if (face.mNumIndices != 3) continue;
    for (unsigned k = 0; k < 3; ++k) to.indices.push_back(base + face.mIndices[k]);
  }
}

Result<Mesh> convert(std::string_view bytes, const std::string& extension) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension.c_str());
  if (scene == nullptr) return corrupt("cannot be read as " + extension);
  TROCAR_RETURN_IF_ERROR(check(*scene));
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                                       aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                       aiProcess_PreTransformVertices);
  if (scene == nullptr) return corrupt("cannot be made into triangles");
  TROCAR_RETURN_IF_ERROR(check(*scene));
  Mesh mesh;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(*scene->mMeshes[m], mesh);
  if (mesh.indices.empty()) return corrupt("has no triangles");
  return mesh;
}

}  // namespace

Result<Mesh> parse_mesh(std::string_view bytes, std::string_view extension) {
  constexpr std::array<std::string_view, 3> kKnown{"ply", "obj", "stl"};
  if (std::find(kKnown.begin(), kKnown.end(), extension) == kKnown.end()) {
    return fail(ErrorCode::kUnsupported,
                "meshes are read from PLY, OBJ and STL files, not from \"" + std::string(extension) + "\"");
  }
  if (bytes.empty()) return corrupt("is empty");
  if (extension == "ply") TROCAR_RETURN_IF_ERROR(check_ply_header(bytes));
  try {
    return convert(bytes, std::string(extension));
  } catch (const std::exception& problem) {
    return corrupt(std::string("cannot be read: ") + problem.what());
  }
}

Result<std::shared_ptr<const Mesh>> import_mesh(const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path, kLimit_bytes));
  std::string extension = path.extension().string();
  extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Result<Mesh> mesh = parse_mesh(bytes, extension);
  if (!mesh) return tl::unexpected(std::move(mesh).error().at(path.string()));
  return std::make_shared<const Mesh>(std::move(*mesh));
}

}  // namespace trocar::scene
