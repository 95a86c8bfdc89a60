/// A file of another program on its way into the project: how it is read, and what would come of it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/exchange/table_preview.h"
#include "engine/workbench/import_settings.h"
#include "engine/workbench/project.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

/// How the file is to be read.
struct ImportLayout {
  exchange::Format format = exchange::Format::kCsv;
  std::optional<exchange::ColumnGuess> columns;  ///< Of a foreign table: the map in use, and what is doubtful in it.
  bool proposed = false;                         ///< Nobody has given it.
};

/// One demonstration of the file, as it would be.
struct ImportPart {
  std::string name;
  std::shared_ptr<const demonstration::Demonstration> document;  ///< Without its notes.
  std::vector<demonstration::AddNote> notes;                     ///< From the file.
  std::vector<std::string> lossy;                                ///< What the file does not have.
  std::vector<std::string> found;                                ///< What is odd about it, and was not mended.
  std::vector<std::string> changed;                              ///< What was changed, left out or assumed.
  std::size_t warnings = 0;                                      ///< Of the problems that it has.
  std::size_t errors = 0;
};

/// Errors: kInvalidArgument for a name that tells no format; those of `exchange::guess_columns` if asked to propose.
Result<ImportLayout> layout_of(const ImportSettings& settings);

/// Everything that the file holds. `created` is the time of import, ISO 8601. Threads: any.
/// Errors: those of `exchange::import_demonstrations`; kCancelled.
Result<std::vector<ImportPart>> parts_of(const ImportSettings& settings, const ImportLayout& layout,
                                         const std::string& created, Progress& progress);

/// Names that no demonstration of the project has, nor another of them.
void give_free_names(std::vector<ImportPart>& parts, const Project& project);

/// Puts them into the project, notes included, as one step. Errors: those of `ProjectFile`.
Result<std::vector<DemonstrationId>> add_parts(ProjectFile& file, const std::filesystem::path& path,
                                               const std::vector<ImportPart>& parts);

/// The transcription of a JIGSAWS file where the data set has it, in a folder beside; empty if there is none.
std::filesystem::path transcription_of(const std::filesystem::path& kinematics);

/// A dry run, for a person to look at before anything is changed.
struct ImportView {
  ImportSettings settings;  ///< As asked.
  ImportLayout layout;
  std::vector<exchange::TableColumn> columns;  ///< Of a foreign table.
  std::vector<ImportPart> parts;               ///< Empty: see `error`.
  std::string error;                           ///< Why it cannot be read so.
};
/// Proposes a map where it can; where it cannot, an empty one is there to be filled in. Threads: any.
std::shared_ptr<const ImportView> view_of_import(ImportSettings settings, const std::string& created,
                                                 Progress& progress);

}  // namespace trocar::workbench
