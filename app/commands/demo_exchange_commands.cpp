#include <fmt/format.h>

#include <algorithm>

#include "app/commands/demo_commands.h"
#include "engine/core/file.h"
#include "engine/exchange/exchange.h"
#include "engine/exchange/findings.h"
#include "engine/review/review.h"
#include "engine/workbench/saved_filters.h"

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
  const review::Review found = review::Reviewer().make(document);
  return {review::count_of(found.problems, demonstration::Severity::kWarning),
          review::count_of(found.problems, demonstration::Severity::kError)};
}

struct ImportArguments {
  std::string project;
  std::string file;
  std::string format;
  std::string name;
  std::string transcription;
  std::vector<double> offset_mm;
  std::vector<std::string> only;
  std::string map;
  double rate_hz = 0.0;
  bool dry_run = false;
  int block = demonstration::kUnknownPlace;
  int goal = demonstration::kUnknownPlace;
};

void bind_import(CLI::App& verb, ImportArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("FILE", arguments.file, "What to read")->required();
  verb.add_option("--format", arguments.format, "csv, npy, hdf5 or jigsaws (else guessed from the file's name)");
  verb.add_option("--transcription", arguments.transcription, "Gestures, of JIGSAWS; they become notes");
  verb.add_option("--map", arguments.map,
                  "Which column of a foreign csv or npy table is what: JSON; --dry-run proposes one");
  verb.add_option("--offset-mm", arguments.offset_mm, "Where the file's origin is on the board: X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  verb.add_option("--only", arguments.only, "Of HDF5: a demonstration (demo_3) or a filter key; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--rate-hz", arguments.rate_hz, "Samples a second, of a file that does not tell")
      ->check(CLI::Range(0.1, 1000.0));
  verb.add_flag("--dry-run", arguments.dry_run, "Only say what would come of it");
  verb.add_option("--name", arguments.name, "Name (else the file's)");
  verb.add_option("--block", arguments.block, "The block that is carried, if you know it")->check(CLI::Range(0, 5));
  verb.add_option("--goal", arguments.goal, "The peg that it goes to, if you know it")->check(CLI::Range(0, 5));
}

/// What the import found and what it has to do without.
Answer imported_answer(const demonstration::Demonstration& document, const exchange::Imported& imported) {
  std::vector<std::string> found = exchange::findings(document, spatial::Grid{});
  found.insert(found.end(), imported.found.begin(), imported.found.end());
  const auto [warnings, errors] = count_problems(document);
  Answer answer;
  answer.json = demonstration_json(document);
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

/// The map that was given, or on a dry run the one that would be proposed, with what is not certain about it.
Result<std::optional<exchange::ColumnGuess>> map_of(const ImportArguments& arguments, exchange::Format& format) {
  std::optional<exchange::ColumnGuess> guess;
  if (!arguments.map.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const std::string json, read_file(arguments.map, std::size_t{1} << 20));
    Result<exchange::ColumnMap> map = exchange::column_map_from_json(json);
    if (!map) return tl::unexpected(std::move(map).error().at(arguments.map));
    guess = exchange::ColumnGuess{std::move(*map), {}};
  } else if (arguments.dry_run) {
    TROCAR_ASSIGN_OR_RETURN(guess, exchange::guess_columns(arguments.file, format));
  }
  if (!guess) return guess;
  if (format == exchange::Format::kJigsaws && arguments.format.empty()) format = exchange::Format::kCsv;
  if (arguments.rate_hz > 0.0) guess->map.time = {"", "s", arguments.rate_hz};
  return guess;
}

/// In place of what a reader says of columns that it does not know.
Error with_hint(const Error& error, const ImportArguments& arguments, exchange::Format format) {
  const auto guess = exchange::guess_columns(arguments.file, format);
  if (!arguments.map.empty() || !guess || !*guess) return error;
  return Error(ErrorCode::kCorrupt,
               "the columns are not those of Trocar; --dry-run proposes a map of them, --map takes it")
      .at(arguments.file);
}

Result<std::vector<exchange::Imported>> read_import(const ImportArguments& arguments, exchange::Format format,
                                                    const std::optional<exchange::ColumnGuess>& guess,
                                                    Console& console) {
  exchange::ImportOptions options;
  options.transcription = arguments.transcription;
  options.robomimic = {arguments.only, arguments.rate_hz};
  if (!arguments.offset_mm.empty()) {
    options.X_WF.p = 1e-3 * Eigen::Vector3d(arguments.offset_mm[0], arguments.offset_mm[1], arguments.offset_mm[2]);
  }
  if (guess) options.map = guess->map;
  Result<std::vector<exchange::Imported>> read = exchange::import_demonstrations(arguments.file, format, options);
  if (!read) return tl::unexpected(with_hint(read.error(), arguments, format));
  std::vector<exchange::Imported>& all = *read;
  for (exchange::Imported& imported : all) {
    demonstration::Provenance& provenance = imported.recording.provenance;
    if (arguments.block != demonstration::kUnknownPlace) provenance.block = arguments.block;
    if (arguments.goal != demonstration::kUnknownPlace) provenance.goal = arguments.goal;
    if (provenance.created.empty()) provenance.created = iso_time(console.clock->unix_s());
  }
  return read;
}

/// What is asked for, else the file's own name for it, else that of the file.
std::string wanted_name(const ImportArguments& arguments, const exchange::Imported& imported, std::size_t nth) {
  const std::string file = std::filesystem::path(arguments.file).stem().string();
  if (!arguments.name.empty()) return nth == 0 ? arguments.name : fmt::format("{} {}", arguments.name, nth + 1);
  if (imported.name.empty()) return file;
  return imported.recording.provenance.operator_kind == "imported" ? fmt::format("{} {}", file, imported.name)
                                                                   : imported.name;
}

Result<Answer> add_import(workbench::ProjectFile& file, const exchange::Imported& imported, const std::string& name) {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.add_recording(imported.recording, name));
  const demonstration::DemonstrationId added{id};
  for (const demonstration::AddNote& note : imported.notes) {
    TROCAR_RETURN_IF_ERROR(file.commit(workbench::EditDemonstration{added, note}));
  }
  Answer answer = imported_answer(*file.project()->demonstrations.at(added), imported);
  if (answer.json["warnings"] != 0 || answer.json["errors"] != 0) answer.summary += ", see `trocar demo check`";
  answer.text = fmt::format("Demonstration {} ({}): {}{}", id, name, answer.summary, answer.text);
  return answer;
}

