#include "engine/exchange/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#include "engine/core/check.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/row_reader.h"

namespace trocar::exchange {
namespace {

constexpr std::string_view kMagic("\x93NUMPY", 6);
constexpr std::size_t kAlignment = 64;

tl::unexpected<Error> corrupt(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

struct NpyHeader {
  std::string_view dictionary;
  std::string_view data;
};

/// Splits the file at the end of its header (NumPy's format versions 1 to 3).
std::optional<NpyHeader> split_header(std::string_view bytes) {
  if (!bytes.starts_with(kMagic) || bytes.size() < 12) return std::nullopt;
  const auto byte = [&](std::size_t i) { return std::size_t{static_cast<std::uint8_t>(bytes[i])}; };
  const bool wide = byte(6) >= 2;
  if (byte(6) < 1 || byte(6) > 3) return std::nullopt;
  const std::size_t length = wide ? byte(8) | byte(9) << 8 | byte(10) << 16 | byte(11) << 24 : byte(8) | byte(9) << 8;
  const std::size_t begin = wide ? 12 : 10;
  if (length > bytes.size() - begin) return std::nullopt;
  return NpyHeader{bytes.substr(begin, length), bytes.substr(begin + length)};
}

/// What follows `'key':` in the header's dictionary.
std::string_view value_of(std::string_view dictionary, std::string_view key) {
  const std::size_t found = dictionary.find(fmt::format("'{}':", key));
  if (found == std::string_view::npos) return {};
  std::string_view rest = dictionary.substr(found + key.size() + 3);
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  return rest;
}

bool take_count(std::string_view& text, std::size_t& count) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), count);
  if (parsed.ec != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(parsed.ptr - text.data()));
  return true;
}

struct Shape {
  std::size_t rows = 0;
  std::size_t width = 0;
};

std::optional<Shape> parse_shape(std::string_view text) {
  Shape shape;
  if (!text.starts_with('(')) return std::nullopt;
  text.remove_prefix(1);
  if (!take_count(text, shape.rows) || !text.starts_with(',')) return std::nullopt;
  text.remove_prefix(1);
  if (!take_count(text, shape.width) || !(text.starts_with(')') || text.starts_with(",)"))) return std::nullopt;
  return shape;
}

/// Of a demonstration's array.
Result<Shape> read_shape(const NpyHeader& header) {
  if (!value_of(header.dictionary, "descr").starts_with("'<f8'")) {
    return fail(ErrorCode::kUnsupported, "the array must be of little-endian float64 ('<f8')");
  }
  if (!value_of(header.dictionary, "fortran_order").starts_with("False")) {
    return fail(ErrorCode::kUnsupported, "the array must be in C order");
  }
  const std::optional<Shape> shape = parse_shape(value_of(header.dictionary, "shape"));
  if (!shape) return corrupt("the array must have two dimensions, samples and columns");
  if (shape->width != columns().size()) {
    return corrupt(
        fmt::format("the array has {} columns where a demonstration has {}", shape->width, columns().size()));
  }
  return *shape;
}

/// Takes an array in pieces.
class NpyReader {
 public:
  NpyReader() : reader_(all_columns()), values_(columns().size()) {}

  Status add(std::string_view bytes) {
    if (!shape_) {
      head_ += bytes;
      // A header that is not whole yet is longer than any piece.
      const std::optional<NpyHeader> header = split_header(head_);
      if (!header) return head_.size() < kLongestHead ? Status() : not_an_array();
      TROCAR_ASSIGN_OR_RETURN(shape_, read_shape(*header));
      const std::string rest(header->data);
      head_.clear();
      return add(rest);
    }
    count_ += bytes.size();
    const std::size_t row_bytes = values_.size() * sizeof(double);
    if (!rest_.empty()) {
      const std::size_t missing = std::min(row_bytes - rest_.size(), bytes.size());
      rest_ += bytes.substr(0, missing);
      bytes.remove_prefix(missing);
      if (rest_.size() < row_bytes) return {};
      TROCAR_RETURN_IF_ERROR(add_row(rest_));
      rest_.clear();
    }
    for (; bytes.size() >= row_bytes; bytes.remove_prefix(row_bytes)) TROCAR_RETURN_IF_ERROR(add_row(bytes));
    rest_ = std::string(bytes);
    return {};
  }

