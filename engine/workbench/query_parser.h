/// Reads a query of the library, by recursive descent. Private to the module.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/workbench/library_query.h"

namespace trocar::workbench {

/// ASCII letters only; other bytes stay.
std::string lower_case(std::string_view text);

class QueryParser {
 public:
  explicit QueryParser(std::string_view text) : text_(text) {}
  Result<LibraryQuery> parse();

 private:
  enum class Kind { kWord, kQuoted, kRelation, kOpen, kClose };
  struct Token {
    Kind kind = Kind::kWord;
    std::string text;
    std::size_t begin = 0;  ///< In the query, in bytes.
    std::size_t end = 0;
  };
  using Place = Result<std::size_t>;  ///< Of a node.

  Status split();
  Place any();
  Place all();
  Place one();
  Place term();
  Place comparison(const LibraryColumn& column, const Token& name);
  Result<double> number_from(const LibraryColumn& column, const Token& value) const;
  bool at_word(std::string_view word) const;
  const Token* peek() const { return next_ < tokens_.size() ? &tokens_[next_] : nullptr; }
  std::size_t keep(LibraryQuery::Node node);
  /// `parts` as one node; the part itself if it is the only one.
  std::size_t joined(LibraryQuery::Test test, std::vector<std::size_t> parts);
  tl::unexpected<Error> wrong(std::string_view what, std::size_t at) const;

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  int depth_ = 0;
  LibraryQuery query_;
};

}  // namespace trocar::workbench
