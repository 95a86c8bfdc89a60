/// Demonstrations to and from files of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/imported.h"
#include "engine/spatial/pose.h"

namespace trocar::exchange {

enum class Format {
  kCsv,
  kNpy,
  kJigsaws,  ///< Is read only.
};
std::string_view to_string(Format format);
/// From a name as the command line takes it, "csv", "npy" or "jigsaws". Errors: kInvalidArgument listing the names.
Result<Format> format_from(std::string_view name);
/// From the file's ending; text is JIGSAWS. Errors: kInvalidArgument.
Result<Format> guess_format(const std::filesystem::path& path);

/// Writes the gated samples; the file is whole or not there. Returns what is not carried (`lossy`).
/// Errors: kIo; kUnsupported for a format that is read only.
Result<std::vector<std::string>> export_demonstration(const demonstration::Demonstration& document,
                                                      const std::filesystem::path& path, Format format);

struct ImportOptions {
  std::filesystem::path transcription;  ///< Of gestures, for JIGSAWS; may be empty.
  spatial::Pose X_WF;                   ///< Of the file's frame F; every pose is moved by it.
};

/// The provenance's `device` is the file's name; the time of import is left to the caller.
/// Errors: kIo; kInvalidArgument for a transcription that the format does not have; those of `from_csv`, `from_npy`
/// and `from_jigsaws`.
Result<Imported> import_demonstration(const std::filesystem::path& path, Format format,
                                      const ImportOptions& options = {});

}  // namespace trocar::exchange
