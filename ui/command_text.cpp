#include "ui/command_text.h"

#include <fmt/format.h>

#include <array>
#include <cctype>

#include "engine/demonstration/edit_words.h"
#include "engine/workbench/importing.h"
#include "engine/workbench/jobs/field_job.h"
#include "ui/edit_text.h"
#include "ui/film_text.h"

namespace trocar::ui {
namespace {

using demonstration::typed_number;
using namespace workbench;

std::string ids(const std::vector<DemonstrationId>& list) {
  std::string text;
  for (const DemonstrationId id : list) text += fmt::format(" {}", id.value);
  return text;
}

std::string record_text(const RecordScripted& command, const std::string& project) {
  const trial::TransferOptions& options = command.options;
  std::string text = fmt::format("trocar demo record {} --operator scripted --skill {} --seed {} --block {} --goal {}",
                                 project, trial::to_string(options.skill), options.seed, options.block, options.goal);
  if (!command.name.empty()) text += " --name " + shell_word(command.name);
  return text;
}

std::string train_text(const TrainModel& command, const std::string& project) {
  const learning::TrainOptions& options = command.options;
  std::string text = fmt::format("trocar model train {}{} --segment {} --method {} --seed {} --grid {}", project,
                                 ids(command.demonstrations), demonstration::letter(command.segment),
                                 learning::to_string(options.method), options.seed, command.grid);
  if (options.method != learning::Method::kExact) {
    text += fmt::format(" --epsilon {} --episodes {}", options.epsilon, options.episodes);
  }
  const learning::TrainOptions usual;
  const auto unusual = [&text](const char* option, auto value, auto usually) {
    if (value != usually) text += fmt::format(" {} {}", option, value);
  };
  unusual("--theta-rate", options.theta_rate, usual.theta_rate);
  unusual("--q-rate", options.q_rate, usual.q_rate);
  unusual("--discount", options.discount, usual.discount);
  unusual("--safe-radius", options.safe_radius, usual.safe_radius);
  unusual("--start-spread", options.start_spread, usual.start_spread);
  unusual("--prior", options.theta_prior, usual.theta_prior);
  unusual("--regularisation", options.regularisation, usual.regularisation);
  if (!command.name.empty()) text += " --name " + shell_word(command.name);
  return text;
}

/// From the starts that are chosen, of the selected model.
std::string rollouts_text(std::string_view verb, const WorkbenchState& state, const std::string& project) {
  return fmt::format("trocar rollout {} {} {} --starts {}", verb, project, state.model.value,
                     shell_word(state.rollouts.starts));
}

std::string erring_text(const learning::MonteCarloOptions& options) {
  return fmt::format(" --epsilon {:g} --runs {} --seed {}", options.epsilon, options.runs, options.seed);
}

std::string perturbed_text(const trial::Perturbation& perturbed) {
  std::string text;
  if (perturbed.epsilon > 0.0) text += fmt::format(" --epsilon {:.6g}", perturbed.epsilon);
  if (perturbed.delay_s > 0.0) text += fmt::format(" --delay-ms {:.6g}", 1e3 * perturbed.delay_s);
  if (perturbed.noise_m > 0.0) text += fmt::format(" --noise-mm {:.6g}", 1e3 * perturbed.noise_m);
  return text;
}

std::string physics_text(const trial::PhysicsOptions& options, const WorkbenchState& state,
                         const std::string& project) {
  return rollouts_text("physics", state, project) + fmt::format(" --seed {}", options.seed) +
         (options.continuous ? " --continuous" : "") + perturbed_text(options.perturbed) + " --out ";
}

std::string rollout_rows_text(const ExportRollouts& command, const WorkbenchState& state, const std::string& project) {
  const std::string path = shell_word(command.path.string());
  if (command.rows == workbench::RolloutRows::kSimulated) {
    return physics_text(state.physics ? state.physics->options : trial::PhysicsOptions(), state, project) + path;
  }
  std::string text = rollouts_text("run", state, project);
  if (command.rows == workbench::RolloutRows::kBand) return text + " --band " + path;
  if (command.rows == workbench::RolloutRows::kErring) {
    text += erring_text(state.monte_carlo ? state.monte_carlo->result.options : learning::MonteCarloOptions());
  }
  return text + " --out " + path;
}

std::string paper_text(const PlotSettings& settings) {
  std::string text;
  if (!settings.preset.empty()) text += " --preset " + settings.preset;
  if (settings.dpi) text += fmt::format(" --dpi {:g}", *settings.dpi);
  if (settings.transparent) text += " --transparent";
  return text;
}

std::string plot_text(const ExportPlot& command, const WorkbenchState& state, const std::string& project) {
  const PlotSettings& settings = command.settings;
  const bool curve = settings.kind == PlotKind::kCurve;
  std::string models = fmt::format("{}", state.model.value);
  const bool second = curve ? state.learning.second != ModelId{} : state.insight && state.insight->second;
  if (second) models += fmt::format(" {}", state.learning.second.value);
  const std::string out = paper_text(settings) + " --out " + shell_word(command.path.string());
  if (curve) return fmt::format("trocar model curve {} {}{}", project, models, out);
  if (settings.kind == PlotKind::kReport) {
    return fmt::format("trocar rollout report {} {} --starts {}{}", project, models, shell_word(state.rollouts.starts),
                       out);
  }
  std::string text = fmt::format("trocar rollout plot {} {}", project, models);
  if (settings.kind != PlotKind::kMap) text += " --starts " + shell_word(state.rollouts.starts);
  text += fmt::format(" --kind {}", workbench::to_string(settings.kind));
  for (std::size_t i = 0; i < settings.measures.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? " --measure " : ",", learning::words_of(settings.measures[i]).word);
  }
  for (const learning::RolloutRange& range : settings.kept) text += " --keep " + workbench::kept_text(range);
  if (settings.kind == PlotKind::kMultiples) {
    text += fmt::format(" --sort {}{} --columns {}", learning::words_of(settings.by).word,
                        settings.descending ? "" : " --ascending", settings.columns);
  }
  if (settings.kind == PlotKind::kMap && !settings.slice.empty()) text += " --slice " + settings.slice;
  return text + out;
}

std::string field_text(const ExportField& command, const std::string& project) {
  std::string what = command.slice.empty() ? "--montage" : "--slice " + command.slice;
  if (command.slab > 1) what += fmt::format(" --slab {} --through {}", command.slab, to_string(command.through));
  std::string look;
  if (command.look.scale) look += fmt::format(" --scale {}", plot::to_string(*command.look.scale));
  if (command.look.map) look += fmt::format(" --map {}", plot::to_string(*command.look.map));
  if (command.look.vision != plot::ColourVision::kFull) {
    look += fmt::format(" --vision {}", plot::to_string(command.look.vision));
  }
  if (command.look.limits) {
    look += fmt::format(" --limits {} {}", (*command.look.limits)[0], (*command.look.limits)[1]);
  }
  if (!command.look.preset.empty()) look += " --preset " + command.look.preset;
  if (command.look.dpi) look += fmt::format(" --dpi {:g}", *command.look.dpi);
  if (command.look.transparent) look += " --transparent";
  // A file of numbers holds them all without being told so.
  const std::string which = command.slice.empty() && !workbench::is_drawn(command.path) ? "" : " " + what;
  std::string of = fmt::format(" --layer {}", learning::to_string(command.layer));
  if (command.mask != learning::FieldMask::kNone) of += fmt::format(" --mask {}", learning::to_string(command.mask));
  if (command.against != ModelId{}) {
    of += fmt::format(" --against {} --show {}", command.against.value, workbench::to_string(command.contrast));
  }
  return fmt::format("trocar field export {} {}{}{}{} --out {}", project, command.model.value, of, which, look,
                     shell_word(command.path.string()));
}

std::string table_text(const ImportTable& command, const std::string& project) {
  std::string text = fmt::format("trocar model import {} {} --kind {}", project, shell_word(command.path.string()),
                                 learning::to_string(command.kind));
  for (const workbench::DemonstrationId id : command.demonstrations) text += fmt::format(" --demo {}", id.value);
  text += fmt::format(" --segment {} --grid {}", demonstration::letter(command.segment), command.grid);
  const ImportTable usual;
  if (command.safe_radius != usual.safe_radius) text += fmt::format(" --safe-radius {}", command.safe_radius);
  return command.name.empty() ? text : text + " --name " + shell_word(command.name);
}

/// JSON without its line breaks and what they are followed by: neither occurs within its strings.
std::string on_one_line(const std::string& json) {
  std::string line;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] != '\n') {
      line += json[i];
      continue;
    }
    while (i + 1 < json.size() && json[i + 1] == ' ') ++i;
  }
  return line;
}

