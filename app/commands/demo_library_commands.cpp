#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/commands/demo_commands.h"
#include "app/suggestion.h"
#include "engine/workbench/batch.h"
#include "engine/workbench/library_query.h"
#include "engine/workbench/saved_filters.h"

namespace trocar::app {
namespace {

using workbench::LibraryCell;
using workbench::LibraryColumn;
using workbench::LibraryRow;

struct ListArguments {
  std::string project;
  std::string filter;
  std::string saved;
  std::string sort;
  bool descending = false;
  bool measures = false;
};

void bind_list(CLI::App& verb, ListArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("--filter", arguments.filter,
                  "Only those that answer: \"jerk>0.3 and segment:C and not tag:bad\"; name=X is just that, "
                  "name~X has it somewhere");
  verb.add_option("--saved", arguments.saved, "Only those that answer a filter saved in the project");
  verb.add_option("--sort", arguments.sort, "By a column: length, jerk (smoothed, without tremor), clearance …");
  verb.add_flag("--descending", arguments.descending, "The largest first");
  verb.add_flag("--measures", arguments.measures, "Say also what takes time to work out");
}

Json column_json(const LibraryCell& cell) {
  if (cell.kind == LibraryCell::Kind::kNumber) return cell.number;
  return cell.kind == LibraryCell::Kind::kText ? Json(cell.text) : Json();
}

/// What the window's table shows of it, beside what every demonstration says.
Json row_json(const LibraryRow& row, const demonstration::Demonstration& document) {
  Json json = demonstration_json(document);
  json["flag"] = workbench::to_string(row.marks.flag);
  json["verdict"] = workbench::to_string(row.marks.verdict);
  json["rating"] = row.marks.rating;
  json["tags"] = row.marks.tags;
  json["note"] = row.marks.note;
  json["edits"] = row.edits;
  json["duplicate_of"] = row.duplicate == workbench::DemonstrationId{} ? Json() : Json(row.duplicate.value);
  json["models"] = row.models;
  json["models_stale"] = row.models_stale;
  json["replay"] = column_json(workbench::find_library_column("replay")->cell(row));
  if (!row.measures) return json;
  const workbench::Measures& measures = *row.measures;
  json["arms"] = column_json(workbench::find_library_column("arms")->cell(row));
  json["path_lengths_m"] = measures.path_length_m;
  const auto told = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  json["mean_smoothed_jerk_m_s3"] = told(measures.mean_jerk_m_s3);
  json["peak_smoothed_jerk_m_s3"] = told(measures.peak_jerk_m_s3);
  json["idle_share"] = told(measures.idle_share);
  json["clearance_m"] = measures.clearance_m ? Json(*measures.clearance_m) : Json();
  json["grid_error_m"] = measures.grid_error_m ? Json(*measures.grid_error_m) : Json();
  json["odd"] = row.oddity ? Json(row.oddity->deviations) : Json();
  json["odd_in"] = row.oddity ? Json(row.oddity->in) : Json();
  return json;
}

std::string measures_text(const LibraryRow& row) {
  std::string text;
  for (const char* id : {"jerk", "idle", "clearance", "grid", "odd"}) {
    const LibraryColumn& column = *workbench::find_library_column(id);
    text += fmt::format("  {} {}{}", std::string_view(id) == "jerk" ? "smoothed jerk" : id,
                        workbench::shown_cell(column, row), column.unit.empty() ? "" : fmt::format(" {}", column.unit));
  }
  return text;
}

std::string row_text(const LibraryRow& row, const Json& json) {
  std::string text = fmt::format("{:>4}  {:<24} {:>7.2f} s  {:>6} samples  {:<6} {:>5.0f} mm  {}", row.id.value,
                                 row.name, row.duration_s, row.samples, row.segments,
                                 1e3 * json["path_length_m"].get<double>(), json["outcome"].get<std::string>());
  if (row.measures) text += measures_text(row);
  if (row.marks.flag != workbench::Flag::kNone) text += fmt::format("  {}", workbench::to_string(row.marks.flag));
  for (const std::string& tag : row.marks.tags) text += " #" + tag;
  if (row.duplicate != workbench::DemonstrationId{}) text += fmt::format("  duplicate of {}", row.duplicate.value);
  return text;
}

Result<const LibraryColumn*> column_from(const std::string& id) {
  if (id.empty()) return nullptr;
  if (const LibraryColumn* column = workbench::find_library_column(id)) return column;
  std::vector<Known> known;
  for (const LibraryColumn& column : workbench::library_columns()) known.push_back({std::string(column.id), ""});
  return fail(ErrorCode::kInvalidArgument, fmt::format("there is no column {}{}", id, suggestion(id, known)));
}

Result<workbench::LibraryQuery> query_of(const workbench::Project& project, const std::string& filter,
                                         const std::string& saved) {
  std::string text = filter;
  if (!saved.empty()) {
    const auto found = project.filters.find(saved);
    if (found == project.filters.end()) {
      std::vector<Known> known;
      for (const auto& [name, query] : project.filters) known.push_back({name, ""});
      return fail(ErrorCode::kNotFound, fmt::format("the project has no filter {}{}", saved, suggestion(saved, known)));
    }
    text = filter.empty() ? found->second : fmt::format("({}) and ({})", found->second, filter);
  }
  return workbench::LibraryQuery::parse(text);
}

Result<Answer> run_list(const ListArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const LibraryColumn* column, column_from(arguments.sort));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  const auto project = file.project();
  TROCAR_ASSIGN_OR_RETURN(const workbench::LibraryQuery query, query_of(*project, arguments.filter, arguments.saved));
  const bool measured = arguments.measures || query.measured() || (column != nullptr && column->measured);
  TROCAR_ASSIGN_OR_RETURN(const auto view,
                          workbench::whole_library({project, file.replays()}, measured, console.progress()));
  std::size_t undecided = 0;
  std::vector<const LibraryRow*> rows = workbench::matching(*view, query, undecided);
  if (column != nullptr) workbench::sort_library(rows, *column, arguments.descending);
  Answer answer;
  answer.json = {{"demonstrations", Json::array()}};
  for (const LibraryRow* row : rows) {
    Json json = row_json(*row, *project->demonstrations.at(row->id));
    answer.text += (answer.text.empty() ? "" : "\n") + row_text(*row, json);
    answer.json["demonstrations"].push_back(std::move(json));
  }
  answer.summary = rows.size() == view->rows.size()
                       ? counted(rows.size(), "demonstration")
                       : fmt::format("{} of {}", rows.size(), counted(view->rows.size(), "demonstration"));
  return answer;
}

struct TagArguments {
  std::string project;
  std::string demonstration;
  std::vector<std::string> add;
  std::vector<std::string> remove;
  std::string flag;
  std::string verdict;
  std::optional<int> rating;
  std::optional<std::string> note;
};

void bind_tag(CLI::App& verb, TagArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_option("--add", arguments.add, "A tag to add; may be repeated")->allow_extra_args(false);
  verb.add_option("--remove", arguments.remove, "A tag to take away; may be repeated")->allow_extra_args(false);
  verb.add_option("--flag", arguments.flag, "good, bad, unsure or none");
  verb.add_option("--verdict", arguments.verdict, "success, failure or none");
  verb.add_option("--rating", arguments.rating, "1 to 5, 0 for none");
  verb.add_option("--note", arguments.note, "A note in place of the one there is; empty: none");
}

Json marks_json(const workbench::Marks& marks) {
  return {{"flag", workbench::to_string(marks.flag)},
          {"verdict", workbench::to_string(marks.verdict)},
          {"rating", marks.rating},
          {"tags", marks.tags},
          {"note", marks.note}};
}

Result<Answer> run_tag(const TagArguments& arguments, Console& console) {
  workbench::MarkChange change;
  change.add = arguments.add;
  change.remove = arguments.remove;
  change.rating = arguments.rating;
  change.note = arguments.note;
  if (!arguments.flag.empty()) {
    TROCAR_ASSIGN_OR_RETURN(change.flag, workbench::flag_from(arguments.flag));
  }
  if (!arguments.verdict.empty()) {
    TROCAR_ASSIGN_OR_RETURN(change.verdict, workbench::verdict_from(arguments.verdict));
  }
  if (change == workbench::MarkChange{}) {
    return fail(ErrorCode::kInvalidArgument,
                "say what to mark: --add, --remove, --flag, --verdict, --rating or --note");
  }
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_demonstration(*file.project(), arguments.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id,
                          file.commit(workbench::MarkDemonstration{demonstration->id, std::move(change)}));
  Answer answer;
  answer.json = marks_json(file.project()->marks_of(demonstration->id));
  answer.json["id"] = id;
  answer.json["demonstration"] = demonstration->id.value;
  answer.summary = file.history().back().description;
  return answer;
}

struct TrashArguments {
  std::string project;
};

Result<Answer> run_trash(const TrashArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  Answer answer;
  answer.json = {{"trash", Json::array()}};
  for (const auto& [id, document] : file.project()->trash) {
    answer.json["trash"].push_back(demonstration_json(*document));
    answer.text += fmt::format("{}{:>4}  {:<24} {:>7.2f} s", answer.text.empty() ? "" : "\n", id.value, document->name,
                               document->duration_s());
  }
  answer.summary = counted(file.project()->trash.size(), "demonstration") + " in the trash";
  return answer;
}

struct RestoreArguments {
  std::string project;
  std::string demonstration;
};

Result<Answer> run_restore(const RestoreArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  workbench::Project trash;
  trash.demonstrations = file.project()->trash;
  auto found = find_demonstration(trash, arguments.demonstration);
  if (!found) return tl::unexpected(std::move(found).error().in("look in the trash"));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(workbench::RestoreDemonstration{(*found)->id}));
  Answer answer;
  answer.json = {{"id", id}, {"demonstration", (*found)->id.value}, {"name", (*found)->name}};
  answer.summary = fmt::format("restored {}", (*found)->name);
  return answer;
}

