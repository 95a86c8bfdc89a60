/// The parameters of every edit, once: journal, command line, inspector and manual are made from this list.
#pragma once

#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// What a parameter is called and means; the unit is in the key ("from_s").
struct Field {
  const char* key;
  const char* help;
  bool positional = false;  ///< On a command line its value stands alone, before the options.
  bool younger = false;     ///< Journals may be without it; then it is as in `without_younger`.
};

/// The edit as a journal means it that says nothing of its younger parameters: what it did before they were there.
template <typename Edited>
Edited without_younger() {
  return {};
}
template <>
inline TrimIdle without_younger<TrimIdle>() {
  TrimIdle edit;
  edit.window_s = 0.15;
  return edit;
}
template <>
inline Bridge without_younger<Bridge>() {
  Bridge edit;
  edit.rate_hz = kSampleRate_hz;
  return edit;
}
template <>
inline SnapToGrid without_younger<SnapToGrid>() {
  SnapToGrid edit;
  edit.keep_snapped = false;
  return edit;
}

/// The words for the values of an enumeration, by its number.
template <typename Enum>
std::span<const std::string_view> words_of();
template <>
std::span<const std::string_view> words_of<Segment>();
template <>
std::span<const std::string_view> words_of<Arms>();
template <>
std::span<const std::string_view> words_of<Align>();
template <>
std::span<const std::string_view> words_of<BridgeShape>();
template <>
std::span<const std::string_view> words_of<Falloff>();
template <>
std::span<const std::string_view> words_of<TurnFrame>();
template <>
std::span<const std::string_view> words_of<Filter>();
template <>
std::span<const std::string_view> words_of<RetimeTo>();
template <>
std::span<const std::string_view> words_of<ResampleBy>();
template <>
std::span<const std::string_view> words_of<RevertWhat>();
template <>
std::span<const std::string_view> words_of<NoteColour>();
template <>
std::span<const std::string_view> words_of<NoteGlyph>();

/// Calls `act(const Edited*)`, a null pointer, for every kind of edit.
template <typename Act>
void for_each_edit(Act act) {
  []<std::size_t... kIndex>(Act & each, std::index_sequence<kIndex...>) {
    (each(static_cast<const std::variant_alternative_t<kIndex, Edit>*>(nullptr)), ...);
  }
  (act, std::make_index_sequence<std::variant_size_v<Edit>>());
}

// One overload for each edit: calls `visitor.field(Field, value)` for each parameter, in the order in which people say
// them. `Of<Edited, Trim>` takes a `Trim&` or a `const Trim&`.
template <typename Edited, typename Kind>
concept Of = std::is_same_v<std::remove_const_t<Edited>, Kind>;

