#include "engine/workbench/jobs/trial_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

namespace trocar::workbench {
namespace {

using demonstration::Segment;

/// The block that the model was learned at; −1 where nobody knows.
int block_of(const Project& project, const ModelEntry& entry) {
  if (entry.demonstrations.empty()) return -1;
  const auto shown = project.demonstrations.find(entry.demonstrations.front());
  return shown == project.demonstrations.end() ? -1 : shown->second->block;
}

std::vector<std::shared_ptr<const ModelEntry>> candidates(const Project& project, const TrialPlan& plan,
                                                          Segment segment) {
  std::vector<std::shared_ptr<const ModelEntry>> named;
  std::vector<std::shared_ptr<const ModelEntry>> all;
  for (const auto& [id, entry] : project.models) {
    if (entry->segment != segment || entry->model == nullptr) continue;
    all.push_back(entry);
    if (std::find(plan.models.begin(), plan.models.end(), id) != plan.models.end()) named.push_back(entry);
  }
  return named.empty() ? all : named;
}

Status check(const TrialPlan& plan) {
  if (plan.transfers < 1 || plan.transfers > 1000) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("1 to 1000 transfers are possible, not {}", plan.transfers));
  }
  if (plan.first_block < 0 || plan.first_block >= peg_board::kBlockCount) {
    return fail(ErrorCode::kInvalidArgument, "the block is a number from 0 to 5");
  }
  return {};
}

Result<RanTrial> run_one(const TrialPlan& plan, const trial::TrialOptions& options, int transfer,
                         const Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(const auto session, trial::SharedControlSession::create(options));
  bool stopped = false;
  while (!session->done()) {
    if (!stopped && progress.cancelled()) {
      session->stop();
      stopped = true;
    }
    session->step();
  }
  RanTrial ran;
  ran.recording.provenance = session->provenance();
  ran.recording.initial_world = session->take_initial_world().value_or("");
  ran.recording.samples = session->take_samples();
  ran.recording.hashes = session->take_marks();
  ran.recording.outcome = session->outcome();
  ran.recording.placed = session->placed();
  ran.record = record_of(*session, plan, transfer, ran.recording.samples, session->take_events());
  ran.record.interrupted = stopped;
  return ran;
}

}  // namespace

Result<std::vector<trial::AgentModel>> agents_for(const Project& project, const TrialPlan& plan, int block) {
  if (plan.options.mode == trial::Mode::kManual) return std::vector<trial::AgentModel>();
  for (const ModelId id : plan.models) {
    const auto found = project.models.find(id);
    if (found == project.models.end()) return fail(ErrorCode::kNotFound, fmt::format("there is no model {}", id.value));
    if (found->second->segment != Segment::kA && found->second->segment != Segment::kC) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("{} is of segment {}: the agent has A and C", found->second->name,
                              demonstration::letter(found->second->segment)));
    }
  }
  std::vector<trial::AgentModel> agents;
  for (const Segment segment : {Segment::kA, Segment::kC}) {
    const auto all = candidates(project, plan, segment);
    if (all.empty()) continue;
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const auto& entry) { return block_of(project, *entry) == block; });
    // On the board another block's model would lead to that block.
    const bool serves_any = segment == Segment::kC || plan.options.anchor == trial::Anchor::kTarget;
    const bool unknown = block_of(project, *all.front()) < 0;
    if (same == all.end() && !serves_any && !unknown) continue;
    const ModelEntry& entry = same == all.end() ? *all.front() : **same;
    trial::AgentModel agent{entry.model, entry.name, segment, {0.0, 0.0, 0.0}};
    const int learned_at = block_of(project, entry);
    if (plan.options.anchor == trial::Anchor::kTarget && learned_at >= 0) {
      agent.shift_W = trial::target_shift(segment, learned_at, block);
    }
    agents.push_back(std::move(agent));
  }
  return agents;
}

Result<trial::TrialOptions> options_of(const Project& project, const TrialPlan& plan, int transfer) {
  trial::TrialOptions options = plan.options;
  options.seed = plan.seed + static_cast<std::uint64_t>(transfer);
  options.block = options.goal = (plan.first_block + (plan.same_block ? 0 : transfer)) % peg_board::kBlockCount;
  options.delay.seed = options.seed;
  TROCAR_ASSIGN_OR_RETURN(options.agents, agents_for(project, plan, options.block));
  if (options.mode == trial::Mode::kShared && options.agents.empty()) {
    const bool any = std::any_of(project.models.begin(), project.models.end(), [](const auto& each) {
      return each.second->segment == Segment::kA || each.second->segment == Segment::kC;
    });
    if (!any) return fail(ErrorCode::kInvalidArgument, "shared control needs a model: train one of segment A or C");
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("no model serves block {}: train one of A there or one of C, or anchor the lattice at the "
                            "target",
                            options.block));
  }
  return options;
}

