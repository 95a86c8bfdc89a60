#include "app/commands/edit_effect_answer.h"

#include <fmt/format.h>

#include "engine/demonstration/diff.h"
#include "engine/demonstration/edit_effect.h"
#include "engine/demonstration/idle_cuts.h"
#include "engine/demonstration/problems.h"

namespace trocar::app {
namespace {

using demonstration::EditEffect;
using demonstration::SpanMotion;

Json motion_json(const SpanMotion& motion) {
  return {{"from_s", motion.from_s},
          {"to_s", motion.to_s},
          {"peak_speed_m_s", motion.peak_speed_m_s},
          {"mean_raw_jerk_m_s3", motion.mean_jerk_m_s3}};
}

/// What a person asks of this kind of edit: of smoothing how far and how much calmer, of other times how fast.
std::string words_of(const demonstration::Edit& edit, const EditEffect& effect,
                     const demonstration::Difference& difference) {
  if (std::holds_alternative<demonstration::Smooth>(edit)) {
    return fmt::format(
        "moved by up to {:.2f} mm, RMS {:.3f} mm; mean raw jerk, tremor included: left {:.3g} → {:.3g} m/s³, "
        "right {:.3g} → {:.3g} m/s³",
        1e3 * difference.max_deviation_m, 1e3 * difference.rms_deviation_m, effect.before.mean_jerk_m_s3[0],
        effect.after.mean_jerk_m_s3[0], effect.before.mean_jerk_m_s3[1], effect.after.mean_jerk_m_s3[1]);
  }
  if (std::holds_alternative<demonstration::Retime>(edit)) {
    return fmt::format("peak speed {:.0f} → {:.0f} mm/s of {:.0f} mm/s", 1e3 * effect.before.fastest_m_s(),
                       1e3 * effect.after.fastest_m_s(), 1e3 * demonstration::MotionBounds{}.speed_m_s);
  }
  return "";
}

void add_idle_cuts(const demonstration::TrimIdle& edit, const demonstration::Demonstration& before, bool in_detail,
                   Answer& answer) {
  const auto cuts = demonstration::idle_cuts(before, edit);
  if (!cuts) return;
  answer.json["spans"] = Json::array();
  int number = 0;
  std::int64_t left_out = 0;
  double left_out_s = 0.0;
  std::string list;
  for (const demonstration::IdleCut& cut : *cuts) {
    answer.json["spans"].push_back({{"span", ++number},
                                    {"begin_s", cut.begin_s},
                                    {"end_s", cut.end_s},
                                    {"from_s", cut.from_s},
                                    {"to_s", cut.to_s},
                                    {"where", cut.at_end ? "end" : "inside"},
                                    {"stays", cut.stays}});
    if (!cut.stays) {
      ++left_out;
      left_out_s += cut.to_s - cut.from_s;
    }
    list += fmt::format("\n{:>4}  {:.2f}–{:.2f} s is idle ({}): {}", number, cut.begin_s, cut.end_s,
                        cut.at_end ? "an end" : "inside",
                        cut.stays ? "stays" : fmt::format("{:.2f}–{:.2f} s goes", cut.from_s, cut.to_s));
  }
  answer.text += fmt::format("{}{} of {} idle {} out, {:.2f} s", answer.text.empty() ? "" : "; ", left_out, number,
                             number == 1 ? "span" : "spans", left_out_s);
  if (in_detail) answer.text += list;
}

}  // namespace

void add_edit_effect(const demonstration::Edit& edit, const demonstration::Demonstration& before,
                     const demonstration::Demonstration& after, bool in_detail, Answer& answer) {
  const EditEffect effect = demonstration::effect_of(edit, before, after);
  const demonstration::Difference difference = demonstration::difference(before, after);
  answer.json["effect"] = {{"duration_change_s", difference.duration_change_s},
                           {"removed", difference.removed},
                           {"added", difference.added},
                           {"moved", difference.moved},
                           {"max_deviation_m", difference.max_deviation_m},
                           {"rms_deviation_m", difference.rms_deviation_m},
                           {"speed_limit_m_s", demonstration::MotionBounds{}.speed_m_s},
                           {"before", motion_json(effect.before)},
                           {"after", motion_json(effect.after)}};
  if (const auto* resample = std::get_if<demonstration::Resample>(&edit)) {
    answer.json["effect"]["energy_above_half_rate"] = demonstration::energy_above(before, 0.5 * resample->rate_hz);
  }
  answer.json["remarks"] = effect.remarks;
  const auto say = [&](const std::string& words) {
    if (!words.empty()) answer.text += fmt::format("{}{}", answer.text.empty() ? "" : "; ", words);
  };
  say(words_of(edit, effect, difference));
  for (const std::string& remark : effect.remarks) say(remark);
  if (const auto* idle = std::get_if<demonstration::TrimIdle>(&edit)) add_idle_cuts(*idle, before, in_detail, answer);
}

}  // namespace trocar::app
