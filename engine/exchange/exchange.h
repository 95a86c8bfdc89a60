/// Demonstrations to and from files of other programs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/column_guess.h"
#include "engine/exchange/column_map.h"
#include "engine/exchange/imported.h"
#include "engine/exchange/robomimic.h"
#include "engine/spatial/pose.h"

namespace trocar::exchange {

enum class Format {
  kCsv,
  kNpy,
  kHdf5,     ///< In robomimic's layout; the one that holds several demonstrations.
  kJigsaws,  ///< Is read only.
};
std::string_view to_string(Format format);
/// From a name as the command line takes it, "csv", "npy", "hdf5" (or "robomimic") or "jigsaws". Errors:
/// kInvalidArgument listing the names.
Result<Format> format_from(std::string_view name);
/// From the file's ending; text is JIGSAWS. Errors: kInvalidArgument.
Result<Format> guess_format(const std::filesystem::path& path);

struct ExportReport {
  std::vector<std::string> lossless;  ///< What an import brings back as it is.
  std::vector<std::string> lossy;     ///< What is not carried.
  std::string reread;                 ///< What was compared after writing, and with which result.
  std::size_t samples = 0;
};

/// What would come back of such a file and what is not carried, before anything is written; `reread` is empty.
/// Errors: those of `export_demonstrations` but kIo.
Result<ExportReport> export_report(const Documents& documents, Format format, const Masks& masks = {});

/// Writes the gated samples, reads them again and compares; the file is whole and right, or not there.
/// Errors: kIo, also if what was read again differs; kUnsupported for a format that is read only; kInvalidArgument for
/// several demonstrations or filter keys where the format has none.
Result<ExportReport> export_demonstrations(const Documents& documents, const std::filesystem::path& path, Format format,
                                           const Masks& masks = {});

/// One demonstration. Returns what is not carried (`lossy`). Errors: those of `export_demonstrations`.
Result<std::vector<std::string>> export_demonstration(const demonstration::Demonstration& document,
                                                      const std::filesystem::path& path, Format format);

struct ImportOptions {
  std::filesystem::path transcription;  ///< Of gestures, for JIGSAWS; may be empty.
  spatial::Pose X_WF;                   ///< Of the file's frame F; every pose is moved by it.
  RobomimicOptions robomimic;           ///< For HDF5.
  std::optional<ColumnMap> map;         ///< For tables (csv, npy) that are not as Trocar writes them.
};

/// What the columns of the file may be; nothing for a file that is read without a map.
/// Errors: kIo; kCorrupt for what is no table; kUnsupported if nothing of use is recognised.
Result<std::optional<ColumnGuess>> guess_columns(const std::filesystem::path& path, Format format);

/// All that the file holds, at least one. The provenance's `device` is the file's name, unless Trocar wrote another;
/// the time of import is left to the caller. Errors: kIo; kInvalidArgument for an option that the format does not have;
/// those of `from_csv`, `from_npy`, `from_jigsaws` and `read_robomimic`.
Result<std::vector<Imported>> import_demonstrations(const std::filesystem::path& path, Format format,
                                                    const ImportOptions& options = {});
/// The first of them.
Result<Imported> import_demonstration(const std::filesystem::path& path, Format format,
                                      const ImportOptions& options = {});

}  // namespace trocar::exchange
