#include "engine/demonstration/edit_sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "engine/demonstration/edit_fields.h"
#include "engine/demonstration/edit_words.h"
#include "engine/spatial/units.h"

namespace trocar::demonstration {
namespace {

std::string span(double from_s, double to_s) {
  return fmt::format("{:.2f}–{:.2f} s", from_s, to_s);
}

template <typename Enum>
std::string_view word_for(Enum value) {
  return words_of<Enum>()[static_cast<std::size_t>(value)];
}

/// "the left tool of Expert 1", "both tools of …".
std::string tools(Arms arms, std::string_view name) {
  if (arms == Arms::kBoth) return fmt::format("both tools of {}", name);
  return fmt::format("the {} tool of {}", words_of<Arms>()[static_cast<std::size_t>(arms)], name);
}

struct Teller {
  std::string_view name;
  std::string_view source;

  std::string taken_from(std::int64_t id) const {
    return source.empty() ? fmt::format("demonstration {}", id) : std::string(source);
  }
  std::string operator()(const Trim& e) const { return fmt::format("Trim {} to {}", name, span(e.from_s, e.to_s)); }
  std::string operator()(const TrimIdle& e) const {
    return fmt::format("Leave out what is idle in {}{}{}", name, e.inside ? ", pauses too" : "",
                       e.stay_s.empty() ? "" : fmt::format(", {} kept", e.stay_s.size()));
  }
  std::string operator()(const Rename& e) const { return fmt::format("Rename {} to {}", name, e.name); }
  std::string operator()(const LabelSegment& e) const {
    return fmt::format("Label {} of {} as {}", span(e.from_s, e.to_s), name, letter(e.label));
  }
  std::string operator()(const ProposeLabels&) const { return fmt::format("Label the segments of {}", name); }
  std::string operator()(const DeleteSpan& e) const {
    return fmt::format("{} {} of {}", e.ripple ? "Delete" : "Lift", span(e.from_s, e.to_s), name);
  }
  std::string operator()(const Splice& e) const {
    return fmt::format("Put {} of {} into {} at {:.2f} s", span(e.clip_from_s, e.clip_to_s), taken_from(e.source), name,
                       e.at_s);
  }
  std::string operator()(const Overdub& e) const {
    return fmt::format("Replace {} by {} of {} from {:.2f} s", tools(e.arms, name), span(e.clip_from_s, e.clip_to_s),
                       taken_from(e.source), e.at_s);
  }
  std::string operator()(const Bridge& e) const {
    return fmt::format("Bridge {} of {}, {}", span(e.from_s, e.to_s), tools(e.arms, name),
                       words_of<BridgeShape>()[static_cast<std::size_t>(e.shape)]);
  }
  std::string operator()(const MoveTool& e) const {
    return fmt::format("Move {} by {:.2f}, {:.2f}, {:.2f} mm at {:.2f} s", tools(e.arms, name), 1e3 * e.by_m.x(),
                       1e3 * e.by_m.y(), 1e3 * e.by_m.z(), e.at_s);
  }
  std::string operator()(const RotateTool& e) const {
    return fmt::format("Turn {} by {:.1f}° at {:.2f} s", tools(e.arms, name), spatial::to_degrees(e.by_rad.norm()),
                       e.at_s);
  }
  std::string operator()(const Offset& e) const {
    return fmt::format("Offset {} by {:.2f}, {:.2f}, {:.2f} mm", tools(e.arms, name), 1e3 * e.by_m.x(),
                       1e3 * e.by_m.y(), 1e3 * e.by_m.z());
  }
  std::string operator()(const Smooth& e) const {
    return fmt::format("Smooth {} of {} over {:.0f} ms", span(e.from_s, e.to_s), tools(e.arms, name), 1e3 * e.width_s);
  }
  std::string operator()(const Simplify& e) const {
    return fmt::format("Simplify {} of {} within {:.2f} mm", span(e.from_s, e.to_s), tools(e.arms, name),
                       1e3 * e.tolerance_m);
  }
  std::string operator()(const Resample& e) const {
    return fmt::format("Resample {} to {:g} Hz, {}", name, e.rate_hz, word_for(e.method));
  }
  std::string operator()(const Retime& e) const {
    return retimed(e) + (e.ease_in_s + e.ease_out_s > 0.0 ? ", eased" : "");
  }
  std::string retimed(const Retime& e) const {
    std::string what = fmt::format("Retime {} of {}", span(e.from_s, e.to_s), name);
    switch (e.mode) {
      case RetimeTo::kScale:
        return fmt::format("{} by {:g}", what, e.scale);
      case RetimeTo::kDuration:
        return fmt::format("{} to {:.2f} s", what, e.duration_s);
      case RetimeTo::kSpeedCap:
        return fmt::format("{} to at most {:.0f} mm/s", what, 1e3 * e.speed_m_s);
      case RetimeTo::kConstantSpeed:
        return fmt::format("{} to {:.0f} mm/s", what, 1e3 * e.speed_m_s);
      case RetimeTo::kWarp:
        return fmt::format("{} by a curve of {} {}", what, e.knots_s.size(), e.knots_s.size() == 1 ? "knot" : "knots");
    }
    return what;
  }
  std::string operator()(const SnapToGrid& e) const {
    return fmt::format("Snap {} of {} to the grid", span(e.from_s, e.to_s), tools(e.arms, name));
  }
  std::string operator()(const SetJaw& e) const {
    return fmt::format("Jaw of {} to {:.0f}° in {}", tools(e.arms, name), spatial::to_degrees(e.jaw_rad),
                       span(e.from_s, e.to_s));
  }
  std::string operator()(const JawEvents& e) const {
    return fmt::format("Clean gripper events of {} in {}", tools(e.arms, name), span(e.from_s, e.to_s));
  }
  std::string operator()(const Mirror&) const { return fmt::format("Mirror {}", name); }
  std::string operator()(const Retarget& e) const {
    return fmt::format("Retarget {} to block {} and peg {}", name, e.block, e.goal);
  }
  std::string operator()(const Perturb& e) const {
    return fmt::format("Perturb {} by {:.2f} mm, seed {}", name, 1e3 * e.sigma_m, e.seed);
  }
  std::string operator()(const Revert& e) const {
    if (e.what == RevertWhat::kLabels)
      return fmt::format("Revert the labels in {} of {}", span(e.from_s, e.to_s), name);
    if (e.what == RevertWhat::kSamples && e.arms == Arms::kBoth)
      return fmt::format("Revert {} of {}", span(e.from_s, e.to_s), name);
    return fmt::format("Revert the {} of {} in {}", e.what == RevertWhat::kSamples ? "motion" : word_for(e.what),
                       tools(e.arms, name), span(e.from_s, e.to_s));
  }
  std::string operator()(const AddNote& e) const { return fmt::format("Note “{}” on {}", e.text, name); }
  std::string operator()(const RemoveNote& e) const { return fmt::format("Remove note {} from {}", e.note, name); }
};

}  // namespace

std::string sentence(const Edit& edit, std::string_view name, std::string_view source) {
  return std::visit(Teller{name, source}, edit);
}

std::string particulars(const Edit& edit) {
  constexpr std::string_view kName = "\x1f";
  std::string words = sentence(edit, kName);
  for (const std::string_view before : {" of ", " on ", " from ", " in ", " "}) {
    const std::string whole = std::string(before) + std::string(kName);
    for (std::size_t at = words.find(whole); at != std::string::npos; at = words.find(whole)) {
      words.erase(at, whole.size());
    }
  }
  // What the title says already.
  const std::string title = title_of(name_of(edit));
  const std::string first = words.substr(0, words.find(' '));
  if (title.starts_with(first)) words.erase(0, std::min(words.size(), first.size() + 1));
  return words;
}

}  // namespace trocar::demonstration
