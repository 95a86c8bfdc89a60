#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/commands/rollout_commands.h"
#include "app/lookup.h"
#include "engine/workbench/jobs/report_job.h"

namespace trocar::app {
namespace {

struct ReportArguments {
  std::string project;
  std::vector<std::string> models;
  std::string starts = "around:3";
  std::string out;
};

void bind_report(CLI::App& verb, ReportArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.models, "One or two, by id or name")->required()->expected(1, 2);
  verb.add_option("--starts", arguments.starts, starts_help())->capture_default_str();
  verb.add_option("--out", arguments.out, "F.html: a page with its figures in it")->required();
}

Result<Answer> run_report(const ReportArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".html"}));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  workbench::ReportRequest request;
  TROCAR_ASSIGN_OR_RETURN(request.models, find_drawn_models(*file.project(), arguments.models, console));
  std::string names;
  for (const auto& entry : request.models) names += (names.empty() ? "" : " and ") + entry->name;
  request.starts = arguments.starts;
  request.path = arguments.out;
  TROCAR_RETURN_IF_ERROR(workbench::write_report(request, console.progress()));
  Answer answer;
  std::error_code ignored;
  answer.json = {{"out", arguments.out}, {"size_bytes", std::filesystem::file_size(arguments.out, ignored)}};
  answer.summary = "report of " + names;
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_rollout_report_command(CLI::App& noun, Action& chosen) {
  add_verb<ReportArguments>(noun, chosen, "report", "Write a page of what rollouts come to, with figures", bind_report,
                            run_report);
}

}  // namespace trocar::app
