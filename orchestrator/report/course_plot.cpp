#include "orchestrator/report/course_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "orchestrator/report/gnuplot.h"
#include "orchestrator/report/plot_style.h"

namespace millwear::orchestrator {
namespace {

constexpr double mm_per_m = 1e3;

std::string curve_block(const std::vector<CourseMoment>& curve) {
  std::string text = "$curve << EOD\n";
  for (const auto& [hours, height] : curve)
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", hours, mm_per_m * height.value,
                   mm_per_m * height.band.low, mm_per_m * height.band.high);
  return text + "EOD\n";
}

/// The rows of the readings of one use; gnuplot takes no empty block.
std::string readings_rows(const CalibratedCourse& course, CourseUse use) {
  std::string text;
  for (const CourseReading& reading : course.readings)
    if (reading.height && reading.use == use)
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", reading.operating_hours,
                     mm_per_m * *reading.height, mm_per_m * reading.error);
  return text;
}

double last_hours(const CalibratedCourse& course) {
  return std::fmax(course.curve.back().operating_hours, course.readings.back().operating_hours);
}

std::string line_block(const CalibratedCourse& course) {
  const double end = std::fmin(last_hours(course), course.fresh_height / course.line_rate);
  return fmt::format("$line << EOD\n0 {}\n{} {}\nEOD\n", mm_per_m * course.fresh_height, end,
                     mm_per_m * (course.fresh_height - course.line_rate * end));
}

}  // namespace

std::string course_png(const CalibratedCourse& course) {
  const bool has_band = std::isfinite(course.factor.band.low);
  const std::string held_out = readings_rows(course, CourseUse::held_out);
  return gnuplot_output(
      plot_terminal(1000, 600) + curve_block(course.curve) + "$calibrated << EOD\n" +
      readings_rows(course, CourseUse::fresh) + readings_rows(course, CourseUse::calibrated) +
      "EOD\n$held_out << EOD\n" + held_out + "EOD\n" + line_block(course) +
      fmt::format("set xlabel 'operating hours'\nset xrange [0:{}]\n", 1.03 * last_hours(course)) +
      fmt::format(
          "set ylabel 'lifter height {} [mm]'\nset yrange [0:*]\n",
          course.gauge_on == GaugeOn::plate ? "over the worn plate" : "over the new plate") +
      "set key top right reverse Left\nplot " +
      (has_band ? "$curve using 1:3:4 with filledcurves fc '#aebfd0' title '95 % band', " : "") +
      "$curve using 1:2 with lines lw 2 lc '#16365c' title 'predicted',"
      " $line using 1:2 with lines lw 1.5 dt 2 lc '#8b959e' title 'straight line',"
      " $calibrated using 1:2:3 with yerrorbars pt 7 ps 1.2 lc '#a8431c'"
      " title 'measured, calibrated on'" +
      (held_out.empty() ? ""
                        : ", $held_out using 1:2:3 with yerrorbars pt 6 ps 1.4 lw 2 lc '#a8431c'"
                          " title 'measured, held out'") +
      "\n");
}

}  // namespace millwear::orchestrator
