#include <utility>

#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

std::shared_ptr<const demonstration::Demonstration> Workbench::Impl::shown() const {
  return state.preview && state.preview->after ? state.preview->after : demonstration(state.demonstration);
}

void Workbench::Impl::follow_filmstrip() {
  if (!view) return;
  const auto drawn = state.live ? nullptr : demonstration(state.demonstration);
  if (filmstrip.poll(drawn, state.light_backdrop, state.filmstrip)) dirty = true;
}

void Workbench::Impl::follow_curves() {
  CurvesRequest wanted;
  wanted.kinds = state.curve_kinds;
  if (wanted.kinds != 0 && !state.live) {
    wanted.shown = shown();
    if (state.preview && state.preview->after) wanted.before = state.preview->before;
  }
  const bool same = wanted.shown == curves_wanted.shown && wanted.before == curves_wanted.before &&
                    wanted.kinds == curves_wanted.kinds;
  if (!same) {
    curves_wanted = wanted;
    curves.request(std::move(wanted));
  }
  if (curves.update()) {
    state.curves = curves.answer();
    dirty = true;
  }
  state.curves_pending = curves.pending();
}

void Workbench::Impl::follow_comparison() {
  ComparisonRequest wanted;
  if (state.comparing && state.project && !state.live) {
    wanted.after = shown();
    wanted.settings = *state.comparing;
    wanted.settings.in_view = true;  // Whether it is drawn changes nothing of it.
  }
  // The other side follows from these; an undo of its edits shows in the project, which is another then.
  const bool same = wanted.after == comparison_wanted.after && wanted.settings == comparison_wanted.settings &&
                    compared_in == (wanted.after ? state.project : nullptr);
  if (!same) {
    comparison_wanted = wanted;
    compared_in = wanted.after ? state.project : nullptr;
    if (wanted.after) {
      const auto project_at = [this](std::int64_t node) { return file->project_at(node); };
      auto before = counterpart(*wanted.after, wanted.settings.against, *state.project, project_at);
      if (before) wanted.before = std::move(*before);
      if (!before) wanted.error = before.error().text();
    }
    comparison.request(std::move(wanted));
  }
  if (comparison.update()) {
    state.comparison = comparison.answer();
    dirty = true;
  }
  state.comparison_pending = comparison.pending();
}

void Workbench::Impl::follow_seeds() {
  SeedRequest wanted;
  wanted.count = state.learning.seeds;
  wanted.layer = state.field.layer;
  if (wanted.count > 0) wanted.entry = model(state.model);
  const bool same =
      wanted.entry == seeds_wanted.entry && wanted.layer == seeds_wanted.layer && wanted.count == seeds_wanted.count;
  if (!same) {
    seeds_wanted = wanted;
    seeds.request(std::move(wanted));
  }
  if (seeds.update()) {
    state.seeds = seeds.answer();
    dirty = true;
  }
  state.seeds_pending = seeds.pending();
}

void Workbench::Impl::on(const ShowCurves& command) {
  dirty = dirty || state.curve_kinds != command.kinds;
  state.curve_kinds = command.kinds;
}

void Workbench::Impl::on(const CompareWith& command) {
  state.comparing = command.settings;
  dirty = true;
}

void Workbench::Impl::on(const EndComparison&) {
  state.comparing.reset();
  state.comparison.reset();
  dirty = true;
}

}  // namespace trocar::workbench
