#include "mill/case_file/case_manual.h"

#include <fmt/format.h>

#include "mill/case_keys/case_schema.h"

namespace millwear {
namespace {

constexpr std::string_view introduction =
    R"(# The case file

One mill, in [TOML](https://toml.io), UTF-8, 64 KiB at most. Every number has its unit in its key.
A whole number may stand where a number is wanted. Keys that are not listed here are refused.
`millwear` never writes to this file; the run folder keeps `case.lock.toml`, a copy with every
default filled in that simulates the same.

The lifter has three forms, of which a case gives one:
- parametric: `height_m`, `top_width_m`, `leading_face_angle_deg`, `trailing_face_angle_deg`;
- measured: `profile_csv`, a CSV with the columns `xi_m` and `eta_m` and `#` comments;
- listed: `nodes_m`.

xi runs along the direction of rotation and eta towards the mill's axis, both from the plate at the
lifter's centre; nodes run from the trailing side to the leading one. A measured or listed profile
ends either on the plate (within 1 mm; the plate's arc is then added) or at the two sector edges,
half a pitch from the lifter's centre (the same radius within 1 mm).

The charge has two forms, of which a case gives one: `[[charge.counts]]`, or `total_filling` with
one or two `[[charge.distributions]]`. With two, the balls get `ball_filling` and the ore the rest.

Each pair of materials that can touch needs a `[[pairs]]`: any two of the charge (one with itself
too), and each of the charge with the liner.
)";

std::string_view type_text(KeyType type) {
  switch (type) {
    case KeyType::name:
      return "name";
    case KeyType::choice:
      return "word";
    case KeyType::words:
      return "text";
    case KeyType::file:
      return "file name";
    case KeyType::real:
      return "number";
    case KeyType::integer:
      return "whole number";
    case KeyType::boolean:
      return "true or false";
    case KeyType::reals:
      return "array of numbers";
    case KeyType::names:
      return "array of two names";
    case KeyType::points:
      return "array of [xi, eta]";
  }
  return "";
}

std::string default_column(const KeySpec& spec) {
  switch (spec.presence) {
    case Presence::required:
      return "required";
    case Presence::optional:
      return "optional";
    case Presence::defaulted:
      return fmt::format("`{}`", spec.default_text);
  }
  return "";
}

std::string allowed_column(const KeySpec& spec) {
  if (spec.choices.empty()) {
    return spec.range.text();
  }
  std::string words;
  for (const char c : spec.choices) {
    words += c == '|' ? std::string(", ") : std::string(1, c);
  }
  return words;
}

}  // namespace

std::string case_file_manual() {
  std::string text(introduction);
  for (const TableSpec& table : case_tables()) {
    text += fmt::format(
        "\n## {}\n\n{}{}\n\n| key | type | default | allowed | meaning |\n|---|---|---|---|---|\n",
        table.name.empty() ? "The top of the file" : fmt::format("`{}`", table_heading(table)),
        table.doc, table.required ? "" : " May be left out.");
    for (const KeySpec& spec : case_keys()) {
      if (spec.table == table.name) {
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", spec.key, type_text(spec.type),
                            default_column(spec), allowed_column(spec), spec.doc);
      }
    }
  }
  return text;
}

}  // namespace millwear