  Result<Imported> finish() {
    if (!shape_) return not_an_array();
    if (!rest_.empty() || rows_ != shape_->rows) {
      return corrupt(fmt::format("the array's {} rows do not fit its {} bytes", shape_->rows, count_));
    }
    return reader_.finish();
  }

 private:
  static constexpr std::size_t kLongestHead = std::size_t{1} << 20U;

  static std::vector<const Column*> all_columns() {
    std::vector<const Column*> order;
    for (const Column& column : columns()) order.push_back(&column);
    return order;
  }
  static tl::unexpected<Error> not_an_array() { return corrupt("the file is not a NumPy array"); }

  Status add_row(std::string_view bytes) {
    // What follows the last row is counted, and refused in the end.
    if (rows_ == shape_->rows) {
      return corrupt(fmt::format("the array has more than the {} rows that it names", shape_->rows));
    }
    std::memcpy(values_.data(), bytes.data(), values_.size() * sizeof(double));
    ++rows_;
    const Status added = reader_.add(values_);
    if (added) return {};
    return corrupt(fmt::format("row {}: {}", rows_, added.error().text()));
  }

  RowReader reader_;
  std::vector<double> values_;
  std::string head_;  ///< As long as the header is not whole.
  std::optional<Shape> shape_;
  std::string rest_;  ///< Of a row that goes on in the next piece.
  std::size_t rows_ = 0;
  std::size_t count_ = 0;
};

/// "(22, 22, 22, 6)", "(7,)" or "()".
std::optional<std::vector<std::size_t>> parse_lengths(std::string_view text) {
  constexpr std::size_t kMostDimensions = 32;  // NumPy's own limit
  std::vector<std::size_t> lengths;
  if (!text.starts_with('(')) return std::nullopt;
  text.remove_prefix(1);
  while (!text.starts_with(')')) {
    if (lengths.size() == kMostDimensions || !take_count(text, lengths.emplace_back())) return std::nullopt;
    if (text.starts_with(',')) {
      text.remove_prefix(1);
    } else if (!text.starts_with(')')) {
      return std::nullopt;
    }
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return lengths;
}

/// What comes before the numbers of float64 in C order.
std::string head_of(std::string_view shape) {
  std::string dictionary = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape);
  const std::size_t prefix = kMagic.size() + 4;
  while ((prefix + dictionary.size() + 1) % kAlignment != 0) dictionary += ' ';
  dictionary += '\n';
  std::string bytes(kMagic);
  bytes += {'\x01', '\x00', static_cast<char>(dictionary.size() & 0xFF), static_cast<char>(dictionary.size() >> 8)};
  return bytes + dictionary;
}

template <typename Number>
double number_at(std::string_view data, std::size_t i) {
  Number value{};
  std::memcpy(&value, data.data() + i * sizeof value, sizeof value);
  return static_cast<double>(value);
}

}  // namespace

Result<std::vector<std::size_t>> read_npy_shape(std::string_view bytes) {
  const std::optional<NpyHeader> header = split_header(bytes);
  if (!header) return corrupt("the file is not a NumPy array");
  std::optional<std::vector<std::size_t>> shape = parse_lengths(value_of(header->dictionary, "shape"));
  if (!shape) return corrupt("the array has no shape");
  return std::move(*shape);
}

