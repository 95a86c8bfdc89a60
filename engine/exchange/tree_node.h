/// One group or array of an HDF5 file, as a value and as bytes between the program and its HDF5 process.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trocar::exchange {

using Attribute = std::variant<double, std::int64_t, std::string, std::vector<double>, std::vector<std::string>>;

struct TreeNode {
  enum class Kind : std::uint8_t {
    kGroup,
    kFloat64,
    kFloat32,
    kInt64,
    kUint8,
    kTexts,   ///< One dimension.
    kUnread,  ///< There is something, which is not taken; `why` says why.
    kFailure  ///< In place of all that would follow; `why` is a sentence for the user.
  };

  std::string path;  ///< Names parted by '/', without one in front; empty is the root.
  Kind kind = Kind::kGroup;
  std::vector<std::uint64_t> shape;  ///< Of an array, rows first.
  std::string data;                  ///< The numbers of an array by rows, little-endian, or nothing.
  std::vector<std::string> texts;
  std::map<std::string, Attribute> attributes;
  std::string why;

  bool holds_numbers() const { return kind >= Kind::kFloat64 && kind <= Kind::kUint8; }
  /// Of all dimensions; 1 without any. No overflow: what would is as large as can be.
  std::uint64_t count() const;
  /// Precondition: `holds_numbers()` and `i < count()`.
  double number(std::size_t i) const;
  std::vector<double> numbers() const;
};

/// Bytes of one number; 0 for a kind without numbers.
std::size_t bytes_of(TreeNode::Kind kind);

/// An array of `numbers`, each stored as `kind`. Precondition: `shape` fits.
TreeNode array_node(std::string path, TreeNode::Kind kind, std::vector<std::uint64_t> shape,
                    const std::vector<double>& numbers);
TreeNode texts_node(std::string path, std::vector<std::string> texts);

std::string encode(const TreeNode& node);
/// Nothing unless `bytes` are exactly one node whose data fit its shape; allocates no more than `bytes` are long, but
/// for a factor.
std::optional<TreeNode> decode(std::string_view bytes);

}  // namespace trocar::exchange
