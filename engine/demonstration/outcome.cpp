// How a transfer ended, as far as what lies between the gates still tells.
#include <algorithm>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {
namespace {

/// For so long a block must stay on its peg, or be lost, until that is decided (shared control, "Trial").
constexpr double kDecided_s = 0.1;
/// A block nearer than this to where it is in the end lies there.
constexpr double kStill_m = 0.0005;

bool is_held(const Sample& sample) {
  return (sample.flags & (kLeftHolds | kRightHolds)) != 0;
}

/// The index of the last recorded sample in which an arm holds the block or, if it was placed, the block is not yet
/// where it stays; not before `first`.
std::size_t last_carried(const Demonstration& document, std::size_t first) {
  const SampleTrack& recorded = document.recorded;
  const int block = document.recording->placed ? document.recording->provenance.block : kUnknownPlace;
  const bool known = block >= 0 && block < peg_board::kBlockCount;
  const auto place_in = [&](const Sample& sample) {
    return sample.blocks[static_cast<std::size_t>(known ? block : 0)].pose().p;
  };
  const Eigen::Vector3d stays = place_in(recorded.back());
  for (std::size_t i = recorded.size() - 1; i > first; --i) {
    const Sample sample = recorded[i];
    if (is_held(sample) || (known && (place_in(sample) - stays).norm() > kStill_m)) return i;
  }
  return first;
}

/// When it was decided that a recording ended as it did; its end where no sample tells, nothing where no instant does.
std::optional<double> decided_at_s(const Demonstration& document) {
  const SampleTrack& recorded = document.recorded;
  const auto time_at = [&](std::size_t i) { return Tick{recorded.tick(i) - document.first_tick()}.seconds(); };
  const std::size_t last = recorded.size() - 1;
  const auto settled = [&](std::size_t carried) { return std::min(time_at(carried) + kDecided_s, time_at(last)); };
  switch (document.recording->outcome) {
    case Outcome::kSuccess: {
      std::size_t handed = last;
      if (recorded[last].segment != Segment::kE) return time_at(last);
      while (handed > 0 && recorded[handed - 1].segment == Segment::kE) --handed;
      return document.recording->placed ? settled(last_carried(document, handed)) : time_at(handed);
    }
    case Outcome::kDropped: {
      const std::size_t carried = last_carried(document, 0);
      return carried == 0 ? time_at(last) : settled(carried);
    }
    case Outcome::kUnfinished:
    case Outcome::kAborted:
    case Outcome::kFault:
    case Outcome::kUnknown:
      break;
  }
  return std::nullopt;
}

bool is_cut_away(const Demonstration& document) {
  const bool whole = document.begin_s <= 0.0 && document.end_s >= document.full_duration_s();
  if (whole || document.recorded.empty()) return false;
  const std::optional<double> at_s = decided_at_s(document);
  return at_s && (*at_s > document.end_s + kTimeTolerance_s || *at_s < document.begin_s - kTimeTolerance_s);
}

}  // namespace

std::string_view Demonstration::outcome_doubt() const {
  if (motion_edited()) return "its motion was edited since";
  return is_cut_away(*this) ? "the gates leave out how it ended" : "";
}

Outcome Demonstration::outcome() const {
  return outcome_doubt().empty() ? recording->outcome : Outcome::kUnknown;
}

bool Demonstration::placed() const {
  return recording->placed && outcome_doubt().empty();
}

}  // namespace trocar::demonstration
