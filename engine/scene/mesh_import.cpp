#include "engine/scene/mesh_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

#include "engine/core/file.h"
#include "engine/scene/ply_check.h"

namespace trocar::scene {
namespace {

constexpr std::size_t kLimit_bytes = std::size_t{64} << 20;

tl::unexpected<Error> corrupt(std::string what) {
  return fail(ErrorCode::kCorrupt, "the mesh " + std::move(what));
}

Eigen::Vector3f vector(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

/// That the importer found what the file says, before its post-processing trusts the indices.
Status check_found(const aiScene& found, const PlyCounts& counts) {
  if (found.mNumMeshes != 1) return corrupt("has no surface");
  const aiMesh& mesh = *found.mMeshes[0];
  if (mesh.mVertices == nullptr || mesh.mNumVertices != counts.vertices || mesh.mNumFaces != counts.faces) {
    return corrupt("is not understood whole");
  }
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    if (!vector(mesh.mVertices[i]).allFinite()) return corrupt("has a vertex that is not finite");
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    const bool sound = std::all_of(face.mIndices, face.mIndices + face.mNumIndices,
                                   [&](unsigned index) { return index < mesh.mNumVertices; });
    if (!sound) return corrupt("has a triangle of a vertex that is not there");
  }
  return {};
}

Eigen::Vector3f unit(const Eigen::Vector3f& normal) {
  const float length = normal.stableNorm();
  // A vertex of empty triangles only has no normal; any will do.
  return length > 0.0F && std::isfinite(length) ? Eigen::Vector3f(normal / length) : Eigen::Vector3f::UnitZ();
}

Mesh convert(const aiMesh& from) {
  Mesh mesh;
  mesh.positions.reserve(from.mNumVertices);
  mesh.normals.reserve(from.mNumVertices);
  mesh.indices.reserve(std::size_t{3} * from.mNumFaces);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    mesh.positions.push_back(vector(from.mVertices[i]));
    mesh.normals.push_back(unit(from.HasNormals() ? vector(from.mNormals[i]) : Eigen::Vector3f(0.0F, 0.0F, 0.0F)));
  }
  for (unsigned f = 0; f < from.mNumFaces; ++f) {
    const aiFace& face = from.mFaces[f];
    if (face.mNumIndices == 3) mesh.indices.insert(mesh.indices.end(), face.mIndices, face.mIndices + 3);
  }
  return mesh;
}

Result<Mesh> import_checked(std::string_view bytes, const PlyCounts& counts) {
  Assimp::Importer importer;
  const aiScene* found = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "ply");
  if (found == nullptr) return corrupt(std::string("cannot be read: ") + importer.GetErrorString());
  TROCAR_RETURN_IF_ERROR(check_found(*found, counts));
  found = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_GenSmoothNormals);
  if (found == nullptr || found->mNumMeshes != 1) return corrupt("cannot be made into triangles");
  Mesh mesh = convert(*found->mMeshes[0]);
  if (mesh.indices.empty()) return corrupt("has no triangles");
  return mesh;
}

}  // namespace

Result<Mesh> parse_mesh(std::string_view bytes) {
  TROCAR_ASSIGN_OR_RETURN(const PlyCounts counts, check_ply(bytes));
  try {
    if (bytes.back() == '\n') return import_checked(bytes, counts);
    return import_checked(std::string(bytes) + '\n', counts);
  } catch (const std::exception& problem) {
    return corrupt(std::string("cannot be read: ") + problem.what());
  }
}

Result<std::shared_ptr<const Mesh>> import_mesh(const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path, kLimit_bytes));
  Result<Mesh> mesh = parse_mesh(bytes);
  if (!mesh) return tl::unexpected(std::move(mesh).error().at(path.string()));
  return std::make_shared<const Mesh>(std::move(*mesh));
}

}  // namespace trocar::scene
