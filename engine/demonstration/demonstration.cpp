#include "engine/demonstration/demonstration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/check.h"
#include "engine/core/hash.h"

namespace trocar::demonstration {
namespace {

/// In ticks, kept where a whole number can hold it.
double ticks(double t_s) {
  return std::clamp(t_s, -1e9, 1e9) * static_cast<double>(Tick::kPerSecond);
}

std::vector<SegmentSpan> recorded_spans(const Demonstration& document) {
  std::vector<SegmentSpan> spans;
  for (const Sample& sample : document.samples) {
    const double t_s = document.time_of(sample);
    if (!spans.empty() && spans.back().label == sample.segment) continue;
    if (!spans.empty()) spans.back().end_s = t_s;
    spans.push_back({sample.segment, t_s, document.end_s});
  }
  // A label that only the very last sample has covers no time.
  if (spans.back().begin_s >= spans.back().end_s) spans.pop_back();
  return spans;
}

}  // namespace

double Demonstration::time_of(const Sample& sample) const {
  return Tick{sample.tick - first_tick()}.seconds();
}

double Demonstration::full_duration_s() const {
  return samples.empty() ? 0.0 : Tick{samples.tick(samples.size() - 1) - first_tick()}.seconds();
}

std::int64_t Demonstration::first_tick() const {
  return recorded.tick(0);
}

std::int64_t Demonstration::tick_from(double t_s) const {
  return first_tick() + static_cast<std::int64_t>(std::ceil(ticks(t_s - kTimeTolerance_s)));
}

std::int64_t Demonstration::tick_after(double t_s) const {
  return first_tick() + static_cast<std::int64_t>(std::floor(ticks(t_s + kTimeTolerance_s))) + 1;
}

SampleTrack Demonstration::gated() const {
  return samples_within(begin_s, end_s);
}

SampleTrack Demonstration::samples_within(double from_s, double to_s) const {
  const std::size_t first = samples.lower_bound(tick_from(from_s));
  const std::size_t last = samples.lower_bound(tick_after(to_s));
  return samples.slice(first, last > first ? last - first : 0);
}

Sample Demonstration::sample_at(double t_s) const {
  const SampleTrack inside = gated();
  TROCAR_CHECK(!inside.empty());
  const std::size_t after = inside.lower_bound(tick_after(t_s));
  return inside[after == 0 ? 0 : after - 1];
}

std::optional<SegmentSpan> Demonstration::segment(Segment label) const {
  for (const SegmentSpan& span : segments) {
    const SegmentSpan cut{span.label, std::max(span.begin_s, begin_s), std::min(span.end_s, end_s)};
    if (span.label == label && cut.begin_s < cut.end_s) return cut;
  }
  return std::nullopt;
}

SampleTrack Demonstration::samples_in(const SegmentSpan& span) const {
  const SampleTrack inside = gated();
  const std::size_t first = inside.lower_bound(tick_from(span.begin_s));
  const bool to_the_end = !inside.empty() && tick_from(span.end_s) >= inside.tick(inside.size() - 1);
  const std::size_t last = to_the_end ? inside.size() : inside.lower_bound(tick_from(span.end_s));
  return inside.slice(first, last > first ? last - first : 0);
}

std::uint64_t Demonstration::hash() const {
  Hasher hasher;
  hasher.value(samples.hash()).value(begin_s).value(end_s);
  hasher.value(segments.size());
  for (const SegmentSpan& span : segments) hasher.value(span.label).value(span.begin_s).value(span.end_s);
  return hasher.digest();
}

bool Demonstration::motion_edited() const {
  return !samples.same_pieces(recorded) && samples.hash() != recorded.hash();
}

Demonstration original_of(const Demonstration& document) {
  Demonstration original;
  original.id = document.id;
  original.name = document.name;
  original.recording = document.recording;
  original.recorded = document.recorded;
  original.samples = document.recorded;
  original.block = document.recording->provenance.block;
  original.goal = document.recording->provenance.goal;
  original.end_s = original.full_duration_s();
  original.segments = recorded_spans(original);
  return original;
}

Demonstration make_demonstration(DemonstrationId id, std::string name, std::shared_ptr<const RecordingInfo> recording,
                                 SampleTrack recorded) {
  Demonstration document;
  document.id = id;
  document.name = std::move(name);
  document.recorded = std::move(recorded);
  document.recording = std::move(recording);
  return original_of(document);
}

Result<Demonstration> make_demonstration(DemonstrationId id, std::string name,
                                         std::shared_ptr<const Recording> recording) {
  if (recording == nullptr || recording->samples.size() < 2) {
    return fail(ErrorCode::kInvalidArgument, "a demonstration needs at least 2 samples");
  }
  TROCAR_RETURN_IF_ERROR(check_samples(recording->samples));
  return make_demonstration(id, std::move(name), std::make_shared<const RecordingInfo>(*recording),
                            SampleTrack(recording->samples));
}

}  // namespace trocar::demonstration
