#include "engine/exchange/exchange.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "engine/core/file.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/csv.h"
#include "engine/exchange/jigsaws.h"
#include "engine/exchange/mapped_table.h"
#include "engine/exchange/new_file.h"
#include "engine/exchange/npy.h"
#include "engine/exchange/row_reader.h"
#include "engine/exchange/text_lines.h"

namespace trocar::exchange {

std::string_view to_string(Format format) {
  switch (format) {
    case Format::kCsv:
      return "csv";
    case Format::kNpy:
      return "npy";
    case Format::kHdf5:
      return "hdf5";
    case Format::kJigsaws:
      return "jigsaws";
  }
  return "";
}

Result<Format> format_from(std::string_view name) {
  for (const Format format : {Format::kCsv, Format::kNpy, Format::kHdf5, Format::kJigsaws}) {
    if (name == to_string(format)) return format;
  }
  if (name == "robomimic") return Format::kHdf5;
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("no format is named {}; there are csv, npy, hdf5 and jigsaws", name));
}

Result<Format> guess_format(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  if (ending == ".csv" || ending == ".tsv") return Format::kCsv;
  if (ending == ".npy") return Format::kNpy;
  if (ending == ".hdf5" || ending == ".h5") return Format::kHdf5;
  if (ending == ".txt") return Format::kJigsaws;
  return tl::unexpected(
      Error(ErrorCode::kInvalidArgument, "the ending names no format, give one with --format csv, npy, hdf5 or jigsaws")
          .at(path.string()));
}

namespace {

Result<std::vector<Imported>> alone(Result<Imported> one) {
  if (!one) return tl::unexpected(std::move(one).error());
  std::vector<Imported> all;
  all.push_back(std::move(*one));
  return all;
}

Result<Imported> read_mapped(std::string_view bytes, Format format, const ColumnMap& map) {
  TROCAR_ASSIGN_OR_RETURN(const NumberTable table, format == Format::kNpy
                                                       ? NumberTable::of_npy(bytes)
                                                       : NumberTable::of_text(bytes, TextLayout::of(map)));
  return from_table(table, map);
}

/// As much as tells what a file is.
Result<std::string> read_beginning(const std::filesystem::path& path) {
  std::string beginning;
  bool read = false;
  const Status done = read_pieces(path, std::size_t{1} << 16U, [&](std::string_view piece) -> Status {
    beginning = std::string(piece);
    read = true;
    return fail(ErrorCode::kCancelled, "that is enough");
  });
  if (!done && !read) return tl::unexpected(done.error());
  return beginning;
}

/// Whether a file that begins so can be read without a map.
Result<bool> is_known(std::string_view bytes, Format format) {
  if (format == Format::kHdf5) return true;
  if (format == Format::kNpy) return is_demonstration_npy(bytes);
  constexpr std::size_t kJigsawsColumns = 76;
  const std::string_view first = take_line(bytes);
  if (format == Format::kJigsaws) return cells_of(first, ' ').size() == kJigsawsColumns;
  return first.find("left_setpoint_x_m") != std::string_view::npos;
}

Result<std::vector<Imported>> read(const std::filesystem::path& path, Format format, const ImportOptions& options) {
  if (options.map && format != Format::kCsv && format != Format::kNpy) {
    return fail(ErrorCode::kInvalidArgument, "only tables, csv and npy, take a map of their columns");
  }
  if (!options.transcription.empty() && format != Format::kJigsaws) {
    return fail(ErrorCode::kInvalidArgument, "only JIGSAWS files have a transcription");
  }
  if (!options.robomimic.only.empty() && format != Format::kHdf5) {
    return fail(ErrorCode::kInvalidArgument, "only HDF5 files hold demonstrations to choose from");
  }
  if (format == Format::kHdf5) return read_robomimic(path, options.robomimic);
  if (!options.map && format == Format::kCsv) return alone(read_csv(path));
  if (!options.map && format == Format::kNpy) return alone(read_npy(path));
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path));
  if (options.map) return alone(read_mapped(bytes, format, *options.map));
  std::string transcription;
  if (!options.transcription.empty()) {
    TROCAR_ASSIGN_OR_RETURN(transcription, read_file(options.transcription));
  }
  return alone(from_jigsaws(bytes, transcription));
}

