#include "engine/workbench/query_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace trocar::workbench {
namespace {

constexpr std::size_t kLongest = 2000;
constexpr int kDeepest = 50;
constexpr std::string_view kRelationSigns = "<>=!:~";
constexpr std::array<std::string_view, 4> kKeywords{"duplicate", "odd", "flagged", "tagged"};

bool is_blank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool ends_word(char c) {
  return is_blank(c) || c == '(' || c == ')' || c == '"' || kRelationSigns.find(c) != std::string_view::npos;
}

std::string column_ids() {
  std::string ids;
  for (const LibraryColumn& column : library_columns()) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", column.id);
  return ids;
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

tl::unexpected<Error> QueryParser::wrong(std::string_view what, std::size_t at) const {
  // Characters, not bytes: those that do not continue one.
  const auto before = text_.substr(0, at);
  const auto place = std::count_if(before.begin(), before.end(),
                                   [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return fail(ErrorCode::kInvalidArgument, fmt::format("{} (character {} of the filter)", what, place + 1));
}

Status QueryParser::split() {
  if (text_.size() > kLongest) return fail(ErrorCode::kInvalidArgument, "a filter has at most 2,000 characters");
  for (std::size_t i = 0; i < text_.size();) {
    const char c = text_[i];
    const std::size_t begin = i;
    if (is_blank(c)) {
      ++i;
    } else if (c == '(' || c == ')') {
      tokens_.push_back({c == '(' ? Kind::kOpen : Kind::kClose, std::string(1, c), begin, ++i});
    } else if (c == '"') {
      const std::size_t end = text_.find('"', i + 1);
      if (end == std::string_view::npos) return wrong("a quote is not closed", begin);
      tokens_.push_back({Kind::kQuoted, std::string(text_.substr(i + 1, end - i - 1)), begin, end + 1});
      i = end + 1;
    } else if (kRelationSigns.find(c) != std::string_view::npos) {
      const char next = i + 1 < text_.size() ? text_[i + 1] : ' ';
      const bool two = (next == '=' && (c == '<' || c == '>' || c == '!')) || (c == '!' && next == '~');
      i += two ? 2 : 1;
      tokens_.push_back({Kind::kRelation, std::string(text_.substr(begin, i - begin)), begin, i});
    } else {
      while (i < text_.size() && !ends_word(text_[i])) ++i;
      tokens_.push_back({Kind::kWord, std::string(text_.substr(begin, i - begin)), begin, i});
    }
  }
  return {};
}

bool QueryParser::at_word(std::string_view word) const {
  const Token* token = peek();
  return token != nullptr && token->kind == Kind::kWord && lower_case(token->text) == word;
}

std::size_t QueryParser::keep(LibraryQuery::Node node) {
  query_.nodes_.push_back(std::move(node));
  return query_.nodes_.size() - 1;
}

std::size_t QueryParser::joined(LibraryQuery::Test test, std::vector<std::size_t> parts) {
  if (parts.size() == 1) return parts.front();
  LibraryQuery::Node node;
  node.test = test;
  node.parts = std::move(parts);
  return keep(std::move(node));
}

Result<LibraryQuery> QueryParser::parse() {
  TROCAR_RETURN_IF_ERROR(split());
  if (tokens_.empty()) return query_;
  TROCAR_ASSIGN_OR_RETURN(const std::size_t whole, any());
  if (const Token* left = peek()) return wrong(fmt::format("\"{}\" closes nothing", left->text), left->begin);
  // The whole is the last node, whatever was kept after it.
  if (whole + 1 != query_.nodes_.size()) query_.nodes_.push_back(query_.nodes_[whole]);
  return std::move(query_);
}

QueryParser::Place QueryParser::any() {
  const std::size_t begin = next_;
  std::vector<std::size_t> parts;
  do {
    if (!parts.empty()) ++next_;
    TROCAR_ASSIGN_OR_RETURN(const std::size_t part, all());
    parts.push_back(part);
  } while (at_word("or"));
  if (depth_ == 0 && parts.size() > 1) {
    const std::size_t from = tokens_[begin].begin;
    query_.terms_ = {std::string(text_.substr(from, tokens_[next_ - 1].end - from))};
  }
  return joined(LibraryQuery::Test::kAny, std::move(parts));
}

QueryParser::Place QueryParser::all() {
  std::vector<std::size_t> parts;
  do {
    if (at_word("and")) ++next_;
    const std::size_t begin = next_;
    TROCAR_ASSIGN_OR_RETURN(const std::size_t part, one());
    parts.push_back(part);
    const std::size_t from = tokens_[begin].begin;
    if (depth_ == 0) query_.terms_.emplace_back(text_.substr(from, tokens_[next_ - 1].end - from));
  } while (peek() != nullptr && peek()->kind != Kind::kClose && !at_word("or"));
  return joined(LibraryQuery::Test::kAll, std::move(parts));
}

QueryParser::Place QueryParser::one() {
  const Token* token = peek();
  if (token == nullptr) return wrong("something is missing at the end", text_.size());
  const std::size_t begin = token->begin;
  if (!at_word("not") && token->kind != Kind::kOpen) return term();
  if (++depth_ > kDeepest) return wrong("this is nested too deep", begin);
  const bool negated = at_word("not");
  ++next_;
  Place inner = negated ? one() : any();
  --depth_;
  if (!inner) return inner;
  if (!negated) {
    if (peek() == nullptr) return wrong("a parenthesis is not closed", begin);
    ++next_;
    return inner;
  }
  LibraryQuery::Node node;
  node.test = LibraryQuery::Test::kNot;
  node.parts = {*inner};
  return keep(std::move(node));
}

QueryParser::Place QueryParser::term() {
  const Token token = tokens_[next_];
  if (token.kind == Kind::kRelation) return wrong(fmt::format("nothing stands before \"{}\"", token.text), token.begin);
  if (token.kind == Kind::kClose) return wrong("something is missing before \")\"", token.begin);
  if (at_word("and") || at_word("or")) return wrong(fmt::format("nothing stands before {}", token.text), token.begin);
  ++next_;
  const std::string word = lower_case(token.text);
  if (token.kind == Kind::kWord && peek() != nullptr && peek()->kind == Kind::kRelation) {
    const LibraryColumn* column = find_library_column(word);
    if (column != nullptr) return comparison(*column, token);
    return wrong(fmt::format("there is no column \"{}\"; there are {}", token.text, column_ids()), token.begin);
  }
  if (token.text.empty()) return wrong("there is nothing between the quotes", token.begin);
  LibraryQuery::Node node;
  const bool keyword =
      token.kind == Kind::kWord && std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
  node.test = keyword ? LibraryQuery::Test::kKeyword : LibraryQuery::Test::kWord;
  node.text = word;
  return keep(std::move(node));
}

QueryParser::Place QueryParser::comparison(const LibraryColumn& column, const Token& name) {
  using Relation = LibraryQuery::Relation;
  constexpr std::array<std::pair<std::string_view, Relation>, 9> kRelations{{{"<", Relation::kLess},
                                                                             {"<=", Relation::kLessOrEqual},
                                                                             {">", Relation::kMore},
                                                                             {">=", Relation::kMoreOrEqual},
                                                                             {"=", Relation::kEqual},
                                                                             {"!=", Relation::kOther},
                                                                             {":", Relation::kHas},
                                                                             {"~", Relation::kHas},
                                                                             {"!~", Relation::kLacks}}};
  const Token relation = tokens_[next_++];
  const auto* found =
      std::find_if(kRelations.begin(), kRelations.end(), [&](const auto& each) { return each.first == relation.text; });
  if (found == kRelations.end()) return wrong(fmt::format("\"{}\" compares nothing", relation.text), relation.begin);
  const Token* value = peek();
  if (value == nullptr || (value->kind != Kind::kWord && value->kind != Kind::kQuoted)) {
    return wrong(fmt::format("nothing follows {}{}", name.text, relation.text), relation.end);
  }
  LibraryQuery::Node node;
  node.column = &column;
  node.relation = found->second;
  node.test = column.number ? LibraryQuery::Test::kNumber : LibraryQuery::Test::kText;
  const bool of_text = node.relation == Relation::kHas || node.relation == Relation::kLacks;
  if (column.number) {
    // length:10 is length=10; nothing is a part of a number.
    if (relation.text == ":") node.relation = Relation::kEqual;
    if (of_text && relation.text != ":") {
      return wrong(
          fmt::format("{} is a number, so that {} says nothing of it; ask {}=10", column.id, relation.text, column.id),
          relation.begin);
    }
    TROCAR_ASSIGN_OR_RETURN(node.number, number_from(column, *value));
  } else if (!of_text && node.relation != Relation::kEqual && node.relation != Relation::kOther) {
    return wrong(
        fmt::format("{} is text, so that {} says nothing of it; ask {}:WORD", column.id, relation.text, column.id),
        relation.begin);
  } else {
    node.text = lower_case(value->text);
    node.whole = relation.text == ":";
  }
  ++next_;
  return keep(std::move(node));
}

Result<double> QueryParser::number_from(const LibraryColumn& column, const Token& value) const {
  char* end = nullptr;
  const double number = std::strtod(value.text.c_str(), &end);
  const std::string_view rest(end);
  const bool digits =
      end != value.text.c_str() && std::isfinite(number) && value.text.find_first_of("xXnN") == std::string::npos;
  if (digits && (rest.empty() || rest == column.unit)) return number;
  return wrong(fmt::format("{} is a number{}, not \"{}\"", column.id,
                           column.unit.empty() ? "" : fmt::format(" ({})", column.unit), value.text),
               value.begin);
}

Result<LibraryQuery> LibraryQuery::parse(std::string_view text) {
  return QueryParser(text).parse();
}

}  // namespace trocar::workbench
