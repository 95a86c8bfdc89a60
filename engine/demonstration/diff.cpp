#include "engine/demonstration/diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"

namespace trocar::demonstration {
namespace {

class Deviation {
 public:
  void add(double left_m, double right_m) {
    const double worst_m = std::max(left_m, right_m);
    if (worst_m > kUnmoved_m) ++moved_;
    max_m_ = std::max(max_m_, worst_m);
    square_sum_ += left_m * left_m + right_m * right_m;
    count_ += 2;
  }
  void write(Difference& difference) const {
    difference.moved = moved_;
    difference.max_deviation_m = max_m_;
    difference.rms_deviation_m = count_ == 0 ? 0.0 : std::sqrt(square_sum_ / static_cast<double>(count_));
  }

 private:
  int moved_ = 0;
  double max_m_ = 0.0;
  double square_sum_ = 0.0;
  long count_ = 0;
};

/// How far a tip is from the way that it took between `low` and `high`.
double off_way_m(const Sample& sample, const Sample& low, const Sample& high, std::size_t arm) {
  const double share = static_cast<double>(sample.tick - low.tick) / static_cast<double>(high.tick - low.tick);
  const Eigen::Vector3d way = measured_tip(low, arm) + share * (measured_tip(high, arm) - measured_tip(low, arm));
  return (measured_tip(sample, arm) - way).norm();
}

/// A sample that has no counterpart lies on the way between its neighbours or not, unless that is a gap.
void match_ticks(const SampleTrack& before, const SampleTrack& after, Difference& difference) {
  Deviation deviation;
  const std::int64_t longest = 2 * usual_step(before);
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < before.size() || j < after.size()) {
    if (j == after.size() || (i < before.size() && before[i].tick < after[j].tick)) {
      ++difference.removed;
      ++i;
    } else if (i == before.size() || after[j].tick < before[i].tick) {
      ++difference.added;
      const bool between = i > 0 && i < before.size() && before.tick(i) - before.tick(i - 1) < longest;
      if (between) {
        const Sample low = before[i - 1];
        const Sample high = before[i];
        const Sample sample = after[j];
        deviation.add(off_way_m(sample, low, high, 0), off_way_m(sample, low, high, 1));
      }
      ++j;
    } else {
      deviation.add((measured_tip(after[j], 0) - measured_tip(before[i], 0)).norm(),
                    (measured_tip(after[j], 1) - measured_tip(before[i], 1)).norm());
      ++i;
      ++j;
    }
  }
  deviation.write(difference);
}

/// The tip of `arm` at `t_s` since the begin gate, between two samples; precondition: within the gated samples.
Eigen::Vector3d tip_at(const Demonstration& document, double t_s, std::size_t arm) {
  const SampleTrack samples = document.gated();
  const double start_s = document.time_of(samples.front());
  const auto after = std::partition_point(samples.begin(), samples.end(), [&](const Sample& sample) {
    return document.time_of(sample) - start_s < t_s - kTimeTolerance_s;
  });
  if (after == samples.begin()) return measured_tip(samples.front(), arm);
  if (after == samples.end()) return measured_tip(samples.back(), arm);
  const Sample& low = *(after - 1);
  const double low_s = document.time_of(low) - start_s;
  const double share = (t_s - low_s) / (document.time_of(*after) - start_s - low_s);
  return measured_tip(low, arm) + share * (measured_tip(*after, arm) - measured_tip(low, arm));
}

void match_times(const Demonstration& before, const Demonstration& after, Difference& difference) {
  const auto length_s = [](const Demonstration& document) {
    const SampleTrack samples = document.gated();
    return document.time_of(samples.back()) - document.time_of(samples.front());
  };
  const double common_s = std::min(length_s(before), length_s(after)) + kTimeTolerance_s;
  const auto beyond = [&](const Demonstration& document) {
    const SampleTrack samples = document.gated();
    const double start_s = document.time_of(samples.front());
    return static_cast<int>(std::count_if(samples.begin(), samples.end(), [&](const Sample& sample) {
      return document.time_of(sample) - start_s > common_s;
    }));
  };
  difference.removed = beyond(before);
  difference.added = beyond(after);
  Deviation deviation;
  const double start_s = after.time_of(after.gated().front());
  for (const Sample& sample : after.gated()) {
    const double t_s = after.time_of(sample) - start_s;
    if (t_s > common_s) break;
    deviation.add((measured_tip(sample, 0) - tip_at(before, t_s, 0)).norm(),
                  (measured_tip(sample, 1) - tip_at(before, t_s, 1)).norm());
  }
  deviation.write(difference);
}

/// "8.10–12.40 and 13.00–14.00 s"; empty if there is none.
std::string spans_of(const Demonstration& document, Segment label) {
  std::string text;
  for (const SegmentSpan& span : document.segments) {
    if (span.label != label) continue;
    text += fmt::format("{}{:.2f}–{:.2f}", text.empty() ? "" : " and ", span.begin_s, span.end_s);
  }
  return text.empty() ? text : text + " s";
}

std::string change(const std::string& what, const std::string& before, const std::string& after) {
  if (before.empty()) return fmt::format("{} is new: {}", what, after);
  if (after.empty()) return fmt::format("{} is gone, was {}", what, before);
  return fmt::format("{} was {}, is {}", what, before, after);
}

bool has_note(const Demonstration& document, const Note& note) {
  return std::any_of(document.notes.begin(), document.notes.end(), [&](const Note& each) {
    return each.begin_s == note.begin_s && each.end_s == note.end_s && each.text == note.text && each.tag == note.tag &&
           each.rating == note.rating && each.colour == note.colour && each.glyph == note.glyph;
  });
}

/// Those of `from` that `other` lacks.
void add_notes(const Demonstration& from, const Demonstration& other, std::string_view fate,
               std::vector<std::string>& clauses) {
  for (const Note& note : from.notes) {
    if (has_note(other, note)) continue;
    clauses.push_back(fmt::format("the note \"{}\" at {:.2f} s {}", note.text, note.begin_s, fate));
  }
}

}  // namespace

std::vector<std::string> label_differences(const Demonstration& before, const Demonstration& after) {
  std::vector<std::string> clauses;
  for (int i = 0; i < kSegmentCount; ++i) {
    const auto label = static_cast<Segment>(i);
    const std::string was = spans_of(before, label);
    const std::string is = spans_of(after, label);
    if (was != is) clauses.push_back(change(fmt::format("segment {}", letter(label)), was, is));
  }
  add_notes(before, after, "is gone", clauses);
  add_notes(after, before, "is new", clauses);
  const auto number = [](int value) { return fmt::format("{}", value); };
  if (before.block != after.block) clauses.push_back(change("the block", number(before.block), number(after.block)));
  if (before.goal != after.goal) clauses.push_back(change("the goal", number(before.goal), number(after.goal)));
  return clauses;
}

bool of_one_recording(const Demonstration& before, const Demonstration& after) {
  return before.recording == after.recording || (before.recording->id && before.recording->id == after.recording->id);
}

Difference difference(const Demonstration& before, const Demonstration& after) {
  Difference result;
  result.duration_change_s = after.duration_s() - before.duration_s();
  const SampleTrack old_samples = before.gated();
  const SampleTrack new_samples = after.gated();
  if (of_one_recording(before, after) || old_samples.empty() || new_samples.empty()) {
    match_ticks(old_samples, new_samples, result);
  } else {
    match_times(before, after, result);
  }
  return result;
}

}  // namespace trocar::demonstration
