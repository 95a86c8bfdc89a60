#include "app/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

namespace trocar::app {
namespace {

constexpr std::size_t kMostNamed = 3;
constexpr std::size_t kMostListed = 16;
constexpr std::size_t kUnlike = std::numeric_limits<std::size_t>::max();

/// Letters and digits of ASCII alone, in lower case: what differs otherwise is no difference of meaning.
std::string folded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') result += static_cast<char>(c | 0x20);
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) result += c;
  }
  return result;
}

/// Letters to put in, leave out, replace, or swap with their neighbour.
std::size_t slips_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> slips(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        slips[i][j] = i + j;
        continue;
      }
      const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
      slips[i][j] = std::min({slips[i - 1][j] + 1, slips[i][j - 1] + 1, slips[i - 1][j - 1] + other});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) slips[i][j] = std::min(slips[i][j], slips[i - 2][j - 2] + 1);
    }
  }
  return slips[a.size()][b.size()];
}

/// 0: the same but for signs; larger is less alike.
std::size_t unlikeness(const std::string& wrong, const std::string& name) {
  if (wrong.empty() || name.empty()) return kUnlike;
  if (wrong == name) return 0;
  constexpr std::size_t kShortestBeginning = 3;
  if (wrong.size() >= kShortestBeginning && name.starts_with(wrong)) return 1;
  const std::size_t allowed = wrong.size() / 3;
  // Long ones that cannot be alike are not compared letter by letter.
  if (name.size() > wrong.size() + allowed || wrong.size() > name.size() + allowed) return kUnlike;
  const std::size_t slips = slips_between(wrong, name);
  return slips <= allowed ? 1 + slips : kUnlike;
}

const std::string& shown_name(const Known& known) {
  return known.shown.empty() ? known.name : known.shown;
}

std::string joined(std::span<const Known> list, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += i + 1 == list.size() ? last : ", ";
    text += shown_name(list[i]);
  }
  return text;
}

}  // namespace

std::string did_you_mean(std::string_view wrong, const std::vector<Known>& known) {
  const std::string word = folded(wrong);
  std::size_t best = kUnlike;
  std::vector<Known> alike;
  for (const Known& each : known) {
    const std::size_t score = unlikeness(word, folded(each.name));
    if (score == kUnlike || score > best) continue;
    if (score < best) alike.clear();
    best = score;
    if (alike.size() < kMostNamed) alike.push_back(each);
  }
  return alike.empty() ? "" : fmt::format("; did you mean {}?", joined(alike, " or "));
}

std::string there_are(const std::vector<Known>& known) {
  if (known.empty()) return "; there is none";
  if (known.size() == 1) return "; there is " + shown_name(known.front());
  if (known.size() <= kMostListed) return "; there are " + joined(known, " and ");
  const std::span<const Known> first(known.data(), kMostListed);
  return fmt::format("; there are {} and {} more", joined(first, ", "), known.size() - kMostListed);
}

std::string suggestion(std::string_view wrong, const std::vector<Known>& known) {
  const std::string meant = did_you_mean(wrong, known);
  return meant.empty() ? there_are(known) : meant;
}

}  // namespace trocar::app
