/// What several panels draw alike: the states without a project, chips of segments, buttons of commands.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ui/command_table.h"
#include "ui/panel.h"

namespace trocar::ui {

/// Where no project is ready: true, and why and what can be done about it is drawn.
bool draw_no_project(Ui& ui, const WorkbenchState& state, Requests& requests);
/// The same at length, for the view: with all ways on.
bool draw_welcome(Ui& ui, const WorkbenchState& state, Requests& requests);

/// Why nothing of the document can be changed while a take goes on or waits for its verdict; "" if it can.
std::string_view being_recorded(const WorkbenchState& state);

/// A button for a row of the command table: its icon, help, keys and reason.
void command_button(Ui& ui, const WorkbenchState& state, std::string_view id, std::string_view label, ButtonStyle style,
                    Requests& requests);
void command_icon(Ui& ui, const WorkbenchState& state, std::string_view id, Requests& requests,
                  ButtonStyle style = ButtonStyle::kQuiet);

/// Something of the field is drawn in the 3-D view: it is on, and a slice or another drawing is chosen.
bool shows_field(const workbench::FieldSettings& settings);

/// A letter on its colour; an outline where the demonstration lacks the segment.
void segment_chip(Ui& ui, demonstration::Segment segment, bool present, float size);
void segment_chips(Ui& ui, const demonstration::Demonstration& shown, float size);

Rgba outcome_colour(const Theme& theme, demonstration::Outcome outcome);
/// "placed", "dropped" …: the outcome in one word, "edited since" once the motion is another than that which had it;
/// its sign makes it more than a colour.
std::string outcome_words(const demonstration::Demonstration& shown);
const char* outcome_sign(demonstration::Outcome outcome);

/// Each with a sign in front, wrapped.
void sentences(Ui& ui, const char* sign, std::span<const std::string> list, Rgba colour);

/// A block's or a peg's number, or "unknown".
std::string place_words(int place);
/// "scripted expert", "imported".
std::string provenance_words(const demonstration::Provenance& provenance);

void append(Requests& to, Requests from);

/// What a panel over time has room for, in seconds: all samples, gates or not; 1 for none.
double length_of(const demonstration::Demonstration& shown);

}  // namespace trocar::ui