std::string import_text(const WorkbenchState& state, const std::string& project) {
  if (!state.import) return "";
  const ImportSettings& settings = state.import->settings;
  std::string text = fmt::format("trocar demo import {} {}", project, shell_word(settings.path.string()));
  if (settings.format) text += fmt::format(" --format {}", exchange::to_string(*settings.format));
  if (!settings.transcription.empty()) text += " --transcription " + shell_word(settings.transcription.string());
  for (const std::string& only : settings.only) text += " --only " + shell_word(only);
  if (settings.rate_hz > 0.0) text += fmt::format(" --rate-hz {}", settings.rate_hz);
  const auto& p = settings.p_WF_m;
  if (p != std::array<double, 3>{}) {
    text += fmt::format(" --offset-mm {},{},{}", typed_number(1e3 * p[0]), typed_number(1e3 * p[1]),
                        typed_number(1e3 * p[2]));
  }
  if (!settings.name.empty()) text += " --name " + shell_word(settings.name);
  if (settings.block != demonstration::kUnknownPlace) text += fmt::format(" --block {}", settings.block);
  if (settings.goal != demonstration::kUnknownPlace) text += fmt::format(" --goal {}", settings.goal);
  if (!state.import->layout.columns) return text;
  return text + " --map " + (settings.map ? shell_word(on_one_line(exchange::to_json(*settings.map))) : "proposed");
}

