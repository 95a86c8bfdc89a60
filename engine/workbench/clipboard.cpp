#include "engine/workbench/clipboard.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::workbench {
namespace {

using demonstration::Demonstration;

constexpr double kSample_s = 1.0 / demonstration::kSampleRate_hz;

/// The indices of the samples that a span means; the second is after the last.
std::pair<std::size_t, std::size_t> samples_of(const Demonstration& shown, const TimeSpan& span) {
  const std::int64_t end = span.end_s >= shown.end_s ? shown.tick_after(shown.end_s) : shown.tick_from(span.end_s);
  return {shown.samples.lower_bound(shown.tick_from(span.begin_s)), shown.samples.lower_bound(end)};
}

/// Where the next sample would be after `index`.
double after(const Demonstration& shown, std::size_t index) {
  return Tick{shown.samples.tick(index) - shown.first_tick()}.seconds() + kSample_s;
}

}  // namespace

std::optional<TimeSpan> kept_within(const Demonstration& shown, const TimeSpan& span) {
  if (!std::isfinite(span.begin_s) || !std::isfinite(span.end_s)) return std::nullopt;
  const auto kept = [&](double t_s) { return std::clamp(t_s, shown.begin_s, shown.end_s); };
  const TimeSpan within{kept(std::min(span.begin_s, span.end_s)), kept(std::max(span.begin_s, span.end_s))};
  const auto [first, last] = samples_of(shown, within);
  if (within.length_s() <= 0.0 || first >= last) return std::nullopt;
  return within;
}

Clipboard copied(const Demonstration& source, const TimeSpan& span, std::int64_t as_of) {
  const auto [first, last] = samples_of(source, span);
  return {source.id, source.name, source.time_of(source.samples[first]), source.time_of(source.samples[last - 1]),
          as_of};
}

Result<demonstration::Edit> deletion(const Demonstration& shown, const TimeSpan& span, bool ripple) {
  const auto [first, last] = samples_of(shown, span);
  const std::size_t gate_first = shown.samples.lower_bound(shown.tick_from(shown.begin_s));
  const std::size_t gate_last = shown.samples.lower_bound(shown.tick_after(shown.end_s));
  const auto staying = static_cast<std::int64_t>(gate_last - gate_first) - static_cast<std::int64_t>(last - first);
  if (staying < 2) return fail(ErrorCode::kInvalidArgument, "nothing would stay of " + shown.name);
  if (last >= gate_last) {
    return demonstration::Edit(demonstration::Trim{shown.begin_s, after(shown, first - 1) - kSample_s});
  }
  if (first <= gate_first && !ripple) {
    return demonstration::Edit(demonstration::Trim{after(shown, last) - kSample_s, shown.end_s});
  }
  return demonstration::Edit(demonstration::DeleteSpan{span.begin_s, span.end_s, ripple});
}

demonstration::Splice paste(const Clipboard& clipboard, const Demonstration& into, double playhead_s,
                            const std::optional<TimeSpan>& selection, demonstration::Align align) {
  demonstration::Splice splice;
  splice.source = clipboard.source.value;
  splice.clip_from_s = clipboard.from_s;
  splice.clip_to_s = clipboard.to_s;
  splice.as_of = clipboard.as_of;
  splice.align = align;
  const auto past_gate = [&](double t_s) { return t_s >= into.end_s ? into.end_s + kSample_s : t_s; };
  splice.at_s = selection ? selection->begin_s : past_gate(playhead_s);
  if (selection) splice.until_s = past_gate(selection->end_s);
  return splice;
}

}  // namespace trocar::workbench
