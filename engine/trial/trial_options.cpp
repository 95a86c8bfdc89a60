#include "engine/trial/trial_options.h"

namespace trocar::trial {

std::string_view to_string(Mode mode) {
  return mode == Mode::kManual ? "MT" : "SC";
}

Result<Mode> mode_from(std::string_view text) {
  if (text == "MT" || text == "mt") return Mode::kManual;
  if (text == "SC" || text == "sc") return Mode::kShared;
  return fail(ErrorCode::kInvalidArgument,
              "the mode is MT (manual) or SC (shared control), not \"" + std::string(text) + "\"");
}

std::string_view to_string(TrialEventKind kind) {
  constexpr std::array<std::string_view, 7> kNames{"pedal",   "state", "guard",   "segment",
                                                   "outcome", "agent", "incident"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace trocar::trial