/// Both tools, from the file's frame to the board's.
void place(demonstration::Sample& sample, const spatial::Pose& X_WF) {
  for (demonstration::ArmSample& arm : sample.arms) {
    arm.set_setpoint(X_WF * arm.setpoint(), arm.setpoint_jaw_rad);
    arm.measured = demonstration::CompactPose::from(X_WF * arm.measured.pose());
  }
}

void place_blocks(demonstration::Sample& sample, const spatial::Pose& X_WF) {
  for (demonstration::CompactPose& block : sample.blocks) {
    block = demonstration::CompactPose::from(X_WF * block.pose());
  }
}

Status place_all(Imported& imported, const spatial::Pose& X_WF) {
  if (X_WF == spatial::Pose{}) return {};
  demonstration::Recording& recording = imported.recording;
  const bool blocks = recorded_channels(recording.samples).blocks;
  for (demonstration::Sample& sample : recording.samples) {
    place(sample, X_WF);
    if (blocks) place_blocks(sample, X_WF);
  }
  if (!recording.initial_world.empty()) {
    recording.initial_world.clear();
    recording.hashes.clear();
    imported.lossy.emplace_back("a simulated world (what was moved cannot be replayed)");
  }
  return demonstration::check_samples(recording.samples);
}

/// "12,000 samples, …"; an error for what does not come back as it was.
Result<std::string> compare(const Documents& documents, const std::vector<Imported>& read) {
  const auto differ = [](std::string_view what) {
    return fail(ErrorCode::kIo, fmt::format("what was written reads back with other {}; nothing is kept of it", what));
  };
  if (read.size() != documents.size()) return differ("demonstrations");
  std::size_t count = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::vector<demonstration::Sample>& back = read[i].recording.samples;
    if (back.size() != documents[i]->gated().size()) return differ("samples");
    std::size_t at = 0;
    std::int64_t shift = 0;
    const Status same = visit_table_samples(*documents[i], [&](demonstration::Sample expected) -> Status {
      // An import may count time from another tick.
      if (at == 0) shift = back.front().tick - expected.tick;
      expected.tick += shift;
      if (std::memcmp(&expected, &back[at++], sizeof expected) != 0) return differ("numbers");
      return {};
    });
    TROCAR_RETURN_IF_ERROR(same);
    count += back.size();
  }
  return fmt::format("{} {} read again, equal to the bit", count, count == 1 ? "sample" : "samples");
}

/// Row by row, so that a long demonstration is nowhere in memory as a table; what reads it again does so from the file,
/// before that takes its name.
Result<std::string> write_text(const Documents& documents, const std::filesystem::path& path, Format format) {
  const bool csv = format == Format::kCsv;
  const demonstration::Demonstration& document = *documents.front();
  const auto make = [&](const TakeBytes& take) -> Status {
    std::string piece = csv ? csv_head() : npy_head(document.gated().size());
    const auto add = [&](const demonstration::Sample& sample) -> Status {
      csv ? add_csv_row(sample, piece) : add_npy_row(sample, piece);
      if (piece.size() < kPiece_bytes) return {};
      TROCAR_RETURN_IF_ERROR(take(piece));
      piece.clear();
      return {};
    };
    TROCAR_RETURN_IF_ERROR(visit_table_samples(document, add));
    return take(piece);
  };
  std::string compared;
  const auto check = [&](const std::filesystem::path& written) -> Status {
    TROCAR_ASSIGN_OR_RETURN(const std::vector<Imported> back, alone(csv ? read_csv(written) : read_npy(written)));
    TROCAR_ASSIGN_OR_RETURN(compared, compare(documents, back));
    return {};
  };
  TROCAR_RETURN_IF_ERROR(write_file(path, make, check));
  return compared;
}

Result<std::string> write_hdf5(const Documents& documents, const std::filesystem::path& path, const Masks& masks) {
  TROCAR_ASSIGN_OR_RETURN(const std::filesystem::path target, replaceable_file(path));
  NewFile file(target);
  TROCAR_RETURN_IF_ERROR(write_robomimic(documents, masks, file.path()));
  TROCAR_ASSIGN_OR_RETURN(const std::vector<Imported> back, read_robomimic(file.path(), {}));
  TROCAR_ASSIGN_OR_RETURN(std::string compared, compare(documents, back));
  TROCAR_RETURN_IF_ERROR(file.put_in_place());
  return compared;
}