struct FilterArguments {
  std::string project;
  std::string name;
  std::string query;
  bool remove = false;
};

void bind_filter(CLI::App& verb, FilterArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("NAME", arguments.name, "Of the filter; without: list those that are saved");
  verb.add_option("QUERY", arguments.query, "What it asks, as `demo list --filter` takes it");
  verb.add_flag("--remove", arguments.remove, "Forget the filter");
}

Result<Answer> run_filter(const FilterArguments& arguments, Console& console) {
  if (!arguments.query.empty()) {
    TROCAR_RETURN_IF_ERROR(workbench::LibraryQuery::parse(arguments.query));
  }
  const bool change = arguments.remove || !arguments.query.empty();
  if (!change && !arguments.name.empty()) {
    return fail(ErrorCode::kInvalidArgument, "say what the filter asks, or --remove");
  }
  if (arguments.remove && !arguments.query.empty()) {
    return fail(ErrorCode::kInvalidArgument, "a filter is saved or removed, not both");
  }
  Answer answer;
  if (!change) {
    TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                            open_to_read(arguments.project, console, Models::kDescribed));
    answer.json = {{"filters", Json::object()}};
    for (const auto& [name, query] : file.project()->filters) {
      answer.json["filters"][name] = query;
      answer.text += fmt::format("{}{:<24} {}", answer.text.empty() ? "" : "\n", name, query);
    }
    answer.summary = counted(file.project()->filters.size(), "filter");
    return answer;
  }
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  workbench::Edit edit = workbench::SaveFilter{arguments.name, arguments.query};
  if (arguments.remove) edit = workbench::RemoveFilter{arguments.name};
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(edit));
  answer.json = {{"id", id}, {"name", arguments.name}};
  answer.summary = file.history().back().description;
  return answer;
}

