/// Where an edit must leave a motion as it is: at its ends, where a grasp begins or ends, where a gripper moves.
/// Private to the module.
#pragma once

#include <vector>

#include "engine/demonstration/sample_track.h"

namespace trocar::demonstration {

class ContactLock {
 public:
  struct What {
    bool contacts = true;
    bool ends = true;
    bool jaws = false;
  };
  /// Samples by increasing tick.
  explicit ContactLock(const SampleTrack& samples) : ContactLock(samples, What{}) {}
  ContactLock(const SampleTrack& samples, What what);
  /// 0 where nothing may move, 1 where all may, smooth in between. Precondition: `i` is the index of a sample.
  double freedom(std::size_t i) const { return freedom_[i]; }

 private:
  std::vector<double> freedom_;
};

}  // namespace trocar::demonstration
