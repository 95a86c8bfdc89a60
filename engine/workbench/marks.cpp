#include "engine/workbench/marks.h"

#include <fmt/format.h>

#include "engine/demonstration/name.h"

namespace trocar::workbench {
namespace {

constexpr std::array<std::string_view, 4> kFlagWords{"none", "good", "bad", "unsure"};
constexpr std::array<std::string_view, 3> kVerdictWords{"none", "success", "failure"};
constexpr std::size_t kLongestTag = 60;
constexpr std::size_t kLongestNote = 4000;

template <typename Value, std::size_t kCount>
Result<Value> value_from(std::string_view word, std::string_view what,
                         const std::array<std::string_view, kCount>& words) {
  std::string known;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (words[i] == word) return static_cast<Value>(i);
    known += fmt::format("{}{}", i == 0 ? "" : i + 1 == kCount ? " or " : ", ", words[i]);
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("a {} is {}, not \"{}\"", what, known, word));
}

}  // namespace

std::string_view to_string(Flag flag) {
  return kFlagWords[static_cast<std::size_t>(flag)];
}

Result<Flag> flag_from(std::string_view word) {
  return value_from<Flag>(word, "flag", kFlagWords);
}

std::string_view to_string(Verdict verdict) {
  return kVerdictWords[static_cast<std::size_t>(verdict)];
}

Result<Verdict> verdict_from(std::string_view word) {
  return value_from<Verdict>(word, "verdict", kVerdictWords);
}

Status check_tag(std::string_view tag) {
  const bool wrong = tag.empty() || tag.size() > kLongestTag || !demonstration::check_name(tag) ||
                     tag.find_first_of(" ,:;\"'()<>=") != std::string_view::npos;
  if (!wrong) return {};
  return fail(ErrorCode::kInvalidArgument,
              "a tag is one word of at most 60 bytes without commas, colons, quotes and parentheses");
}

Result<Marks> changed(Marks marks, const MarkChange& change) {
  if (change.rating && (*change.rating < 0 || *change.rating > 5)) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a rating is from 0 (none) to 5, not {}", *change.rating));
  }
  if (change.note && change.note->size() > kLongestNote) {
    return fail(ErrorCode::kInvalidArgument, "a note must not be longer than 4,000 bytes");
  }
  for (const std::string& tag : change.add) TROCAR_RETURN_IF_ERROR(check_tag(tag));
  marks.flag = change.flag.value_or(marks.flag);
  marks.verdict = change.verdict.value_or(marks.verdict);
  marks.rating = change.rating.value_or(marks.rating);
  marks.note = change.note.value_or(marks.note);
  for (const std::string& tag : change.remove) marks.tags.erase(tag);
  marks.tags.insert(change.add.begin(), change.add.end());
  return marks;
}

std::string to_words(const MarkChange& change) {
  std::string words;
  const auto say = [&words](const std::string& part) { words += words.empty() ? part : ", " + part; };
  if (change.flag) say(fmt::format("flag {}", to_string(*change.flag)));
  if (change.verdict) say(fmt::format("verdict {}", to_string(*change.verdict)));
  if (change.rating) say(fmt::format("rating {}", *change.rating));
  for (const std::string& tag : change.remove) say("untag " + tag);
  for (const std::string& tag : change.add) say("tag " + tag);
  if (change.note) say(change.note->empty() ? "no note" : "note");
  return words.empty() ? "nothing" : words;
}

}  // namespace trocar::workbench
