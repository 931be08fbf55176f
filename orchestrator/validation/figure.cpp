#include "orchestrator/validation/figure.h"

#include <array>

namespace millwear::orchestrator {
namespace {

constexpr std::array<QuantityName, 6> names{{
    {Quantity::power, "power_w", "net power", "W"},
    {Quantity::shoulder, "shoulder_deg", "shoulder", "°"},
    {Quantity::toe, "toe_deg", "toe", "°"},
    {Quantity::surface_angle, "surface_angle_deg", "angle of the free surface", "°"},
    {Quantity::surface_speed, "surface_speed_m_per_s", "speed at the surface", "m/s"},
    {Quantity::turning_depth, "turning_depth_m", "depth without motion, below the axis", "m"},
}};

}  // namespace

std::span<const QuantityName> quantity_names() { return names; }

const QuantityName& name_of(Quantity quantity) { return names[static_cast<std::size_t>(quantity)]; }

}  // namespace millwear::orchestrator
