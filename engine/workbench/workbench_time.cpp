// The workbench in time: playhead, playing, looping, selection, clipboard.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

void Workbench::Impl::on(const SetPlayhead& command) {
  const auto shown = demonstration(state.demonstration);
  const double wanted_s = std::isfinite(command.t_s) ? command.t_s : 0.0;
  state.playhead_s = shown ? std::clamp(wanted_s, shown->begin_s, shown->end_s) : 0.0;
  dirty = true;
}

void Workbench::Impl::on(const Play& command) {
  const auto shown = demonstration(state.demonstration);
  if (!shown || !std::isfinite(command.speed)) return;
  state.play_speed = std::clamp(command.speed, -50.0, 50.0);
  // From the end, play means once more from the beginning; backwards the other way round.
  if (state.play_speed > 0.0 && state.playhead_s >= shown->end_s) on(SetPlayhead{shown->begin_s});
  if (state.play_speed < 0.0 && state.playhead_s <= shown->begin_s) on(SetPlayhead{shown->end_s});
  dirty = true;
}

void Workbench::Impl::on(const ShowEdges& command) {
  state.edges = command.edges;
  dirty = true;
}

void Workbench::Impl::on(const SetSelection& command) {
  const auto shown = demonstration(state.demonstration);
  state.selection = shown && command.span ? kept_within(*shown, *command.span) : std::nullopt;
  dirty = true;
}

void Workbench::Impl::on(const CopyRun& command) {
  const auto shown = demonstration(command.demonstration);
  const auto span = shown ? kept_within(*shown, command.span) : std::nullopt;
  if (!span) return log(Severity::kWarning, "There is nothing to copy");
  state.clipboard = copied(*shown, *span, state.head);
  tell(fmt::format("Copied {:.2f}–{:.2f} s of {}", span->begin_s, span->end_s, shown->name));
}

void Workbench::Impl::on(const SetSnapping& command) {
  state.snapping = command.on;
  tell(command.on ? "Snapping is on" : "Snapping is off");
}

void Workbench::Impl::on(const SetLoop& command) {
  state.loop = command.loop;
  tell(command.loop == Loop::kOff       ? "Playing ends at the gate"
       : command.loop == Loop::kSegment ? "The segment at the playhead is played again and again"
                                        : "What is selected, or all, is played again and again");
}

void Workbench::Impl::tell(std::string sentence) {
  state.done = sentence;
  log(Severity::kInfo, std::move(sentence));
}

void Workbench::Impl::follow(const demonstration::Edit& edit, const demonstration::Demonstration& before,
                             const demonstration::Demonstration& after) {
  if (const auto* deleted = std::get_if<demonstration::DeleteSpan>(&edit)) {
    on(SetPlayhead{deleted->from_s});
    // A gap that was left is what one bridges next.
    if (deleted->ripple) on(SetSelection{});
  }
  if (const auto* splice = std::get_if<demonstration::Splice>(&edit)) {
    const double longer_s = after.full_duration_s() - before.full_duration_s();
    const double until_s = std::max(splice->until_s, splice->at_s);
    on(SetSelection{});
    on(SetPlayhead{until_s + longer_s});
  }
}

std::optional<TimeSpan> Workbench::Impl::looped() const {
  const auto shown = demonstration(state.demonstration);
  if (!shown || state.loop == Loop::kOff) return std::nullopt;
  if (state.loop == Loop::kSpan) return state.selection.value_or(TimeSpan{shown->begin_s, shown->end_s});
  for (const demonstration::SegmentSpan& span : shown->segments) {
    if (state.playhead_s < span.begin_s || state.playhead_s >= span.end_s) continue;
    return kept_within(*shown, {span.begin_s, span.end_s});
  }
  return std::nullopt;
}

void Workbench::Impl::advance_playhead(double elapsed_s) {
  if (state.play_speed == 0.0) return;
  const auto shown = demonstration(state.demonstration);
  if (!shown) return;
  const std::optional<TimeSpan> loop = looped();
  double t_s = state.playhead_s + state.play_speed * elapsed_s;
  if (loop && (t_s >= loop->end_s || t_s < loop->begin_s)) {
    // A long frame may pass the whole loop: where in it one is does not matter then.
    const double over_s = std::fmod(t_s - loop->begin_s, loop->length_s());
    t_s = loop->begin_s + (over_s < 0.0 ? over_s + loop->length_s() : over_s);
  } else if (t_s >= shown->end_s || t_s < shown->begin_s) {
    state.play_speed = 0.0;
  }
  on(SetPlayhead{t_s});
}

}  // namespace trocar::workbench
