#include "engine/exchange/exchange.h"

#include <fmt/format.h>

#include "engine/core/file.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/csv.h"
#include "engine/exchange/jigsaws.h"
#include "engine/exchange/npy.h"

namespace trocar::exchange {

std::string_view to_string(Format format) {
  switch (format) {
    case Format::kCsv:
      return "csv";
    case Format::kNpy:
      return "npy";
    case Format::kJigsaws:
      return "jigsaws";
  }
  return "";
}

Result<Format> format_from(std::string_view name) {
  for (const Format format : {Format::kCsv, Format::kNpy, Format::kJigsaws}) {
    if (name == to_string(format)) return format;
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("no format is named {}; there are csv, npy and jigsaws", name));
}

Result<Format> guess_format(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".csv" || ending == ".CSV") return Format::kCsv;
  if (ending == ".npy") return Format::kNpy;
  if (ending == ".txt") return Format::kJigsaws;
  return tl::unexpected(
      Error(ErrorCode::kInvalidArgument, "the ending names no format, give one with --format csv, npy or jigsaws")
          .at(path.string()));
}

Result<std::vector<std::string>> export_demonstration(const demonstration::Demonstration& document,
                                                      const std::filesystem::path& path, Format format) {
  if (format == Format::kJigsaws) {
    return fail(ErrorCode::kUnsupported, "JIGSAWS files can be read, not written");
  }
  TROCAR_RETURN_IF_ERROR(write_file(path, format == Format::kCsv ? to_csv(document) : to_npy(document)));
  return lost_by_export(document);
}

namespace {

Result<Imported> read(const std::filesystem::path& path, Format format, const ImportOptions& options) {
  if (!options.transcription.empty() && format != Format::kJigsaws) {
    return fail(ErrorCode::kInvalidArgument, "only JIGSAWS files have a transcription");
  }
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path));
  if (format == Format::kCsv) return from_csv(bytes);
  if (format == Format::kNpy) return from_npy(bytes);
  std::string transcription;
  if (!options.transcription.empty()) {
    TROCAR_ASSIGN_OR_RETURN(transcription, read_file(options.transcription));
  }
  return from_jigsaws(bytes, transcription);
}

/// Every pose of the sample, from the file's frame to the board's.
void place(demonstration::Sample& sample, const spatial::Pose& X_WF) {
  for (demonstration::ArmSample& arm : sample.arms) {
    arm.set_setpoint(X_WF * arm.setpoint(), arm.setpoint_jaw_rad);
    arm.measured = demonstration::CompactPose::from(X_WF * arm.measured.pose());
  }
  for (demonstration::CompactPose& block : sample.blocks) {
    block = demonstration::CompactPose::from(X_WF * block.pose());
  }
}

}  // namespace

Result<Imported> import_demonstration(const std::filesystem::path& path, Format format, const ImportOptions& options) {
  Result<Imported> imported = read(path, format, options);
  if (!imported) return tl::unexpected(std::move(imported).error().at(path.string()));
  if (!(options.X_WF == spatial::Pose{})) {
    for (demonstration::Sample& sample : imported->recording.samples) place(sample, options.X_WF);
    TROCAR_RETURN_IF_ERROR(demonstration::check_samples(imported->recording.samples));
  }
  imported->recording.provenance.device = path.filename().string();
  return imported;
}

}  // namespace trocar::exchange
