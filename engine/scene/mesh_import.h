/// Triangle meshes from text PLY files.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "engine/core/result.h"
#include "engine/scene/scene.h"

namespace trocar::scene {

/// A file's mesh in the file's units; normals are the file's, or made where it has none.
/// Errors: kIo, and those of `parse_mesh`, naming the file.
Result<std::shared_ptr<const Mesh>> import_mesh(const std::filesystem::path& path);

/// The same from bytes: what `check_ply` finds sound, read by assimp (which aborts the process on what is not);
/// polygons become triangles.
/// Errors: those of `check_ply`, and kCorrupt if no triangle can be made. Threads: any.
Result<Mesh> parse_mesh(std::string_view bytes);

}  // namespace trocar::scene