Result<Answer> show_import(const exchange::Imported& imported, const std::string& name) {
  const auto recording = std::make_shared<const demonstration::Recording>(imported.recording);
  TROCAR_ASSIGN_OR_RETURN(const auto document, demonstration::make_demonstration({}, name, recording));
  Answer answer = imported_answer(document, imported);
  answer.text = fmt::format("{} would be: {}{}", name, answer.summary, answer.text);
  return answer;
}

/// One alone is the answer; of several it is a list.
Answer united(std::vector<Answer> parts, exchange::Format format, bool dry_run) {
  Answer answer;
  if (parts.size() == 1) {
    answer = std::move(parts.front());
  } else {
    answer.summary = counted(parts.size(), "demonstration");
    answer.json["demonstrations"] = Json::array();
    for (const Answer& part : parts) {
      answer.json["demonstrations"].push_back(part.json);
      answer.text += (answer.text.empty() ? "" : "\n") + part.text;
    }
  }
  answer.json["format"] = exchange::to_string(format);
  answer.json["imported"] = dry_run ? 0 : std::max<std::size_t>(parts.size(), 1);
  return answer;
}

/// Puts the proposed map in front of what would come of it.
void show_map(const exchange::ColumnGuess& guess, Answer& answer) {
  const std::string map = exchange::to_json(guess.map);
  answer.json["map"] = Json::parse(map);
  answer.json["doubts"] = guess.doubts;
  std::string text = fmt::format("A map for --map, to be saved and looked through:\n{}\n", map);
  for (const std::string& doubt : guess.doubts) text += fmt::format("not certain: {}\n", doubt);
  answer.text = text + answer.text;
}

/// A map of columns makes a table of whatever ending.
Result<exchange::Format> import_format(const ImportArguments& arguments) {
  Result<exchange::Format> format = format_of(arguments.format, arguments.file);
  const bool table = !format && arguments.format.empty() && !arguments.map.empty();
  return table ? Result<exchange::Format>(exchange::Format::kCsv) : format;
}

Result<Answer> run_import(const ImportArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(exchange::Format format, import_format(arguments));
  const auto open = arguments.dry_run ? open_to_read : open_to_edit;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const std::optional<exchange::ColumnGuess> guess, map_of(arguments, format));
  TROCAR_ASSIGN_OR_RETURN(const std::vector<exchange::Imported> all, read_import(arguments, format, guess, console));
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  std::vector<Answer> parts;
  for (const exchange::Imported& imported : all) {
    const std::string name =
        free_demonstration_name(*file.project(), wanted_name(arguments, imported, parts.size()), console);
    TROCAR_ASSIGN_OR_RETURN(Answer part,
                            arguments.dry_run ? show_import(imported, name) : add_import(file, imported, name));
    parts.push_back(std::move(part));
    TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  }
  Answer answer = united(std::move(parts), format, arguments.dry_run);
  if (guess && arguments.map.empty()) show_map(*guess, answer);
  return answer;
}