std::string export_text(const ExportDemonstrations& command, const std::string& project) {
  std::string text = fmt::format("trocar demo export {}{} {} --format {}", project, ids(command.demonstrations),
                                 shell_word(command.path.string()), exchange::to_string(command.format));
  for (const auto& [key, places] : command.masks) {
    for (const std::size_t place : places) {
      text += " --mask " + shell_word(fmt::format("{}={}", key, command.demonstrations[place].value));
    }
  }
  return text;
}

/// One field that is drawn besides, as --also takes it.
std::string also_text(const workbench::FieldSettings& field) {
  std::string text(learning::to_string(field.layer));
  if (field.mask != learning::FieldMask::kNone) text += fmt::format(",mask={}", learning::to_string(field.mask));
  if (field.scale != plot::ScaleKind::kLinear) text += fmt::format(",scale={}", plot::to_string(field.scale));
  if (field.map) text += fmt::format(",map={}", plot::to_string(*field.map));
  if (field.voxels) text += fmt::format(",voxels={:.6g}", field.voxel_threshold);
  if (field.iso_surface) text += fmt::format(",iso={:.6g}", field.iso_level);
  if (field.volume) text += ",volume";
  if (field.volume && field.opacity_curve) text += "=" + plot::to_string(*field.opacity_curve);
  for (std::size_t i = 0; i < field.slices.size(); ++i) {
    if (field.slices[i] >= 0) text += fmt::format(",{}={}", "xyz"[i], field.slices[i]);
  }
  return text + fmt::format(",opacity={:.6g}", field.opacity);
}

/// The field in the view, from the paper's camera or a preset; "" where there is nothing to draw it with.
std::string view_text(const workbench::FieldSettings& field, const WorkbenchState& state, const std::string& project) {
  if (state.demonstration == DemonstrationId{} || state.model == ModelId{}) return "";
  std::string text = fmt::format("trocar view render {} {} --model {} --layer {}", project, state.demonstration.value,
                                 state.model.value, learning::to_string(field.layer));
  for (const workbench::FieldSettings& layer : state.field_layers) {
    if (layer.visible) text += " --also " + shell_word(also_text(layer));
  }
  if (field.mask != learning::FieldMask::kNone) text += fmt::format(" --mask {}", learning::to_string(field.mask));
  if (state.learning.second_in_view && state.insight && state.insight->second) {
    text += fmt::format(" --beside {}", state.learning.second.value);
  }
  if (field.scale != plot::ScaleKind::kLinear) text += fmt::format(" --scale {}", plot::to_string(field.scale));
  if (field.map) text += fmt::format(" --map {}", plot::to_string(*field.map));
  if (field.vision != plot::ColourVision::kFull) text += fmt::format(" --vision {}", plot::to_string(field.vision));
  if (field.limits) text += fmt::format(" --limits {} {}", (*field.limits)[0], (*field.limits)[1]);
  constexpr std::array<char, 3> kAxes{'x', 'y', 'z'};
  bool slices = false;
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (field.slices[i] < 0) continue;
    text += fmt::format(" --slice {}={}", kAxes[i], field.slices[i]);
    slices = true;
  }
  if (!slices) text += " --no-slices";
  if (field.slabs != std::array{1, 1, 1}) {
    text += fmt::format(" --slab {},{},{}", field.slabs[0], field.slabs[1], field.slabs[2]);
    if (field.through != learning::Through::kLargest) text += fmt::format(" --through {}", to_string(field.through));
  }
  if (field.voxels) text += fmt::format(" --voxels {:.6g}", field.voxel_threshold);
  if (field.iso_surface) text += fmt::format(" --iso {:.6g}", field.iso_level);
  if (field.volume) text += " --volume";
  if (field.volume && field.opacity_curve) text += " --opacity-curve " + plot::to_string(*field.opacity_curve);
  if (field.glyphs != workbench::Glyphs::kNone) text += fmt::format(" --glyphs {}", to_string(field.glyphs));
  if (field.streamlines) text += " --streamlines " + shell_word(field.streamline_starts);
  return text + fmt::format(" --opacity {:.6g} --out F.png", field.opacity);
}

