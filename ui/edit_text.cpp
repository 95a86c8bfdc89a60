#include "ui/edit_text.h"

#include <fmt/format.h>

#include "engine/demonstration/edit_words.h"
#include "ui/command_text.h"

namespace trocar::ui {
namespace {

using demonstration::typed_number;
using namespace workbench;

struct EditText {
  std::string project;
  std::string operator()(const AddDemonstration&) const { return ""; }
  std::string operator()(const PunchIn&) const { return ""; }
  // The window copies one at a time.
  /// Copies as a form makes them: of one demonstration, with noise of seeds that count up.
  std::string operator()(const CopyDemonstrations& edit) const {
    if (edit.copies.empty()) return "";
    const auto noise_of = [](const CopyDemonstration& copy) {
      return copy.edits.size() == 1 ? std::get_if<demonstration::Perturb>(&copy.edits.front()) : nullptr;
    };
    const CopyDemonstration& first = edit.copies.front();
    const auto* noise = noise_of(first);
    if (noise == nullptr || !first.name.empty()) return "";
    return fmt::format("trocar demo copy {} {} --copies {} --perturb-mm {} --period {} --seed {}", project,
                       first.demonstration.value, edit.copies.size(), typed_number(1e3 * noise->sigma_m),
                       typed_number(noise->period_s), noise->seed);
  }
  std::string operator()(const ImportDemonstrations&) const { return ""; }
  std::string operator()(const AddModel&) const { return ""; }
  std::string operator()(const CopyDemonstration& edit) const {
    return named(fmt::format("trocar demo copy {} {}", project, edit.demonstration.value), edit.name);
  }
  std::string operator()(const SplitDemonstration& edit) const {
    return named(fmt::format("trocar demo split {} {} --at {}", project, edit.demonstration.value, edit.at_s),
                 edit.name);
  }
  static std::string named(const std::string& command, const std::string& name) {
    return name.empty() ? command : fmt::format("{} --name {}", command, shell_word(name));
  }
  std::string operator()(const RemoveDemonstration& edit) const {
    return fmt::format("trocar demo remove {} {}", project, edit.demonstration.value);
  }
  std::string operator()(const RestoreDemonstration& edit) const {
    return fmt::format("trocar demo restore {} {}", project, edit.demonstration.value);
  }
  std::string operator()(const MarkDemonstration& edit) const {
    std::string text = fmt::format("trocar demo tag {} {}", project, edit.demonstration.value);
    const MarkChange& change = edit.change;
    for (const std::string& tag : change.add) text += " --add " + shell_word(tag);
    for (const std::string& tag : change.remove) text += " --remove " + shell_word(tag);
    if (change.flag) text += fmt::format(" --flag {}", to_string(*change.flag));
    if (change.verdict) text += fmt::format(" --verdict {}", to_string(*change.verdict));
    if (change.rating) text += fmt::format(" --rating {}", *change.rating);
    if (change.note) text += " --note " + shell_word(*change.note);
    return text;
  }
  std::string operator()(const SaveFilter& edit) const {
    return fmt::format("trocar demo filter {} {} {}", project, shell_word(edit.name), shell_word(edit.query));
  }
  std::string operator()(const RemoveFilter& edit) const {
    return fmt::format("trocar demo filter {} {} --remove", project, shell_word(edit.name));
  }
  // What was planned is in the state, see below.
  std::string operator()(const Batch&) const { return ""; }
  // Trials are added by running them.
  std::string operator()(const AddTrial&) const { return ""; }
  std::string operator()(const JudgeTrial& edit) const {
    return fmt::format("trocar trial judge {} {} {}", project, edit.trial.value,
                       edit.excluded ? "--exclude " + shell_word(edit.reason) : "--include");
  }
  // The command line does not remove models; there is nothing to copy.
  std::string operator()(const RemoveModel&) const { return ""; }
  static std::string words(const demonstration::Edit& edit) {
    std::string text;
    for (const std::string& word : demonstration::to_words(edit))
      text += fmt::format("{}{}", text.empty() ? "" : " ", shell_word(word));
    return text;
  }
  std::string stack(DemonstrationId demonstration, std::int64_t entry, const std::string& change) const {
    return fmt::format("trocar demo stack {} {} {} {}", project, demonstration.value, demonstration::entry_words(entry),
                       change);
  }
  std::string operator()(const MoveStackEntry& edit) const {
    return stack(edit.demonstration, edit.entry, fmt::format("move {}", edit.place + 1));
  }
  std::string operator()(const EnableStackEntry& edit) const {
    return stack(edit.demonstration, edit.entry, edit.enabled ? "enable" : "disable");
  }
  std::string operator()(const ReplaceStackEntry& edit) const {
    return stack(edit.demonstration, edit.entry, "change -- " + words(edit.edit));
  }
  std::string operator()(const NameStackEntry& edit) const {
    return stack(edit.demonstration, edit.entry, "name " + shell_word(edit.name));
  }
  std::string operator()(const RemoveStackEntry& edit) const { return stack(edit.demonstration, edit.entry, "remove"); }
  std::string operator()(const EditDemonstration& edit) const {
    const std::string head = fmt::format("trocar demo edit {} {} ", project, edit.demonstration.value);
    return head + words(edit.edit);
  }
};

}  // namespace

std::string edit_text(const Edit& edit, const std::string& project) {
  return std::visit(EditText{project}, edit);
}

}  // namespace trocar::ui
