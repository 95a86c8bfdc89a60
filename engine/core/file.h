/// Files read whole and written atomically: a write that fails or is interrupted leaves the old file, or none.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace trocar {

/// Errors: kIo if there is none, or it cannot be read or is larger than `limit_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit_bytes = std::size_t{1} << 30);

/// The file that a write to `path` is to replace: links are followed, so that they stay links. It need not exist.
/// Errors: kIo if there is something that is no file (a folder, a device, a pipe), which a rename would put an end to.
Result<std::filesystem::path> replaceable_file(const std::filesystem::path& path);

/// Writes beside `replaceable_file(path)`, syncs and renames.
/// Errors: those of `replaceable_file`; kIo (folder missing, no permission, disk full). Nothing is left then.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

using TakeBytes = std::function<Status(std::string_view)>;
/// Likewise for what is large: `make` hands it over piece by piece, in order; `check` may read it under the name that
/// it is given before it is put in place. Errors: those of both, too.
Status write_file(const std::filesystem::path& path, const std::function<Status(const TakeBytes&)>& make,
                  const std::function<Status(const std::filesystem::path&)>& check);

/// Hands over a file piece by piece, each of up to `piece_bytes` and all but the last of them whole.
/// Errors: kIo as of `read_file`; those of `take`, which end the reading.
Status read_pieces(const std::filesystem::path& path, std::size_t piece_bytes, const TakeBytes& take);

/// A name beside `path` for a file that is renamed to it when complete; keeps the extension, which writers go by.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Where `assets` or `demos` are: $TROCAR_SHARE, else beside the program's installation, else the source tree.
std::filesystem::path share_path(std::string_view relative);

}  // namespace trocar
