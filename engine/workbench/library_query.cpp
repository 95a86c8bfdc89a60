#include "engine/workbench/library_query.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "engine/workbench/query_parser.h"

namespace trocar::workbench {
namespace {

using Answer = LibraryQuery::Answer;

Answer answer_of(bool yes) {
  return yes ? Answer::kYes : Answer::kNo;
}

bool holds(std::string_view text, std::string_view word) {
  return lower_case(text).find(word) != std::string::npos;
}

/// Columns whose text is one of few words, so that a part of one means nothing.
constexpr std::array<std::string_view, 5> kWholeWords{"flag", "verdict", "outcome", "replay", "arms"};

enum class Match { kExact, kWhole, kPart };

bool matches(std::string_view text, std::string_view word, Match how) {
  return how == Match::kPart ? holds(text, word) : lower_case(text) == word;
}

/// `kWhole`: a part, but not of what is one of few words.
bool text_matches(const LibraryColumn& column, const LibraryRow& row, const LibraryCell& cell, std::string_view word,
                  Match how) {
  if (cell.kind == LibraryCell::Kind::kNone) return word == "none";
  if (column.id == "tag") {
    return std::any_of(row.marks.tags.begin(), row.marks.tags.end(),
                       [&](const std::string& tag) { return matches(tag, word, how); });
  }
  if (column.id == "segment" && how != Match::kExact) {
    const std::string letters = lower_case(row.segments);
    return std::all_of(word.begin(), word.end(), [&](char each) { return letters.find(each) != std::string::npos; });
  }
  const bool few = std::find(kWholeWords.begin(), kWholeWords.end(), column.id) != kWholeWords.end();
  return matches(column.id == "segment" ? std::string_view(row.segments) : std::string_view(cell.text), word,
                 how == Match::kWhole && !few ? Match::kPart : how);
}

bool word_matches(const LibraryRow& row, std::string_view word) {
  return holds(row.name, word) || holds(row.source, word) || holds(row.marks.note, word) ||
         std::any_of(row.marks.tags.begin(), row.marks.tags.end(),
                     [&](const std::string& tag) { return holds(tag, word); });
}

constexpr double kOddFrom = 3.0;

Answer keyword_matches(const LibraryRow& row, std::string_view word) {
  if (word == "duplicate") return answer_of(row.duplicate != DemonstrationId{});
  if (word == "flagged") return answer_of(row.marks.flag != Flag::kNone);
  if (word == "tagged") return answer_of(!row.marks.tags.empty());
  if (!row.measures) return Answer::kUnknown;
  return answer_of(row.oddity && row.oddity->deviations >= kOddFrom);
}

}  // namespace

LibraryQuery::Answer LibraryQuery::leaf(const Node& node, const LibraryRow& row) {
  if (node.test == Test::kWord) return answer_of(word_matches(row, node.text));
  if (node.test == Test::kKeyword) return keyword_matches(row, node.text);
  const LibraryCell cell = node.column->cell(row);
  if (cell.kind == LibraryCell::Kind::kPending) return Answer::kUnknown;
  if (node.test == Test::kText) {
    const bool exact = node.relation == Relation::kEqual || node.relation == Relation::kOther;
    const bool contrary = node.relation == Relation::kOther || node.relation == Relation::kLacks;
    const Match how = exact ? Match::kExact : node.whole ? Match::kWhole : Match::kPart;
    return answer_of(text_matches(*node.column, row, cell, node.text, how) != contrary);
  }
  if (cell.kind != LibraryCell::Kind::kNumber) return Answer::kNo;
  switch (node.relation) {
    case Relation::kLess:
      return answer_of(cell.number < node.number);
    case Relation::kLessOrEqual:
      return answer_of(cell.number <= node.number);
    case Relation::kMore:
      return answer_of(cell.number > node.number);
    case Relation::kMoreOrEqual:
      return answer_of(cell.number >= node.number);
    case Relation::kEqual:
      return answer_of(cell.number == node.number);
    case Relation::kOther:
      return answer_of(cell.number != node.number);
    case Relation::kHas:
    case Relation::kLacks:
      return Answer::kNo;  // The parser lets none through.
  }
  return Answer::kNo;
}

/// Kleene's logic: what is unknown decides nothing that the others decide.
LibraryQuery::Answer LibraryQuery::answer(const Node& node, const LibraryRow& row) const {
  if (node.test == Test::kNot) {
    const Answer inner = answer(nodes_[node.parts.front()], row);
    return inner == Answer::kUnknown ? inner : answer_of(inner == Answer::kNo);
  }
  if (node.test != Test::kAll && node.test != Test::kAny) return leaf(node, row);
  const Answer deciding = node.test == Test::kAll ? Answer::kNo : Answer::kYes;
  Answer whole = node.test == Test::kAll ? Answer::kYes : Answer::kNo;
  for (const std::size_t part : node.parts) {
    const Answer each = answer(nodes_[part], row);
    if (each == deciding) return each;
    if (each == Answer::kUnknown) whole = each;
  }
  return whole;
}

LibraryQuery::Answer LibraryQuery::operator()(const LibraryRow& row) const {
  return nodes_.empty() ? Answer::kYes : answer(nodes_.back(), row);
}

bool LibraryQuery::measured() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& node) {
    return (node.column != nullptr && node.column->measured) || (node.test == Test::kKeyword && node.text == "odd");
  });
}

std::vector<const LibraryRow*> matching(const LibraryView& view, const LibraryQuery& query, std::size_t& undecided) {
  std::vector<const LibraryRow*> rows;
  undecided = 0;
  for (const LibraryRow& row : view.rows) {
    const Answer found = query(row);
    if (found == Answer::kYes) rows.push_back(&row);
    undecided += found == Answer::kUnknown ? 1 : 0;
  }
  return rows;
}

std::string with_term_toggled(std::string_view query, std::string_view term) {
  const Result<LibraryQuery> parsed = LibraryQuery::parse(query);
  if (!parsed) return std::string(term);
  std::string rest;
  bool taken_out = false;
  const auto add = [&rest](std::string_view each) { rest += (rest.empty() ? "" : " and ") + std::string(each); };
  for (const std::string& each : parsed->terms()) {
    if (each == term) {
      taken_out = true;
    } else {
      add(parsed->alternatives() && each.front() != '(' ? "(" + each + ")" : each);
    }
  }
  if (!taken_out) add(term);
  return rest;
}

}  // namespace trocar::workbench
