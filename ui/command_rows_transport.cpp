// Rows of the transport: playing, shuttling, stepping, looping.
#include <algorithm>
#include <cmath>

#include "engine/demonstration/events.h"
#include "ui/command_rows.h"
#include "ui/icons.h"
#include "ui/timeline_steps.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

constexpr double kFrame_s = 1.0 / 30.0;  // Of a video.

Requests go_to(double t_s) {
  return one(Command{SetPlayhead{t_s}});
}

Requests play(const State& state) {
  return one(Command{Play{state.play_speed == 0.0 ? 1.0 : 0.0}});
}

template <int direction>
Requests shuttle(const State& state) {
  return one(Command{Play{shuttled(state.play_speed, direction)}});
}

Requests stop(const State&) {
  return one(Command{Play{0.0}});
}

std::string not_playing(const State& state) {
  return state.play_speed == 0.0 ? "It does not play" : "";
}

template <int frames>
Requests step_frames(const State& state) {
  return go_to(state.playhead_s + frames * kFrame_s);
}

template <int steps>
Requests step_samples(const State& state) {
  return go_to(stepped(*selected_demonstration(state), state.playhead_s, steps));
}

template <int direction>
Requests step_event(const State& state) {
  return go_to(demonstration::next_event(*selected_demonstration(state), state.playhead_s, direction));
}

Requests to_begin(const State& state) {
  return go_to(selected_demonstration(state)->begin_s);
}

Requests to_end(const State& state) {
  return go_to(selected_demonstration(state)->end_s);
}

template <Loop loop>
Requests toggle_loop(const State& state) {
  return one(Command{SetLoop{state.loop == loop ? Loop::kOff : loop}});
}

Requests toggle_snapping(const State& state) {
  return one(Command{SetSnapping{!state.snapping}});
}

constexpr std::array<RowData, 18> kTransportRows{{
    {"transport.play",
     "Transport",
     "Play or pause",
     "Run the playhead in real time",
     icon::kPlay,
     {"Space"},
     false,
     no_demonstration,
     play},
    {"transport.shuttle_forward",
     "Transport",
     "Shuttle forward",
     "Play; once more: faster, up to 32 times",
     nullptr,
     {"L"},
     false,
     no_demonstration,
     shuttle<1>},
    {"transport.shuttle_back",
     "Transport",
     "Shuttle back",
     "Play backwards; once more: faster, up to 32 times",
     nullptr,
     {"J"},
     false,
     no_demonstration,
     shuttle<-1>},
    {"transport.stop", "Transport", "Stop", "Stay where the playhead is", nullptr, {"K"}, false, not_playing, stop},
    {"transport.forward",
     "Transport",
     "One sample forward",
     "5 ms",
     nullptr,
     {"Right"},
     false,
     no_demonstration,
     step_samples<1>},
    {"transport.back",
     "Transport",
     "One sample back",
     "5 ms",
     nullptr,
     {"Left"},
     false,
     no_demonstration,
     step_samples<-1>},
    {"transport.forward_10",
     "Transport",
     "Ten samples forward",
     "50 ms",
     nullptr,
     {"Shift+Right"},
     false,
     no_demonstration,
     step_samples<10>},
    {"transport.back_10",
     "Transport",
     "Ten samples back",
     "50 ms",
     nullptr,
     {"Shift+Left"},
     false,
     no_demonstration,
     step_samples<-10>},
    {"transport.next_event",
     "Transport",
     "Next event",
     "To the next segment, note, grasp or move of a gripper",
     nullptr,
     {"Ctrl+Right"},
     false,
     no_demonstration,
     step_event<1>},
    {"transport.last_event",
     "Transport",
     "Previous event",
     "To the segment, note, grasp or move of a gripper before",
     nullptr,
     {"Ctrl+Left"},
     false,
     no_demonstration,
     step_event<-1>},
    {"transport.begin",
     "Transport",
     "To the beginning",
     "To the in gate",
     icon::kToBegin,
     {"Home", "Shift+I"},
     false,
     no_demonstration,
     to_begin},
    {"transport.end",
     "Transport",
     "To the end",
     "To the out gate",
     icon::kToEnd,
     {"End", "Shift+O"},
     false,
     no_demonstration,
     to_end},
    {"transport.frame_forward",
     "Transport",
     "One frame forward",
     "A thirtieth of a second, as in a film",
     nullptr,
     {"."},
     true,
     no_demonstration,
     step_frames<1>},
    {"transport.frame_back",
     "Transport",
     "One frame back",
     "A thirtieth of a second, as in a film",
     nullptr,
     {","},
     false,
     no_demonstration,
     step_frames<-1>},
    {"transport.loop",
     "Transport",
     "Loop",
     "Play the selection, or all between the gates, again and again",
     icon::kLoop,
     {"Ctrl+L"},
     true,
     no_demonstration,
     toggle_loop<Loop::kSpan>},
    {"transport.loop_segment",
     "Transport",
     "Loop the segment",
     "Play the segment at the playhead again and again",
     icon::kLoop,
     {"Ctrl+Shift+L"},
     false,
     no_demonstration,
     toggle_loop<Loop::kSegment>},
    {"transport.snap",
     "Transport",
     "Snap",
     "What is dragged in time goes to events near it; Ctrl inverts",
     icon::kMagnet,
     {"N"},
     true,
     nullptr,
     toggle_snapping},
    {"transport.ruler",
     "Transport",
     "Next ruler unit",
     "Seconds, frames of a film (30 a second), or steps of the left tool on the lattice",
     icon::kSliders,
     {"Shift+N"},
     false,
     nullptr,
     act<UiAction::kNextRuler>},
}};

}  // namespace

std::span<const RowData> transport_rows() {
  return kTransportRows;
}

}  // namespace trocar::ui
