#include "engine/workbench/library.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/demonstration/discretise.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/quality.h"
#include "engine/review/clearance.h"
#include "engine/statistics/summary.h"

namespace trocar::workbench {
namespace {

using demonstration::Demonstration;
using demonstration::Segment;

constexpr double kMoves_m = 0.002;

bool moves(const demonstration::SampleTrack& samples, std::size_t arm) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
  Eigen::Vector3d high = -low;
  for (const demonstration::Sample& sample : samples) {
    const Eigen::Vector3d p_WT = demonstration::measured_tip(sample, arm);
    low = low.cwiseMin(p_WT);
    high = high.cwiseMax(p_WT);
  }
  return (high - low).norm() > kMoves_m;
}

std::optional<double> least_clearance_m(const Demonstration& document, const demonstration::SampleTrack& samples,
                                        review::ClearanceMaker& maker) {
  const bool finite = std::all_of(samples.begin(), samples.end(),
                                  [](const demonstration::Sample& sample) { return is_finite(sample); });
  if (!finite || samples.empty()) return std::nullopt;
  return maker.make(document).least_m();
}

std::optional<double> grid_error_m(const Demonstration& document) {
  std::optional<double> largest_m;
  for (const Segment segment : {Segment::kA, Segment::kC}) {
    const auto path = demonstration::discretise(document, segment, spatial::Grid{});
    if (path) largest_m = std::max(largest_m.value_or(0.0), path->max_error_m);
  }
  return largest_m;
}

LibraryRow facts_of(const Demonstration& document, const LibraryRequest& request) {
  const demonstration::RecordingInfo& recording = *document.recording;
  LibraryRow row;
  row.id = document.id;
  row.name = document.name;
  row.duration_s = document.duration_s();
  row.samples = document.gated().size();
  for (int i = 0; i < demonstration::kSegmentCount; ++i) {
    const auto segment = static_cast<Segment>(i);
    if (document.segment(segment)) row.segments += demonstration::letter(segment);
  }
  row.outcome = document.outcome();
  row.placed = document.placed();
  row.source = recording.provenance.operator_kind;
  if (!recording.provenance.skill.empty()) row.source += " " + recording.provenance.skill;
  row.hash = document.hash();
  row.edits = document.stack->size();
  row.marks = request.project->marks_of(document.id);
  const auto replay = request.replays.find(recording.id);
  if (replay != request.replays.end()) row.replay = replay->second;
  for (const auto& [id, model] : request.project->models) {
    const auto used = std::find(model->demonstrations.begin(), model->demonstrations.end(), document.id);
    if (used == model->demonstrations.end()) continue;
    row.models.push_back(model->name);
    const auto place = static_cast<std::size_t>(used - model->demonstrations.begin());
    const auto& hashes = model->demonstration_hashes;
    row.models_stale = row.models_stale || place >= hashes.size() || hashes[place] != row.hash;
  }
  return row;
}

void find_duplicates(std::vector<LibraryRow>& rows) {
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < rows.size(); ++i) places[rows[i].hash].push_back(i);
  for (const auto& [hash, alike] : places) {
    for (const std::size_t i : alike) {
      if (alike.size() > 1) rows[i].duplicate = rows[alike[i == alike.front() ? 1 : 0]].id;
    }
  }
}

/// What a row can be odd in, and what it is called on either side.
struct Trait {
  std::optional<double> (*value)(const LibraryRow&);
  const char* more;
  const char* less;  ///< Empty: that is no fault.
};
constexpr std::array<Trait, 3> kTraits{{
    {[](const LibraryRow& row) { return std::optional(row.duration_s); }, "long", "short"},
    {[](const LibraryRow& row) { return row.measures->mean_jerk_m_s3; }, "jerky", ""},
    {[](const LibraryRow& row) { return row.measures->idle_share; }, "still", ""},
}};
/// Of a normal distribution, the standard deviation is so many times the median distance from the median.
constexpr double kDeviationPerMedianDistance = 1.4826;
/// Below so many, nothing is usual.
constexpr std::size_t kLeastForOddity = 5;

void find_oddities(std::vector<LibraryRow>& rows) {
  if (rows.size() < kLeastForOddity) return;
  for (LibraryRow& row : rows) row.oddity.emplace();
  for (const Trait& trait : kTraits) {
    // Those of which it is not known are as odd as the others make them.
    std::vector<double> values;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::optional<double> value = trait.value(rows[i]);
      if (!value) continue;
      values.push_back(*value);
      places.push_back(i);
    }
    if (values.size() < kLeastForOddity) continue;
    const double middle = statistics::median(values);
    std::vector<double> distances(values);
    for (double& value : distances) value = std::abs(value - middle);
    const double deviation = kDeviationPerMedianDistance * statistics::median(distances);
    if (!(deviation > 0.0)) continue;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double deviations = std::abs(values[i] - middle) / deviation;
      const char* word = values[i] > middle ? trait.more : trait.less;
      std::optional<Oddity>& oddity = rows[places[i]].oddity;
      if (*word != '\0' && deviations > oddity->deviations) oddity = Oddity{deviations, word};
    }
  }
}

}  // namespace

Measures measures_of(const Demonstration& document) {
  review::ClearanceMaker maker;
  return measures_of(document, maker);
}

Measures measures_of(const Demonstration& document, review::ClearanceMaker& maker) {
  const demonstration::SampleTrack samples = document.gated();
  Measures measures;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    measures.moves[arm] = moves(samples, arm);
    measures.path_length_m[arm] = demonstration::path_length_m(document, arm);
    const std::optional<demonstration::JerkSummary> jerk = demonstration::jerk_without_tremor(document, arm);
    if (!jerk) continue;
    measures.mean_jerk_m_s3 = std::max(measures.mean_jerk_m_s3.value_or(0.0), jerk->mean_m_s3);
    measures.peak_jerk_m_s3 = std::max(measures.peak_jerk_m_s3.value_or(0.0), jerk->peak_m_s3);
  }
  measures.idle_share = demonstration::idle_share(document);
  measures.clearance_m = least_clearance_m(document, samples, maker);
  measures.grid_error_m = grid_error_m(document);
  return measures;
}

/// Every version of every demonstration has measures of its own.
void LibraryMaker::forget_old(const LibraryView& view) {
  if (known_.size() <= std::max(kMostMeasures, 2 * view.rows.size())) return;
  decltype(known_) now;
  for (const LibraryRow& row : view.rows) {
    const auto found = known_.find({row.hash, view.of.project->demonstrations.at(row.id)->block});
    if (found != known_.end()) now.insert(*found);
  }
  known_ = std::move(now);
}

std::shared_ptr<const LibraryView> LibraryMaker::make(const LibraryRequest& request, std::size_t most_samples) {
  if (!request.project) return nullptr;
  auto view = std::make_shared<LibraryView>();
  view->of = request;
  std::size_t done_samples = 0;
  for (const auto& [id, document] : request.project->demonstrations) {
    LibraryRow row = facts_of(*document, request);
    auto& measures = known_[{row.hash, document->block}];
    if (!measures && done_samples < most_samples) {
      done_samples += std::max<std::size_t>(row.samples, 1);
      measures = std::make_shared<const Measures>(measures_of(*document, clearance_));
    }
    row.measures = measures;
    view->unmeasured += measures ? 0 : 1;
    view->rows.push_back(std::move(row));
  }
  forget_old(*view);
  find_duplicates(view->rows);
  if (view->unmeasured == 0) find_oddities(view->rows);
  return view;
}

}  // namespace trocar::workbench
