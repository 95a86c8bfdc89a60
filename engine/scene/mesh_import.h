/// Triangle meshes from files (PLY, OBJ, STL).
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "engine/core/result.h"
#include "engine/scene/scene.h"

namespace trocar::scene {

/// All that a file holds as one mesh in the file's units; normals are made where there are none.
/// Errors: kNotFound, kIo, and those of `parse_mesh`.
Result<std::shared_ptr<const Mesh>> import_mesh(const std::filesystem::path& path);

/// The same from bytes; `extension` is "ply", "obj" or "stl".
/// Errors: kUnsupported for another extension; kCorrupt if the bytes are no such mesh: nothing in it, cut short,
/// numbers that are not finite, a triangle of a vertex that is not there. Threads: any.
Result<Mesh> parse_mesh(std::string_view bytes, std::string_view extension);

}  // namespace trocar::scene
