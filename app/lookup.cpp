#include "app/lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "app/suggestion.h"
#include "engine/core/ending.h"
#include "engine/store/project_store.h"

namespace trocar::app {
namespace {

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// One rule for demonstrations and models: an id first, then a name that is unique.
template <typename Map>
Result<typename Map::mapped_type> find(const Map& map, const std::string& text, std::string_view noun) {
  if (const auto number = whole_number(text)) {
    if (const auto found = map.find({*number}); found != map.end()) return found->second;
  }
  std::vector<typename Map::mapped_type> matches;
  std::vector<std::int64_t> ids;
  std::vector<Known> known;
  for (const auto& [id, item] : map) {
    known.push_back({item->name, fmt::format("\"{}\" (id {})", item->name, id.value)});
    if (item->name != text) continue;
    matches.push_back(item);
    ids.push_back(id.value);
  }
  if (matches.size() == 1) return matches.front();
  if (matches.empty()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("no {} has the id or name {}{}", noun, text, suggestion(text, known)));
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("more than one {} is named {}; give the id: {}", noun, text, fmt::join(ids, ", ")));
}

template <typename Map>
bool is_taken(const Map& map, std::string_view name) {
  return std::any_of(map.begin(), map.end(), [name](const auto& item) { return item.second->name == name; });
}

/// A name in front of its number: "Expert 3" is "Expert" and 3; without one, the number is 1.
std::pair<std::string, std::int64_t> split_number(const std::string& name) {
  const std::size_t space = name.rfind(' ');
  if (space == std::string::npos || space == 0) return {name, 1};
  const std::optional<std::int64_t> number = whole_number(std::string_view(name).substr(space + 1));
  constexpr std::int64_t kLargest = 1'000'000;
  if (!number || *number < 1 || *number > kLargest) return {name, 1};
  return {name.substr(0, space), *number};
}

/// `wanted`, or with the next number that makes it unique, which is then said.
template <typename Map>
std::string free_name(const Map& map, const std::string& wanted, std::string_view noun, Console& console) {
  if (!is_taken(map, wanted)) return wanted;
  auto [base, number] = split_number(wanted);
  std::string name = wanted;
  while (is_taken(map, name)) name = fmt::format("{} {}", base, ++number);
  console.diagnostics.warn(fmt::format("a {} is named {} already; this one is named {}", noun, wanted, name));
  return name;
}

}  // namespace

Result<workbench::ProjectFile> open_project(const std::filesystem::path& path, Console& console,
                                            workbench::ProjectFile::Purpose purpose, Models models) {
  return workbench::ProjectFile::open(path, console.clock, console.diagnostics, purpose, models);
}

Result<workbench::ProjectFile> open_to_read(const std::filesystem::path& path, Console& console, Models models) {
  return open_project(path, console, workbench::ProjectFile::Purpose::kRead, models);
}

Result<workbench::ProjectFile> open_to_edit(const std::filesystem::path& path, Console& console, Models models) {
  return open_project(path, console, workbench::ProjectFile::Purpose::kEdit, models);
}

Status check_output(const std::filesystem::path& out, const std::filesystem::path& project,
                    std::initializer_list<std::string_view> endings) {
  const auto refuse = [&out](std::string why) {
    return tl::unexpected(Error(ErrorCode::kInvalidArgument, std::move(why)).at(out.string()));
  };
  if (!project.empty() && store::is_part_of_project(out, project)) return refuse("that is the project itself");
  const std::string ending = ending_of(out);
  if (ending == ".trocar") return refuse("a name that ends in .trocar is a project's");
  if (endings.size() == 0 || std::find(endings.begin(), endings.end(), ending) != endings.end()) return {};
  return refuse(fmt::format("the name must end in {}", fmt::join(endings, " or ")));
}

Result<std::shared_ptr<const demonstration::Demonstration>> find_demonstration(const workbench::Project& project,
                                                                               const std::string& text) {
  return find(project.demonstrations, text, "demonstration");
}

Result<std::shared_ptr<const workbench::TrialEntry>> find_trial(const workbench::Project& project,
                                                                const std::string& text) {
  return find(project.trials, text, "trial");
}

Result<std::shared_ptr<const demonstration::Demonstration>> find_shown(const workbench::Project& project,
                                                                       const std::string& text) {
  if (const auto trial = find_trial(project, text)) return (*trial)->shown;
  return find_demonstration(project, text);
}

Result<std::shared_ptr<const workbench::ModelEntry>> find_model(const workbench::Project& project,
                                                                const std::string& text) {
  return find(project.models, text, "model");
}

std::string free_demonstration_name(const workbench::Project& project, const std::string& wanted, Console& console) {
  return free_name(project.demonstrations, wanted, "demonstration", console);
}

std::string free_model_name(const workbench::Project& project, const std::string& wanted, Console& console) {
  return free_name(project.models, wanted, "model", console);
}

void warn_if_stale(const workbench::Project& project, const workbench::ModelEntry& model, Console& console) {
  if (!project.stale(model)) return;
  console.diagnostics.warn(fmt::format(
      "the model {} is stale: a demonstration that it was trained on has been edited or removed since", model.name));
}

void warn_if_unlike(const workbench::ModelEntry& a, const workbench::ModelEntry& b, Console& console) {
  if (a.segment != b.segment) {
    console.diagnostics.warn(
        fmt::format("{} serves segment {} and {} segment {}: they do different tasks, so that "
                    "their numbers say little about each other",
                    a.name, demonstration::letter(a.segment), b.name, demonstration::letter(b.segment)));
  } else if (a.model->goal != b.model->goal) {
    console.diagnostics.warn(fmt::format(
        "{} and {} have different goals, so that their numbers say little about each other", a.name, b.name));
  }
}

CLI::Option* add_seed(CLI::App& verb, std::uint64_t& seed, const std::string& help) {
  // The parser's own conversion takes -1 for the largest number, and 010 for eight.
  const auto check = [](const std::string& text) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool plain = error == std::errc{} && end == text.data() + text.size() && (text[0] != '0' || text.size() == 1);
    return plain ? "" : text + " is no whole number from 0 to 18446744073709551615";
  };
  return verb.add_option("--seed", seed, help)->check(check)->capture_default_str();
}

Result<std::pair<int, int>> size_from(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = whole_number(std::string_view(text).substr(0, cross));
    const auto height = whole_number(std::string_view(text).substr(cross + 1));
    constexpr std::int64_t kLargest = 8192;
    if (width && height && *width >= 1 && *height >= 1 && *width <= kLargest && *height <= kLargest) {
      return std::pair(static_cast<int>(*width), static_cast<int>(*height));
    }
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("{} is no size like 1280x720 (1 … 8192 each)", text));
}

Result<demonstration::Segment> segment_from(const std::string& text) {
  if (text.size() == 1) {
    const int number = (text[0] & ~0x20) - 'A';
    if (number >= 0 && number < demonstration::kSegmentCount) return static_cast<demonstration::Segment>(number);
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("{} is no segment; there are A, B, C, D and E", text));
}

std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace trocar::app
