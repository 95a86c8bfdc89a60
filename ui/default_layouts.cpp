// Where everything lies in each workspace, to begin with.
#include <utility>
#include <vector>

#include "ui/tile_tree.h"

namespace trocar::ui {
namespace {

Tile tabs(std::vector<PanelId> panels) {
  Tile tile;
  tile.panels = std::move(panels);
  return tile;
}

Tile split(Tile::Kind kind, std::vector<float> shares, std::vector<Tile> children) {
  Tile tile;
  tile.kind = kind;
  tile.shares = std::move(shares);
  tile.children = std::move(children);
  return tile;
}

}  // namespace

Tile default_layout(Workspace workspace) {
  using enum PanelId;
  constexpr auto row = Tile::Kind::kRow;
  constexpr auto column = Tile::Kind::kColumn;
  switch (workspace) {
    case Workspace::kLibrary:
      return split(row, {0.52F, 0.48F},
                   {split(column, {0.72F, 0.28F}, {tabs({kLibrary}), tabs({kHistory, kProblems, kJobs, kLog})}),
                    split(column, {0.52F, 0.48F},
                          {tabs({kView}), tabs({kInspector, kEdits, kTrain, kTimeline, kCurves, kDiff, kFields, kModels,
                                                kRollouts, kTrials, kExport})})});
    case Workspace::kAuthor:
      return split(row, {0.245F, 0.515F, 0.24F},
                   {split(column, {0.64F, 0.36F}, {tabs({kLibrary}), tabs({kHistory, kProblems, kJobs, kLog})}),
                    split(column, {0.54F, 0.46F}, {tabs({kView}), tabs({kTimeline, kCurves, kDiff})}),
                    tabs({kInspector, kEdits, kTrain, kFields, kModels, kRollouts, kTrials, kExport})});
    case Workspace::kFields:
      return split(row, {0.235F, 0.405F, 0.36F},
                   {split(column, {0.6F, 0.4F},
                          {tabs({kLibrary}), tabs({kTrain, kInspector, kEdits, kHistory, kProblems, kJobs, kLog})}),
                    split(column, {0.66F, 0.34F}, {tabs({kView}), tabs({kTimeline, kCurves, kDiff})}),
                    tabs({kFields, kModels, kRollouts, kTrials, kExport})});
    case Workspace::kRollouts:
      return split(row, {0.235F, 0.385F, 0.38F},
                   {split(column, {0.6F, 0.4F},
                          {tabs({kLibrary}), tabs({kTrain, kInspector, kEdits, kHistory, kProblems, kJobs, kLog})}),
                    split(column, {0.66F, 0.34F}, {tabs({kView}), tabs({kTimeline, kCurves, kDiff})}),
                    tabs({kRollouts, kFields, kModels, kTrials, kExport})});
    case Workspace::kTrials:
      return split(row, {0.20F, 0.46F, 0.34F},
                   {split(column, {0.6F, 0.4F}, {tabs({kLibrary}), tabs({kHistory, kProblems, kJobs, kLog, kTrain})}),
                    split(column, {0.66F, 0.34F}, {tabs({kView}), tabs({kTimeline, kCurves, kDiff})}),
                    tabs({kTrials, kInspector, kEdits, kFields, kModels, kRollouts, kExport})});
    case Workspace::kExport:
      return split(row, {0.20F, 0.44F, 0.36F},
                   {split(column, {0.6F, 0.4F}, {tabs({kLibrary}), tabs({kJobs, kHistory, kProblems, kLog, kTrain})}),
                    split(column, {0.66F, 0.34F}, {tabs({kView}), tabs({kTimeline, kCurves, kDiff})}),
                    tabs({kExport, kTrials, kInspector, kEdits, kFields, kModels, kRollouts})});
  }
  return tabs({kView});
}

}  // namespace trocar::ui