/// What the panel of models shows; "" where the command line has no word for it.
std::string learning_text(const workbench::LearningSettings& settings, const WorkbenchState& state,
                          const std::string& project) {
  if (!state.project) return "";
  const auto found = state.project->models.find(state.model);
  if (found == state.project->models.end() || found->second->model == nullptr) return "";
  const workbench::ModelEntry& entry = *found->second;
  if (settings.seeds > 0 && settings.seeds != state.learning.seeds) {
    TrainModel train;
    train.demonstrations = entry.demonstrations;
    train.segment = entry.segment;
    train.options = entry.model->options;
    train.grid = entry.model->grid.n;
    std::string text = train_text(train, project);
    text.replace(text.find(" model train "), std::string_view(" model train ").size(), " model seeds ");
    return text + fmt::format(" --seeds {} --layer {}", settings.seeds, learning::to_string(state.field.layer));
  }
  if (settings.second_in_view != state.learning.second_in_view) {
    WorkbenchState next = state;
    next.learning = settings;
    return view_text(state.field, next, project);
  }
  if (settings.second != state.learning.second && settings.second != ModelId{}) {
    return fmt::format("trocar model compare {} {} {}", project, state.model.value, settings.second.value);
  }
  return "";
}

/// Of a person there is none: nobody sits at the command line. A console brings one transfer there, a whole protocol
/// only to the window.
std::string trials_text(const StartTrials& trials, const std::string& project, const Project& of) {
  if (trials.person || (trials.person_assists && !trials.console_port)) return "";
  if (trials.console_port && !trials.protocol.empty()) return "";
  const TrialPlan& plan = trials.plan;
  const trial::TrialOptions& options = plan.options;
  std::string text = "trocar trial run " + project;
  if (trials.protocol.empty()) {
    text += fmt::format(" --mode {}", trial::to_string(options.mode));
    if (!trials.console_port) text += fmt::format(" --transfers {}", plan.transfers);
    const std::string delay = control::to_string(options.delay);
    if (delay != "0") text += " --delay-ms " + delay;
  } else {
    text += fmt::format(" --protocol {} --subject-number {}", shell_word(trials.protocol), trials.subject_number);
  }
  if (trials.console_port) {
    text +=
        fmt::format(" --operator tcp --listen {}{}", *trials.console_port, trials.person_assists ? " --assist" : "");
  } else {
    text += fmt::format(" --skill {}", trial::to_string(options.skill));
  }
  text += fmt::format(" --seed {}", plan.seed);
  for (const ModelId id : plan.models) {
    const auto model = of.models.find(id);
    if (model == of.models.end()) continue;
    text += fmt::format(" --model-{} {}", model->second->segment == demonstration::Segment::kA ? "a" : "c", id.value);
  }
  if (trials.from) {
    text += fmt::format(" --from-cell {},{},{}", trials.from->cell.x, trials.from->cell.y, trials.from->cell.z);
    if (trials.from->grid != 22) text += fmt::format(" --grid {}", trials.from->grid);
  }
  if (plan.same_block) text += fmt::format(" --block {}", plan.first_block);
  if (!plan.same_block && plan.first_block != 0) text += fmt::format(" --first-block {}", plan.first_block);
  if (options.anchor != trial::Anchor::kBoard) text += " --anchor target";
  if (options.agent_rate_hz != 20.0) text += fmt::format(" --agent-rate {:g}", options.agent_rate_hz);
  return text;
}

std::string batch_text(const BatchRequest& request, const std::string& project) {
  std::string text = "trocar demo batch " + project;
  for (const DemonstrationId id : request.demonstrations) text += fmt::format(" --demo {}", id.value);
  text += " --";
  for (const std::string& word : request.words) text += " " + shell_word(word);
  return text;
}

}  // namespace

