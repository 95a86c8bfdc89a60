#include "engine/trial/trial_people.h"

#include <algorithm>

#include "engine/trial/scripted_assistant.h"
#include "engine/trial/scripted_user.h"
#include "engine/trial/trial_setup.h"

namespace trocar::trial {

using demonstration::Outcome;

TrialPeople::TrialPeople(const TrialOptions& options, const TrialInputs& inputs)
    : scripted_inputs_(inputs.scripted), line_(options.delay) {
  // One stream each, the same in both modes: what happens first to a person under MT happens to them under SC.
  const Random random = Random(options.seed).child(0);
  scripted_user_ = std::make_unique<ScriptedUser>(assignment_of(options, options.skill), random.child(1));
  Assignment of_assistant = assignment_of(options, Skill::kExpert);
  of_assistant.scale = kAssistantScale;
  scripted_assistant_ = std::make_unique<ScriptedAssistant>(of_assistant, random.child(2));
  user_ = inputs.user != nullptr ? inputs.user : scripted_user_.get();
  assistant_ = inputs.assistant != nullptr ? inputs.assistant : scripted_assistant_.get();
}

void TrialPeople::listen(const simulation::WorldState& seen) {
  const Tick now = seen.tick;
  const bool sampled = now.count % demonstration::kTicksPerSample == 0;
  const std::optional<HandSample> hand = sampled ? user_->sample(seen) : user_->news(now);
  user_link_ = user_->link(now);
  if (hand && user_link_.connected) line_.send(*hand, now);
  if (sampled) assistant_hand_ = assistant_->sample(seen);
  const bool arrived_before = line_.any();
  line_.receive(now);
  joins_ = !arrived_before && line_.any();
  assistant_link_ = assistant_->link(now);
}

LinkState TrialPeople::link() const {
  return {user_link_.connected, user_link_.present && line_.any(), std::min(user_link_.stamp, line_.arrived_at())};
}

LinkState TrialPeople::assistant_link() const {
  return {assistant_link_.connected, assistant_link_.present && line_.any(), assistant_link_.stamp};
}

bool TrialPeople::finished(const Task& task) const {
  const bool user_done =
      user_ == scripted_user_.get() ? scripted_user_->finished() : task.outcome() == Outcome::kSuccess;
  const bool assistant_done = assistant_ == scripted_assistant_.get() ? scripted_assistant_->finished() : task.placed();
  return user_done && assistant_done;
}

}  // namespace trocar::trial
