#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "mill/case/case.h"
#include "orchestrator/results/calibrated_course.h"

namespace millwear::orchestrator {

/// A value that several campaigns predict.
struct Repeated {
  std::vector<double> values;  ///< a value a campaign, in their order; NaN where one has none
  double mean;                 ///< NaN unless all have one
  double scatter;              ///< standard deviation between the campaigns
  double predicted_error;      ///< root mean square of the standard errors of their bands
};

/// A height that was read, beside those that the campaigns predict.
struct RepeatedReading {
  double operating_hours;  ///< [h]
  CourseUse use;
  std::optional<double> height;  ///< measured [m]
  Repeated predicted;            ///< [m]
  Repeated predicted_plate;      ///< [m]
  double line;                   ///< height by the straight line [m]
};

/// Campaigns of one case that differ in the seed of their packing alone, each calibrated by itself
/// on the same readings.
struct RepeatedCourses {
  std::vector<CalibratedCourse> courses;
  std::vector<std::uint64_t> seeds;
  Repeated factor;
  Repeated life;  ///< to the height limit [h]
  std::vector<RepeatedReading> readings;
  int held_out;      ///< readings of a height that are held out and that all campaigns predict
  double rms;        ///< of their mean less the height measured, over the held-out readings [m]
  double line_rms;   ///< of the straight line's, over the same [m]
  double mape;       ///< mean of |their mean less measured| / measured over these readings [-]
  double line_mape;  ///< of the straight line's, over the same [-]
};

/// A held-out height that every campaign predicts: what repeats are judged by.
[[nodiscard]] bool is_judged(const RepeatedReading& reading);

/// Throws InputError, naming the folders and the keys, where campaigns were run with cases that
/// differ in more than name and seed, or not in the seed.
void check_repeats(const std::vector<Case>& cases,
                   const std::vector<std::filesystem::path>& folders);

/// Puts the courses of two campaigns or more side by side, which were calibrated on the same
/// readings.
[[nodiscard]] RepeatedCourses repeated_courses(std::vector<CalibratedCourse> courses,
                                               std::vector<std::uint64_t> seeds);

}  // namespace millwear::orchestrator
