#include "ui/tile_tree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <set>

#include "ui/icons.h"

namespace trocar::ui {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, kPanelCount> kTitles{
    "Library", "View",  "Timeline", "Fields", "Rollouts", "Train",  "Inspector", "History", "Jobs",
    "Log",     "Edits", "Problems", "Curves", "Diff",     "Models", "Trials",    "Export"};
constexpr std::array<const char*, kPanelCount> kIcons{
    icon::kTable, icon::kCube,    icon::kSliders, icon::kThLarge, icon::kRoad,   icon::kTrain,
    icon::kInfo,  icon::kHistory, icon::kTasks,   icon::kList,    icon::kPencil, icon::kWarning,
    icon::kChart, icon::kBranch,  icon::kBalance, icon::kUsers,   icon::kFilm};
constexpr std::array<std::string_view, kWorkspaceCount> kWorkspaceTitles{"Library",  "Author", "Fields",
                                                                         "Rollouts", "Trials", "Export"};

void collect_panels(const Tile& tile, std::vector<PanelId>& panels) {
  panels.insert(panels.end(), tile.panels.begin(), tile.panels.end());
  for (const Tile& child : tile.children) collect_panels(child, panels);
}

// The picture and what it shows over time stay in sight for as long as there is room for both.
struct InSight {
  bool view = false;
  bool timeline = false;
  bool any() const { return view || timeline; }
};

// By what is first in a tab group, so that nothing moves when another of its panels comes to the front.
InSight in_sight_in(const Tile& tile) {
  const bool leads = tile.kind == Tile::Kind::kTabs && !tile.panels.empty();
  InSight found{leads && tile.panels.front() == PanelId::kView, leads && tile.panels.front() == PanelId::kTimeline};
  for (const Tile& child : tile.children) {
    const InSight inner = in_sight_in(child);
    found = {found.view || inner.view, found.timeline || inner.timeline};
  }
  return found;
}

float least_of(const InSight& seen, bool row, const PlaceOptions& options) {
  if (row) return seen.timeline ? std::max(options.least_timeline_width, options.least_width) : options.least_width;
  const bool lower = seen.view && !seen.timeline && options.least_in_sight_height > 0.0F;
  return lower ? options.least_in_sight_height : options.least_height;
}

struct Group {
  std::vector<Tile*> tiles;  ///< More than one: too little room, they become one tab group.
  float share = 0.0F;
  std::size_t panels = 0;
  float least = 0.0F;     ///< Pixels.
  bool in_sight = false;  ///< The first tile keeps its own arrangement, and the others join it as tabs.
};

// Two groups that become one: `into` < `from`.
struct Join {
  std::size_t into = 0;
  std::size_t from = 0;
};

// Those of the two groups that have the fewest panels together, of equals those at the end. Groups that stay in sight
// are stepped over as long as two others are left.
Join join_of(const std::vector<Group>& groups) {
  const auto aside = std::count_if(groups.begin(), groups.end(), [](const Group& group) { return !group.in_sight; });
  std::optional<Join> best;
  std::size_t fewest = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (aside >= 2 && groups[i].in_sight) continue;
    std::size_t next = i + 1;
    while (aside >= 2 && next < groups.size() && groups[next].in_sight) ++next;
    if (next >= groups.size()) break;
    // The last one aside goes to one that stays in sight before two of those become one.
    if (aside == 1 && groups[i].in_sight && groups[next].in_sight) continue;
    const std::size_t both = groups[i].panels + groups[next].panels;
    if (best && both > fewest) continue;
    best = Join{i, next};
    fewest = both;
  }
  return *best;
}

