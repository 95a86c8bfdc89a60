/// The tables of a project file, and the look at its first bytes that decides whether it is one.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace trocar::store {

/// SQL that makes an empty project; marks it with our application id and schema version.
extern const char* const kSchemaSql;

/// Reads at most 100 bytes and changes nothing, so that a foreign or damaged file is left exactly as it is.
/// Errors: kIo (missing, not readable); kCorrupt (not a project, truncated); kUnsupported (newer schema).
Status check_header(const std::filesystem::path& path);

/// The write-ahead log that belongs to a project, which is there only while it is open or after a crash.
std::filesystem::path log_of(const std::filesystem::path& path);

}  // namespace trocar::store
