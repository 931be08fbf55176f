#pragma once
#include <string>

#include "orchestrator/charge/charge_of_cycle.h"
#include "orchestrator/pictures/composed.h"

namespace millwear::orchestrator {

/// As PNG, over the mill's section in the frame at rest: circles mark the shell and the crests
/// of the lifters.

/// The share of time that a place is inside of a particle, with toe, shoulder, head and centre of
/// circulation.
[[nodiscard]] std::string occupancy_picture(const ChargeOfCycle& charge);

/// Mean speed, with arrows of the mean velocity. `fastest` [m/s] is the scale's end.
[[nodiscard]] std::string velocity_picture(const ChargeOfCycle& charge, double fastest);

/// Power that collisions between particles dissipate, normal and along the contact; empty where
/// they were not recorded.
[[nodiscard]] std::string collision_power_picture(const ChargeOfCycle& charge);

/// Mean size and, of several materials, the share of each: segregation.
[[nodiscard]] std::string segregation_picture(const ChargeOfCycle& charge);

/// The tracks of particles over the frames, coloured by speed; as JPEG without its colour bar.
[[nodiscard]] ChargePicture streaks_picture(const ChargeOfCycle& charge, double fastest);

}  // namespace millwear::orchestrator
