#include "engine/exchange/exchange.h"

#include <fmt/format.h>

#include "engine/core/file.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/csv.h"
#include "engine/exchange/npy.h"

namespace trocar::exchange {

std::string_view to_string(Format format) {
  return format == Format::kCsv ? "csv" : "npy";
}

Result<Format> format_from(std::string_view name) {
  for (const Format format : {Format::kCsv, Format::kNpy}) {
    if (name == to_string(format)) return format;
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("no format is named {}; there are csv and npy", name));
}

Result<Format> guess_format(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".csv" || ending == ".CSV") return Format::kCsv;
  if (ending == ".npy") return Format::kNpy;
  return tl::unexpected(
      Error(ErrorCode::kInvalidArgument, "the ending names no format, give one with --format csv or --format npy")
          .at(path.string()));
}

Result<std::vector<std::string>> export_demonstration(const demonstration::Demonstration& document,
                                                      const std::filesystem::path& path, Format format) {
  TROCAR_RETURN_IF_ERROR(write_file(path, format == Format::kCsv ? to_csv(document) : to_npy(document)));
  return lost_by_export(document);
}

Result<Imported> import_demonstration(const std::filesystem::path& path, Format format) {
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path));
  Result<Imported> imported = format == Format::kCsv ? from_csv(bytes) : from_npy(bytes);
  if (!imported) return tl::unexpected(std::move(imported).error().at(path.string()));
  imported->recording.provenance.device = path.filename().string();
  return imported;
}

}  // namespace trocar::exchange