trial::TrialRecord record_of(trial::SharedControlSession& session, const TrialPlan& plan, int transfer,
                             const std::vector<demonstration::Sample>& samples,
                             const std::vector<trial::TrialEvent>& events) {
  const trial::TrialOptions& options = session.options();
  trial::TrialRecord record;
  record.mode = options.mode;
  record.operator_kind = session.provenance().operator_kind;
  record.skill = session.provenance().skill;
  record.assistant = session.assistant_kind();
  record.subject = plan.subject;
  record.session = plan.session;
  record.block_number = plan.block_number;
  record.transfer = transfer;
  record.in_results = plan.in_results;
  record.seed = options.seed;
  record.block = options.block;
  record.goal = options.goal;
  record.begin_p_W = options.begin_p_W;
  record.scale = options.scale;
  record.agent_rate_hz = options.agent_rate_hz;
  record.anchor = options.anchor;
  record.delay = control::to_string(options.delay);
  for (const trial::AgentModel& agent : options.agents) {
    record.models.push_back({agent.name, agent.segment, agent.model->hash()});
  }
  record.outcome = session.outcome();
  record.placed = session.placed();
  record.completion_s = session.completion_s();
  record.duration_s = session.state().tick.seconds();
  record.counts = session.trial_status()->counts;
  record.metrics = trial::trial_metrics(samples, session.decided_s(), record.counts.agent_s);
  record.events = events;
  return record;
}

Result<std::vector<RanTrial>> run_trials(const Project& project, const TrialPlan& plan, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(plan));
  std::vector<trial::TrialOptions> all;
  for (int i = 0; i < plan.transfers; ++i) {
    TROCAR_ASSIGN_OR_RETURN(all.emplace_back(), options_of(project, plan, i));
  }
  std::vector<std::optional<Result<RanTrial>>> ran(all.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  const auto work = [&] {
    for (std::size_t i = next.fetch_add(1); i < all.size() && !progress.cancelled(); i = next.fetch_add(1)) {
      ran[i] = run_one(plan, all[i], static_cast<int>(i), progress);
      progress.set(static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(all.size()));
    }
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < std::clamp(plan.threads, 1, 64); ++i) others.emplace_back(work);
  work();
  others.clear();
  std::vector<RanTrial> trials;
  for (auto& each : ran) {
    if (!each) continue;
    if (!*each) return tl::unexpected(std::move(*each).error());
    trials.push_back(std::move(**each));
  }
  return trials;
}

Result<std::vector<RanTrial>> run_block(const Project& project, TrialPlan plan, const trial::ProtocolBlock& block,
                                        Progress& progress) {
  std::vector<RanTrial> ran;
  int successes = 0;
  double elapsed_s = 0.0;
  constexpr int kMost = 1000;
  for (int i = 0; i < kMost && !progress.cancelled() && !trial::block_over(block, i, successes, elapsed_s); ++i) {
    TROCAR_ASSIGN_OR_RETURN(const trial::TrialOptions options, options_of(project, plan, i));
    TROCAR_ASSIGN_OR_RETURN(RanTrial each, run_one(plan, options, i, progress));
    successes += each.record.outcome == demonstration::Outcome::kSuccess ? 1 : 0;
    elapsed_s += each.record.duration_s;
    ran.push_back(std::move(each));
  }
  return ran;
}

Status check_blocks(const Project& project, const TrialPlan& plan, int transfers) {
  for (int i = 0; i < std::min(transfers, static_cast<int>(peg_board::kBlockCount)); ++i) {
    TROCAR_RETURN_IF_ERROR(options_of(project, plan, i).map([](const auto&) {}));
  }
  return {};
}

void add_link(const link::HandServerStatus& link, trial::TrialRecord& record) {
  if (link.scripted) record.operator_kind = record.assistant = "scripted";
  if (!link.one_clock) return;
  record.counts.delay_mean_s += link.delay_mean_s;
  record.counts.delay_worst_s += link.delay_worst_s;
}

Result<TrialPlan> plan_of(TrialPlan plan, const std::vector<trial::ProtocolBlock>& blocks, std::size_t number) {
  const trial::ProtocolBlock& block = blocks[number];
  constexpr std::uint64_t kFamiliarisation = 500;
  std::uint64_t rank = 0;
  for (std::size_t i = 0; i < number; ++i) {
    rank += blocks[i].mode == block.mode && blocks[i].counts == block.counts ? 1 : 0;
  }
  // Scenes of their own for those that are tried before.
  if (!block.counts) rank += kFamiliarisation;
  constexpr std::uint64_t kApart = 1000;
  plan.seed += rank * kApart;
  plan.options.mode = block.mode;
  plan.block_number = static_cast<int>(number);
  plan.in_results = block.counts;
  TROCAR_ASSIGN_OR_RETURN(plan.options.delay, control::delay_from(block.delay));
  return plan;
}

std::string trial_name(const Project& project, trial::Mode mode) {
  const auto taken = [&project](const std::string& name) {
    return std::any_of(project.trials.begin(), project.trials.end(),
                       [&name](const auto& each) { return each.second->name == name; });
  };
  int number = 1;
  for (const auto& [id, entry] : project.trials) number += entry->record.mode == mode ? 1 : 0;
  std::string name = fmt::format("{} {}", trial::to_string(mode), number);
  while (taken(name)) name = fmt::format("{} {}", trial::to_string(mode), ++number);
  return name;
}

}  // namespace trocar::workbench