std::string shell_word(const std::string& word) {
  bool plain = !word.empty();
  for (const char c : word) {
    const bool fine = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                      std::string_view("/._-+=:,@%").find(c) != std::string_view::npos;
    plain = plain && fine;
  }
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string command_text(const workbench::Command& command, const workbench::WorkbenchState& state) {
  const std::string project = shell_word(state.path.string());
  if (const auto* edit = std::get_if<CommitEdit>(&command)) {
    if (std::holds_alternative<Batch>(edit->edit) && state.batch) return batch_text(state.batch->of, project);
  }
  if (const auto* name = std::get_if<NameCheckpoint>(&command)) {
    return fmt::format("trocar history {} --at {} --checkpoint {}", project, name->node,
                       shell_word(name->name ? *name->name : unused_name(state.checkpoints)));
  }
  if (const auto* edit = std::get_if<CommitEdit>(&command)) return edit_text(edit->edit, project);
  if (std::holds_alternative<Undo>(command)) return "trocar undo " + project;
  if (std::holds_alternative<Redo>(command)) return "trocar redo " + project;
  if (const auto* go = std::get_if<GoToHistory>(&command)) {
    return fmt::format("trocar history {} --go {}", project, go->node);
  }
  if (const auto* open = std::get_if<OpenProject>(&command)) {
    return (open->create ? "trocar new " : "trocar-workbench ") + shell_word(open->path.string());
  }
  if (const auto* record = std::get_if<RecordScripted>(&command)) return record_text(*record, project);
  if (const auto* trials = std::get_if<StartTrials>(&command)) return trials_text(*trials, project, *state.project);
  if (const auto* out = std::get_if<ExportTrials>(&command)) {
    return fmt::format("trocar trial results {} {} {}", project,
                       out->path.extension() == ".html"  ? "--report"
                       : out->path.extension() == ".csv" ? "--trials"
                                                         : "--figure",
                       shell_word(out->path.string()));
  }
  if (const auto* train = std::get_if<TrainModel>(&command)) return train_text(*train, project);
  if (std::holds_alternative<MakeImport>(command)) return import_text(state, project);
  if (const auto* out = std::get_if<ExportDemonstrations>(&command)) return export_text(*out, project);
  if (const auto* verify = std::get_if<VerifyReplay>(&command)) {
    return fmt::format("trocar demo replay {} {} --verify", project, verify->demonstration.value);
  }
  if (const auto* simulate = std::get_if<SimulateDemonstration>(&command)) {
    return fmt::format("trocar demo check {} {} --simulate", project, simulate->demonstration.value);
  }
  if (const auto* fix = std::get_if<FixProblems>(&command)) {
    return fmt::format("trocar demo check {} {} --fix all", project, fix->demonstration.value);
  }
  if (const auto* video = std::get_if<ExportVideo>(&command)) return film_text(*video, project);
  if (const auto* film = std::get_if<RenderFilm>(&command)) return film_text(film->film, state);
  if (const auto* compare = std::get_if<CompareWith>(&command)) {
    return fmt::format("trocar demo diff {} {} --against {} --align {}", project, state.demonstration.value,
                       to_words(compare->settings.against), demonstration::to_string(compare->settings.alignment));
  }
  if (const auto* figure = std::get_if<ExportField>(&command)) return field_text(*figure, project);
  if (const auto* table = std::get_if<ImportTable>(&command)) return table_text(*table, project);
  if (const auto* field = std::get_if<SetField>(&command)) return view_text(field->settings, state, project);
  if (const auto* learning = std::get_if<workbench::SetLearning>(&command)) {
    return learning_text(learning->settings, state, project);
  }
  if (const auto* layers = std::get_if<workbench::SetFieldLayers>(&command)) {
    WorkbenchState next = state;
    next.field_layers = layers->layers;
    return view_text(state.field, next, project);
  }
  if (const auto* rows = std::get_if<ExportRollouts>(&command)) return rollout_rows_text(*rows, state, project);
  if (const auto* plot = std::get_if<ExportPlot>(&command)) return plot_text(*plot, state, project);
  if (const auto* erring = std::get_if<RunMonteCarlo>(&command)) {
    return rollouts_text("run", state, project) + erring_text(erring->options);
  }
  if (const auto* physics = std::get_if<RunPhysics>(&command)) {
    return physics_text(physics->options, state, project) + "rollouts.csv";
  }
  return "";
}

}  // namespace trocar::ui
