// What the workbench does about problems: follows them, mends them, and simulates.
#include <fmt/format.h>

#include "engine/review/fixes.h"
#include "engine/workbench/batch.h"
#include "engine/workbench/review_goals.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

void Workbench::Impl::follow_review() {
  const ReviewRequest wanted{demonstration(state.demonstration), model(state.model)};
  if (wanted != review_wanted) {
    review_wanted = wanted;
    review.request(wanted);
  }
  if (review.update()) {
    state.review = review.answer();
    dirty = true;
  }
  state.review_pending = review.pending();
  // What was found for another version is no news of this one.
  if (state.simulation && state.simulation->of != wanted.document) state.simulation.reset();
}

void Workbench::Impl::follow_preview_review() {
  ReviewRequest wanted;
  if (state.preview && state.preview->after) wanted = {state.preview->after, model(state.model)};
  if (wanted != preview_review_wanted) {
    preview_review_wanted = wanted;
    preview_review.request(wanted);
    // What it said of an edit that is no longer made is no news.
    if (!wanted.document) state.preview_review.reset();
  }
  if (!preview_review.update()) return;
  state.preview_review = wanted.document ? preview_review.answer() : nullptr;
  dirty = true;
}

void Workbench::Impl::on(const SimulateDemonstration& command) {
  const auto shown = demonstration(command.demonstration);
  if (!shown) return log(Severity::kError, fmt::format("there is no demonstration {}", command.demonstration.value));
  state.simulation = SimulationView{shown, {}, {}};
  dirty = true;
  const auto take = [this, shown](SimulationView found) {
    if (state.simulation && state.simulation->of == shown) state.simulation = std::move(found);
    dirty = true;
  };
  const auto work = [shown, take](Progress& progress) -> Result<JobResult> {
    const auto found = std::make_shared<Result<review::Resimulation>>(review::resimulate(*shown, progress));
    return JobResult{*found ? (*found)->sentence : "", [shown, take, found]() -> Status {
                       if (*found) {
                         take({shown, **found, {}});
                         return {};
                       }
                       take({shown, {}, found->error().text()});
                       return tl::unexpected(found->error());
                     }};
  };
  jobs.start("Simulate " + shown->name, work);
}

void Workbench::Impl::on(const FixProblems& command) {
  if (!project_open() || !document_free()) return;
  const auto shown = demonstration(command.demonstration);
  if (!shown) return log(Severity::kError, fmt::format("there is no demonstration {}", command.demonstration.value));
  review::ReviewOptions asked;
  asked.goals = goals_of(model(state.model).get());
  const auto work = [this, shown, asked](Progress&) -> Result<JobResult> {
    const auto edits = std::make_shared<std::vector<demonstration::Edit>>(review::fixes_of_all(*shown, asked));
    const std::string message = edits->empty() ? "no fix helps" : fmt::format("{} fixes made", edits->size());
    return JobResult{message, [this, shown, edits]() -> Status {
                       // They are for the version that they were found for.
                       if (recording || demonstration(shown->id) != shown) {
                         return fail(ErrorCode::kCheckFailed, recording ? "A transfer is being recorded"
                                                                        : "the demonstration was changed meanwhile");
                       }
                       if (edits->empty()) return {};
                       const Result<std::int64_t> made = file->commit(mending(*shown, *edits));
                       refresh_document();
                       return made.map([](std::int64_t) {});
                     }};
  };
  jobs.start("Fix problems of " + shown->name, work);
}

}  // namespace trocar::workbench
