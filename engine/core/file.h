/// Files read whole and written atomically: a write that fails or is interrupted leaves the old file, or none.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace trocar {

/// Errors: kNotFound if there is none, kIo if it cannot be read or is larger than `limit_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit_bytes = std::size_t{1} << 30);

/// Writes beside `path`, syncs and renames. Errors: kIo (folder missing, no permission, disk full), nothing is left.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

/// A name beside `path` for a file that is renamed to it when complete; keeps the extension, which writers go by.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Where `assets` or `demos` are: $TROCAR_SHARE, else beside the program's installation, else the source tree.
std::filesystem::path share_path(std::string_view relative);

}  // namespace trocar
