#include "orchestrator/calibration/calibration_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "mill/case_file/case_lock.h"

namespace millwear::orchestrator {

std::string_view name_of(ReadingUse use) {
  constexpr std::array<std::string_view, 4> names = {"fitted", "shown", "held_out",
                                                     "beyond_campaign"};
  return names.at(static_cast<std::size_t>(use));
}

std::string_view name_of(MeasuredQuantity quantity) {
  constexpr std::array<std::string_view, 3> names = {"lifter_height", "plate_thickness",
                                                     "worn_section"};
  return names.at(static_cast<std::size_t>(quantity));
}

std::string wear_table(const CalibratedLaw& law) {
  Case rounded = law.calibrated;
  for (auto& mechanism : rounded.wear.mechanisms) {
    mechanism.specific_wear_rate = std::stod(fmt::format("{:.6g}", mechanism.specific_wear_rate));
    mechanism.depth_rate = std::stod(fmt::format("{:.6g}", mechanism.depth_rate));
  }
  const std::string text = locked_case_text(rounded);
  const std::size_t start = text.find("[wear]\n");
  std::size_t end = text.find("\n[", start);
  while (end != std::string::npos && text.compare(end, 7, "\n[[wear") == 0)
    end = text.find("\n[", end + 1);
  return text.substr(start, end == std::string::npos ? end : end + 1 - start);
}

std::string calibration_csv(const CalibratedLaw& law) {
  const auto field = [](double value) {
    return std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
  };
  std::string text = "# millwear calibration 1\n";
  text += "operating_hours,quantity,use,measured,error,fitted,line,fitted_without,line_without\n";
  for (const auto& row : law.readings)
    text += fmt::format("{},{},{}", row.hours, name_of(row.quantity), name_of(row.use)) +
            field(row.measured) + field(row.error) + field(row.fitted) + field(row.line) +
            field(row.fitted_without) + field(row.line_without) + "\n";
  return text;
}

}  // namespace millwear::orchestrator
