// Meshes from any bytes. What is accepted must hold together.
#include <cstddef>
#include <cstdint>

#include "engine/scene/mesh_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto mesh = trocar::scene::parse_mesh({reinterpret_cast<const char*>(data), size});
  if (!mesh) return 0;
  if (mesh->indices.empty() || mesh->indices.size() % 3 != 0) __builtin_trap();
  if (mesh->normals.size() != mesh->positions.size()) __builtin_trap();
  for (const std::uint32_t index : mesh->indices) {
    if (index >= mesh->positions.size()) __builtin_trap();
  }
  return 0;
}
