/// Triangle meshes from text PLY files.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "engine/core/result.h"
#include "engine/scene/scene.h"

namespace trocar::scene {

/// A file's mesh in the file's units; normals are made where there are none.
/// Errors: kNotFound, kIo, and those of `parse_mesh`, naming the file.
Result<std::shared_ptr<const Mesh>> import_mesh(const std::filesystem::path& path);

/// The same from bytes: text PLY with vertices (x, y, z, perhaps nx, ny, nz, in any order and among others that are
/// passed over) before faces (polygons of 3 to 64 corners, made into triangles).
/// Errors: kUnsupported for binary PLY; kCorrupt if the bytes are no such mesh: cut short or longer than it says,
/// numbers that are not finite, a face of a vertex that is not there, no faces at all. Threads: any.
Result<Mesh> parse_mesh(std::string_view bytes);

}  // namespace trocar::scene
