/// What a person says of a demonstration: flag, verdict, rating, tags and a note. None of it changes the motion.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::workbench {

enum class Flag : std::uint8_t { kNone, kGood, kBad, kUnsure };
constexpr std::array<Flag, 4> kFlags{Flag::kNone, Flag::kGood, Flag::kBad, Flag::kUnsure};
std::string_view to_string(Flag flag);
/// Errors (here and below): kInvalidArgument naming the words that there are.
Result<Flag> flag_from(std::string_view word);

/// How the transfer ended in a person's eyes; the recording keeps what the recorder made of it.
enum class Verdict : std::uint8_t { kNone, kSuccess, kFailure };
constexpr std::array<Verdict, 3> kVerdicts{Verdict::kNone, Verdict::kSuccess, Verdict::kFailure};
std::string_view to_string(Verdict verdict);
Result<Verdict> verdict_from(std::string_view word);

struct Marks {
  Flag flag = Flag::kNone;
  Verdict verdict = Verdict::kNone;
  int rating = 0;  ///< 0: none, else 1 … 5.
  std::set<std::string> tags;
  std::string note;
  bool operator==(const Marks&) const = default;
};

/// What is to be said anew; all else stays as it was.
struct MarkChange {
  std::optional<Flag> flag;
  std::optional<Verdict> verdict;
  std::optional<int> rating;
  std::vector<std::string> add;     ///< Tags.
  std::vector<std::string> remove;  ///< Tags; one that is not there is no error.
  std::optional<std::string> note;
  bool operator==(const MarkChange&) const = default;
};

/// Errors: kInvalidArgument for a rating that is not from 0 to 5, a note longer than 4,000 bytes, and a tag that is no
/// word: up to 60 bytes without blanks, commas, colons, quotes and parentheses, so that it can be asked for.
Result<Marks> changed(Marks marks, const MarkChange& change);
Status check_tag(std::string_view tag);
/// "flag bad, tag slow, untag good"; "nothing" where that is so.
std::string to_words(const MarkChange& change);

}  // namespace trocar::workbench