struct BatchArguments {
  std::string project;
  std::string filter;
  std::string saved;
  std::vector<std::string> demonstrations;
  std::vector<std::string> words;
  bool dry_run = false;
};

void bind_batch(CLI::App& verb, BatchArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("--filter", arguments.filter, "Of those that answer, as `demo list --filter` takes it");
  verb.add_option("--saved", arguments.saved, "Of those that answer a filter saved in the project");
  verb.add_option("--demo", arguments.demonstrations, "Of this one, by id or name; may be repeated")
      ->allow_extra_args(false);
  verb.add_flag("--dry-run", arguments.dry_run, "Say what it would do, and do nothing");
  verb.add_option("WORDS", arguments.words,
                  "flag F, tag T, untag T, rate N, verdict V, remove, or an edit with its parameters after --")
      ->required();
}

Result<std::vector<workbench::DemonstrationId>> chosen_by(const BatchArguments& arguments,
                                                          const workbench::ProjectFile& file, Console& console) {
  std::vector<workbench::DemonstrationId> ids;
  for (const std::string& text : arguments.demonstrations) {
    TROCAR_ASSIGN_OR_RETURN(const auto document, find_demonstration(*file.project(), text));
    if (std::find(ids.begin(), ids.end(), document->id) == ids.end()) ids.push_back(document->id);
  }
  if (arguments.filter.empty() && arguments.saved.empty()) {
    if (!ids.empty()) return ids;
    return fail(ErrorCode::kInvalidArgument, "say which demonstrations: --filter, --saved or --demo");
  }
  TROCAR_ASSIGN_OR_RETURN(const workbench::LibraryQuery query,
                          query_of(*file.project(), arguments.filter, arguments.saved));
  TROCAR_ASSIGN_OR_RETURN(const auto view, workbench::whole_library({file.project(), file.replays()}, query.measured(),
                                                                    console.progress()));
  std::size_t undecided = 0;
  for (const LibraryRow* row : workbench::matching(*view, query, undecided)) {
    if (std::find(ids.begin(), ids.end(), row->id) == ids.end()) ids.push_back(row->id);
  }
  if (ids.empty()) return fail(ErrorCode::kNotFound, "no demonstration answers the filter");
  return ids;
}

