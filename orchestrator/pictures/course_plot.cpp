#include "orchestrator/pictures/course_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mill/base/contract.h"
#include "orchestrator/pictures/gnuplot.h"
#include "orchestrator/pictures/plot_style.h"

namespace millwear::orchestrator {
namespace {

constexpr double mm_per_m = 1e3;

std::string curve_block(std::size_t number, const std::vector<CourseMoment>& curve) {
  std::string text = fmt::format("$curve{} << EOD\n", number);
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

double last_hours(const std::vector<CalibratedCourse>& courses) {
  double last = courses.front().readings.back().operating_hours;
  for (const CalibratedCourse& course : courses)
    last = std::fmax(last, course.curve.back().operating_hours);
  return last;
}

std::string line_block(const CalibratedCourse& course, double last) {
  const double end = std::fmin(last, course.fresh_height / course.line_rate);
  return fmt::format("$line << EOD\n0 {}\n{} {}\nEOD\n", mm_per_m * course.fresh_height, end,
                     mm_per_m * (course.fresh_height - course.line_rate * end));
}

}  // namespace

std::string course_png(const std::vector<CalibratedCourse>& courses) {
  expect(!courses.empty(), "a picture shows one course or more");
  const CalibratedCourse& first = courses.front();
  const bool has_band = courses.size() == 1 && std::isfinite(first.factor.band.low);
  const std::string held_out = readings_rows(first, CourseUse::held_out);
  const double last = last_hours(courses);
  std::string blocks;
  std::string curves;
  for (std::size_t i = 0; i < courses.size(); ++i) {
    blocks += curve_block(i, courses[i].curve);
    curves += fmt::format("$curve{} using 1:2 with lines lw 2 lc '#16365c' {}, ", i,
                          i == 0 ? "title 'predicted'" : "notitle");
  }
  return gnuplot_output(
      plot_terminal(1000, 600) + blocks + "$calibrated << EOD\n" +
      readings_rows(first, CourseUse::fresh) + readings_rows(first, CourseUse::calibrated) +
      "EOD\n$held_out << EOD\n" + held_out + "EOD\n" + line_block(first, last) +
      fmt::format("set xlabel 'operating hours'\nset xrange [0:{}]\n", 1.03 * last) +
      fmt::format("set ylabel 'lifter height {} [mm]'\nset yrange [0:*]\n",
                  first.gauge_on == GaugeOn::plate ? "over the worn plate" : "over the new plate") +
      "set key top right reverse Left\nplot " +
      (has_band ? "$curve0 using 1:3:4 with filledcurves fc '#aebfd0' title '95 % band', " : "") +
      curves +
      "$line using 1:2 with lines lw 1.5 dt 2 lc '#8b959e' title 'straight line',"
      " $calibrated using 1:2:3 with yerrorbars pt 7 ps 1.2 lc '#a8431c'"
      " title 'measured, calibrated on'" +
      (held_out.empty() ? ""
                        : ", $held_out using 1:2:3 with yerrorbars pt 6 ps 1.4 lw 2 lc '#a8431c'"
                          " title 'measured, held out'") +
      "\n");
}

}  // namespace millwear::orchestrator
