/// The problems of the demonstration that is shown, worked out beside the window; and what the simulator made of it.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "engine/review/resimulation.h"
#include "engine/review/review.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct ReviewRequest {
  std::shared_ptr<const demonstration::Demonstration> document;  ///< Null: nothing is selected.
  std::shared_ptr<const ModelEntry> model;  ///< Whose goal and safe set it is held to; may be null.
  bool operator==(const ReviewRequest&) const = default;
};

struct ReviewView {
  ReviewRequest of;
  review::Review review;
  std::string incomplete;  ///< Why not everything could be checked; empty: it was.
};

/// So many versions are remembered: undo and redo of neighbours work nothing out.
constexpr std::size_t kKeptReviews = 4;

/// Keeps distances from version to version, and the last views. Threads: one at a time.
class ReviewMaker {
 public:
  explicit ReviewMaker(std::shared_ptr<review::ClearanceStore> distances = std::make_shared<review::ClearanceStore>())
      : reviewer_(std::move(distances)) {}

  /// Null for a request without a demonstration.
  std::shared_ptr<const ReviewView> make(const ReviewRequest& request);

 private:
  review::Reviewer reviewer_;
  /// Without its request, as a version that nobody shows any more is not to stay in memory for this.
  struct Kept {
    std::weak_ptr<const demonstration::Demonstration> document;
    std::weak_ptr<const ModelEntry> model;
    ReviewView view;
  };
  std::deque<Kept> kept_;  ///< The newest comes first.
};

/// The latest re-simulation. It is of one version of one demonstration, and says nothing of later ones.
struct SimulationView {
  std::shared_ptr<const demonstration::Demonstration> of;
  std::optional<review::Resimulation> result;  ///< Nothing while it runs, and if it failed.
  std::string error;                           ///< Why it failed or cannot be.
};

}  // namespace trocar::workbench
