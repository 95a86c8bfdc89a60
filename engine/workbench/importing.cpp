#include "engine/workbench/importing.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "engine/exchange/findings.h"
#include "engine/review/review.h"

namespace trocar::workbench {
namespace {

using exchange::Format;

Result<Format> format_of(const ImportSettings& settings) {
  if (settings.format) return *settings.format;
  Result<Format> format = exchange::guess_format(settings.path);
  // A map of columns makes a table of whatever ending.
  return !format && settings.map ? Result<Format>(Format::kCsv) : format;
}

/// What is asked for, else the file's own name for it, else that of the file.
std::string wanted_name(const ImportSettings& settings, const exchange::Imported& imported, std::size_t nth) {
  const std::string file = settings.path.stem().string();
  if (!settings.name.empty()) return nth == 0 ? settings.name : fmt::format("{} {}", settings.name, nth + 1);
  if (imported.name.empty()) return file;
  return imported.name_is_own ? imported.name : fmt::format("{} {}", file, imported.name);
}

exchange::ImportOptions options_of(const ImportSettings& settings, const ImportLayout& layout) {
  exchange::ImportOptions options;
  options.transcription = settings.transcription;
  options.robomimic = {settings.only, settings.rate_hz};
  options.X_WF.p = Eigen::Vector3d(settings.p_WF_m.data());
  if (layout.columns) options.map = layout.columns->map;
  return options;
}

Result<ImportPart> part_of(const ImportSettings& settings, exchange::Imported imported, const std::string& created,
                           std::size_t nth) {
  ImportPart part;
  demonstration::Provenance& provenance = imported.recording.provenance;
  if (settings.block != demonstration::kUnknownPlace) provenance.block = settings.block;
  if (settings.goal != demonstration::kUnknownPlace) provenance.goal = settings.goal;
  if (provenance.created.empty()) provenance.created = created;
  part.name = wanted_name(settings, imported, nth);
  part.lossy = std::move(imported.lossy);
  const bool told = settings.block != demonstration::kUnknownPlace && settings.goal != demonstration::kUnknownPlace;
  if (told)
    std::replace(part.lossy.begin(), part.lossy.end(), std::string("its block, goal and outcome"),
                 std::string("its outcome"));
  part.notes = std::move(imported.notes);
  auto recording = std::make_shared<const demonstration::Recording>(std::move(imported.recording));
  TROCAR_ASSIGN_OR_RETURN(auto document, demonstration::make_demonstration({}, part.name, std::move(recording)));
  part.found = exchange::findings(document, spatial::Grid{});
  part.changed = std::move(imported.found);
  const review::Review reviewed = review::Reviewer().make(document);
  part.warnings = review::count_of(reviewed.problems, demonstration::Severity::kWarning);
  part.errors = review::count_of(reviewed.problems, demonstration::Severity::kError);
  part.document = std::make_shared<const demonstration::Demonstration>(std::move(document));
  return part;
}

/// A map in which nothing is said but how text is cut.
ImportLayout empty_map(Format format, const std::filesystem::path& path) {
  exchange::ColumnGuess guess;
  if (path.extension() == ".tsv") guess.map.delimiter = "tab";
  if (path.extension() == ".txt") guess.map.delimiter = "space";
  guess.map.time.rate_hz = 30.0;
  return {format == Format::kJigsaws ? Format::kCsv : format, guess, true};
}

}  // namespace

Result<ImportLayout> layout_of(const ImportSettings& settings) {
  ImportLayout layout;
  TROCAR_ASSIGN_OR_RETURN(layout.format, format_of(settings));
  if (settings.map) {
    layout.columns = exchange::ColumnGuess{*settings.map, {}};
  } else if (settings.propose) {
    TROCAR_ASSIGN_OR_RETURN(layout.columns, exchange::guess_columns(settings.path, layout.format));
    layout.proposed = layout.columns.has_value();
  }
  if (!layout.columns) return layout;
  if (layout.format == Format::kJigsaws && !settings.format) layout.format = Format::kCsv;
  if (settings.rate_hz > 0.0) layout.columns->map.time = {"", "s", settings.rate_hz};
  return layout;
}

Result<std::vector<ImportPart>> parts_of(const ImportSettings& settings, const ImportLayout& layout,
                                         const std::string& created, Progress& progress) {
  const auto stopped = [] { return fail(ErrorCode::kCancelled, "the import was stopped"); };
  if (progress.cancelled()) return stopped();
  TROCAR_ASSIGN_OR_RETURN(std::vector<exchange::Imported> all,
                          exchange::import_demonstrations(settings.path, layout.format, options_of(settings, layout)));
  std::vector<ImportPart> parts;
  for (exchange::Imported& imported : all) {
    if (progress.cancelled()) return stopped();
    // Reading is about half of the work, judging the other.
    progress.set(0.5 + 0.5 * static_cast<double>(parts.size()) / static_cast<double>(all.size()));
    TROCAR_ASSIGN_OR_RETURN(ImportPart part, part_of(settings, std::move(imported), created, parts.size()));
    parts.push_back(std::move(part));
  }
  return parts;
}

void give_free_names(std::vector<ImportPart>& parts, const Project& project) {
  std::set<std::string> taken;
  for (const auto& [id, each] : project.demonstrations) taken.insert(each->name);
  for (ImportPart& part : parts) {
    const std::string wanted = part.name;
    for (int number = 2; !taken.insert(part.name).second; ++number) part.name = fmt::format("{} {}", wanted, number);
  }
}

Result<std::vector<DemonstrationId>> add_parts(ProjectFile& file, const std::filesystem::path& path,
                                               const std::vector<ImportPart>& parts) {
  std::vector<ProjectFile::NewRecording> recordings;
  for (const ImportPart& part : parts) {
    recordings.push_back({part.document->recording, part.document->recorded, part.name,
                          std::vector<demonstration::Edit>(part.notes.begin(), part.notes.end())});
  }
  return file.import_recordings(path.filename().string(), recordings);
}

std::filesystem::path transcription_of(const std::filesystem::path& kinematics) {
  // TASK/kinematics/AllGestures/NAME.txt and TASK/transcriptions/NAME.txt.
  std::filesystem::path folder = std::filesystem::path(kinematics).parent_path();
  for (int up = 0; up < 3; ++up, folder = folder / "..") {
    std::error_code error;
    const std::filesystem::path found = (folder / "transcriptions" / kinematics.filename()).lexically_normal();
    if (std::filesystem::is_regular_file(found, error)) return found;
  }
  return {};
}

std::shared_ptr<const ImportView> view_of_import(ImportSettings settings, const std::string& created,
                                                 Progress& progress) {
  auto view = std::make_shared<ImportView>();
  settings.propose = true;
  view->settings = settings;
  Result<ImportLayout> layout = layout_of(settings);
  if (!layout && layout.error().code() == ErrorCode::kUnsupported) {
    if (const Result<Format> format = format_of(settings)) layout = empty_map(*format, settings.path);
  }
  if (!layout) {
    view->error = layout.error().text();
    return view;
  }
  view->layout = std::move(*layout);
  if (view->layout.columns) {
    auto columns = exchange::table_columns(settings.path, view->layout.format, view->layout.columns->map);
    if (columns) view->columns = std::move(*columns);
  }
  progress.set(0.1);
  auto parts = parts_of(settings, view->layout, created, progress);
  if (parts) {
    view->parts = std::move(*parts);
  } else {
    view->error = parts.error().text();
  }
  return view;
}

}  // namespace trocar::workbench
