#include "mill/recording/recorder_lines.h"

#include <fmt/format.h>

#include "mill/base/line_parts.h"
#include "mill/load/drift_text.h"

namespace millwear {
namespace {

constexpr std::string_view at_step = "millwear: step ";
constexpr std::string_view then = ", ";
constexpr std::string_view known_to = "rate at its peaks known to ";
constexpr std::string_view target = " % (target ";
constexpr std::string_view going_on = " %), going on to step ";
constexpr std::string_view perhaps_to = ", perhaps to ";
constexpr std::string_view ends = " %), the measurement ends";

}  // namespace

std::string printed(const MeasuringLine& line) {
  const std::string known = fmt::format("{}{}{}{}{:.2g}{}{:g}", at_step, line.step, then, known_to,
                                        100.0 * line.peak_error, target, 100.0 * line.target_error);
  if (!line.next) return fmt::format("{}{}", known, ends);
  return fmt::format("{}{}{}{}{}", known, going_on, line.next->step, perhaps_to,
                     line.next->expected_step);
}

std::optional<MeasuringLine> measuring_line(std::string_view line) {
  MeasuringLine read{};
  LineParts parts(line);
  parts.text(at_step).number(read.step).text(then).text(known_to).percent(read.peak_error);
  parts.text(target).percent(read.target_error);
  if (LineParts(parts).text(ends).fits_to_the_end()) return read;
  NextEnd next{};
  parts.text(going_on).number(next.step).text(perhaps_to).number(next.expected_step);
  if (!parts.fits_to_the_end()) return std::nullopt;
  read.next = next;
  return read;
}

std::string printed(const MixingLine& line) {
  return fmt::format("{}{}{}{}", at_step, line.step, then, spoken_drift(line.drift));
}

std::optional<MixingLine> mixing_line(std::string_view line) {
  MixingLine read{};
  LineParts parts(line);
  parts.text(at_step).number(read.step).text(then);
  if (!parts.fits() || !read_drift(parts.left(), read.drift)) return std::nullopt;
  return read;
}

}  // namespace millwear
