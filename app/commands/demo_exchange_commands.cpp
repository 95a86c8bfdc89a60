#include <fmt/format.h>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/problems.h"
#include "engine/exchange/exchange.h"

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
  int block = demonstration::kUnknownPlace;
  int goal = demonstration::kUnknownPlace;
};

void bind_import(CLI::App& verb, ImportArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("FILE", arguments.file, "What to read")->required();
  verb.add_option("--format", arguments.format, "csv or npy (else guessed from the file's name)");
  verb.add_option("--name", arguments.name, "Name (else the file's)");
  verb.add_option("--block", arguments.block, "The block that is carried, if you know it")->check(CLI::Range(0, 5));
  verb.add_option("--goal", arguments.goal, "The peg that it goes to, if you know it")->check(CLI::Range(0, 5));
}

Result<Answer> run_import(const ImportArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const exchange::Format format, format_of(arguments.format, arguments.file));
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(exchange::Imported imported, exchange::import_demonstration(arguments.file, format));
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  imported.recording.provenance.block = arguments.block;
  imported.recording.provenance.goal = arguments.goal;
  imported.recording.provenance.created = iso_time(console.clock->unix_s());
  const std::string wanted =
      arguments.name.empty() ? std::filesystem::path(arguments.file).stem().string() : arguments.name;
  const std::string name = free_demonstration_name(*file.project(), wanted, console);
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.add_recording(imported.recording, name));
  const auto& document = *file.project()->demonstrations.at(demonstration::DemonstrationId{id});
  const auto [warnings, errors] = count_problems(document);
  Answer answer;
  answer.json = demonstration_json(document);
  answer.json["imported"] = 1;
  answer.json["format"] = exchange::to_string(format);
  answer.json["lossy"] = imported.lossy;
  answer.summary =
      fmt::format("{:.2f} s, {} samples{}", document.duration_s(), document.gated().size(), lossy_text(imported.lossy));
  answer.json["warnings"] = warnings;
  answer.json["errors"] = errors;
  if (warnings + errors > 0) {
    answer.summary +=
        fmt::format("; {} and {}, see `trocar demo check`", counted(errors, "error"), counted(warnings, "warning"));
  }
  answer.text = fmt::format("Demonstration {} ({}): {}", id, name, answer.summary);
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