struct ExportArguments {
  std::string project;
  std::vector<std::string> words;  ///< Demonstrations, and last the file.
  std::string format;
  std::vector<std::string> masks;
};

void bind_export(CLI::App& verb, ExportArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO_FILE", arguments.words, "Ids or names of demonstrations (several for HDF5), then what to write")
      ->required()
      ->expected(-2);
  verb.add_option("--format", arguments.format, "csv, npy or hdf5, robomimic's layout (else guessed from the name)");
  verb.add_option("--mask", arguments.masks, "KEY=DEMO: of HDF5, put DEMO under the filter key KEY; may be repeated")
      ->allow_extra_args(false);
}

/// "KEY=DEMO". Errors: kInvalidArgument; those of `find_demonstration`.
Status take_mask(const workbench::Project& project, const std::string& text, const exchange::Documents& documents,
                 exchange::Masks& masks) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("--mask is KEY=DEMO, not \"{}\"", text));
  }
  TROCAR_ASSIGN_OR_RETURN(const auto document, find_demonstration(project, text.substr(equals + 1)));
  const auto place = std::find(documents.begin(), documents.end(), document);
  if (place == documents.end()) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("--mask names {}, which is not exported", document->name));
  }
  masks[text.substr(0, equals)].push_back(static_cast<std::size_t>(place - documents.begin()));
  return {};
}

Answer exported_answer(const ExportArguments& arguments, exchange::Format format, const exchange::Documents& documents,
                       const exchange::ExportReport& report) {
  const std::string& out = arguments.words.back();
  std::error_code ignored;
  Answer answer;
  answer.json = {{"out", out},
                 {"format", exchange::to_string(format)},
                 {"demonstrations", documents.size()},
                 {"samples", report.samples},
                 {"size_bytes", std::filesystem::file_size(out, ignored)},
                 {"lossless", report.lossless},
                 {"lossy", report.lossy},
                 {"reread", report.reread}};
  const std::string what = documents.size() == 1 ? "" : counted(documents.size(), "demonstration") + ", ";
  answer.summary = fmt::format("{}{} samples as {}", what, report.samples, exchange::to_string(format));
  answer.text = fmt::format("Wrote {}: {}{} samples{}", out, what, report.samples, lossy_text(report.lossy));
  for (const std::string& kept : report.lossless) answer.text += fmt::format("\ncomes back: {}", kept);
  answer.text += fmt::format("\nchecked: {}", report.reread);
  return answer;
}

Result<Answer> run_export(const ExportArguments& arguments, Console& console) {
  const std::string& out = arguments.words.back();
  TROCAR_RETURN_IF_ERROR(check_output(out, arguments.project));
  TROCAR_ASSIGN_OR_RETURN(const exchange::Format format, format_of(arguments.format, out));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  exchange::Documents documents;
  for (std::size_t i = 0; i + 1 < arguments.words.size(); ++i) {
    TROCAR_ASSIGN_OR_RETURN(const auto document, find_demonstration(*file.project(), arguments.words[i]));
    if (std::find(documents.begin(), documents.end(), document) != documents.end()) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("{} is named twice", document->name));
    }
    documents.push_back(document);
  }
  exchange::Masks masks;
  if (format == exchange::Format::kHdf5) {
    TROCAR_ASSIGN_OR_RETURN(masks, workbench::filter_keys({file.project(), file.replays()}, documents,
                                                          console.progress(), console.diagnostics));
  }
  for (const std::string& text : arguments.masks) {
    TROCAR_RETURN_IF_ERROR(take_mask(*file.project(), text, documents, masks));
  }
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_ASSIGN_OR_RETURN(const exchange::ExportReport report,
                          exchange::export_demonstrations(documents, out, format, masks));
  return exported_answer(arguments, format, documents, report);
}

}  // namespace

void add_demo_exchange_commands(CLI::App& noun, Action& chosen) {
  add_verb<ImportArguments>(noun, chosen, "import", "Add a demonstration from a file of another program", bind_import,
                            run_import);
  add_verb<ExportArguments>(noun, chosen, "export", "Write demonstrations for other programs", bind_export, run_export);
}

}  // namespace trocar::app