void join(std::vector<Group>& groups, Join which) {
  Group& into = groups[which.into];
  Group& from = groups[which.from];
  // What is put aside gets no more of the room for being two.
  const bool kept = std::any_of(groups.begin(), groups.end(), [](const Group& group) { return group.in_sight; });
  const bool aside = kept && !into.in_sight && !from.in_sight;
  into.share = aside ? std::max(into.share, from.share) : into.share + from.share;
  into.panels += from.panels;
  into.least = std::max(into.least, from.least);
  if (from.in_sight && !into.in_sight) std::swap(into.tiles, from.tiles);
  // Two that both have to stay in sight and cannot are tabs like any others.
  into.in_sight = into.in_sight != from.in_sight;
  into.tiles.insert(into.tiles.end(), from.tiles.begin(), from.tiles.end());
  groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(which.from));
}

std::vector<Group> groups_of(Tile& tile, float room, const PlaceOptions& options) {
  const bool row = tile.kind == Tile::Kind::kRow;
  std::vector<Group> groups;
  for (std::size_t i = 0; i < tile.children.size(); ++i) {
    Tile& child = tile.children[i];
    if (child.hidden) continue;
    const InSight seen = in_sight_in(child);
    groups.push_back({{&child}, tile.shares[i], panels_of(child).size(), least_of(seen, row, options), seen.any()});
  }
  const auto fits = [&] {
    float needed = -options.gap;
    for (const Group& group : groups) needed += options.gap + group.least;
    return needed <= room;
  };
  while (groups.size() > 1 && !fits()) join(groups, join_of(groups));
  return groups;
}

// What each group gets of `room`: its share, but at least its least, at the cost of those that have more.
std::vector<float> sizes_of(const std::vector<Group>& groups, float room) {
  std::vector<float> sizes(groups.size(), 0.0F);
  std::vector<bool> held(groups.size(), false);
  float left = room;
  for (bool again = true; again;) {
    again = false;
    float shares = 0.0F;
    for (std::size_t i = 0; i < groups.size(); ++i) shares += held[i] ? 0.0F : groups[i].share;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (held[i]) continue;
      sizes[i] = left * groups[i].share / shares;
      if (sizes[i] >= groups[i].least || groups.size() == 1) continue;
      sizes[i] = groups[i].least;
      held[i] = again = true;
      left -= groups[i].least;
      break;
    }
  }
  return sizes;
}

void place_tabs(std::vector<PanelId> panels, const Rect& rect, Placement& out) {
  out.merged.push_back(std::make_unique<Tile>());
  out.merged.back()->panels = std::move(panels);
  out.tiles.push_back({out.merged.back().get(), rect, true});
}

// `joining` are panels of elsewhere that there is no other room for.
void place_into(Tile& tile, const Rect& rect, const PlaceOptions& options, const std::vector<PanelId>& joining,
                Placement& out);

void place_group(const Group& group, const Rect& rect, const PlaceOptions& options, const std::vector<PanelId>& joining,
                 Placement& out) {
  const bool one = group.in_sight || group.tiles.size() == 1;
  std::vector<PanelId> others;
  for (std::size_t i = one ? 1 : 0; i < group.tiles.size(); ++i) collect_panels(*group.tiles[i], others);
  others.insert(others.end(), joining.begin(), joining.end());
  if (one) return place_into(*group.tiles.front(), rect, options, others, out);
  place_tabs(std::move(others), rect, out);
}

// Beside the timeline rather than over the picture.
std::size_t joined_group(const std::vector<Group>& groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto& tiles = groups[i].tiles;
    const auto has_timeline = [](const Tile* tile) { return find_panel(*tile, PanelId::kTimeline) != nullptr; };
    if (std::any_of(tiles.begin(), tiles.end(), has_timeline)) return i;
  }
  return groups.size() - 1;
}

