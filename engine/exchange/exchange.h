/// Demonstrations to and from files of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/imported.h"

namespace trocar::exchange {

enum class Format { kCsv, kNpy };
std::string_view to_string(Format format);
/// From a name as the command line takes it, "csv" or "npy". Errors: kInvalidArgument listing the names.
Result<Format> format_from(std::string_view name);
/// From the file's ending. Errors: kInvalidArgument.
Result<Format> guess_format(const std::filesystem::path& path);

/// Writes the gated samples; the file is whole or not there. Returns what is not carried (`lossy`).
/// Errors: kIo.
Result<std::vector<std::string>> export_demonstration(const demonstration::Demonstration& document,
                                                      const std::filesystem::path& path, Format format);

/// The provenance's `device` is the file's name; the time of import is left to the caller.
/// Errors: kIo; those of `from_csv` and `from_npy`.
Result<Imported> import_demonstration(const std::filesystem::path& path, Format format);

}  // namespace trocar::exchange
