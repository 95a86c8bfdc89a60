#include "engine/exchange/csv.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

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

}  // namespace

std::string to_csv(const demonstration::Demonstration& document) {
  std::string text;
  for (const Column& column : columns()) {
    if (!text.empty()) text += ',';
    text += column.name;
  }
  text += '\n';
  for (const demonstration::Sample& sample : table_samples(document)) {
    for (const Column& column : columns()) {
      fmt::format_to(std::back_inserter(text), "{},", column.read(sample));
    }
    text.back() = '\n';
  }
  return text;
}

Result<Imported> from_csv(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (text.empty()) return fail(ErrorCode::kCorrupt, "the file is empty");
  const Result<std::vector<const Column*>> order = columns_named(split(take_line(text)));
  if (!order) return wrong_line(1, order.error().text());
  RowReader reader(*order);
  std::vector<double> values(order->size());
  for (std::size_t line_number = 2; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    Status read = parse_row(line, *order, values);
    if (read) read = reader.add(values);
    if (!read) return wrong_line(line_number, read.error().text());
  }
  return reader.finish();
}

}  // namespace trocar::exchange
