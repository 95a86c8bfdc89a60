#include "engine/demonstration/demonstration.h"

#include <algorithm>
#include <utility>

#include "engine/core/check.h"
#include "engine/core/hash.h"

namespace trocar::demonstration {
namespace {

/// Times are whole ticks divided by 1000; a gate typed as a decimal may differ from them in the last bit.
constexpr double kTimeTolerance_s = 1e-9;

std::vector<SegmentSpan> recorded_spans(const Demonstration& document) {
  std::vector<SegmentSpan> spans;
  for (const Sample& sample : *document.samples) {
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
  return Tick{sample.tick - recording->samples.front().tick}.seconds();
}

double Demonstration::full_duration_s() const {
  return time_of(samples->back());
}

std::span<const Sample> Demonstration::gated() const {
  const auto first = std::partition_point(samples->begin(), samples->end(), [&](const Sample& sample) {
    return time_of(sample) < begin_s - kTimeTolerance_s;
  });
  const auto last = std::partition_point(
      first, samples->end(), [&](const Sample& sample) { return time_of(sample) <= end_s + kTimeTolerance_s; });
  return {first, last};
}

const Sample& Demonstration::sample_at(double t_s) const {
  const std::span<const Sample> inside = gated();
  TROCAR_CHECK(!inside.empty());
  const auto after = std::partition_point(
      inside.begin(), inside.end(), [&](const Sample& sample) { return time_of(sample) <= t_s + kTimeTolerance_s; });
  return after == inside.begin() ? inside.front() : *(after - 1);
}

std::optional<SegmentSpan> Demonstration::segment(Segment label) const {
  for (const SegmentSpan& span : segments) {
    const SegmentSpan cut{span.label, std::max(span.begin_s, begin_s), std::min(span.end_s, end_s)};
    if (span.label == label && cut.begin_s < cut.end_s) return cut;
  }
  return std::nullopt;
}

std::span<const Sample> Demonstration::samples_in(const SegmentSpan& span) const {
  const std::span<const Sample> inside = gated();
  const auto before = [&](double limit_s) {
    return [this, limit_s](const Sample& sample) { return time_of(sample) < limit_s - kTimeTolerance_s; };
  };
  const auto first = std::partition_point(inside.begin(), inside.end(), before(span.begin_s));
  const bool to_the_end = !inside.empty() && span.end_s >= time_of(inside.back()) - kTimeTolerance_s;
  const auto last = to_the_end ? inside.end() : std::partition_point(first, inside.end(), before(span.end_s));
  return {first, last};
}

std::uint64_t Demonstration::hash() const {
  Hasher hasher;
  hasher.value(samples_hash != 0 ? samples_hash : hash_of(*samples)).value(begin_s).value(end_s);
  hasher.value(segments.size());
  for (const SegmentSpan& span : segments) hasher.value(span.label).value(span.begin_s).value(span.end_s);
  return hasher.digest();
}

Result<Demonstration> make_demonstration(DemonstrationId id, std::string name,
                                         std::shared_ptr<const Recording> recording) {
  if (recording == nullptr || recording->samples.size() < 2) {
    return fail(ErrorCode::kInvalidArgument, "a demonstration needs at least 2 samples");
  }
  TROCAR_RETURN_IF_ERROR(check_samples(recording->samples));
  Demonstration document;
  document.id = id;
  document.name = std::move(name);
  document.samples = std::shared_ptr<const std::vector<Sample>>(recording, &recording->samples);
  document.samples_hash = hash_of(recording->samples);
  document.recording = std::move(recording);
  document.end_s = document.full_duration_s();
  document.segments = recorded_spans(document);
  return document;
}

}  // namespace trocar::demonstration
