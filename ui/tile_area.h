/// The tiles of a workspace on screen: panels behind tabs, bars between them, and tabs that are dragged elsewhere.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ui/panel.h"
#include "ui/tile_moves.h"

namespace trocar::ui {

/// Threads: that of the window.
class TileArea {
 public:
  /// `time` is what panels over time show; they share it.
  explicit TileArea(const std::shared_ptr<SharedTime>& time);

  /// Draws the layout into `rect`, or one panel of it. Moves its bars and fronts; asks for everything else.
  void draw(Ui& ui, const WorkbenchState& state, const Rect& rect, Tile& layout, Requests& requests);
  void bring_to_front(Tile& layout, PanelId panel);
  /// Where tab groups become one for want of room, it is in front until another is brought there; only the view comes
  /// before it.
  void favour(PanelId panel);
  Panel& panel(PanelId which) { return *panels_[static_cast<std::size_t>(which)]; }
  const Panel& panel(PanelId which) const { return *panels_[static_cast<std::size_t>(which)]; }

  /// The panel that the keyboard is in, else that under the pointer, else the last one.
  PanelId current(const Ui& ui) const;
  bool dragging() const { return dragged_.has_value(); }
  const std::optional<PanelId>& maximised() const { return maximised_; }
  void maximise(std::optional<PanelId> panel) { maximised_ = panel; }

 private:
  /// Where a tab can be dropped.
  struct Ground {
    Rect strip;
    Rect body;
    std::vector<PanelId> panels;
    std::vector<Rect> tabs;  ///< In the order of the panels.
  };
  struct Drop {
    DropPlace place;
    Rect preview;
  };
  void draw_tile(Ui& ui, const WorkbenchState& state, const PlacedTile& placed, Tile& layout, Requests& requests);
  void draw_tabs(Ui& ui, const Tile& tile, const Rect& rect, Tile& layout, Requests& requests);
  void draw_splitters(Ui& ui, const Placement& placement) const;
  void follow_drag(Ui& ui, const Tile& layout, Requests& requests);
  std::optional<Drop> drop_at(const Ui& ui, ImVec2 mouse) const;
  void choose_front(Tile& tile) const;

  std::array<std::unique_ptr<Panel>, kPanelCount> panels_;
  std::array<std::uint64_t, kPanelCount> fronted_{};  ///< The larger, the later a panel was brought to the front.
  std::uint64_t front_counter_ = 1;
  PanelId pointed_ = PanelId::kView;  ///< Under the mouse.
  std::optional<PanelId> maximised_;
  std::vector<Ground> grounds_;
  std::optional<PanelId> dragged_;
  bool drag_cancelled_ = false;  ///< Until the button is released.
};

}  // namespace trocar::ui
