#include "engine/exchange/tree_node.h"

#include <bit>
#include <cstring>
#include <limits>

namespace trocar::exchange {
namespace {

static_assert(std::endian::native == std::endian::little);

using Kind = TreeNode::Kind;

class Writer {
 public:
  template <typename Number>
  void number(Number value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(std::string_view value) {
    number(std::uint64_t{value.size()});
    bytes += value;
  }
  void texts(const std::vector<std::string>& values) {
    number(std::uint64_t{values.size()});
    for (const std::string& value : values) text(value);
  }
  template <typename Number>
  void numbers(const std::vector<Number>& values) {
    number(std::uint64_t{values.size()});
    for (const Number value : values) number(value);
  }

  void write(double value) { number(value); }
  void write(std::int64_t value) { number(value); }
  void write(const std::string& value) { text(value); }
  void write(const std::vector<double>& values) { numbers(values); }
  void write(const std::vector<std::string>& values) { texts(values); }

  std::string bytes;
};

/// Takes from the front; once something is missing, `good` is false and what is taken is empty.
class Reader {
 public:
  explicit Reader(std::string_view from) : bytes(from) {}

  template <typename Number>
  Number number() {
    Number value{};
    if (bytes.size() < sizeof value) {
      good = false;
      return value;
    }
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return value;
  }
  /// How many of at least `each` bytes follow.
  std::size_t count(std::size_t each) {
    const auto value = number<std::uint64_t>();
    if (value > bytes.size() / each) good = false;
    return good ? static_cast<std::size_t>(value) : 0;
  }
  std::string text() {
    const std::size_t size = count(1);
    std::string value(bytes.substr(0, size));
    bytes.remove_prefix(size);
    return value;
  }
  std::vector<std::string> texts() {
    std::vector<std::string> values(count(sizeof(std::uint64_t)));
    for (std::string& value : values) value = text();
    return values;
  }
  template <typename Number>
  std::vector<Number> numbers() {
    std::vector<Number> values(count(sizeof(Number)));
    for (Number& value : values) value = number<Number>();
    return values;
  }
  Attribute attribute() {
    switch (number<std::uint8_t>()) {
      case 0:
        return number<double>();
      case 1:
        return number<std::int64_t>();
      case 2:
        return text();
      case 3:
        return numbers<double>();
      case 4:
        return texts();
      default:
        good = false;
        return 0.0;
    }
  }

  std::string_view bytes;
  bool good = true;
};

bool fits(const TreeNode& node) {
  if (node.kind > Kind::kFailure) return false;
  if (node.kind == Kind::kTexts) return node.count() == node.texts.size();
  if (!node.holds_numbers()) return node.data.empty();
  return node.data.size() % bytes_of(node.kind) == 0 && node.count() == node.data.size() / bytes_of(node.kind);
}

template <typename Number>
double number_at(const std::string& data, std::size_t i) {
  Number value{};
  std::memcpy(&value, data.data() + i * sizeof value, sizeof value);
  return static_cast<double>(value);
}

template <typename Number>
void append_as(std::string& data, double value) {
  const auto stored = static_cast<Number>(value);
  data.append(reinterpret_cast<const char*>(&stored), sizeof stored);
}

}  // namespace

std::uint64_t TreeNode::count() const {
  std::uint64_t product = 1;
  for (const std::uint64_t length : shape) {
    if (length != 0 && product > std::numeric_limits<std::uint64_t>::max() / length) {
      return std::numeric_limits<std::uint64_t>::max();
    }
    product *= length;
  }
  return product;
}

double TreeNode::number(std::size_t i) const {
  switch (kind) {
    case Kind::kFloat64:
      return number_at<double>(data, i);
    case Kind::kFloat32:
      return number_at<float>(data, i);
    case Kind::kInt64:
      return number_at<std::int64_t>(data, i);
    default:
      return number_at<std::uint8_t>(data, i);
  }
}

std::vector<double> TreeNode::numbers() const {
  std::vector<double> values(static_cast<std::size_t>(count()));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = number(i);
  return values;
}

std::size_t bytes_of(Kind kind) {
  switch (kind) {
    case Kind::kFloat64:
    case Kind::kInt64:
      return 8;
    case Kind::kFloat32:
      return 4;
    case Kind::kUint8:
      return 1;
    default:
      return 0;
  }
}

TreeNode array_node(std::string path, Kind kind, std::vector<std::uint64_t> shape, const std::vector<double>& numbers) {
  TreeNode node;
  node.path = std::move(path);
  node.kind = kind;
  node.shape = std::move(shape);
  node.data.reserve(numbers.size() * bytes_of(kind));
  for (const double value : numbers) {
    if (kind == Kind::kFloat64) append_as<double>(node.data, value);
    if (kind == Kind::kFloat32) append_as<float>(node.data, value);
    if (kind == Kind::kInt64) append_as<std::int64_t>(node.data, value);
    if (kind == Kind::kUint8) append_as<std::uint8_t>(node.data, value);
  }
  return node;
}

TreeNode texts_node(std::string path, std::vector<std::string> texts) {
  TreeNode node;
  node.path = std::move(path);
  node.kind = Kind::kTexts;
  node.shape = {texts.size()};
  node.texts = std::move(texts);
  return node;
}

std::string encode(const TreeNode& node) {
  Writer writer;
  writer.text(node.path);
  writer.number(static_cast<std::uint8_t>(node.kind));
  writer.numbers(node.shape);
  writer.text(node.data);
  writer.texts(node.texts);
  writer.number(std::uint64_t{node.attributes.size()});
  for (const auto& [name, value] : node.attributes) {
    writer.text(name);
    writer.number(static_cast<std::uint8_t>(value.index()));
    std::visit([&writer](const auto& held) { writer.write(held); }, value);
  }
  writer.text(node.why);
  return std::move(writer.bytes);
}

std::optional<TreeNode> decode(std::string_view bytes) {
  Reader reader(bytes);
  TreeNode node;
  node.path = reader.text();
  node.kind = static_cast<Kind>(reader.number<std::uint8_t>());
  node.shape = reader.numbers<std::uint64_t>();
  node.data = reader.text();
  node.texts = reader.texts();
  const std::size_t attributes = reader.count(sizeof(std::uint64_t) + 1);
  for (std::size_t i = 0; i < attributes && reader.good; ++i) {
    std::string name = reader.text();
    node.attributes[std::move(name)] = reader.attribute();
  }
  node.why = reader.text();
  if (!reader.good || !reader.bytes.empty() || !fits(node)) return std::nullopt;
  return node;
}

}  // namespace trocar::exchange
