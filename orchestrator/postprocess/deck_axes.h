#pragma once
#include <Eigen/Core>
#include <string_view>

namespace millwear::orchestrator {

/// Turns the axes of a deck to those of the mill's frame, in which the mill turns about +y and
/// gravity is along -z. `turns_about` is the deck's axis that it turns about by the right-hand
/// rule, `gravity` where things fall to, each as "+x", "-z" ... Throws InputError for any other
/// word, and where the two do not stand upright on each other.
[[nodiscard]] Eigen::Matrix3d axes_to_mill(std::string_view turns_about, std::string_view gravity);

}  // namespace millwear::orchestrator
