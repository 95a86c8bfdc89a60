/// The curves of a demonstration ready to be drawn, in the units that people read, with what they were before an edit.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/demonstration/curves.h"
#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/problems.h"
#include "engine/plot/axis.h"
#include "engine/plot/curve.h"
#include "engine/review/clearance.h"

namespace trocar::workbench {

using demonstration::CurveKind;

/// How a kind of curve is shown.
struct CurveLook {
  std::string_view title;  ///< "Speed"
  std::string_view unit;   ///< "mm/s": of the numbers in a `plot::Curve`, whatever it is in SI.
  double per_si = 1.0;     ///< Shown units for each SI unit.
  bool from_zero = false;  ///< Its axis begins at zero.
};
const CurveLook& look_of(CurveKind kind);
/// What the numbers may be before `demonstration::problems` says something, in shown units.
std::vector<plot::Band> limits_of(CurveKind kind);
/// "Left", "Right".
std::string_view arm_title(int arm);

/// In shown units, gates or not: what the panel draws and `trocar demo plot` writes. Not of the clearance.
std::shared_ptr<const plot::Curve> plotted(const demonstration::SampleTrack& samples, std::int64_t first_tick,
                                           CurveKind kind, int arm);

/// The clearance of a tool from all that it could hit, in shown units, between the gates; `maker` remembers what it
/// worked out.
std::shared_ptr<const plot::Curve> plotted_clearance(const demonstration::Demonstration& shown, int arm,
                                                     review::ClearanceMaker& maker);

/// A bit for each kind.
using CurveKinds = std::uint32_t;
constexpr CurveKinds bit(CurveKind kind) {
  return CurveKinds{1} << static_cast<unsigned>(kind);
}

struct ShownCurve {
  CurveKind kind = CurveKind::kX;
  int arm = 0;
  std::shared_ptr<const plot::Curve> now;
  std::shared_ptr<const plot::Curve> before;  ///< Null if nothing has changed.
};

struct CurvesRequest {
  std::shared_ptr<const demonstration::Demonstration> shown;   ///< Null: nothing is to be shown.
  std::shared_ptr<const demonstration::Demonstration> before;  ///< Null: as `shown` was recorded.
  CurveKinds kinds = 0;
};

struct CurveSet {
  CurvesRequest of;
  std::vector<ShownCurve> curves;  ///< By kind, left before right.
  std::vector<demonstration::Problem> problems;

  const ShownCurve* find(CurveKind kind, int arm) const;
};

/// Keeps what the last requests had in common, by the hash of the track: a gate that moves costs nothing.
/// Threads: one at a time.
class CurveMaker {
 public:
  explicit CurveMaker(std::shared_ptr<review::ClearanceStore> distances = std::make_shared<review::ClearanceStore>())
      : clearance_(std::move(distances)) {}

  /// Null for a request without a demonstration.
  std::shared_ptr<const CurveSet> make(const CurvesRequest& request);

 private:
  using Key = std::tuple<std::uint64_t, std::int64_t, CurveKind, int>;
  using Curves = std::map<Key, std::shared_ptr<const plot::Curve>>;

  std::shared_ptr<const plot::Curve> kept_or_made(const demonstration::SampleTrack& samples, std::uint64_t hash,
                                                  std::int64_t first_tick, CurveKind kind, int arm, Curves& kept) const;

  void add_clearance(const CurvesRequest& request, CurveSet& set);

  Curves curves_;
  review::ClearanceMaker clearance_;
  std::shared_ptr<const demonstration::Demonstration> checked_;
  std::vector<demonstration::Problem> problems_;
};

}  // namespace trocar::workbench