template <typename Visitor, Of<Trim> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "New begin"}, edit.from_s);
  visitor.field(Field{"to_s", "New end"}, edit.to_s);
}
template <typename Visitor, Of<TrimIdle> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"speed_m_s", "Slower is idle"}, edit.speed_m_s);
  visitor.field(Field{"longer_s", "Shorter pauses stay"}, edit.longer_s);
  visitor.field(Field{"keep_s", "What stays of each pause"}, edit.keep_s);
  visitor.field(Field{"ends", "Trim the ends"}, edit.ends);
  visitor.field(Field{"inside", "Cut pauses inside too"}, edit.inside);
  visitor.field(Field{"window_s", "Speeds are measured over so long before and after; 0: by the rate", false, true},
                edit.window_s);
  visitor.field(Field{"keep_samples", "What stays of each, in samples; 0: as the time says", false, true},
                edit.keep_samples);
  visitor.field(Field{"stay_s", "What is idle at these times stays whole", false, true}, edit.stay_s);
}
template <typename Visitor, Of<Rename> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"name", "The new name", true}, edit.name);
}
template <typename Visitor, Of<LabelSegment> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"label", "Segment A, B, C, D or E", true}, edit.label);
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
}
template <typename Visitor, Of<ProposeLabels> Edited>
void visit_fields(Visitor& /*visitor*/, Edited& /*edit*/) {}
template <typename Visitor, Of<DeleteSpan> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"ripple", "Close the gap"}, edit.ripple);
}
template <typename Visitor, Of<Splice> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"source", "The demonstration to take it from"}, edit.source);
  visitor.field(Field{"clip_from_s", "Where it begins there"}, edit.clip_from_s);
  visitor.field(Field{"clip_to_s", "Where it ends there"}, edit.clip_to_s);
  visitor.field(Field{"at_s", "Where it goes"}, edit.at_s);
  visitor.field(Field{"until_s", "It replaces what lies up to here; 0: nothing"}, edit.until_s);
  visitor.field(Field{"align", "Where the arms go"}, edit.align);
  visitor.field(Field{"as_of", "The point of the history at which the source is meant; 0: now"}, edit.as_of);
  visitor.field(Field{"peg", "To which start peg, 0 to 5, with peg; -1: this demonstration's", false, true}, edit.peg);
}
template <typename Visitor, Of<Overdub> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"source", "The demonstration to take it from"}, edit.source);
  visitor.field(Field{"clip_from_s", "Where it begins there"}, edit.clip_from_s);
  visitor.field(Field{"clip_to_s", "Where it ends there"}, edit.clip_to_s);
  visitor.field(Field{"at_s", "Where it goes"}, edit.at_s);
  visitor.field(Field{"arms", "Whose motion is replaced"}, edit.arms);
  visitor.field(Field{"ease_s", "After it, back to the old motion within this time; 0: at once"}, edit.ease_s);
  visitor.field(Field{"as_of", "The point of the history at which the source is meant; 0: now"}, edit.as_of);
}
template <typename Visitor, Of<Bridge> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"arms", "Which arms"}, edit.arms);
  visitor.field(Field{"shape", "Kind of motion"}, edit.shape);
  visitor.field(Field{"peak_speed_m_s", "Sets the duration; 0: as it is"}, edit.peak_speed_m_s);
  visitor.field(Field{"via_m", "Points to pass"}, edit.via_m);
  visitor.field(Field{"model", "Whose policy; 0: the newest of the segment", false, true}, edit.model);
  visitor.field(Field{"rate_hz", "Of the new samples; 0: as on either side", false, true}, edit.rate_hz);
}
template <typename Visitor, Of<MoveTool> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"arms", "Which arm"}, edit.arms);
  visitor.field(Field{"at_s", "The middle"}, edit.at_s);
  visitor.field(Field{"by_m", "How far, in the board frame"}, edit.by_m);
  visitor.field(Field{"radius_s", "How far in time it reaches"}, edit.radius_s);
  visitor.field(Field{"falloff", "How it fades"}, edit.falloff);
}
template <typename Visitor, Of<RotateTool> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"arms", "Which arm"}, edit.arms);
  visitor.field(Field{"at_s", "The middle"}, edit.at_s);
  visitor.field(Field{"by_rad", "Rotation vector"}, edit.by_rad);
  visitor.field(Field{"frame", "Whose axes"}, edit.frame);
  visitor.field(Field{"radius_s", "How far in time it reaches"}, edit.radius_s);
  visitor.field(Field{"falloff", "How it fades"}, edit.falloff);
}
template <typename Visitor, Of<Offset> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"arms", "Which arms"}, edit.arms);
  visitor.field(Field{"by_m", "How far, in the board frame"}, edit.by_m);
}
template <typename Visitor, Of<Smooth> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"arms", "Which arms"}, edit.arms);
  visitor.field(Field{"filter", "Kind of filter"}, edit.filter);
  visitor.field(Field{"width_s", "Of the window"}, edit.width_s);
  visitor.field(Field{"max_deviation_m", "No sample moves further"}, edit.max_deviation_m);
  visitor.field(Field{"lock_contacts", "Hold still where a grasp begins or ends"}, edit.lock_contacts);
  visitor.field(Field{"lock_ends", "Ease in and out at the ends of the span", false, true}, edit.lock_ends);
  visitor.field(Field{"lock_jaws", "Hold still where a gripper opens or closes", false, true}, edit.lock_jaws);
}
template <typename Visitor, Of<Simplify> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"arms", "Which arm"}, edit.arms);
  visitor.field(Field{"tolerance_m", "How far the path may move"}, edit.tolerance_m);
}
template <typename Visitor, Of<Resample> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"rate_hz", "The new rate"}, edit.rate_hz);
  visitor.field(Field{"method", "How it goes between samples", false, true}, edit.method);
}
template <typename Visitor, Of<Retime> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"mode", "What is given"}, edit.mode);
  visitor.field(Field{"scale", "Factor of the duration"}, edit.scale);
  visitor.field(Field{"duration_s", "The new duration"}, edit.duration_s);
  visitor.field(Field{"speed_m_s", "The speed of the faster tool"}, edit.speed_m_s);
  visitor.field(Field{"ease_in_s", "How long it takes to get going; 0: at once", false, true}, edit.ease_in_s);
  visitor.field(Field{"ease_out_s", "How long it takes to come to rest; 0: at once", false, true}, edit.ease_out_s);
  visitor.field(Field{"knots_s", "With warp: old time to new time, as 1.5:2,3:2.5", false, true}, edit.knots_s);
}
template <typename Visitor, Of<SnapToGrid> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"arms", "Which arm"}, edit.arms);
  visitor.field(Field{"keep_offset", "Keep the place within the cell"}, edit.keep_offset);
  visitor.field(Field{"keep_snapped", "Leave what lies on the lattice already", false, true}, edit.keep_snapped);
}
template <typename Visitor, Of<SetJaw> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"arms", "Which arm"}, edit.arms);
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"jaw_rad", "The opening"}, edit.jaw_rad);
  visitor.field(Field{"ramp_s", "How long it takes"}, edit.ramp_s);
}
template <typename Visitor, Of<JawEvents> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"arms", "Which arms"}, edit.arms);
  visitor.field(Field{"ramp_s", "How long each takes"}, edit.ramp_s);
}
template <typename Visitor, Of<Mirror> Edited>
void visit_fields(Visitor& /*visitor*/, Edited& /*edit*/) {}
template <typename Visitor, Of<Retarget> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"block", "The block, 0 to 5"}, edit.block);
  visitor.field(Field{"goal", "The goal peg, 0 to 5"}, edit.goal);
}
template <typename Visitor, Of<Perturb> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"sigma_m", "Standard deviation"}, edit.sigma_m);
  visitor.field(Field{"period_s", "Over which it changes"}, edit.period_s);
  visitor.field(Field{"seed", "Of the noise"}, edit.seed);
}
template <typename Visitor, Of<Revert> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"arms", "Which arms", false, true}, edit.arms);
  visitor.field(Field{"what", "Samples whole, or one channel", false, true}, edit.what);
}
template <typename Visitor, Of<AddNote> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"text", "What to say", true}, edit.text);
  visitor.field(Field{"from_s", "Begin"}, edit.from_s);
  visitor.field(Field{"to_s", "End"}, edit.to_s);
  visitor.field(Field{"tag", "A word to find it by"}, edit.tag);
  visitor.field(Field{"rating", "1 to 5; 0: none"}, edit.rating);
  visitor.field(Field{"colour", "Of its mark", false, true}, edit.colour);
  visitor.field(Field{"glyph", "Its mark", false, true}, edit.glyph);
}
template <typename Visitor, Of<RemoveNote> Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  visitor.field(Field{"note", "Its id", true}, edit.note);
}

}  // namespace trocar::demonstration
