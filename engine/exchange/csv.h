/// A demonstration as comma-separated values: a header row with the names of `columns()`, then a row for each sample.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/imported.h"

namespace trocar::exchange {

/// Numbers are written so that they read back to the same bits.
std::string to_csv(const demonstration::Demonstration& document);
/// Its first line, and one of the others.
std::string csv_head();
void add_csv_row(const demonstration::Sample& sample, std::string& text);

/// Columns may come in any order; those that are not required may be left out. Lines end with LF or CRLF.
/// Errors: kCorrupt naming the line at fault and what is wrong with it.
Result<Imported> from_csv(std::string_view text);
/// The same from a file, which is not held in memory; also kIo.
Result<Imported> read_csv(const std::filesystem::path& path);

}  // namespace trocar::exchange
