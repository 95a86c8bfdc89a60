/// Two demonstrations, or two versions of one, laid beside each other: which instant answers to which, how far the
/// tools are apart there, and what that amounts to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/diff.h"
#include "engine/spatial/grid.h"

namespace trocar::demonstration {

/// Which instant of `before` answers to an instant of `after`.
enum class Alignment : std::uint8_t {
  kTime,       ///< "time": versions of one recording by their ticks, others by the time since the begin gate.
  kArcLength,  ///< "arc": each tool by the share of its path that it has gone.
  kWarping,    ///< "dtw": dynamic time warping, the matching with the least sum of distances of both tools.
  kSegment,    ///< "segment": by the share of the segment, and of the stretches between segments.
};
constexpr std::array<Alignment, 4> kAlignments{Alignment::kTime, Alignment::kArcLength, Alignment::kWarping,
                                               Alignment::kSegment};
std::string_view to_string(Alignment alignment);
/// Errors: kInvalidArgument with the names that there are.
Result<Alignment> alignment_from(std::string_view text);

/// A sample of `after` and what of `before` answers to it; arrays are by arm, left first.
struct Match {
  double t_s = 0.0;                        ///< Of `after`.
  std::array<double, 2> before_s{};        ///< Of `before`.
  std::array<Eigen::Vector3d, 2> p_after;  ///< p_WT as measured.
  std::array<Eigen::Vector3d, 2> p_before;

  double deviation_m(std::size_t arm) const { return (p_after[arm] - p_before[arm]).norm(); }
};

/// By time of `after`, between the gates; samples without a counterpart are left out. Dynamic time warping gives each
/// sample the nearest of those that it is matched with.
/// Errors: kInvalidArgument if one of them has no samples between its gates, or for kSegment no segment that both have.
Result<std::vector<Match>> match(const Demonstration& before, const Demonstration& after, Alignment alignment);

/// The deviation of matched tips, in metres.
struct Deviation {
  double max_m = 0.0;
  double mean_m = 0.0;
  double share_95_m = 0.0;  ///< 95 % of the matches deviate by no more.
};

struct Comparison {
  Alignment alignment = Alignment::kTime;
  Difference difference;
  std::vector<Match> matches;
  std::array<Deviation, 2> deviation;  ///< Of each arm.
  Deviation both;                      ///< Over both arms.
  double before_s = 0.0;               ///< Durations.
  double after_s = 0.0;
  std::array<double, 2> path_before_m{};
  std::array<double, 2> path_after_m{};
  std::array<std::optional<double>, 2> jerk_before_m_s3{};  ///< Mean magnitudes; none where they cannot be told.
  std::array<std::optional<double>, 2> jerk_after_m_s3{};
  int cells_lost = 0;  ///< Of the lattice: the left tool was there in `before` only.
  int cells_gained = 0;
  std::vector<std::string> labels;  ///< As `label_differences`.
};

/// Errors: as `match`.
Result<Comparison> compare(const Demonstration& before, const Demonstration& after, Alignment alignment,
                           const spatial::Grid& grid);

/// The comparison as a table for a code review, in Markdown; `title` is its heading ("Expert 1 against its original").
std::string to_markdown(const Comparison& comparison, const std::string& title);

}  // namespace trocar::demonstration
