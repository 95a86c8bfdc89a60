/// Where an edit must leave a motion as it is: at its ends and where a grasp begins or ends. Private to the module.
#pragma once

#include <vector>

#include "engine/demonstration/sample_track.h"

namespace trocar::demonstration {

class ContactLock {
 public:
  /// `contacts` false: only the ends are held. Samples by increasing tick.
  explicit ContactLock(const SampleTrack& samples, bool contacts = true);
  /// 0 where nothing may move, 1 where all may, smooth in between. Precondition: `i` is the index of a sample.
  double freedom(std::size_t i) const { return freedom_[i]; }

 private:
  std::vector<double> freedom_;
};

}  // namespace trocar::demonstration
