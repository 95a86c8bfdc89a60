/// Where what is dragged in time goes by itself: the places near it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/demonstration/events.h"

namespace trocar::ui {

/// The nearest of `places` that is within `reach_s` of `t_s`, if any.
std::optional<double> nearest_place(std::span<const double> places, double t_s, double reach_s);

/// `t_s` at the nearest sample of the recording's rate.
double at_sample(double t_s);

/// Gates, segments, notes and `events` of a demonstration.
std::vector<double> places_of(const demonstration::Demonstration& shown, std::span<const demonstration::Event> events);

}  // namespace trocar::ui
