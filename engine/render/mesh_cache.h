/// Meshes and pictures of a scene on the GL side, kept as long as someone else holds them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "engine/core/image.h"
#include "engine/render/gl_functions.h"
#include "engine/scene/scene.h"

namespace trocar::render {

/// One instance of a mesh as the vertex shader reads it.
struct Instance {
  Eigen::Matrix<float, 3, 4, Eigen::RowMajor> X_WM;
  Eigen::Vector4f base_colour;
  Eigen::Vector4f material;  ///< Roughness, metallic, emission, unused.
};

struct GpuMesh {
  std::uint64_t serial = 0;  ///< From 1; never given twice by one cache.
  GLuint vertex_array = 0;
  GLuint buffers[2] = {0, 0};  ///< Vertices, indices.
  GLsizei index_count = 0;
  Eigen::Vector3f centre{0, 0, 0};  ///< Of the bounding box, in the mesh's frame.
  Eigen::Vector3f half_size{0, 0, 0};
  float radius_m = 0.0F;  ///< Half the bounding box's diagonal.
  /// Of a convex body: its sides, n · p + d ≤ 0 inside, each as (n, d). Empty of others and of very fine ones.
  std::vector<Eigen::Vector4f> sides;
};

struct GpuTexture {
  std::uint64_t serial = 0;  ///< As of a mesh, and different from any mesh's.
  GLuint name = 0;
};

/// Threads: that of the context.
class MeshCache {
 public:
  explicit MeshCache(const GlFunctions& gl);
  ~MeshCache();
  MeshCache(const MeshCache&) = delete;
  MeshCache& operator=(const MeshCache&) = delete;

  /// The reference lives until the next `drop_unused`. Precondition: not null, normals and colours fit the positions.
  const GpuMesh& mesh(const std::shared_ptr<const scene::Mesh>& mesh);
  /// Premultiplied, with mipmaps. Precondition: neither null nor empty.
  GpuTexture texture(const std::shared_ptr<const Image>& image);
  /// Points the instance attributes of the bound vertex array at `first` in the bound array buffer.
  void point_at_instances(std::size_t first) const;
  /// Frees what only the cache still holds.
  void drop_unused();

 private:
  struct MeshEntry {
    std::shared_ptr<const scene::Mesh> source;
    GpuMesh mesh;
  };
  struct TextureEntry {
    std::shared_ptr<const Image> source;
    GpuTexture texture;
  };

  const GlFunctions& gl_;
  std::unordered_map<const scene::Mesh*, MeshEntry> meshes_;
  std::unordered_map<const Image*, TextureEntry> textures_;
  std::uint64_t last_serial_ = 0;
};

}  // namespace trocar::render
