#include <fmt/format.h>

#include <algorithm>

#include "app/commands/demo_commands.h"
#include "engine/core/file.h"
#include "engine/exchange/exchange.h"
#include "engine/exchange/map_presets.h"
#include "engine/workbench/importing.h"
#include "engine/workbench/saved_filters.h"

namespace trocar::app {
namespace {

/// Errors: kInvalidArgument for a file whose ending names nothing that we write.
Result<exchange::Format> written_format(const std::string& name, const std::string& path) {
  if (!name.empty()) return exchange::format_from(name);
  const Result<exchange::Format> guessed = exchange::guess_format(path);
  if (guessed && *guessed != exchange::Format::kJigsaws) return guessed;
  return tl::unexpected(
      Error(ErrorCode::kInvalidArgument,
            "the ending names no format that can be written; end the file in .csv, .npy or .hdf5, or give --format")
          .at(path));
}

std::string lossy_text(const std::vector<std::string>& lossy) {
  std::string text;
  for (const std::string& part : lossy) text += (text.empty() ? "; without " : ", ") + part;
  return text;
}

/// In place of a map: the one that we would propose.
constexpr std::string_view kProposed = "proposed";

struct ImportArguments {
  std::string project;
  std::string file;
  std::string format;
  std::string name;
  std::string transcription;
  std::vector<double> offset_mm;
  std::vector<std::string> only;
  std::string map;
  std::string save_map;
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
                  "Which column of a foreign csv or npy table is what: a JSON file, a name that one is kept under, the "
                  "JSON itself, or `proposed` for the one that --dry-run shows");
  verb.add_option("--save-map", arguments.save_map,
                  "Keep the map that is used, or proposed: F.json writes a file, any other name keeps it under that");
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
Answer imported_answer(const demonstration::Demonstration& document, const workbench::ImportPart& part) {
  Answer answer;
  answer.json = demonstration_json(document);
  answer.json["lossy"] = part.lossy;
  answer.json["found"] = part.found;
  answer.json["changed"] = part.changed;
  answer.json["notes"] = part.notes.size();
  answer.json["warnings"] = part.warnings;
  answer.json["errors"] = part.errors;
  answer.summary =
      fmt::format("{:.2f} s, {} samples{}", document.duration_s(), document.gated().size(), lossy_text(part.lossy));
  if (part.warnings + part.errors > 0) {
    answer.summary += fmt::format("; {} and {}", counted(part.errors, "error"), counted(part.warnings, "warning"));
  }
  for (const std::string& sentence : part.found) answer.text += fmt::format("\nfound: {}", sentence);
  for (const std::string& sentence : part.changed) answer.text += fmt::format("\nchanged: {}", sentence);
  return answer;
}

/// A map in a file of its own, one that was kept under a name, or the map itself.
Result<exchange::ColumnMap> map_from(const std::string& file_or_name) {
  if (file_or_name.starts_with('{')) return exchange::column_map_from_json(file_or_name);
  std::error_code error;
  const std::filesystem::path folder = exchange::map_preset_folder();
  const std::vector<std::string> presets = exchange::map_presets(folder);
  const bool kept = std::find(presets.begin(), presets.end(), file_or_name) != presets.end();
  if (kept && !std::filesystem::exists(file_or_name, error)) return exchange::load_map_preset(folder, file_or_name);
  TROCAR_ASSIGN_OR_RETURN(const std::string json, read_file(file_or_name, std::size_t{1} << 20));
  Result<exchange::ColumnMap> map = exchange::column_map_from_json(json);
  if (!map) return tl::unexpected(std::move(map).error().at(file_or_name));
  return map;
}

Result<workbench::ImportSettings> settings_of(const ImportArguments& arguments) {
  workbench::ImportSettings settings;
  settings.path = arguments.file;
  if (!arguments.format.empty()) {
    TROCAR_ASSIGN_OR_RETURN(settings.format, exchange::format_from(arguments.format));
  }
  settings.transcription = arguments.transcription;
  const bool proposed = arguments.map == kProposed;
  if (!arguments.map.empty() && !proposed) {
    TROCAR_ASSIGN_OR_RETURN(settings.map, map_from(arguments.map));
  }
  settings.propose = arguments.dry_run || proposed;
  settings.only = arguments.only;
  settings.rate_hz = arguments.rate_hz;
  for (std::size_t i = 0; i < arguments.offset_mm.size(); ++i) settings.p_WF_m[i] = 1e-3 * arguments.offset_mm[i];
  settings.name = arguments.name;
  settings.block = arguments.block;
  settings.goal = arguments.goal;
  return settings;
}

/// Into a file if the name is one's, else among the maps that are kept by name.
Status keep_map(const std::string& name, const exchange::ColumnMap& map, const ImportArguments& arguments) {
  if (std::filesystem::path(name).extension() != ".json") {
    return exchange::save_map_preset(exchange::map_preset_folder(), name, map);
  }
  TROCAR_RETURN_IF_ERROR(check_output(name, arguments.project, {".json"}));
  return write_file(name, exchange::to_json(map) + "\n");
}

/// In place of what a reader says of columns that it does not know.
Error with_hint(const Error& error, const workbench::ImportSettings& settings, exchange::Format format) {
  const auto guess = exchange::guess_columns(settings.path, format);
  if (settings.map || settings.propose || !guess || !*guess) return error;
  return Error(ErrorCode::kCorrupt,
               "the columns are not those of Trocar; --dry-run proposes a map of them, --map proposed takes it, and "
               "--map F.json another")
      .at(settings.path.string());
}

Result<std::vector<workbench::ImportPart>> read_parts(const workbench::ImportSettings& settings,
                                                      const workbench::ImportLayout& layout, Console& console) {
  Progress progress;
  auto parts = workbench::parts_of(settings, layout, iso_time(console.clock->unix_s()), progress);
  if (!parts) return tl::unexpected(with_hint(parts.error(), settings, layout.format));
  return parts;
}

/// So that nobody looks for a demonstration under a name that another has.
void name_parts(std::vector<workbench::ImportPart>& parts, const workbench::Project& project, Console& console) {
  std::vector<std::string> wanted;
  for (const workbench::ImportPart& part : parts) wanted.push_back(part.name);
  workbench::give_free_names(parts, project);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].name == wanted[i]) continue;
    console.diagnostics.warn(
        fmt::format("a demonstration is named {} already; this one is named {}", wanted[i], parts[i].name));
  }
}