Result<NpyNumbers> read_npy_numbers(std::string_view bytes) {
  NpyNumbers numbers;
  TROCAR_ASSIGN_OR_RETURN(numbers.shape, read_npy_shape(bytes));
  const NpyHeader header = *split_header(bytes);
  const std::string_view type = value_of(header.dictionary, "descr").substr(0, 5);
  const auto read = type == "'<f8'"   ? number_at<double>
                    : type == "'<i8'" ? number_at<std::int64_t>
                    : type == "'<f4'" ? number_at<float>
                    : type == "'<i4'" ? number_at<std::int32_t>
                                      : nullptr;
  if (read == nullptr) {
    return fail(ErrorCode::kUnsupported, "the array must be of little-endian numbers ('<f8', '<f4', '<i8' or '<i4')");
  }
  const std::size_t each = type[3] == '8' ? 8 : 4;
  const std::size_t stored = header.data.size() / each;
  std::size_t count = 1;
  for (const std::size_t length : numbers.shape) {
    // More than the file has is as good as endless, and does not overflow.
    count = length != 0 && count > stored / length ? stored + 1 : count * length;
  }
  if (count != stored || header.data.size() % each != 0) {
    return corrupt(fmt::format("the array's shape does not fit its {} bytes", header.data.size()));
  }
  numbers.values.resize(count);
  if (!value_of(header.dictionary, "fortran_order").starts_with("True")) {
    for (std::size_t i = 0; i < count; ++i) numbers.values[i] = read(header.data, i);
    return numbers;
  }
  std::vector<std::size_t> index(numbers.shape.size(), 0);  // of the i-th number in C order
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t at = 0;
    for (std::size_t axis = index.size(); axis-- > 0;) at = at * numbers.shape[axis] + index[axis];
    numbers.values[i] = read(header.data, at);
    for (std::size_t axis = index.size(); axis-- > 0;) {
      if (++index[axis] < numbers.shape[axis]) break;
      index[axis] = 0;
    }
  }
  return numbers;
}

std::string to_npy(const NpyNumbers& numbers) {
  std::string shape;
  for (const std::size_t length : numbers.shape) shape += fmt::format("{}, ", length);
  std::string bytes = head_of(fmt::format("({})", shape));
  bytes.append(reinterpret_cast<const char*>(numbers.values.data()), numbers.values.size() * sizeof(double));
  return bytes;
}

Result<NpyArray> read_npy_array(std::string_view bytes) {
  TROCAR_ASSIGN_OR_RETURN(const std::vector<std::size_t> shape, read_npy_shape(bytes));
  if (shape.size() != 2 || shape[0] == 0 || shape[1] == 0) {
    return corrupt("the array must have two dimensions, samples and columns");
  }
  TROCAR_ASSIGN_OR_RETURN(NpyNumbers numbers, read_npy_numbers(bytes));
  return NpyArray{shape[1], std::move(numbers.values)};
}

std::string npy_head(std::size_t rows) {
  return head_of(fmt::format("({}, {})", rows, columns().size()));
}

void add_npy_row(const demonstration::Sample& sample, std::string& bytes) {
  for (const Column& column : columns()) {
    const double value = column.read(sample);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

std::string to_npy(const demonstration::Demonstration& document) {
  std::string bytes = npy_head(document.gated().size());
  const Status all = visit_table_samples(document, [&bytes](const demonstration::Sample& sample) {
    add_npy_row(sample, bytes);
    return Status();
  });
  TROCAR_CHECK(all.has_value());
  return bytes;
}

Result<Imported> from_npy(std::string_view bytes) {
  NpyReader reader;
  TROCAR_RETURN_IF_ERROR(reader.add(bytes));
  return reader.finish();
}

Result<Imported> read_npy(const std::filesystem::path& path) {
  return read_file_in_pieces<NpyReader>(path);
}

Result<bool> is_demonstration_npy(std::string_view beginning) {
  const std::optional<NpyHeader> header = split_header(beginning);
  if (!header) return corrupt("the file is not a NumPy array");
  const std::optional<Shape> shape = parse_shape(value_of(header->dictionary, "shape"));
  if (!shape) return corrupt("the array must have two dimensions, samples and columns");
  return shape->width == columns().size();
}

}  // namespace trocar::exchange
