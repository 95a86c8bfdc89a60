/// The part of a demonstration that an edit works on: its samples in one place, and the way back. Private to the
/// module.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// Errors: kInvalidArgument for numbers that are not finite, or an end that is not after the begin.
Status check_range(double from_s, double to_s);
/// Errors: kInvalidArgument naming what must be finite and above 0.
Status check_positive(double value, std::string_view what);

/// A run of samples, copied out.
struct Stretch {
  std::size_t first = 0;  ///< In the document's track.
  std::vector<Sample> samples;
};

/// The samples from `from_s` to `to_s`, both included.
/// Errors: those of `check_range`; kInvalidArgument if there are fewer than `fewest` of them.
Result<Stretch> stretch_of(const Demonstration& document, double from_s, double to_s, std::size_t fewest);

/// The same, shared and not copied.
struct TrackPart {
  std::size_t first = 0;  ///< In the document's track.
  SampleTrack samples;
};
/// Errors: as `stretch_of`.
Result<TrackPart> part_of(const Demonstration& document, double from_s, double to_s, std::size_t fewest);

/// The document with each sample of the part as `change(sample, i)` leaves it, at the same tick. They are unpacked one
/// by one: an hour of them takes no more room than it needs.
template <typename Change>
Demonstration with_changed(const Demonstration& document, const TrackPart& part, const Change& change) {
  BlockBuilder made;
  std::size_t i = 0;
  for (Sample sample : part.samples) {
    change(sample, i++);
    made.add(sample);
  }
  Demonstration edited = document;
  edited.samples = document.samples.replaced(part.first, part.samples.size(), SampleTrack(made.take()));
  return edited;
}

/// The document with the stretch's samples, as many and at the same ticks, in place of its own.
Demonstration with_stretch(const Demonstration& document, Stretch stretch);

/// The document with `samples` in place of `count` from `first`, and everything after them `shift` ticks later. Labels,
/// gates and notes follow: a time inside the old span keeps its share of it, or is moved by `inside`, in seconds since
/// its begin. Errors: kInvalidArgument if fewer than 2 samples stay between the gates.
Result<Demonstration> with_other_length(const Demonstration& document, std::size_t first, std::size_t count,
                                        const SampleTrack& samples, std::int64_t shift,
                                        const std::function<double(double)>& inside = {});

/// Times of labels, gates and notes go through `moved`, which never decreases; labels without a length go.
void move_times(Demonstration& document, const std::function<double(double)>& moved);

/// Arms that an edit means, as indices.
std::vector<std::size_t> indices_of(Arms arms);

/// The pose between two samples at a tick between theirs; flags and labels are those of `a`.
Sample between(const Sample& a, const Sample& b, std::int64_t tick);

/// The sample of a track at any time between its first and last.
class TrackReader {
 public:
  explicit TrackReader(SampleTrack samples) : samples_(std::move(samples)) {}
  /// Ticks need not be whole. Precondition: at least one sample; calls by increasing `tick` are quick.
  Sample at(double tick);

 private:
  SampleTrack samples_;
  std::size_t next_ = 1;
};

/// Turns the arm by `turn` about its tip and then moves it, and what it holds with it. Frames: W.
void displace(Sample& sample, std::size_t arm, const Eigen::Vector3d& by_m, const Eigen::Quaterniond& turn, int block);

/// The flag that says that an arm holds the target block.
SampleFlag holds_flag(std::size_t arm);

}  // namespace trocar::demonstration
