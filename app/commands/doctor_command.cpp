#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "app/options.h"
#include "engine/core/file.h"
#include "engine/device/joystick.h"
#include "engine/device/space_mouse.h"
#include "engine/media/video_writer.h"
#include "engine/render/renderer.h"

namespace trocar::app {
namespace {

struct NoArguments {};

struct Finding {
  std::string part;
  std::string name;
  bool available = false;
  std::string detail;  ///< What it is, or why it is not there.
};

Finding examine_gl() {
  const Result<render::Renderer> renderer = render::Renderer::create();
  if (!renderer) return {"gl", "pictures", false, renderer.error().text()};
  return {"gl", "pictures", true, renderer->description()};
}

std::vector<Finding> examine_codecs() {
  using media::Codec;
  const std::vector<Codec> available = media::available_codecs();
  std::vector<Finding> findings;
  for (const Codec codec : media::all_codecs()) {
    const bool found = std::find(available.begin(), available.end(), codec) != available.end();
    findings.push_back({"codecs", std::string(media::to_string(codec)), found,
                        found ? "films can be written" : "FFmpeg's libraries on this machine cannot write it"});
  }
  return findings;
}

Finding examine_assets() {
  const std::filesystem::path assets = share_path("assets");
  const bool found = std::filesystem::is_directory(assets);
  return {"files", "assets", found, found ? assets.string() : "not found at " + assets.string()};
}

Finding examine_space_mouse() {
  const Result<device::SpaceMouse> found = device::SpaceMouse::open();
  return {"devices", "SpaceMouse", found.has_value(), found ? "through spacenavd" : found.error().text()};
}

Finding examine_gamepad() {
  const Result<device::Joystick> found = device::Joystick::open("/dev/input/js0");
  return {"devices", "gamepad", found.has_value(), found ? "in the window and trocar-console" : found.error().text()};
}

Finding examine_display() {
  for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"}) {
    const char* value = std::getenv(variable);
    if (value != nullptr && *value != '\0') return {"window", "display", true, fmt::format("${}={}", variable, value)};
  }
  return {"window", "display", false, "neither $DISPLAY nor $WAYLAND_DISPLAY is set; `trocar ui run` needs none"};
}

Result<Answer> run_doctor(const NoArguments& /*arguments*/, Console& /*console*/) {
  std::vector<Finding> findings = {examine_gl()};
  for (Finding& finding : examine_codecs()) findings.push_back(std::move(finding));
  for (const char* format : {"csv", "npy", "hdf5"})
    findings.push_back({"formats", format, true, "demo import and export"});
  findings.push_back({"formats", "jigsaws", true, "demo import"});
  findings.push_back(examine_assets());
  findings.push_back(examine_display());
  findings.push_back({"devices", "simulated arms", true, "both PSMs, in ODE"});
  findings.push_back({"devices", "keyboard and mouse", true, "in the window"});
  findings.push_back(examine_gamepad());
  findings.push_back(examine_space_mouse());
  findings.push_back({"devices", "physical arms", false, "this version drives simulated arms only"});
  findings.push_back({"links", "tcp", true,
                      "`trocar trial run --operator tcp`, trials in the window; trocar-console at the other end"});

  Answer answer;
  bool usable = true;
  for (const Finding& finding : findings) {
    answer.json[finding.part].push_back(
        {{"name", finding.name}, {"available", finding.available}, {"detail", finding.detail}});
    answer.text += fmt::format("{} {:<8} {:<16} {}\n", finding.available ? "yes" : "no ", finding.part, finding.name,
                               finding.detail);
    const bool needed = finding.part == "gl" || finding.part == "files";
    usable = usable && (finding.available || !needed);
  }
  answer.json["usable"] = usable;
  answer.text.pop_back();
  answer.summary = usable ? "this machine can do everything that needs no window" : "something is missing";
  answer.passed = usable;
  return answer;
}

}  // namespace

void add_doctor_command(CLI::App& root, Action& chosen) {
  add_verb<NoArguments>(
      root, chosen, "doctor", "Say what this machine offers: GL, codecs, formats, devices, links; and why not",
      [](CLI::App&, NoArguments&) {}, run_doctor);
}

}  // namespace trocar::app
