#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>

#include "app/lookup.h"
#include "app/options.h"
#include "engine/store/project_store.h"

namespace trocar::app {
namespace {

struct ProjectArguments {
  std::string project;
};

void bind(CLI::App& verb, ProjectArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file, NAME.trocar")->required();
}

Result<Answer> run_new(const ProjectArguments& arguments, Console& console) {
  if (std::filesystem::path(arguments.project).extension() != ".trocar") {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "a project's name must end in .trocar").at(arguments.project));
  }
  if (std::error_code ignored; std::filesystem::exists(arguments.project, ignored)) {
    return tl::unexpected(
        Error(ErrorCode::kIo,
              "the file exists already; remove it, or choose another name (for a script, another --out)")
            .at(arguments.project));
  }
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          workbench::ProjectFile::create(arguments.project, console.clock));
  Answer answer;
  answer.json = {{"path", arguments.project}, {"schema", store::kSchemaVersion}, {"size_bytes", file.size_bytes()}};
  answer.summary = "an empty project";
  answer.text = fmt::format("Made {}", arguments.project);
  return answer;
}

Result<Answer> run_info(const ProjectArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  const auto project = file.project();
  Answer answer;
  answer.json = {{"demonstrations", project->demonstrations.size()},
                 {"models", project->models.size()},
                 {"trials", project->trials.size()},
                 {"edits", file.history().size()},
                 {"head", file.head()},
                 {"schema", store::kSchemaVersion},
                 {"size_bytes", file.size_bytes()},
                 {"hash", hash_text(project->hash())}};
  answer.summary = fmt::format("{}, {}, {}, {:.1f} MB", counted(project->demonstrations.size(), "demonstration"),
                               counted(project->models.size(), "model"), counted(project->trials.size(), "trial"),
                               static_cast<double>(file.size_bytes()) * 1e-6);
  return answer;
}

std::string description_of(const workbench::ProjectFile& file, std::int64_t id) {
  const auto& nodes = file.history();
  const auto found = std::find_if(nodes.begin(), nodes.end(), [id](const auto& node) { return node.id == id; });
  return found == nodes.end() ? "" : found->description;
}

std::string place_of(const workbench::ProjectFile& file, std::int64_t id) {
  return id == 0 ? "the beginning" : fmt::format("edit {} ({})", id, description_of(file, id));
}

/// One line for each node, children under their parent; a branch is indented, the line that goes on is not.
void print_tree(const std::map<std::int64_t, std::vector<const workbench::HistoryNode*>>& children,
                const workbench::ProjectFile& file, std::int64_t parent, int depth, std::string& text) {
  const auto found = children.find(parent);
  if (found == children.end()) return;
  const auto& nodes = found->second;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int own_depth = i + 1 == nodes.size() ? depth : depth + 1;
    const auto name = file.checkpoints().find(nodes[i]->id);
    text += fmt::format("{} {:>4}  {:{}}{}{}  ({})\n", nodes[i]->id == file.head() ? '>' : ' ', nodes[i]->id, "",
                        2 * own_depth, name == file.checkpoints().end() ? "" : fmt::format("[{}] ", name->second),
                        nodes[i]->description, nodes[i]->time);
    print_tree(children, file, nodes[i]->id, own_depth, text);
  }
}

Json checkpoint_json(const workbench::ProjectFile& file, std::int64_t node) {
  const auto name = file.checkpoints().find(node);
  return name == file.checkpoints().end() ? Json() : Json(name->second);
}

struct HistoryArguments {
  std::string project;
  std::optional<std::int64_t> go;
  std::optional<std::string> checkpoint;
  std::optional<std::int64_t> at;  ///< Of the checkpoint; none: where the project stands.
};

