#include "engine/trial/segment_world.h"

#include <fmt/format.h>

#include <utility>

namespace trocar::trial {

SegmentApproach::SegmentApproach(demonstration::Segment segment, TransferSession transfer)
    : segment_(segment), transfer_(std::move(transfer)) {}

Result<SegmentApproach> SegmentApproach::create(demonstration::Segment segment, const TransferOptions& options) {
  TROCAR_ASSIGN_OR_RETURN(TransferSession transfer, TransferSession::create(options));
  return SegmentApproach(segment, std::move(transfer));
}

bool SegmentApproach::there() const {
  return transfer_.segment() == segment_;
}

void SegmentApproach::step(int ticks) {
  for (int i = 0; i < ticks && !there() && !transfer_.done(); ++i) transfer_.step();
}

Result<std::string> segment_world(demonstration::Segment segment, const TransferOptions& options, Progress& progress) {
  if (segment == demonstration::Segment::kA) return std::string();
  TROCAR_ASSIGN_OR_RETURN(SegmentApproach approach, SegmentApproach::create(segment, options));
  while (!approach.there()) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped by the user");
    if (approach.failed()) {
      return fail(ErrorCode::kCheckFailed, fmt::format("the scripted transfer of seed {} does not come to segment {}",
                                                       options.seed, demonstration::letter(segment)));
    }
    approach.step(1000);
  }
  return approach.world();
}

}  // namespace trocar::trial
