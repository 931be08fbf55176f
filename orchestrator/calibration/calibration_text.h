#pragma once
#include <string>
#include <string_view>

#include "orchestrator/calibration/calibrated_law.h"

namespace millwear::orchestrator {

[[nodiscard]] std::string_view name_of(ReadingUse use);
[[nodiscard]] std::string_view name_of(MeasuredQuantity quantity);

/// The lines of the case file's [wear] with the coefficients found, to six digits.
[[nodiscard]] std::string wear_table(const CalibratedLaw& law);

/// `readings` as a table: `operating_hours,quantity,use,measured,error,fitted,line,fitted_without,
/// line_without`, in m and m2.
[[nodiscard]] std::string calibration_csv(const CalibratedLaw& law);

}  // namespace millwear::orchestrator