/// Without doubles, in the order in which they come.
void unite(std::vector<std::string>& all, std::vector<std::string> more) {
  for (std::string& one : more) {
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(std::move(one));
  }
}

ExportReport report_of(const Documents& documents, Format format) {
  ExportReport report;
  for (const auto& document : documents) {
    const bool table = format != Format::kHdf5;
    unite(report.lossless, table ? kept_by_export(*document) : kept_by_robomimic(*document));
    unite(report.lossy, table ? lost_by_export(*document) : lost_by_robomimic(*document));
    report.samples += document->gated().size();
  }
  if (const std::string told = format == Format::kHdf5 ? rate_of(documents).lost : ""; !told.empty()) {
    report.lossy.push_back(told);
  }
  return report;
}

Status check_export(const Documents& documents, Format format, const Masks& masks) {
  if (format == Format::kJigsaws) return fail(ErrorCode::kUnsupported, "JIGSAWS files can be read, not written");
  if (documents.empty()) return fail(ErrorCode::kInvalidArgument, "there is no demonstration to write");
  if (format == Format::kHdf5) return {};
  if (documents.size() > 1) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("a {} file holds one demonstration, {} go into hdf5", to_string(format), documents.size()));
  }
  return masks.empty() ? Status() : fail(ErrorCode::kInvalidArgument, "only hdf5 files have filter keys (--mask)");
}

}  // namespace

Result<ExportReport> export_report(const Documents& documents, Format format, const Masks& masks) {
  TROCAR_RETURN_IF_ERROR(check_export(documents, format, masks));
  return report_of(documents, format);
}

Result<ExportReport> export_demonstrations(const Documents& documents, const std::filesystem::path& path, Format format,
                                           const Masks& masks) {
  TROCAR_ASSIGN_OR_RETURN(ExportReport report, export_report(documents, format, masks));
  Result<std::string> compared =
      format == Format::kHdf5 ? write_hdf5(documents, path, masks) : write_text(documents, path, format);
  if (!compared) return tl::unexpected(std::move(compared).error().at(path.string()));
  report.reread = std::move(*compared);
  return report;
}

Result<std::vector<std::string>> export_demonstration(const demonstration::Demonstration& document,
                                                      const std::filesystem::path& path, Format format) {
  const auto shared = std::make_shared<const demonstration::Demonstration>(document);
  TROCAR_ASSIGN_OR_RETURN(ExportReport report, export_demonstrations({shared}, path, format));
  return std::move(report.lossy);
}

Result<std::optional<ColumnGuess>> guess_columns(const std::filesystem::path& path, Format format) {
  const auto refuse = [&path](const Error& error) { return tl::unexpected(Error(error).at(path.string())); };
  const Result<std::string> beginning = read_beginning(path);
  if (!beginning) return refuse(beginning.error());
  const Result<bool> known = is_known(*beginning, format);
  if (!known) return refuse(known.error());
  if (*known) return std::optional<ColumnGuess>();
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return refuse(bytes.error());
  Result<std::optional<ColumnGuess>> guess =
      format == Format::kNpy ? guess_columns_of_npy(*bytes) : guess_columns_of_text(*bytes);
  if (!guess) return refuse(guess.error());
  if (*guess) return guess;
  return refuse(Error(ErrorCode::kUnsupported,
                      "no position of a tool and no joints are recognised in the columns; write a map of them"));
}

Result<std::vector<Imported>> import_demonstrations(const std::filesystem::path& path, Format format,
                                                    const ImportOptions& options) {
  Result<std::vector<Imported>> all = read(path, format, options);
  if (!all) return tl::unexpected(std::move(all).error().at(path.string()));
  for (Imported& imported : *all) {
    TROCAR_RETURN_IF_ERROR(place_all(imported, options.X_WF));
    demonstration::Provenance& provenance = imported.recording.provenance;
    const bool told = !provenance.device.empty() || provenance.operator_kind != "imported";
    if (!told) provenance.device = path.filename().string();
  }
  return all;
}

Result<Imported> import_demonstration(const std::filesystem::path& path, Format format, const ImportOptions& options) {
  TROCAR_ASSIGN_OR_RETURN(std::vector<Imported> all, import_demonstrations(path, format, options));
  return std::move(all.front());
}

}  // namespace trocar::exchange
