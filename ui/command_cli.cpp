#include "ui/command_cli.h"

#include <algorithm>
#include <array>

namespace trocar::ui {
namespace {

struct Equivalent {
  std::string_view id;  ///< One that ends in a dot or _ stands for all that begin so.
  std::string_view cli;
};

constexpr std::array<Equivalent, 79> kEquivalents{{
    {"file.new", "trocar new P"},
    {"file.open", "trocar-workbench P"},
    {"trials.start", "trocar trial run P --mode MT|SC"},
    {"trials.", "trocar trial run P --mode MT|SC"},
    {"file.import", "trocar demo import P FILE"},
    {"file.export_demonstrations", "trocar demo export P DEMO FILE"},
    {"file.export_video", "trocar video render P DEMO --out F.mp4"},
    {"film.", "trocar video render P F.json"},
    {"file.export_field", "trocar field export P MODEL --layer reward --montage --out F.png"},
    {"file.export_plot", "trocar rollout plot P MODEL --kind arrivals --out F.pdf"},
    {"file.checkpoint", "trocar history P --checkpoint NAME"},
    {"edit.undo", "trocar undo P"},
    {"edit.redo", "trocar redo P"},
    {"edit.trim_in", "trocar demo edit P DEMO trim --from S --to S"},
    {"edit.trim_out", "trocar demo edit P DEMO trim --from S --to S"},
    {"edit.clear_gates", "trocar demo edit P DEMO trim --from S --to S"},
    {"edit.trim_idle", "trocar demo edit P DEMO trim-idle"},
    {"edit.split", "trocar demo split P DEMO --at S"},
    {"edit.copy_demonstration", "trocar demo copy P DEMO"},
    {"edit.remove_demonstration", "trocar demo remove P DEMO"},
    {"edit.cut", "trocar demo edit P DEMO delete --from S --to S"},
    {"edit.ripple_delete", "trocar demo edit P DEMO delete --from S --to S"},
    {"edit.lift", "trocar demo edit P DEMO delete --from S --to S --ripple=no"},
    {"edit.paste", "trocar demo edit P DEMO splice --source DEMO --clip-from S --clip-to S --at S"},
    {"edit.paste_meeting",
     "trocar demo edit P DEMO splice --source DEMO --clip-from S --clip-to S --at S --align meet"},
    {"edit.paste_to_peg", "trocar demo edit P DEMO splice --source DEMO --clip-from S --clip-to S --at S --align peg"},
    {"modify.trim", "trocar demo edit P DEMO trim --from S --to S"},
    {"modify.trim_idle", "trocar demo edit P DEMO trim-idle"},
    {"modify.delete", "trocar demo edit P DEMO delete --from S --to S"},
    {"modify.splice", "trocar demo edit P DEMO splice --source DEMO --at S"},
    {"modify.overdub", "trocar demo edit P DEMO overdub --source DEMO --at S --arms left|right|both"},
    {"modify.bridge", "trocar demo edit P DEMO bridge --from S --to S"},
    {"modify.move", "trocar demo edit P DEMO move --at S"},
    {"modify.rotate", "trocar demo edit P DEMO rotate --at S"},
    {"modify.offset", "trocar demo edit P DEMO offset"},
    {"modify.smooth", "trocar demo edit P DEMO smooth"},
    {"modify.simplify", "trocar demo edit P DEMO simplify"},
    {"modify.resample", "trocar demo edit P DEMO resample"},
    {"modify.retime", "trocar demo edit P DEMO retime"},
    {"modify.snap", "trocar demo edit P DEMO snap"},
    {"modify.jaw", "trocar demo edit P DEMO jaw"},
    {"modify.jaw_events", "trocar demo edit P DEMO jaw-events"},
    {"modify.close_gripper", "trocar demo edit P DEMO jaw"},
    {"modify.open_gripper", "trocar demo edit P DEMO jaw"},
    {"modify.rename", "trocar demo edit P DEMO rename"},
    {"modify.mirror", "trocar demo edit P DEMO mirror"},
    {"modify.retarget", "trocar demo edit P DEMO retarget"},
    {"modify.perturb", "trocar demo edit P DEMO perturb"},
    {"modify.copies", "trocar demo copy P DEMO --copies N --perturb-mm MM"},
    {"modify.revert", "trocar demo edit P DEMO revert"},
    {"modify.label", "trocar demo edit P DEMO label"},
    {"modify.propose_labels", "trocar demo edit P DEMO propose-labels"},
    {"modify.label_", "trocar demo edit P DEMO label"},
    {"modify.select_", "trocar demo edit P DEMO label"},
    {"modify.marker", "trocar demo edit P DEMO note"},
    {"modify.note", "trocar demo edit P DEMO note"},
    {"modify.remove_note", "trocar demo edit P DEMO remove-note"},
    {"record.", "trocar demo record P --operator keys --script F"},
    {"demo.record", "trocar demo record P --operator scripted"},
    {"demo.verify", "trocar demo replay P DEMO --verify"},
    {"demo.problems", "trocar demo check P DEMO"},
    {"demo.fix_all", "trocar demo check P DEMO --fix all"},
    {"demo.simulate", "trocar demo check P DEMO --simulate"},
    {"model.import", "trocar model import P FILE --kind q|theta --demo DEMO"},
    {"model.train", "trocar model train P DEMO --segment A --method eg-maxent"},
    {"model.compare", "trocar model compare P MODEL_A MODEL_B"},
    {"tool.move", "trocar demo edit P DEMO move --at S"},
    {"tool.turn", "trocar demo edit P DEMO rotate --at S"},
    {"tool.waypoint", "trocar demo edit P DEMO waypoint --at S"},
    {"tool.nudge_", "trocar demo edit P DEMO move --at S"},
    {"tool.fine_", "trocar demo edit P DEMO move --at S"},
    {"view.camera_", "trocar view render P DEMO --camera paper|top|side|front --out F.png"},
    {"view.field", "trocar view render P DEMO --model M --layer reward --volume --out F.png"},
    {"view.curves", "trocar demo plot P DEMO --out F.png"},
    {"view.diff", "trocar demo diff P DEMO"},
    {"view.comparison", "trocar demo diff P DEMO"},
    {"transport.ruler", "trocar demo export P DEMO F.csv"},
    {"help.shortcuts", "trocar ui manual --out DIR"},
    {"help.page", "trocar ui manual --out DIR"},
}};

}  // namespace

std::string_view cli_of(std::string_view id) {
  const auto* found = std::find_if(kEquivalents.begin(), kEquivalents.end(), [id](const Equivalent& words) {
    return words.id == id || ((words.id.ends_with('_') || words.id.ends_with('.')) && id.starts_with(words.id));
  });
  return found == kEquivalents.end() ? std::string_view() : found->cli;
}

}  // namespace trocar::ui
