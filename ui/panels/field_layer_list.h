/// The fields that are drawn in the 3-D view besides the one that the panel is about: a list with an eye, opacity and
/// order, as layers in a picture editor.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

/// Precondition: there is an insight with a field.
void draw_field_layers(Ui& ui, const WorkbenchState& state, Requests& requests);

/// "reward · volume, in the safe set"
std::string field_words(const workbench::FieldSettings& settings);

}  // namespace trocar::ui
