#include "engine/render/mesh_cache.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/check.h"

namespace trocar::render {
namespace {

struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;
  Rgba colour;
};

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

std::vector<Vertex> interleaved(const scene::Mesh& mesh) {
  std::vector<Vertex> vertices(mesh.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = {mesh.positions[i], mesh.normals[i],
                   mesh.colours.empty() ? Rgba{255, 255, 255, 255} : mesh.colours[i]};
  }
  return vertices;
}

void measure(const scene::Mesh& mesh, GpuMesh& gpu) {
  if (mesh.positions.empty()) return;
  Eigen::Vector3f low = mesh.positions.front();
  Eigen::Vector3f high = low;
  for (const Eigen::Vector3f& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  gpu.centre = 0.5F * (low + high);
  gpu.half_size = 0.5F * (high - low);
  gpu.radius_m = gpu.half_size.norm();
}

std::vector<Eigen::Vector4f> sides_of(const scene::Mesh& mesh) {
  constexpr std::size_t kMostIndices = 1200;
  constexpr float kFlat_m = 2e-6F;
  std::vector<Eigen::Vector4f> sides;
  if (mesh.indices.size() > kMostIndices) return sides;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Eigen::Vector3f& a = mesh.positions[mesh.indices[i]];
    const Eigen::Vector3f area =
        (mesh.positions[mesh.indices[i + 1]] - a).cross(mesh.positions[mesh.indices[i + 2]] - a);
    if (!(area.norm() > 0.0F)) continue;
    const Eigen::Vector3f n = area.normalized();
    const float d = -n.dot(a);
    for (const Eigen::Vector3f& p : mesh.positions) {
      if (n.dot(p) + d > kFlat_m) return {};
    }
    sides.emplace_back(n.x(), n.y(), n.z(), d);
  }
  return sides;
}

GpuMesh upload(const GlFunctions& gl, const scene::Mesh& mesh) {
  TROCAR_CHECK(mesh.normals.size() == mesh.positions.size());
  TROCAR_CHECK(mesh.colours.empty() || mesh.colours.size() == mesh.positions.size());
  GpuMesh gpu;
  const std::vector<Vertex> vertices = interleaved(mesh);
  gl.GenVertexArrays(1, &gpu.vertex_array);
  gl.GenBuffers(2, gpu.buffers);
  gl.BindVertexArray(gpu.vertex_array);
  gl.BindBuffer(GL_ARRAY_BUFFER, gpu.buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                mesh.indices.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, position)));
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, normal)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), offset(offsetof(Vertex, colour)));
  for (GLuint attribute = 0; attribute < 8; ++attribute) {
    gl.EnableVertexAttribArray(attribute);
    if (attribute > 2) gl.VertexAttribDivisor(attribute, 1);
  }
  gpu.index_count = static_cast<GLsizei>(mesh.indices.size());
  measure(mesh, gpu);
  gpu.sides = sides_of(mesh);
  return gpu;
}

void free_mesh(const GlFunctions& gl, const GpuMesh& mesh) {
  gl.DeleteVertexArrays(1, &mesh.vertex_array);
  gl.DeleteBuffers(2, mesh.buffers);
}

std::vector<std::uint8_t> premultiplied(const Image& image) {
  std::vector<std::uint8_t> bytes = image.rgba;
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
    const unsigned alpha = bytes[i + 3];
    for (std::size_t k = 0; k < 3; ++k) bytes[i + k] = static_cast<std::uint8_t>((bytes[i + k] * alpha + 127U) / 255U);
  }
  return bytes;
}

GLuint upload(const GlFunctions& gl, const Image& image) {
  TROCAR_CHECK(!image.empty());
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::vector<std::uint8_t> bytes = premultiplied(image);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return name;
}

}  // namespace

MeshCache::MeshCache(const GlFunctions& gl) : gl_(gl) {}

MeshCache::~MeshCache() {
  for (const auto& [key, entry] : meshes_) free_mesh(gl_, entry.mesh);
  for (const auto& [key, entry] : textures_) gl_.DeleteTextures(1, &entry.texture.name);
}

const GpuMesh& MeshCache::mesh(const std::shared_ptr<const scene::Mesh>& mesh) {
  TROCAR_CHECK(mesh != nullptr);
  const auto found = meshes_.find(mesh.get());
  if (found != meshes_.end()) return found->second.mesh;
  GpuMesh& made = meshes_.emplace(mesh.get(), MeshEntry{mesh, upload(gl_, *mesh)}).first->second.mesh;
  made.serial = ++last_serial_;
  return made;
}

GpuTexture MeshCache::texture(const std::shared_ptr<const Image>& image) {
  TROCAR_CHECK(image != nullptr);
  const auto found = textures_.find(image.get());
  if (found != textures_.end()) return found->second.texture;
  const GpuTexture made{++last_serial_, upload(gl_, *image)};
  textures_.emplace(image.get(), TextureEntry{image, made});
  return made;
}

void MeshCache::point_at_instances(std::size_t first) const {
  const std::size_t start = first * sizeof(Instance);
  for (GLuint row = 0; row < 3; ++row) {
    gl_.VertexAttribPointer(3 + row, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                            offset(start + offsetof(Instance, X_WM) + row * 4 * sizeof(float)));
  }
  gl_.VertexAttribPointer(6, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), offset(start + offsetof(Instance, base_colour)));
  gl_.VertexAttribPointer(7, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), offset(start + offsetof(Instance, material)));
}

void MeshCache::drop_unused() {
  for (auto entry = meshes_.begin(); entry != meshes_.end();) {
    if (entry->second.source.use_count() > 1) {
      ++entry;
      continue;
    }
    free_mesh(gl_, entry->second.mesh);
    entry = meshes_.erase(entry);
  }
  for (auto entry = textures_.begin(); entry != textures_.end();) {
    if (entry->second.source.use_count() > 1) {
      ++entry;
      continue;
    }
    gl_.DeleteTextures(1, &entry->second.texture.name);
    entry = textures_.erase(entry);
  }
}

}  // namespace trocar::render