void place_into(Tile& tile, const Rect& rect, const PlaceOptions& options, const std::vector<PanelId>& joining,
                Placement& out) {
  if (tile.kind == Tile::Kind::kTabs) {
    if (joining.empty()) {
      out.tiles.push_back({&tile, rect, false});
      return;
    }
    std::vector<PanelId> panels = tile.panels;
    panels.insert(panels.end(), joining.begin(), joining.end());
    return place_tabs(std::move(panels), rect, out);
  }
  const bool row = tile.kind == Tile::Kind::kRow;
  const float gap = options.gap;
  const float whole = row ? rect.width() : rect.height();
  const std::vector<Group> groups = groups_of(tile, whole, options);
  const std::size_t joined = joined_group(groups);
  const auto count = groups.size();
  const auto apart =
      std::count_if(tile.children.begin(), tile.children.end(), [](const Tile& child) { return !child.hidden; });
  const std::vector<float> sizes = sizes_of(groups, whole - gap * static_cast<float>(count - 1));
  std::vector<float> edges{row ? rect.x0 : rect.y0};
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const float end = last ? (row ? rect.x1 : rect.y1) : std::round(edges.back() + sizes[i]);
    const Rect child = row ? Rect{edges.back(), rect.y0, end, rect.y1} : Rect{rect.x0, edges.back(), rect.x1, end};
    place_group(groups[i], child, options, i == joined ? joining : std::vector<PanelId>{}, out);
    edges.push_back(end + gap);
  }
  if (count < static_cast<std::size_t>(apart)) {
    // Shares of tiles that are not apart now cannot be dragged; the gaps between the groups stay gaps.
    return;
  }
  const int first = tile.children.front().hidden ? 1 : 0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const float low = edges[i + 1] - gap;
    const Rect bar = row ? Rect{low, rect.y0, low + gap, rect.y1} : Rect{rect.x0, low, rect.x1, low + gap};
    out.splitters.push_back({&tile, first + static_cast<int>(i), row, bar, edges[i], edges[i + 2] - gap});
  }
}

Json json_of(const Tile& tile) {
  Json json = Json::object();
  if (tile.kind == Tile::Kind::kTabs) {
    Json names = Json::array();
    for (const PanelId panel : tile.panels) names.push_back(std::string(title(panel)));
    json = {{"tabs", std::move(names)}, {"active", tile.active}};
  } else {
    Json children = Json::array();
    for (const Tile& child : tile.children) children.push_back(json_of(child));
    json = {{tile.kind == Tile::Kind::kRow ? "row" : "column", std::move(children)}, {"shares", tile.shares}};
  }
  if (tile.hidden) json["hidden"] = true;
  return json;
}

tl::unexpected<Error> no_layout(const std::string& why) {
  return fail(ErrorCode::kCorrupt, "the layout is broken: " + why);
}

Result<Tile> tabs_of(const Json& json, std::set<PanelId>& seen) {
  Tile tile;
  if (!json["tabs"].is_array() || json["tabs"].empty()) return no_layout("a tab group is empty");
  for (const Json& name : json["tabs"]) {
    const auto* found =
        name.is_string() ? std::find(kTitles.begin(), kTitles.end(), name.get<std::string>()) : kTitles.end();
    if (found == kTitles.end()) return no_layout("an unknown panel");
    const auto panel = static_cast<PanelId>(found - kTitles.begin());
    if (!seen.insert(panel).second) return no_layout("a panel twice");
    tile.panels.push_back(panel);
  }
  if (json.contains("active") && json["active"].is_number_integer()) tile.active = json["active"].get<int>();
  tile.active = std::clamp(tile.active, 0, static_cast<int>(tile.panels.size()) - 1);
  return tile;
}

