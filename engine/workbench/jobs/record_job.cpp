#include "engine/workbench/jobs/record_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <utility>

#include "engine/trial/hand_session.h"
#include "engine/workbench/take_plan.h"
#include "engine/workbench/take_writer.h"

namespace trocar::workbench {
namespace {

constexpr int kTicksPerPart = 250;

/// Moves what the session recorded to disk and says how far it is; discards it if it is stopped.
Status carry_on(trial::LiveSession& session, TakeWriter& writer, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(writer.write(take_part(session)));
  if (!progress.cancelled()) return {};
  // Who stops it on purpose does not want it back as if a crash had cut it off.
  TROCAR_RETURN_IF_ERROR(writer.discard());
  return fail(ErrorCode::kCancelled,
              fmt::format("the recording was stopped; its {:.1f} s were discarded", writer.duration_s()));
}

Result<RecordReport> finish(const trial::LiveSession& session, TakeWriter& writer) {
  RecordReport report{{}, session.outcome(), session.placed(), writer.duration_s(), writer.samples(), writer.name()};
  TROCAR_ASSIGN_OR_RETURN(report.id, writer.finish(report.outcome, report.placed));
  report.take = writer.take();
  if (writer.target()) report.replaced = writer.target();
  return report;
}

/// Presses the keys when their time has come. Recording has begun.
class KeyPlayer {
 public:
  KeyPlayer(trial::HandSession& session, const std::vector<trial::KeyStroke>& strokes)
      : session_(session), strokes_(strokes), keyboard_({session.options().mode}), begin_(session.state().tick) {}

  void press_due() {
    const std::int64_t now = session_.state().tick.count - begin_.count;
    if (resume_in_ > 0 && --resume_in_ == 0) session_.post(trial::PauseTake{false});
    for (; resume_in_ == 0 && next_ < strokes_.size() && strokes_[next_].at.count <= now; ++next_)
      press(strokes_[next_]);
  }

 private:
  void press(const trial::KeyStroke& stroke) {
    if (stroke.act == trial::KeyAct::kEnd) session_.post(trial::EndTake{});
    if (stroke.act == trial::KeyAct::kPause && stroke.duration.count > 0) {
      session_.post(trial::PauseTake{true});
      resume_in_ = stroke.duration.count;
    }
    if (stroke.act != trial::KeyAct::kDown && stroke.act != trial::KeyAct::kUp) return;
    for (const trial::HandEvent& event : keyboard_.key(stroke.key, stroke.act == trial::KeyAct::kDown)) {
      session_.post(event);
    }
  }

  trial::HandSession& session_;
  const std::vector<trial::KeyStroke>& strokes_;
  trial::KeyboardHands keyboard_;
  Tick begin_;
  std::size_t next_ = 0;
  std::int64_t resume_in_ = 0;  ///< Steps until a pause is over; 0: there is none.
};

}  // namespace

std::string demonstration_name(const Project& project, trial::Skill skill) {
  std::string word(trial::to_string(skill));
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return take_name(project, word);
}

Result<RecordReport> record_transfer(ProjectFile& file, const trial::TransferOptions& options, std::string name,
                                     Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(trial::TransferSession session, trial::TransferSession::create(options));
  if (name.empty()) name = demonstration_name(*file.project(), options.skill);
  TakeWriter writer(file, session.provenance(), std::move(name));
  while (!session.done()) {
    for (int tick = 0; tick < kTicksPerPart && !session.done(); ++tick) session.step();
    // How far a transfer has come is best told by its segment.
    progress.set(static_cast<double>(session.segment()) / demonstration::kSegmentCount);
    TROCAR_RETURN_IF_ERROR(carry_on(session, writer, progress));
  }
  return finish(session, writer);
}

Result<RecordReport> record_keys(ProjectFile& file, const RecordByHand& request,
                                 const std::vector<trial::KeyStroke>& strokes, Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(TakePlan plan, plan_take(*file.project(), request));
  plan.options.operator_kind = "scripted";
  plan.options.device = "key script";
  TROCAR_ASSIGN_OR_RETURN(const std::unique_ptr<trial::HandSession> session,
                          trial::HandSession::create(std::move(plan.options)));
  TakeWriter writer(file, session->provenance(), std::move(plan.name), plan.target);
  std::optional<KeyPlayer> player;
  while (!session->done()) {
    for (int tick = 0; tick < kTicksPerPart && !session->done(); ++tick) {
      if (!player && session->status().phase == trial::Phase::kRecording) player.emplace(*session, strokes);
      if (player) player->press_due();
      session->step();
    }
    const double end_s = strokes.back().at.seconds();
    progress.set(end_s > 0.0 ? std::min(writer.duration_s() / end_s, 1.0) : 1.0);
    TROCAR_RETURN_IF_ERROR(carry_on(*session, writer, progress));
  }
  TROCAR_ASSIGN_OR_RETURN(RecordReport report, finish(*session, writer));
  for (const trial::ArmReport& arm : session->status().arms) {
    report.limited += arm.limited_count;
    report.refused += arm.refused_count;
  }
  return report;
}

}  // namespace trocar::workbench