Result<std::vector<Answer>> add_import(workbench::ProjectFile& file, const workbench::ImportSettings& settings,
                                       const std::vector<workbench::ImportPart>& parts) {
  TROCAR_ASSIGN_OR_RETURN(const auto ids, workbench::add_parts(file, settings.path, parts));
  std::vector<Answer> answers;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Answer answer = imported_answer(*file.project()->demonstrations.at(ids[i]), parts[i]);
    if (parts[i].warnings + parts[i].errors > 0) answer.summary += ", see `trocar demo check`";
    answer.text = fmt::format("Demonstration {} ({}): {}{}", ids[i].value, parts[i].name, answer.summary, answer.text);
    answers.push_back(std::move(answer));
  }
  return answers;
}

std::vector<Answer> show_import(const std::vector<workbench::ImportPart>& parts) {
  std::vector<Answer> answers;
  for (const workbench::ImportPart& part : parts) {
    demonstration::Demonstration named = *part.document;
    named.name = part.name;
    Answer answer = imported_answer(named, part);
    answer.text = fmt::format("{} would be: {}{}", part.name, answer.summary, answer.text);
    answers.push_back(std::move(answer));
  }
  return answers;
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
  std::string text =
      fmt::format("A map, to be looked through; --map proposed takes it, --save-map F.json keeps it:\n{}\n", map);
  for (const std::string& doubt : guess.doubts) text += fmt::format("not certain: {}\n", doubt);
  answer.text = text + answer.text;
}

Result<Answer> run_import(const ImportArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ImportSettings settings, settings_of(arguments));
  const auto open = arguments.dry_run ? open_to_read : open_to_edit;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ImportLayout layout, workbench::layout_of(settings));
  if (!arguments.save_map.empty()) {
    // Before anything is in the project, so that a name that is none leaves it as it is.
    if (!layout.columns) {
      return fail(ErrorCode::kInvalidArgument,
                  "there is no map to keep with --save-map: the columns are known; or give --map proposed");
    }
    TROCAR_RETURN_IF_ERROR(keep_map(arguments.save_map, layout.columns->map, arguments));
  }
  TROCAR_ASSIGN_OR_RETURN(std::vector<workbench::ImportPart> parts, read_parts(settings, layout, console));
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  name_parts(parts, *file.project(), console);
  std::vector<Answer> answers;
  if (arguments.dry_run) {
    answers = show_import(parts);
  } else {
    TROCAR_ASSIGN_OR_RETURN(answers, add_import(file, settings, parts));
  }
  Answer answer = united(std::move(answers), layout.format, arguments.dry_run);
  if (layout.proposed && arguments.dry_run) show_map(*layout.columns, answer);
  if (layout.proposed && !arguments.dry_run) answer.json["map"] = Json::parse(exchange::to_json(layout.columns->map));
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
  TROCAR_ASSIGN_OR_RETURN(const exchange::Format format, written_format(arguments.format, out));
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
