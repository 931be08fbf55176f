#include "orchestrator/validation/figure.h"

#include <array>

namespace millwear::orchestrator {
namespace {

constexpr std::array<QuantityName, 4> names{{
    {Quantity::power, "power_w", "net power", "W"},
    {Quantity::shoulder, "shoulder_deg", "shoulder", "°"},
    {Quantity::toe, "toe_deg", "toe", "°"},
    {Quantity::face_angle, "face_angle_deg", "angle of the worn leading face", "°"},
}};

}  // namespace

std::span<const QuantityName> quantity_names() { return names; }

const QuantityName& name_of(Quantity quantity) { return names[static_cast<std::size_t>(quantity)]; }

}  // namespace millwear::orchestrator
