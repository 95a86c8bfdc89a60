/// The library: of every demonstration one row with what is known of it, and what takes time to work out.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/review/clearance.h"
#include "engine/workbench/facts.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// What takes time, of one version of a demonstration, between its gates. Arrays are by arm, left first.
struct Measures {
  std::array<bool, 2> moves{};  ///< Its tool goes farther than 2 mm.
  std::array<double, 2> path_length_m{};
  /// Of the path without its tremor, of the arm that has the more; none where it cannot be told.
  std::optional<double> mean_jerk_m_s3;
  std::optional<double> peak_jerk_m_s3;
  std::optional<double> idle_share;    ///< Likewise.
  std::optional<double> clearance_m;   ///< The least; none if some samples are not finite.
  std::optional<double> grid_error_m;  ///< The largest of segments A and C on the lattice; none without either.
};
/// Threads: any.
Measures measures_of(const demonstration::Demonstration& document);
/// With distances that `maker` may remember.
Measures measures_of(const demonstration::Demonstration& document, review::ClearanceMaker& maker);

/// How far a row is from the others in what it is oddest in, in robust standard deviations.
struct Oddity {
  double deviations = 0.0;
  std::string in;  ///< "long", "short", "jerky", "still" …; empty if it is odd in nothing.
};

struct LibraryRow {
  DemonstrationId id;
  std::string name;
  double duration_s = 0.0;
  std::size_t samples = 0;
  std::string segments;  ///< "ABCDE": those that are labelled between the gates.
  demonstration::Outcome outcome = demonstration::Outcome::kUnknown;
  bool placed = false;
  std::string source;         ///< "scripted expert", "imported".
  std::uint64_t hash = 0;     ///< Of its content.
  std::size_t edits = 0;      ///< In its stack.
  DemonstrationId duplicate;  ///< The first other one with the same content; none if there is none.
  std::optional<ReplayFound> replay;
  std::vector<std::string> models;  ///< The names of those trained on it.
  bool models_stale = false;        ///< One of them on an older version of it.
  Marks marks;
  std::shared_ptr<const Measures> measures;  ///< Null: not worked out yet.
  std::optional<Oddity> oddity;              ///< None before the measures of all are there.
};

struct LibraryRequest {
  std::shared_ptr<const Project> project;  ///< Null: nothing is wanted.
  Replays replays;
  bool operator==(const LibraryRequest&) const = default;
};
struct LibraryView {
  LibraryRequest of;
  std::vector<LibraryRow> rows;  ///< By id.
  std::size_t unmeasured = 0;    ///< Rows without measures.
};

/// With more versions than this, only those of the rows at hand are remembered.
constexpr std::size_t kMostMeasures = 4096;

/// Works out a library piece by piece, and remembers measures by what they are of. Threads: one at a time.
class LibraryMaker {
 public:
  explicit LibraryMaker(std::shared_ptr<review::ClearanceStore> distances = std::make_shared<review::ClearanceStore>())
      : clearance_(std::move(distances)) {}

  /// All rows; of those without measures as many are measured as have `most_samples` together, one at least unless it
  /// is 0. Null for a request without a project.
  std::shared_ptr<const LibraryView> make(const LibraryRequest& request, std::size_t most_samples);

  /// Versions of which measures are remembered.
  std::size_t remembered() const { return known_.size(); }

 private:
  void forget_old(const LibraryView& view);

  review::ClearanceMaker clearance_;
  std::map<std::pair<std::uint64_t, int>, std::shared_ptr<const Measures>> known_;
};

/// A piece that takes about a tenth of a second.
constexpr std::size_t kLibraryPiece_samples = 15'000;

}  // namespace trocar::workbench
