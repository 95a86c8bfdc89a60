/// From what a person types to what the project holds: projects, demonstrations and models by id or unique name.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/console.h"
#include "engine/workbench/project.h"
#include "engine/workbench/project_file.h"

namespace trocar::app {

using Models = workbench::ProjectFile::Models;

/// Opens the project; what is odd about it goes to the console's warnings. A command that only reads says so, and one
/// that looks at no model, that describing them is enough.
Result<workbench::ProjectFile> open_project(const std::filesystem::path& path, Console& console,
                                            workbench::ProjectFile::Purpose purpose, Models models);
Result<workbench::ProjectFile> open_to_read(const std::filesystem::path& path, Console& console, Models models);
Result<workbench::ProjectFile> open_to_edit(const std::filesystem::path& path, Console& console, Models models);

/// To be asked before a project is opened for an output. `endings` are those that are good (".csv"); none: any.
/// Errors: kInvalidArgument for another ending, for the project's own file, and for any name that is a project's.
Status check_output(const std::filesystem::path& out, const std::filesystem::path& project,
                    std::initializer_list<std::string_view> endings = {});

/// `text` is an id, or a name that only one demonstration has.
/// Errors: kNotFound, with what may have been meant or what there is; kInvalidArgument, with the ids, if the name is
/// not unique.
Result<std::shared_ptr<const demonstration::Demonstration>> find_demonstration(const workbench::Project& project,
                                                                               const std::string& text);
Result<std::shared_ptr<const workbench::TrialEntry>> find_trial(const workbench::Project& project,
                                                                const std::string& text);
/// A demonstration, or what was recorded of a trial.
Result<std::shared_ptr<const demonstration::Demonstration>> find_shown(const workbench::Project& project,
                                                                       const std::string& text);
Result<std::shared_ptr<const workbench::ModelEntry>> find_model(const workbench::Project& project,
                                                                const std::string& text);

/// `wanted`, or numbered where it is taken, with a warning that says so: names that repeat cannot be asked for.
std::string free_demonstration_name(const workbench::Project& project, const std::string& wanted, Console& console);
std::string free_model_name(const workbench::Project& project, const std::string& wanted, Console& console);

/// Warns that what is shown of `model` is of demonstrations as they no longer are.
void warn_if_stale(const workbench::Project& project, const workbench::ModelEntry& model, Console& console);
/// Warns of a comparison of two models with different tasks. Precondition: both are open whole.
void warn_if_unlike(const workbench::ModelEntry& a, const workbench::ModelEntry& b, Console& console);

/// An option for a seed, 0 … 2⁶⁴ − 1 in decimal digits; anything else is refused, never wrapped or cut off.
CLI::Option* add_seed(CLI::App& verb, std::uint64_t& seed, const std::string& help);

/// "1280x720". Errors: kInvalidArgument.
Result<std::pair<int, int>> size_from(const std::string& text);
/// 'A' … 'E'. Errors: kInvalidArgument.
Result<demonstration::Segment> segment_from(const std::string& text);

/// 16 hexadecimal digits, as every hash is written.
std::string hash_text(std::uint64_t hash);
/// "3 demonstrations", "1 model".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace trocar::app
