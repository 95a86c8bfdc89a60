#include "ui/widgets/lint.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace trocar::ui {
namespace {

// Of a target for the mouse, at 100 %: WCAG 2.2, success criterion 2.5.8.
constexpr float kLeastTarget = 24.0F;

bool any_of(std::string_view role, std::initializer_list<std::string_view> roles) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

bool is_control(const Item& item) {
  return !any_of(item.role, {"text", "progress", "mark"});
}

// A glyph of the private use area is a picture to us and nothing to a screen reader.
bool has_private_glyph(std::string_view words) {
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const auto byte = static_cast<unsigned char>(words[i]);
    if (byte == 0xEE || (byte == 0xEF && static_cast<unsigned char>(words[i + 1]) < 0xA4)) return true;
  }
  return false;
}

bool is_small(const Item& item, float scale) {
  if (!any_of(item.role, {"button", "toggle", "checkbox", "combo", "field", "tab", "menu", "row"})) return false;
  const float least = kLeastTarget * scale - 1.0F;
  return item.rect.height() < least || item.rect.width() < least;
}

// What lies on a ground by design does not count: marks on a canvas, words in a row.
bool is_ground(const Item& item) {
  return any_of(item.role, {"canvas", "row", "splitter", "progress", "slider", "mark"});
}

bool overlap(const Item& a, const Item& b) {
  constexpr float kSlack = 1.5F;
  if (a.region != b.region || is_ground(a) || is_ground(b)) return false;
  const float wide = std::min(a.rect.x1, b.rect.x1) - std::max(a.rect.x0, b.rect.x0);
  const float tall = std::min(a.rect.y1, b.rect.y1) - std::max(a.rect.y0, b.rect.y0);
  return wide > kSlack && tall > kSlack;
}

}  // namespace

std::vector<LintFinding> lint(const std::vector<Item>& items, float scale) {
  std::vector<LintFinding> findings;
  std::map<std::string_view, int> seen;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    if (is_control(item) && item.label.empty()) findings.push_back({item.path, "has no name"});
    if (has_private_glyph(item.label)) findings.push_back({item.path, "has a picture in its name"});
    if (++seen[item.path] == 2) findings.push_back({item.path, "is there twice"});
    if (item.text_clipped) findings.push_back({item.path, "is cut off"});
    if (is_small(item, scale)) findings.push_back({item.path, "is too small a target"});
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(items[j], item)) findings.push_back({item.path, "lies on " + items[j].path});
    }
  }
  return findings;
}

}  // namespace trocar::ui
