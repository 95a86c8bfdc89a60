// What the workbench does about files of other programs: reads them for a look, takes them in, and writes them.
#include <fmt/format.h>

#include "engine/workbench/importing.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

void Workbench::Impl::on(const ReadImport& command) {
  reading.cancel_all();
  state.import_pending = true;
  dirty = true;
  const std::string created = iso_time(options.clock->unix_s());
  const auto work = [this, settings = command.settings, created](Progress& progress) -> Result<JobResult> {
    const auto read = view_of_import(settings, created, progress);
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the import was stopped");
    return JobResult{"", [this, read]() -> Status {
                       state.import = read;
                       return {};
                     }};
  };
  reading.start("Read " + command.settings.path.filename().string(), work, true);
}

void Workbench::Impl::on(const EndImport&) {
  reading.cancel_all();
  state.import.reset();
  dirty = true;
}

void Workbench::Impl::poll_import() {
  const bool was_pending = std::exchange(state.import_pending, reading.busy());
  if (was_pending != state.import_pending) dirty = true;
  state.import_fraction = reading.jobs().empty() ? 0.0 : reading.jobs().front().fraction;
}

void Workbench::Impl::on(const MakeImport&) {
  if (!project_open() || !document_free()) return;
  if (state.import_pending || !state.import || state.import->parts.empty()) {
    return log(Severity::kWarning, "There is nothing to import yet");
  }
  const std::string name = state.import->settings.path.filename().string();
  const auto work = [this, read = state.import, owner = file](Progress&) -> Result<JobResult> {
    const std::size_t count = read->parts.size();
    const std::string message = count == 1 ? "1 demonstration" : fmt::format("{} demonstrations", count);
    // Into the project that was open when it was asked for, even if another is by now.
    return JobResult{message, [this, read, owner]() -> Status {
                       std::vector<ImportPart> parts = read->parts;
                       give_free_names(parts, *owner->project());
                       TROCAR_ASSIGN_OR_RETURN(const auto ids, add_parts(*owner, read->settings.path, parts));
                       if (owner != file) return {};
                       state.demonstration = ids.front();
                       state.selection.reset();
                       refresh_document();
                       tell(file->history().back().description);
                       return {};
                     }};
  };
  importing = jobs.start("Import " + name, work);
  on(EndImport{});
}

void Workbench::Impl::on(const ExportDemonstrations& command) {
  if (!is_output(command.path)) return;
  exchange::Documents documents;
  for (const DemonstrationId id : command.demonstrations) {
    documents.push_back(demonstration(id));
    if (!documents.back()) return log(Severity::kError, fmt::format("there is no demonstration {}", id.value));
  }
  state.exported = ExportView{command.path, true, {}, {}};
  dirty = true;
  const auto take = [this, path = command.path](const Result<exchange::ExportReport>& report) {
    if (!state.exported || state.exported->path != path) return;
    state.exported->running = false;
    if (report) {
      state.exported->report = *report;
    } else {
      state.exported->error = report.error().text();
    }
  };
  const auto work = [documents, command, take](Progress&) -> Result<JobResult> {
    const auto report = std::make_shared<const Result<exchange::ExportReport>>(
        exchange::export_demonstrations(documents, command.path, command.format, command.masks));
    return JobResult{*report ? (*report)->reread : "", [report, take]() -> Status {
                       take(*report);
                       return report->map([](const exchange::ExportReport&) {});
                     }};
  };
  jobs.start("Export " + command.path.filename().string(), work);
}

}  // namespace trocar::workbench