Result<Answer> run_history(const HistoryArguments& arguments, Console& console) {
  if (arguments.at && !arguments.checkpoint) {
    return fail(ErrorCode::kInvalidArgument, "--at says of which edit --checkpoint is the name");
  }
  const bool changes = arguments.go || arguments.checkpoint;
  const auto purpose = changes ? workbench::ProjectFile::Purpose::kMove : workbench::ProjectFile::Purpose::kRead;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file,
                          open_project(arguments.project, console, purpose, Models::kDescribed));
  if (arguments.go) TROCAR_RETURN_IF_ERROR(file.go_to(*arguments.go));
  if (arguments.checkpoint) {
    TROCAR_RETURN_IF_ERROR(file.name_checkpoint(arguments.at.value_or(file.head()), *arguments.checkpoint));
  }
  Answer answer;
  answer.json = {{"head", file.head()}, {"history", Json::array()}};
  std::map<std::int64_t, std::vector<const workbench::HistoryNode*>> children;
  for (const workbench::HistoryNode& node : file.history()) {
    answer.json["history"].push_back({{"id", node.id},
                                      {"parent", node.parent},
                                      {"name", node.name},
                                      {"description", node.description},
                                      {"time", node.time},
                                      {"checkpoint", checkpoint_json(file, node.id)},
                                      {"head", node.id == file.head()}});
    children[node.parent].push_back(&node);
  }
  answer.summary = counted(file.history().size(), "edit");
  if (arguments.go) answer.summary = "now at " + place_of(file, file.head());
  if (arguments.checkpoint) {
    answer.summary =
        fmt::format("{} is now \"{}\"", place_of(file, arguments.at.value_or(file.head())), *arguments.checkpoint);
  }
  print_tree(children, file, 0, 0, answer.text);
  if (!answer.text.empty()) answer.text.pop_back();
  return answer;
}

/// `edit` is what was taken back or made again.
Answer moved(const workbench::ProjectFile& file, const std::string& verb, std::int64_t edit) {
  Answer answer;
  const std::string description = description_of(file, edit);
  answer.json = {{"head", file.head()},
                 {"undoable", file.undoable()},
                 {"redoable", file.redoable()},
                 {"edit", edit},
                 {"description", description}};
  answer.summary = fmt::format("{}: {}", verb, description);
  answer.text = fmt::format("{}; now at {}", answer.summary, place_of(file, file.head()));
  return answer;
}

Result<Answer> run_undo(const ProjectArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(
      workbench::ProjectFile file,
      open_project(arguments.project, console, workbench::ProjectFile::Purpose::kMove, Models::kDescribed));
  const std::int64_t undone = file.head();
  TROCAR_RETURN_IF_ERROR(file.undo());
  return moved(file, "undone", undone);
}

Result<Answer> run_redo(const ProjectArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(
      workbench::ProjectFile file,
      open_project(arguments.project, console, workbench::ProjectFile::Purpose::kMove, Models::kDescribed));
  TROCAR_RETURN_IF_ERROR(file.redo());
  return moved(file, "done again", file.head());
}

Result<Answer> run_recover(const ProjectArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_edit(arguments.project, console, Models::kDescribed));
  Answer answer;
  answer.json = {{"recovered", file.recovered()}};
  answer.summary = file.recovered() == 0 ? "nothing to recover"
                                         : fmt::format("recovered {}", counted(file.recovered(), "recording"));
  return answer;
}

}  // namespace

void add_project_commands(CLI::App& root, Action& chosen) {
  add_verb<ProjectArguments>(root, chosen, "new", "Make an empty project with the standard board", bind, run_new);
  add_verb<ProjectArguments>(root, chosen, "info", "Say what a project holds", bind, run_info);
  add_verb<HistoryArguments>(
      root, chosen, "history", "Show every edit as a tree, or go to one of them",
      [](CLI::App& verb, HistoryArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("--go", a.go, "Make the project as it was after this edit, by its number; 0: empty");
        verb.add_option("--checkpoint", a.checkpoint, "Name the edit that the project stands at; empty: no name");
        verb.add_option("--at", a.at, "Name this edit instead, by its number");
      },
      run_history);
  add_verb<ProjectArguments>(root, chosen, "recover", "Take in recordings that were cut off, as every edit does", bind,
                             run_recover);
  add_verb<ProjectArguments>(root, chosen, "undo", "Go back by one edit", bind, run_undo);
  add_verb<ProjectArguments>(root, chosen, "redo", "Go forward by one edit", bind, run_redo);
}

}  // namespace trocar::app
