/// What a session has recorded, as a recording.
#pragma once

#include <concepts>

#include "engine/demonstration/recording.h"
#include "engine/trial/live_session.h"

namespace trocar::testing {

/// Takes what the session still has: all of it, if nothing was taken before.
template <std::derived_from<trial::LiveSession> Session>
demonstration::Recording recording_of(Session& session) {
  demonstration::Recording recording;
  recording.provenance = session.provenance();
  recording.initial_world = session.take_initial_world().value_or("");
  recording.samples = session.take_samples();
  recording.hashes = session.take_marks();
  recording.outcome = session.outcome();
  recording.placed = session.placed();
  return recording;
}

}  // namespace trocar::testing
