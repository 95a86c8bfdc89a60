#include "ui/panel_pages.h"

#include <algorithm>

namespace trocar::ui {
namespace {

constexpr PanelPage kLibrary{
    "Demonstrations and models of the project",
    "Click one to work on it: all other panels follow. A model whose demonstration was edited since it was learned "
    "says "
    "that it is stale. In the workspace Library the table has a column for each number.",
    {"demo.record", "demo.verify", "model.train", "edit.copy_demonstration", "edit.remove_", "file."},
    {}};
constexpr PanelPage kView{
    "The peg board, the blocks and both arms in 3-D",
    "It shows the instant at the playhead, the path of the tools, and the field and paths of a model. A tool that is "
    "taken "
    "in hand has handles: drag one, or name an axis and type how far.",
    {"tool.", "view.camera_", "view.field", "view.ghosts", "view.comparison"},
    {{{"Turn the view", "Left drag"},
      {"Shift the view", "Right or middle drag"},
      {"Zoom", "Wheel, at the pointer"},
      {"Move or turn a tool", "Drag a handle in the view; Ctrl: whole steps, wheel: reach, Esc cancels"}}}};
constexpr PanelPage kTimeline{
    "The demonstration over time, lane by lane",
    "Segments, who leads, pedals, jaws, what is held, notes and problems lie one below the other. The gates at the "
    "ends "
    "trim without losing what was recorded; a span that is selected can be cut, copied and pasted.",
    {"transport.", "select.", "edit."},
    {{{"Trim", "Drag a gate; Esc cancels"},
      {"Select time", "Drag over the lanes"},
      {"Zoom to a span", "Middle drag"},
      {"Zoom in time", "Wheel, at the pointer"}}}};
constexpr PanelPage kFields{
    "What a model has learned, cell by cell",
    "Reward, value, Q, visits and what follows from them, as slices through the lattice of 22 cells a side. The probe "
    "tells all numbers of one cell.",
    {"view.field", "file.export_field", "model.train"},
    {{{"Step a slice", "Wheel over it"},
      {"Thicker slice", "Shift+wheel over it"},
      {"One slice alone", "X, Y, Z"},
      {"Probe a cell", "Click it"},
      {"Pin a cell", "Shift+click it"},
      {"Shape what a cloud hides", "Drag a knot of its curve; double-click: a new one, or this one away"},
      {"Copy cells as CSV", "Ctrl+C"}}}};
constexpr PanelPage kRollouts{
    "What the agent does from every start",
    "How many starts arrive, loop or end nowhere: all cells, those near the expert's start, or cells that are painted. "
    "One rollout is picked out by the map, the table or the small pictures; if it fails, it is said why, and a "
    "demonstration that puts it right can be begun there. The agent can err at random, and be driven through the "
    "simulator. All play together: by steps, or by the share of their ways, which plays their segment from 0 to 100 %. "
    "Each page can be written as a figure, and all rollouts as a table.",
    {"view.ghosts", "model.train"},
    {{{"Select a start", "Click it in the map, the table or the pictures, or its line across the measures"},
      {"Keep a range of a measure", "Drag along its axis; a click lets go"},
      {"Play all rollouts, on the page Paths", "Space, the pointer over the panel"},
      {"Paint starts", "Drag over the map; Erase takes them away"},
      {"Step through the map", "Wheel over it"}}}};
constexpr PanelPage kTrain{
    "Learns a model from demonstrations",
    "Choose demonstrations, segment and method; the training is a job, and the window can be used meanwhile.",
    {"model.train"},
    {}};
constexpr PanelPage kModels{
    "Two models beside each other",
    "Model A is the selected one. The slices share their scale and move together; Difference shows B less A, Policy "
    "where "
    "the greedy action is another, Outcomes which starts arrive with which. The table has what both measure.",
    {"model.train"},
    {{{"Step a slice", "Wheel over it"}, {"Move the border", "Drag it, in Swipe"}}}};
constexpr PanelPage kInspector{
    "All about what is selected",
    "Names and notes can be typed here; lengths, segments and where a recording comes from can be read.",
    {"edit.copy_demonstration", "edit.remove_", "demo.verify"},
    {}};
constexpr PanelPage kHistory{"Every state that the project has been in",
                             "Click one to go there. An edit after an undo begins a branch; nothing is ever thrown "
                             "away, and the history is there "
                             "again when the project is next opened.",
                             {"edit.undo", "edit.redo"},
                             {}};
constexpr PanelPage kJobs{
    "What runs, and what has run",
    "Trainings, films and checks with their progress; each can be cancelled and then leaves nothing behind.",
    {"model.train", "file.export_video", "demo.verify", "demo.simulate"},
    {}};
constexpr PanelPage kLog{"Everything that was reported", "Warnings and errors, oldest first, with the time.", {}, {}};
constexpr PanelPage kEdits{"The edits that led from the recording to what is shown",
                           "Each can be switched off, moved, changed or removed afterwards; a new one is chosen from "
                           "the list and shown before it "
                           "is made.",
                           {"edit."},
                           {}};
constexpr PanelPage kProblems{"What is wrong with the demonstration",
                              "Collisions, joints, speeds, gaps and labels, followed while one edits. A click goes to "
                              "the place; what has a quick "
                              "fix is mended by an ordinary edit.",
                              {"demo.problems", "demo.fix_all", "demo.simulate"},
                              {}};
constexpr PanelPage kCurves{
    "Position, speed, acceleration, jerk and jaw over time",
    "Of both arms, with limits, problems and what was before an edit. It shares the time that the timeline shows.",
    {"view.curves", "transport."},
    {{{"Zoom in time", "Wheel, at the pointer"}}}};
constexpr PanelPage kDiff{"Compares the demonstration with its original, its past or another one",
                          "Matched by time, arc length, warping or segment; the deviation is shown as numbers, over "
                          "time, and as whiskers in the "
                          "view.",
                          {"view.diff", "view.comparison"},
                          {}};

constexpr PanelPage kTrials{
    "Manual and shared-control trials",
    "Blocks of transfers by a script or a person, each arm behind the guard; the agent moves in A and C while its "
    "pedal is "
    "held. Every trial stays with its record, replays to the bit, and is compared with the others on the page Results.",
    {"trials."},
    {{{"Stop, at once", "Esc, or the red button: a soft stop"},
      {"Let the agent run", "Hold Space"},
      {"Move the left tool", "W S A D Q E; Z X turn it"},
      {"Open or shut its jaws", "C"}}}};

constexpr PanelPage kExport{
    "Films: what is in them, how they look, and the queue",
    "Sources are demonstrations, trials, fields of models and curves; each recording has its camera, which goes by "
    "keys "
    "taken from the 3-D view. The picture is a frame of the film as it will be. The film is kept as a job in a file, "
    "which the command line renders to the same frames; films wait in the queue, can be held there, and leave no half "
    "file when they are given up.",
    {"view.export", "film.", "file.export_video"},
    {}};

}  // namespace

const PanelPage& page_of(PanelId panel) {
  switch (panel) {
    case PanelId::kLibrary:
      return kLibrary;
    case PanelId::kView:
      return kView;
    case PanelId::kTimeline:
      return kTimeline;
    case PanelId::kFields:
      return kFields;
    case PanelId::kRollouts:
      return kRollouts;
    case PanelId::kTrain:
      return kTrain;
    case PanelId::kInspector:
      return kInspector;
    case PanelId::kHistory:
      return kHistory;
    case PanelId::kJobs:
      return kJobs;
    case PanelId::kLog:
      return kLog;
    case PanelId::kEdits:
      return kEdits;
    case PanelId::kProblems:
      return kProblems;
    case PanelId::kCurves:
      return kCurves;
    case PanelId::kModels:
      return kModels;
    case PanelId::kTrials:
      return kTrials;
    case PanelId::kExport:
      return kExport;
    case PanelId::kDiff:
      return kDiff;
  }
  return kLog;
}

std::vector<const CommandRow*> commands_of(const PanelPage& page) {
  std::vector<const CommandRow*> rows;
  for (const CommandRow& row : command_table()) {
    const bool named = std::any_of(page.commands.begin(), page.commands.end(), [&](std::string_view name) {
      if (name.empty()) return false;
      return row.id == name || ((name.ends_with('.') || name.ends_with('_')) && row.id.starts_with(name));
    });
    if (named) rows.push_back(&row);
  }
  return rows;
}

std::vector<MouseHelp> all_mouse_help() {
  std::vector<MouseHelp> all;
  const auto add = [&all](const MouseHelp& help) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const MouseHelp& one) { return one.act == help.act; });
    if (!help.act.empty() && !known) all.push_back(help);
  };
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    for (const MouseHelp& help : page_of(static_cast<PanelId>(i)).mouse) add(help);
  }
  add({"Move a panel", "Drag its tab to other tabs, or to the edge of a tile to split it; Esc cancels"});
  add({"Close a panel", "Middle click on its tab"});
  add({"Share room evenly", "Double click between two tiles"});
  return all;
}

}  // namespace trocar::ui
