/// Which instant of each source a frame of a film shows.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/film/composition.h"

namespace trocar::film {

/// When the stages of a source begin that are to begin together, and when it ends; times of the source. A stage that it
/// lacks begins with the next one.
struct Stages {
  std::vector<double> begins_s;
  double end_s = 0.0;
  double duration_s(std::size_t stage) const;
};

/// By clock one stage; by segment six (what comes before A, then A to E, each from where its label first comes after
/// the one before); by grasp two. Between `in_s` and `out_s`.
Stages stages_of(const demonstration::Demonstration& shown, double in_s, double out_s, Sync sync);
/// Of what stands still: it begins when the film does, and waits for nobody.
Stages still_stages(Sync sync);

/// One source at one frame.
struct Instant {
  double at_s = 0.0;
  bool waiting = false;  ///< It has come to the end of a stage that another is still in.
  bool over = false;     ///< It has come to its own end, and another has not.
};

struct Moment {
  double film_s = 0.0;    ///< Since the pass began, holds included.
  double common_s = 0.0;  ///< What all sources have in common.
  double speed = 1.0;     ///< 0 in a hold.
  std::size_t stage = 0;
  std::vector<Instant> sources;
};

/// A stage lasts as long as in the source in which it is longest. Pure: a frame depends on its number alone, so that
/// frames may be made in any order. Threads: any.
class TimeMap {
 public:
  /// Errors: kInvalidArgument for a film of more than ten million frames. Precondition: as many stages in each source,
  /// and a pace that passed `check`.
  static Result<TimeMap> create(std::vector<Stages> sources, const Pace& pace, double fps);

  int frame_count() const { return pace_.loops * frames_of_a_pass_; }
  /// Precondition: 0 ≤ frame < frame_count().
  Moment at(int frame) const;
  double duration_s() const { return common_s_.back(); }  ///< Of what is in common.
  double stage_begin_s(std::size_t stage) const { return common_s_[stage]; }
  std::size_t stage_count() const { return common_s_.size() - 1; }

 private:
  TimeMap() = default;

  std::vector<Stages> sources_;
  std::vector<double> common_s_;  ///< Begin of each stage, and the end.
  Pace pace_;
  double fps_ = 30.0;
  int frames_of_a_pass_ = 1;
};

}  // namespace trocar::film
