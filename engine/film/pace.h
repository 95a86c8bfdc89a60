/// Between the time of a film and that of its speed: keys of the speed count film time without holds.
#pragma once

#include "engine/film/composition.h"

namespace trocar::film {

/// When the film, holds left out, comes to `common_s` of what its sources have in common. Precondition: `check`ed.
double running_at(const Pace& pace, double common_s);
/// The same of an instant of the film; in a hold, of where it stands.
double running_of(const Pace& pace, double film_s);
/// When a film comes to that, holds before it included.
double film_time_of(const Pace& pace, double running_s);

}  // namespace trocar::film
