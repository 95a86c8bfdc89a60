/// A world in which a segment of the transfer begins: with the block in the left jaws in C, as a scripted expert took
/// it.
#pragma once

#include <string>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/trial/transfer_session.h"

namespace trocar::trial {

/// Plays a scripted transfer until a segment begins, a piece at a time. Threads: one at a time.
class SegmentApproach {
 public:
  /// Errors: those of `TransferSession::create`.
  static Result<SegmentApproach> create(demonstration::Segment segment, const TransferOptions& options);

  /// So many ticks, or fewer if it is there.
  void step(int ticks);
  bool there() const;
  /// The transfer ended before the segment began.
  bool failed() const { return !there() && transfer_.done(); }
  const TransferSession& transfer() const { return transfer_; }
  /// Snapshot for `simulation::World::restore`. Precondition: `there()`.
  std::string world() const { return transfer_.world(); }

 private:
  SegmentApproach(demonstration::Segment segment, TransferSession transfer);

  demonstration::Segment segment_;
  TransferSession transfer_;
};

/// All of it at once, some tenths of a second of computing; "" for A, where a new world is what is needed.
/// Errors: kCancelled; kCheckFailed if the transfer never comes to the segment.
Result<std::string> segment_world(demonstration::Segment segment, const TransferOptions& options, Progress& progress);

}  // namespace trocar::trial
