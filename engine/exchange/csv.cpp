#include "engine/exchange/csv.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "engine/core/check.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/row_reader.h"
#include "engine/exchange/text_lines.h"

namespace trocar::exchange {
namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.emplace_back(bare_cell(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> parse_number(std::string_view field) {
  double value = 0.0;
  const char* end = field.data() + field.size();
  const auto parsed = std::from_chars(field.data(), end, value);
  if (field.empty() || parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

Status parse_row(std::string_view line, const std::vector<const Column*>& order, std::vector<double>& values) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t comma = line.find(',');
    const bool last = comma == std::string_view::npos;
    if (last != (i + 1 == order.size())) {
      return fail(ErrorCode::kCorrupt, fmt::format("it must have {} values, as many as the first line", order.size()));
    }
    const std::string_view field = bare_cell(line.substr(0, comma));
    const std::optional<double> value = parse_number(field);
    if (!value) {
      return fail(ErrorCode::kCorrupt,
                  fmt::format("{} must be a number, not \"{}\"", order[i]->name, field.substr(0, 40)));
    }
    values[i] = *value;
    if (!last) line.remove_prefix(comma + 1);
  }
  return {};
}

/// Takes a text in pieces.
class CsvReader {
 public:
  Status add(std::string_view piece) {
    if (rest_.empty()) return take(piece);
    // A line that began in the piece before.
    const std::size_t end = piece.find('\n');
    rest_ += piece.substr(0, end == std::string_view::npos ? end : end + 1);
    if (end == std::string_view::npos) return {};
    const std::string line = std::move(rest_);
    rest_.clear();
    TROCAR_RETURN_IF_ERROR(take(line));
    return take(piece.substr(end + 1));
  }

  Result<Imported> finish() {
    if (!rest_.empty()) {
      std::string_view last = rest_;
      TROCAR_RETURN_IF_ERROR(add_line(take_line(last)));
    }
    if (!reader_) return fail(ErrorCode::kCorrupt, "the file is empty");
    return reader_->finish();
  }

 private:
  /// Whole lines; what is left waits for its end.
  Status take(std::string_view text) {
    while (text.find('\n') != std::string_view::npos) TROCAR_RETURN_IF_ERROR(add_line(take_line(text)));
    rest_ = std::string(text);
    return {};
  }

  Status add_line(std::string_view line) {
    ++number_;
    if (!reader_) return begin(line);
    if (line.empty()) return {};
    Status read = parse_row(line, order_, values_);
    if (read) read = reader_->add(values_);
    return read ? Status() : Status(wrong_line(number_, read.error().text()));
  }

  Status begin(std::string_view line) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
    Result<std::vector<const Column*>> order = columns_named(split(line));
    if (!order) return wrong_line(1, order.error().text());
    order_ = *order;
    values_.resize(order_.size());
    reader_.emplace(std::move(*order));
    return {};
  }

  std::vector<const Column*> order_;
  std::vector<double> values_;
  std::optional<RowReader> reader_;  ///< From the second line on.
  std::string rest_;                 ///< Of a line that goes on in the next piece.
  std::size_t number_ = 0;
};

}  // namespace

std::string csv_head() {
  std::string text;
  for (const Column& column : columns()) {
    if (!text.empty()) text += ',';
    text += column.name;
  }
  return text + '\n';
}

void add_csv_row(const demonstration::Sample& sample, std::string& text) {
  for (const Column& column : columns()) {
    fmt::format_to(std::back_inserter(text), "{},", column.read(sample));
  }
  text.back() = '\n';
}

std::string to_csv(const demonstration::Demonstration& document) {
  std::string text = csv_head();
  const Status all = visit_table_samples(document, [&text](const demonstration::Sample& sample) {
    add_csv_row(sample, text);
    return Status();
  });
  TROCAR_CHECK(all.has_value());
  return text;
}

Result<Imported> from_csv(std::string_view text) {
  CsvReader reader;
  TROCAR_RETURN_IF_ERROR(reader.add(text));
  return reader.finish();
}

Result<Imported> read_csv(const std::filesystem::path& path) {
  return read_file_in_pieces<CsvReader>(path);
}

}  // namespace trocar::exchange
