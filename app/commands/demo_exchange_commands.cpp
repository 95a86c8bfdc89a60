#include <fmt/format.h>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/problems.h"
#include "engine/exchange/exchange.h"
#include "engine/exchange/findings.h"

namespace trocar::app {
namespace {

Result<exchange::Format> format_of(const std::string& name, const std::string& path) {
  return name.empty() ? exchange::guess_format(path) : exchange::format_from(name);
}

std::string lossy_text(const std::vector<std::string>& lossy) {
  std::string text;
  for (const std::string& part : lossy) text += (text.empty() ? "; without " : ", ") + part;
  return text;
}

/// Warnings and errors.
std::pair<std::size_t, std::size_t> count_problems(const demonstration::Demonstration& document) {
  std::pair<std::size_t, std::size_t> counts{0, 0};
  for (const demonstration::Problem& problem : demonstration::problems(document, spatial::Grid{})) {
    if (problem.severity == demonstration::Severity::kWarning) ++counts.first;
    if (problem.severity == demonstration::Severity::kError) ++counts.second;
  }
  return counts;
}

struct ImportArguments {
  std::string project;
  std::string file;
  std::string format;
  std::string name;
  std::string transcription;
  std::vector<double> offset_mm;
  bool dry_run = false;
  int block = demonstration::kUnknownPlace;
  int goal = demonstration::kUnknownPlace;
};

void bind_import(CLI::App& verb, ImportArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("FILE", arguments.file, "What to read")->required();
  verb.add_option("--format", arguments.format, "csv, npy or jigsaws (else guessed from the file's name)");
  verb.add_option("--transcription", arguments.transcription, "Gestures, of JIGSAWS; they become notes");
  verb.add_option("--offset-mm", arguments.offset_mm, "Where the file's origin is on the board: X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  verb.add_flag("--dry-run", arguments.dry_run, "Only say what would come of it");
  verb.add_option("--name", arguments.name, "Name (else the file's)");
  verb.add_option("--block", arguments.block, "The block that is carried, if you know it")->check(CLI::Range(0, 5));
  verb.add_option("--goal", arguments.goal, "The peg that it goes to, if you know it")->check(CLI::Range(0, 5));
}

/// What the import found and what it has to do without.
Answer imported_answer(const demonstration::Demonstration& document, const exchange::Imported& imported,
                       exchange::Format format) {
  std::vector<std::string> found = exchange::findings(document, spatial::Grid{});
  found.insert(found.end(), imported.found.begin(), imported.found.end());
  const auto [warnings, errors] = count_problems(document);
  Answer answer;
  answer.json = demonstration_json(document);
  answer.json["format"] = exchange::to_string(format);
  answer.json["lossy"] = imported.lossy;
  answer.json["found"] = found;
  answer.json["notes"] = imported.notes.size();
  answer.json["warnings"] = warnings;
  answer.json["errors"] = errors;
  answer.summary =
      fmt::format("{:.2f} s, {} samples{}", document.duration_s(), document.gated().size(), lossy_text(imported.lossy));
  if (warnings + errors > 0) {
    answer.summary += fmt::format("; {} and {}", counted(errors, "error"), counted(warnings, "warning"));
  }
  for (const std::string& sentence : found) answer.text += fmt::format("\nfound: {}", sentence);
  return answer;
}

Result<exchange::Imported> read_import(const ImportArguments& arguments, exchange::Format format, Console& console) {
  exchange::ImportOptions options;
  options.transcription = arguments.transcription;
  if (!arguments.offset_mm.empty()) {
    options.X_WF.p = 1e-3 * Eigen::Vector3d(arguments.offset_mm[0], arguments.offset_mm[1], arguments.offset_mm[2]);
  }
  TROCAR_ASSIGN_OR_RETURN(exchange::Imported imported, exchange::import_demonstration(arguments.file, format, options));
  imported.recording.provenance.block = arguments.block;
  imported.recording.provenance.goal = arguments.goal;
  imported.recording.provenance.created = iso_time(console.clock->unix_s());
  return imported;
}

Result<Answer> run_import(const ImportArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const exchange::Format format, format_of(arguments.format, arguments.file));
  const auto open = arguments.dry_run ? open_to_read : open_to_edit;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const exchange::Imported imported, read_import(arguments, format, console));
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  const std::string wanted =
      arguments.name.empty() ? std::filesystem::path(arguments.file).stem().string() : arguments.name;
  const std::string name = free_demonstration_name(*file.project(), wanted, console);
  if (arguments.dry_run) {
    const auto recording = std::make_shared<const demonstration::Recording>(imported.recording);
    TROCAR_ASSIGN_OR_RETURN(const auto document, demonstration::make_demonstration({}, name, recording));
    Answer answer = imported_answer(document, imported, format);
    answer.json["imported"] = 0;
    answer.text = fmt::format("{} would be: {}{}", name, answer.summary, answer.text);
    return answer;
  }
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.add_recording(imported.recording, name));
  const demonstration::DemonstrationId added{id};
  for (const demonstration::AddNote& note : imported.notes) {
    TROCAR_RETURN_IF_ERROR(file.commit(workbench::EditDemonstration{added, note}));
  }
  Answer answer = imported_answer(*file.project()->demonstrations.at(added), imported, format);
  answer.json["imported"] = 1;
  if (answer.json["warnings"] != 0 || answer.json["errors"] != 0) answer.summary += ", see `trocar demo check`";
  answer.text = fmt::format("Demonstration {} ({}): {}{}", id, name, answer.summary, answer.text);
  return answer;
}

struct ExportArguments {
  std::string project;
  std::string demonstration;
  std::string file;
  std::string format;
};

void bind_export(CLI::App& verb, ExportArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_option("FILE", arguments.file, "What to write")->required();
  verb.add_option("--format", arguments.format, "csv or npy (else guessed from the file's name)");
}

Result<Answer> run_export(const ExportArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.file, arguments.project));
  TROCAR_ASSIGN_OR_RETURN(const exchange::Format format, format_of(arguments.format, arguments.file));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto document, find_demonstration(*file.project(), arguments.demonstration));
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_ASSIGN_OR_RETURN(const std::vector<std::string> lossy,
                          exchange::export_demonstration(*document, arguments.file, format));
  std::error_code ignored;
  Answer answer;
  answer.json = {{"out", arguments.file},
                 {"format", exchange::to_string(format)},
                 {"samples", document->gated().size()},
                 {"size_bytes", std::filesystem::file_size(arguments.file, ignored)},
                 {"lossy", lossy}};
  answer.summary = fmt::format("{} samples as {}", document->gated().size(), exchange::to_string(format));
  answer.text = fmt::format("Wrote {}: {} samples{}", arguments.file, document->gated().size(), lossy_text(lossy));
  return answer;
}

}  // namespace

void add_demo_exchange_commands(CLI::App& noun, Action& chosen) {
  add_verb<ImportArguments>(noun, chosen, "import", "Add a demonstration from a file of another program", bind_import,
                            run_import);
  add_verb<ExportArguments>(noun, chosen, "export", "Write a demonstration for other programs", bind_export,
                            run_export);
}

}  // namespace trocar::app
