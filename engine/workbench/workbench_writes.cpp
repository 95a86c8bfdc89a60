// What changes the document, and what happens to it while another program is writing to the project.
#include <fmt/format.h>

#include "engine/demonstration/edits.h"
#include "engine/demonstration/join.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {
namespace {

constexpr int kUsualPatience_ms = 500;
/// Then it is given up, and said to be.
constexpr double kLongestWait_s = 15.0;
/// Edits of so many samples are made within a frame.
constexpr std::size_t kAtOnce_samples = 20'000;

using demonstration::Demonstration;

/// Whether an edit makes all samples of a demonstration anew, or of a span that may be all of it.
bool rewrites_all(const demonstration::Edit& edit) {
  using namespace demonstration;
  return std::holds_alternative<Offset>(edit) || std::holds_alternative<Smooth>(edit) ||
         std::holds_alternative<Simplify>(edit) || std::holds_alternative<Resample>(edit) ||
         std::holds_alternative<Retime>(edit) || std::holds_alternative<SnapToGrid>(edit) ||
         std::holds_alternative<Mirror>(edit) || std::holds_alternative<Retarget>(edit) ||
         std::holds_alternative<Perturb>(edit);
}

bool same(const demonstration::Edit& a, const demonstration::Edit& b) {
  return name_of(a) == name_of(b) && to_json(a) == to_json(b);
}

}  // namespace

bool Workbench::Impl::attempt_now(const std::function<bool()>& attempt) {
  const std::shared_ptr<ProjectFile> project = file;
  if (project) project->set_patience_ms(0);
  const bool done = attempt();
  if (project) project->set_patience_ms(kUsualPatience_ms);
  return done;
}

void Workbench::Impl::write(std::function<bool()> attempt) {
  if (waiting_writes.empty()) {
    if (attempt_now(attempt)) return;
    waiting_since_s = options.clock->now_s();
    log(Severity::kInfo, "Another program is writing to the project; what was asked for waits for it");
  }
  waiting_writes.push_back(std::move(attempt));
}

void Workbench::Impl::retry_writes() {
  while (!waiting_writes.empty()) {
    if (!attempt_now(waiting_writes.front())) break;
    waiting_writes.pop_front();
    waiting_since_s = options.clock->now_s();
  }
  if (waiting_writes.empty() || options.clock->now_s() - waiting_since_s < kLongestWait_s) return;
  waiting_writes.clear();
  log(Severity::kError, "What waited was given up: the project is open in another program that is writing to it");
}

bool Workbench::Impl::make_beside(const CommitEdit& command) {
  const auto* change = std::get_if<EditDemonstration>(&command.edit);
  if (change == nullptr || !rewrites_all(change->edit)) return false;
  const auto before = demonstration(change->demonstration);
  if (!before || before->samples.size() <= kAtOnce_samples) return false;
  // As it is shown already, while its parameters were chosen.
  const auto shown = state.preview;
  if (shown && shown->after && shown->entry == 0 && shown->before == before && same(shown->edit, change->edit)) {
    file->prepare(before, change->edit, shown->after);
    return false;
  }
  const auto work = [this, owner = file, before, command, edit = change->edit](Progress&) -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(Demonstration made, demonstration::transformed(*before, edit, 0));
    const auto after = std::make_shared<const Demonstration>(std::move(made));
    return JobResult{"", [this, owner, before, command, edit, after]() -> Status {
                       if (owner != file || demonstration(before->id) != before) {
                         return fail(ErrorCode::kCheckFailed, "the demonstration was changed meanwhile");
                       }
                       file->prepare(before, edit, after);
                       write([this, command] { return commit(command); });
                       return {};
                     }};
  };
  editing.start(fmt::format("Edit {}", before->name), work, true);
  return true;
}

bool Workbench::Impl::commit(const CommitEdit& command) {
  if (!project_open()) return true;
  const auto* change = std::get_if<EditDemonstration>(&command.edit);
  const auto before = change == nullptr ? nullptr : demonstration(change->demonstration);
  const Result<std::int64_t> id = file->commit(command.edit);
  if (!id && file->held_elsewhere()) return false;
  if (!id) {
    log(Severity::kError, id.error().text());
    return true;
  }
  refresh_document();
  std::string sentence = file->history().back().description;
  const auto after = before == nullptr ? nullptr : demonstration(before->id);
  if (after != nullptr) {
    const std::string joins = demonstration::sentence_of(demonstration::joins_of(change->edit, *before, *after));
    if (!joins.empty()) sentence += "; " + joins;
    if (before->id == state.demonstration) follow(change->edit, *before, *after);
  }
  tell(std::move(sentence));
  return true;
}

bool Workbench::Impl::move(const std::function<Status()>& step) {
  if (!project_open()) return true;
  const Status done = step();
  if (!done && file->held_elsewhere()) return false;
  if (succeeded(done)) refresh_document();
  return true;
}

Status Workbench::Impl::keep_model(const std::shared_ptr<ProjectFile>& owner,
                                   const std::shared_ptr<const ModelEntry>& entry) {
  const auto add = [this, owner, entry]() -> Status {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, owner->add_model(*entry, Progress()));
    if (owner != file) return {};
    state.model = ModelId{id};
    refresh_document();
    return {};
  };
  owner->set_patience_ms(0);
  Status added = add();
  owner->set_patience_ms(kUsualPatience_ms);
  if (added || !owner->held_elsewhere()) return added;
  write([this, owner, add] {
    const Status again = add();
    if (!again && owner->held_elsewhere()) return false;
    succeeded(again);
    return true;
  });
  return {};
}

void Workbench::Impl::on(const CommitEdit& asked) {
  if (!document_free()) return;
  const CommitEdit command{as_typed(asked.edit)};
  if (file && make_beside(command)) return;
  write([this, command] { return commit(command); });
}

void Workbench::Impl::on(const Undo&) {
  if (!document_free()) return;
  write([this] {
    return move([this]() -> Status {
      const std::string undone = description_of(file->head());
      TROCAR_RETURN_IF_ERROR(file->undo());
      tell("Undid: " + undone);
      return {};
    });
  });
}

void Workbench::Impl::on(const Redo&) {
  if (!document_free()) return;
  write([this] {
    return move([this]() -> Status {
      TROCAR_RETURN_IF_ERROR(file->redo());
      tell("Did again: " + description_of(file->head()));
      return {};
    });
  });
}

void Workbench::Impl::on(const GoToHistory& command) {
  if (!document_free()) return;
  write([this, command] { return move([this, command] { return file->go_to(command.node); }); });
}

}  // namespace trocar::workbench
