#include "ui/widgets/item_log.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace trocar::ui {
namespace {

constexpr std::string_view kEllipsis = "…";

std::string plain(std::string_view text) {
  if (text.ends_with(kEllipsis)) text.remove_suffix(kEllipsis.size());
  if (text.ends_with("...")) text.remove_suffix(3);
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// How many pairs of neighbouring letters two words share; enough to suggest what was meant.
int likeness(const std::string& a, const std::string& b) {
  int shared = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    if (b.find(a.substr(i, 2)) != std::string::npos) ++shared;
  }
  return shared;
}

// True where no scrolling brings the whole of the item into sight. A row may be wider than the column it begins in.
bool cut_off(const Item& item) {
  constexpr float kSlack = 1.0F;
  const bool beside = item.rect.x0 < item.clip.x0 - kSlack || item.rect.x1 > item.clip.x1 + kSlack;
  const bool beyond = item.rect.y0 < item.clip.y0 - kSlack || item.rect.y1 > item.clip.y1 + kSlack;
  const bool too_tall = item.rect.height() > std::max(item.room_y, item.clip.height()) + kSlack;
  if (beside && !item.scrolls_x && item.role != "row" && item.role != "canvas") return true;
  return item.role == "canvas" ? beyond && !item.scrolls_y : beyond && (!item.scrolls_y || too_tall);
}

}  // namespace

void ItemLog::begin_frame() {
  items_.clear();
  prefix_.clear();
  lengths_.clear();
}

void ItemLog::push(std::string_view scope) {
  lengths_.push_back(prefix_.size());
  prefix_.append(scope).push_back('/');
}

void ItemLog::pop() {
  prefix_.resize(lengths_.back());
  lengths_.pop_back();
}

void ItemLog::add(Item item) {
  item.path = prefix_ + item.label;
  item.text_clipped = item.text_clipped || cut_off(item);
  items_.push_back(std::move(item));
}

void ItemLog::note_text(float width, float padding) {
  Item& item = items_.back();
  item.text_clipped = item.text_clipped || width > item.rect.width() - padding + 0.5F;
}

void ItemLog::note_end(float x1) {
  Item& item = items_.back();
  item.text_clipped = item.text_clipped || (x1 > item.clip.x1 + 1.0F && !item.scrolls_x);
}

const Item* ItemLog::find(std::string_view path) const {
  const std::string wanted = plain(path);
  const std::string tail = "/" + wanted;
  const Item* found = nullptr;
  bool exact = false;
  for (const Item& item : items_) {
    const std::string candidate = plain(item.path);
    if (candidate == wanted) {
      found = &item;
      exact = true;
    } else if (!exact && candidate.ends_with(tail)) {
      found = &item;
    }
  }
  return found;
}

std::vector<std::string> ItemLog::similar(std::string_view path, std::size_t count) const {
  const std::string wanted = plain(path);
  std::vector<std::pair<int, std::string>> ranked;
  for (const Item& item : items_) {
    if (item.role != "text") ranked.emplace_back(-likeness(wanted, plain(item.path)), item.path);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (const auto& [score, name] : ranked) {
    if (names.size() == count) break;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string ItemLog::to_json() const {
  nlohmann::json list = nlohmann::json::array();
  for (const Item& item : items_) {
    nlohmann::json entry{
        {"path", item.path},           {"role", item.role},
        {"label", item.label},         {"value", item.value},
        {"enabled", item.enabled},     {"rect", {item.rect.x0, item.rect.y0, item.rect.x1, item.rect.y1}},
        {"visible", item.reachable()}, {"text_clipped", item.text_clipped}};
    if (!item.reason.empty()) entry["reason"] = item.reason;
    if (!item.help.empty()) entry["help"] = item.help;
    if (!item.shortcut.empty()) entry["shortcut"] = item.shortcut;
    list.push_back(std::move(entry));
  }
  return list.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace trocar::ui
