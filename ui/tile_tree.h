/// The layout of a workspace: a tree of rows, columns and tab groups that fills the window without gaps.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "ui/widgets/item_log.h"

namespace trocar::ui {

enum class PanelId : std::uint8_t {
  kLibrary,
  kView,
  kTimeline,
  kFields,
  kRollouts,
  kTrain,
  kInspector,
  kHistory,
  kJobs,
  kLog,
  kEdits,
  kProblems,
  kCurves,
  kDiff,
  kModels,
  kTrials,
  kExport,
};
constexpr std::size_t kPanelCount = 17;
/// "Library", as on its tab.
std::string_view title(PanelId panel);
const char* icon_of(PanelId panel);

/// The jobs of a day; each has a layout of its own.
enum class Workspace : std::uint8_t { kLibrary, kAuthor, kFields, kRollouts, kTrials, kExport };
constexpr std::size_t kWorkspaceCount = 6;
std::string_view title(Workspace workspace);
/// What it is there for.
PanelId main_panel(Workspace workspace);

struct Tile {
  enum class Kind : std::uint8_t { kRow, kColumn, kTabs };
  Kind kind = Kind::kTabs;
  std::vector<Tile> children;   ///< Of a row (left to right) or a column (top to bottom).
  std::vector<float> shares;    ///< One for each child, their sum is 1.
  std::vector<PanelId> panels;  ///< Of a tab group.
  int active = 0;               ///< The panel in front.
  /// Put away for now, with all that is in it. Only the first and the last child of a row that is the root can be, and
  /// never all of its children.
  bool hidden = false;
};
/// What lies where, whichever panels are in front.
bool same_places(const Tile& a, const Tile& b);

struct PlacedTile {
  Tile* tile = nullptr;
  Rect rect;
  bool merged = false;  ///< Made of several tab groups for want of room; `tile` is not in the tree.
};
struct PlacedSplitter {
  Tile* parent = nullptr;
  int index = 0;  ///< Between children `index` and `index` + 1.
  bool vertical = true;
  Rect rect;
  float begin = 0.0F;  ///< Where the two children begin and end, pixels.
  float end = 0.0F;
};
struct Placement {
  std::vector<PlacedTile> tiles;
  std::vector<PlacedSplitter> splitters;
  std::vector<std::unique_ptr<Tile>> merged;
};

/// All in pixels.
struct PlaceOptions {
  float gap = 4.0F;
  /// Of a tile; those that would get less become one tab group: first those beside the view and the timeline, which
  /// are the last to lose their own place. These two count where they are the first of a tab group.
  float least_width = 0.0F;
  float least_height = 0.0F;
  float least_timeline_width = 0.0F;   ///< Of what holds the timeline; at least `least_width`.
  float least_in_sight_height = 0.0F;  ///< Of the view above the timeline; 0: as of the others.
};

/// Where everything lies when the tree fills `rect`. Pointers are into `root` and into the placement.
Placement place(Tile& root, const Rect& rect, const PlaceOptions& options);
/// Moves a splitter to `position`; both neighbours keep at least `smallest` pixels.
void move_splitter(const PlacedSplitter& splitter, float position, float smallest);
/// Gives all children of the splitter's parent the same share.
void equalise(const PlacedSplitter& splitter);

/// The tab group that holds a panel, hidden or not; null if none.
Tile* find_panel(Tile& root, PanelId panel);
const Tile* find_panel(const Tile& root, PanelId panel);
std::vector<PanelId> panels_of(const Tile& root);
Tile default_layout(Workspace workspace);

std::string to_json(const Tile& root);
/// Errors: kCorrupt for what is no layout: an unknown panel, one twice, shares that do not
/// fit. Panels that are missing are closed.
Result<Tile> tile_from_json(std::string_view text);

}  // namespace trocar::ui