Result<Tile> tile_of(const Json& json, std::set<PanelId>& seen, int depth) {
  if (!json.is_object() || depth > 16) return no_layout("no object, or too deep");
  if (json.contains("tabs")) return tabs_of(json, seen);
  const bool row = json.contains("row");
  if (!row && !json.contains("column")) return no_layout("neither row, column nor tabs");
  const Json& children = row ? json["row"] : json["column"];
  if (!children.is_array() || children.empty() || !json.contains("shares")) return no_layout("no children or shares");
  const Json& shares = json["shares"];
  if (!shares.is_array() || shares.size() != children.size()) return no_layout("shares do not fit the children");
  Tile tile;
  tile.kind = row ? Tile::Kind::kRow : Tile::Kind::kColumn;
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (!shares[i].is_number()) return no_layout("a share is no number");
    const float share = shares[i].get<float>();
    if (!(share > 0.0F) || share > 1.0F) return no_layout("a share is not between 0 and 1");
    tile.shares.push_back(share);
    TROCAR_ASSIGN_OR_RETURN(Tile child, tile_of(children[i], seen, depth + 1));
    const bool at_side = depth == 0 && row && (i == 0 || i + 1 == children.size());
    child.hidden = at_side && children[i].contains("hidden") && children[i]["hidden"] == true;
    tile.children.push_back(std::move(child));
  }
  if (std::all_of(tile.children.begin(), tile.children.end(), [](const Tile& child) { return child.hidden; }))
    tile.children.front().hidden = false;
  const float sum = std::accumulate(tile.shares.begin(), tile.shares.end(), 0.0F);
  for (float& share : tile.shares) share /= sum;
  return tile;
}

}  // namespace

std::string_view title(PanelId panel) {
  return kTitles[static_cast<std::size_t>(panel)];
}

const char* icon_of(PanelId panel) {
  return kIcons[static_cast<std::size_t>(panel)];
}

PanelId main_panel(Workspace workspace) {
  constexpr std::array<PanelId, kWorkspaceCount> kMain{PanelId::kLibrary,  PanelId::kTimeline, PanelId::kFields,
                                                       PanelId::kRollouts, PanelId::kTrials,   PanelId::kExport};
  return kMain[static_cast<std::size_t>(workspace)];
}

std::string_view title(Workspace workspace) {
  return kWorkspaceTitles[static_cast<std::size_t>(workspace)];
}

Placement place(Tile& root, const Rect& rect, const PlaceOptions& options) {
  Placement placement;
  place_into(root, rect, options, {}, placement);
  return placement;
}

void move_splitter(const PlacedSplitter& splitter, float position, float smallest) {
  const float room = splitter.end - splitter.begin;
  if (room <= 2.0F * smallest) return;
  // A neighbour at its least size may have a smaller share than it shows; both are set anew.
  const float at = std::clamp(position - splitter.begin, smallest, room - smallest) / room;
  float& first = splitter.parent->shares[static_cast<std::size_t>(splitter.index)];
  float& second = splitter.parent->shares[static_cast<std::size_t>(splitter.index) + 1];
  const float both = first + second;
  first = both * at;
  second = both - first;
}

void equalise(const PlacedSplitter& splitter) {
  std::vector<float>& shares = splitter.parent->shares;
  std::fill(shares.begin(), shares.end(), 1.0F / static_cast<float>(shares.size()));
}

Tile* find_panel(Tile& root, PanelId panel) {
  if (std::find(root.panels.begin(), root.panels.end(), panel) != root.panels.end()) return &root;
  for (Tile& child : root.children) {
    if (Tile* found = find_panel(child, panel)) return found;
  }
  return nullptr;
}

const Tile* find_panel(const Tile& root, PanelId panel) {
  return find_panel(const_cast<Tile&>(root),
                    panel);  // NOLINT(cppcoreguidelines-pro-type-const-cast): nothing is changed
}

std::vector<PanelId> panels_of(const Tile& root) {
  std::vector<PanelId> panels;
  collect_panels(root, panels);
  return panels;
}

bool same_places(const Tile& a, const Tile& b) {
  return a.kind == b.kind && a.hidden == b.hidden && a.panels == b.panels && a.shares == b.shares &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(), same_places);
}

std::string to_json(const Tile& root) {
  return json_of(root).dump();
}

Result<Tile> tile_from_json(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return no_layout("it is not JSON");
  std::set<PanelId> seen;
  TROCAR_ASSIGN_OR_RETURN(Tile root, tile_of(json, seen, 0));
  return root;
}

}  // namespace trocar::ui
