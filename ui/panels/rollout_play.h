/// Plays all rollouts together, in the 3-D view and the small pictures: by steps, or by the share of each one's way.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

/// It never begins by itself; at the end the whole ways are seen again.
class RolloutPlay {
 public:
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// The keys of `transport.play` play the rollouts where these are the current panel, but for a widget that the
  /// keyboard is on.
  static bool claims(const Ui& ui, const Chord& chord);

 private:
  bool key_pressed(const Ui& ui) const;
  /// How much is still to come after another moment of it; none: all has been seen.
  std::optional<double> next(const Ui& ui, const workbench::RolloutSettings& settings, double longest);

  bool playing_ = false;
  double shown_s_ = 0.0;  ///< When the last moment of it was shown.
};

}  // namespace trocar::ui
