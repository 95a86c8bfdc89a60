#include "engine/demonstration/edit_spans.h"

#include <algorithm>
#include <optional>
#include <type_traits>

#include "engine/demonstration/clip.h"

namespace trocar::demonstration {
namespace {

constexpr double kSample_s = 1.0 / kSampleRate_hz;

/// A span that an edit worked on becomes `after_s` long; what follows moves.
struct Effect {
  double begin_s = 0.0;
  double end_s = 0.0;
  double after_s = 0.0;

  double moved(double t_s) const {
    if (t_s <= begin_s) return t_s;
    const double longer_s = after_s - (end_s - begin_s);
    return t_s >= end_s ? t_s + longer_s : std::min(t_s, begin_s + after_s);
  }
};

struct EffectOf {
  double length_s;  ///< Of all, before the edit.

  std::optional<Effect> operator()(const DeleteSpan& edit) const {
    const double end_s = std::min(edit.to_s, length_s);
    return Effect{edit.from_s, end_s, edit.ripple ? 0.0 : end_s - edit.from_s};
  }
  std::optional<Effect> operator()(const Splice& edit) const {
    const double end_s = std::max(edit.until_s, edit.at_s);
    double after_s = end_s - edit.at_s;
    if (edit.clip) after_s = Tick{edit.clip->samples.tick(edit.clip->samples.size() - 1)}.seconds() + kSample_s;
    return Effect{edit.at_s, end_s, after_s};
  }
  std::optional<Effect> operator()(const Overdub& edit) const {
    double span_s = edit.clip_to_s - edit.clip_from_s;
    if (edit.clip) span_s = Tick{edit.clip->samples.tick(edit.clip->samples.size() - 1)}.seconds() + kSample_s;
    return Effect{edit.at_s, edit.at_s + span_s, span_s};
  }
  std::optional<Effect> operator()(const Retime& edit) const {
    const double span_s = edit.to_s - edit.from_s;
    double after_s = span_s;
    if (edit.mode == RetimeTo::kScale) after_s = span_s * edit.scale;
    if (edit.mode == RetimeTo::kWarp && !edit.knots_s.empty()) {
      const Eigen::Vector2d& last = edit.knots_s.back();
      after_s = last.y() + std::max(edit.to_s - last.x(), 0.0) - edit.from_s;
    } else if (edit.mode == RetimeTo::kDuration) {
      after_s = edit.duration_s;
    } else {
      after_s += 0.5 * (edit.ease_in_s + edit.ease_out_s);
    }
    return Effect{edit.from_s, edit.to_s, after_s};
  }
  std::optional<Effect> operator()(const Trim&) const { return std::nullopt; }
  std::optional<Effect> operator()(const TrimIdle&) const { return std::nullopt; }

  /// What works on a span, about an instant, or on everything.
  template <typename Any>
  std::optional<Effect> operator()(const Any& edit) const {
    if constexpr (requires {
                    edit.from_s;
                    edit.to_s;
                  }) {
      return Effect{edit.from_s, edit.to_s, edit.to_s - edit.from_s};
    } else if constexpr (requires {
                           edit.at_s;
                           edit.radius_s;
                         }) {
      const double begin_s = std::max(edit.at_s - edit.radius_s, 0.0);
      const double end_s = std::min(edit.at_s + edit.radius_s, length_s);
      return Effect{begin_s, end_s, end_s - begin_s};
    } else {
      return Effect{0.0, length_s, length_s};
    }
  }
};

}  // namespace

std::vector<EditSpan> edit_spans(const Demonstration& document) {
  std::vector<EditSpan> spans;
  const SampleTrack& recorded = document.recorded;
  double length_s = recorded.empty() ? 0.0 : Tick{recorded.tick(recorded.size() - 1) - recorded.tick(0)}.seconds();
  for (const StackEntry& entry : *document.stack) {
    if (!entry.enabled || !entry.conflict.empty() || !stacks(*entry.edit)) continue;
    const std::optional<Effect> effect = std::visit(EffectOf{length_s}, *entry.edit);
    if (!effect) continue;
    for (EditSpan& span : spans) {
      span.begin_s = effect->moved(span.begin_s);
      span.end_s = effect->moved(span.end_s);
    }
    spans.push_back({entry.id, effect->begin_s, effect->begin_s + effect->after_s});
    length_s += effect->after_s - (effect->end_s - effect->begin_s);
  }
  return spans;
}

}  // namespace trocar::demonstration
