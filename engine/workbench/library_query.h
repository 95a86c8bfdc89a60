/// Questions to the library as people type them: "jerk>0.3 and segment:C and not tag:bad".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/workbench/library_columns.h"

namespace trocar::workbench {

/// What was asked, ready to be held against rows. One term after the other means all of them; `and`, `or`, `not` and
/// parentheses combine. A term is
/// - a comparison of a number, in the unit that its column shows: `length>10`, `idle>=20`, `clearance<0.5mm`;
/// - `column=word` for text that is just that, or any one tag that is, `!=` for its contrary; `flag=none` for what has
///   none;
/// - `column:word` or `column~word` for text that has the word somewhere, `!~` for its contrary: any part of it, all
///   letters of `segment:ABC`, but with `:` the whole word of flag, verdict, outcome, replay, arms and any one tag;
/// - `duplicate`, `odd` (three deviations or more), `flagged` or `tagged`;
/// - any other word, or "several in quotes": found in name, tags, source or note.
/// The case of letters does not matter.
class LibraryQuery {
 public:
  /// Matches every row.
  LibraryQuery() = default;
  /// Errors: kInvalidArgument saying what is wrong at which character, also for more than 2,000 characters.
  static Result<LibraryQuery> parse(std::string_view text);

  enum class Answer : std::uint8_t { kNo, kYes, kUnknown };  ///< Unknown: it depends on what is being worked out.
  Answer operator()(const LibraryRow& row) const;
  /// It asks for what takes time to work out.
  bool measured() const;
  /// The terms that must all hold, as they were typed; one if they are joined by `or`.
  const std::vector<std::string>& terms() const { return terms_; }
  /// It is terms joined by `or`.
  bool alternatives() const { return !nodes_.empty() && nodes_.back().test == Test::kAny; }

 private:
  friend class QueryParser;
  enum class Test : std::uint8_t { kAll, kAny, kNot, kNumber, kText, kWord, kKeyword };
  enum class Relation : std::uint8_t { kLess, kLessOrEqual, kMore, kMoreOrEqual, kEqual, kOther, kHas, kLacks };
  struct Node {
    Test test = Test::kAll;
    std::vector<std::size_t> parts;  ///< Of kAll, kAny and kNot.
    const LibraryColumn* column = nullptr;
    Relation relation = Relation::kEqual;
    double number = 0.0;
    std::string text;    ///< In small letters.
    bool whole = false;  ///< Written with a colon: of what is one of few words, the whole word.
  };
  Answer answer(const Node& node, const LibraryRow& row) const;
  static Answer leaf(const Node& node, const LibraryRow& row);

  std::vector<Node> nodes_;  ///< The last one is the whole; empty: everything matches.
  std::vector<std::string> terms_;
};

/// The rows that match; `undecided` counts those of which it is not known yet.
std::vector<const LibraryRow*> matching(const LibraryView& view, const LibraryQuery& query, std::size_t& undecided);
/// `term` added to what `query` asks already, or taken out again if it is one of its terms.
std::string with_term_toggled(std::string_view query, std::string_view term);

}  // namespace trocar::workbench