/// A bridge by policy may name its model, as for `trocar demo edit`. Errors: those of `find_model`.
Status with_model_id(std::vector<std::string>& words, const workbench::Project& project) {
  constexpr std::string_view kOption = "--model";
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool joined = words[i].starts_with(std::string(kOption) + "=");
    if (!joined && (words[i] != kOption || i + 1 == words.size())) continue;
    const std::string text = joined ? words[i].substr(kOption.size() + 1) : words[i + 1];
    if (text.empty() || text == "0") continue;
    TROCAR_ASSIGN_OR_RETURN(const auto found, find_model(project, text));
    (joined ? words[i] : words[i + 1]) = (joined ? "--model=" : "") + std::to_string(found->id.value);
  }
  return {};
}

Result<Answer> run_batch(const BatchArguments& typed, Console& console) {
  BatchArguments arguments = typed;
  // Models are large; only bridges that go as one of them would need them.
  const bool policy = std::any_of(arguments.words.begin(), arguments.words.end(),
                                  [](const std::string& word) { return word == "policy" || word == "--shape=policy"; });
  if (!policy) TROCAR_RETURN_IF_ERROR(workbench::act_from_words(arguments.words));
  const auto purpose =
      arguments.dry_run ? workbench::ProjectFile::Purpose::kRead : workbench::ProjectFile::Purpose::kEdit;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_project(arguments.project, console, purpose,
                                                                    policy ? Models::kWhole : Models::kDescribed));
  if (policy) TROCAR_RETURN_IF_ERROR(with_model_id(arguments.words, *file.project()));
  TROCAR_ASSIGN_OR_RETURN(auto ids, chosen_by(arguments, file, console));
  const auto plan = workbench::plan_batch({file.project(), std::move(ids), arguments.words}, console.progress());
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  if (!plan->error.empty()) return fail(ErrorCode::kInvalidArgument, plan->error);
  Answer answer;
  answer.json = {{"changed", plan->edit.edits.size()}, {"id", Json()}, {"demonstrations", Json::array()}};
  for (const workbench::BatchLine& line : plan->lines) {
    answer.json["demonstrations"].push_back(
        {{"id", line.id.value}, {"name", line.name}, {"change", line.change}, {"problem", line.problem}});
    answer.text += fmt::format("{:>4}  {:<24} {}\n", line.id.value, line.name,
                               line.problem.empty() ? line.change : "left out: " + line.problem);
  }
  answer.summary = fmt::format("{} of {} changed", plan->edit.edits.size(), plan->lines.size());
  if (arguments.dry_run)
    answer.summary = fmt::format("would change {} of {}", plan->edit.edits.size(), plan->lines.size());
  if (!arguments.dry_run && !plan->edit.edits.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(plan->edit));
    answer.json["id"] = id;
  }
  answer.text += answer.summary;
  return answer;
}

}  // namespace

void add_demo_library_commands(CLI::App& noun, Action& chosen) {
  add_verb<ListArguments>(noun, chosen, "list", "List the demonstrations, filtered and sorted", bind_list, run_list);
  add_verb<TagArguments>(noun, chosen, "tag", "Flag, tag, rate and annotate a demonstration", bind_tag, run_tag);
  add_verb<TrashArguments>(
      noun, chosen, "trash", "List what was removed and can be restored",
      [](CLI::App& verb, TrashArguments& a) { verb.add_option("PROJECT", a.project, "The project file")->required(); },
      run_trash);
  add_verb<RestoreArguments>(
      noun, chosen, "restore", "Take a demonstration out of the trash",
      [](CLI::App& verb, RestoreArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("DEMO", a.demonstration, "Its id or name")->required();
      },
      run_restore);
  add_verb<FilterArguments>(noun, chosen, "filter", "List, save or remove filters; HDF5 exports hold them as masks",
                            bind_filter, run_filter);
  add_verb<BatchArguments>(noun, chosen, "batch", "Do one thing to several demonstrations, as one step of the history",
                           bind_batch, run_batch);
}

}  // namespace trocar::app
