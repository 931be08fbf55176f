#!/bin/sh
# How do toe, shoulder, head and power of the pilot mill follow speed and filling? Four speeds and
# three fillings, one load each on the new liner, against two published regressions: toe and shoulder
# of Morrell (1992), power of Hogg and Fuerstenau (1972) with a dynamic angle of repose of 35 degrees.
# Prints a table for a page. Runs what is missing in FOLDER, so the same command resumes it.
#   scripts/studies/charge_motion.sh FOLDER
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
millwear=${MILLWEAR:-$here/build/release/millwear}
folder=${1:?usage: charge_motion.sh FOLDER}
"$millwear" study "$here/cases/charge_motion_study/study.toml" --jobs 2 --out "$folder" --quiet >/dev/null

case_value() { awk -v key="$1" '$1 == key && $2 == "=" { print $3; exit }' "$here/cases/pilot_mill/case.toml"; }
heads=$(mktemp)
trap 'rm -f "$heads"' EXIT
for point in "$folder"/points/*; do
  awk -F, -v point="$(basename "$point" | sed 's/-.*//;s/^0*//')" '
    /^cycle/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
    /^0,/ { print point "," $column["head_z_m"] }' "$point/results/landmarks.csv"
done >"$heads"

awk -F, -v shell="$(case_value shell_diameter_m)" -v plate="$(case_value plate_thickness_m)" \
  -v slice="$(case_value slice_length_m)" -v rows="$(case_value rows)" -v height="$(case_value height_m)" \
  -v top="$(case_value top_width_m)" -v face="$(case_value leading_face_angle_deg)" \
  -v porosity="$(case_value porosity)" -v density="$(case_value density_kg_per_m3)" '
  function tangent(x) { return sin(x) / cos(x) }
  BEGIN {
    pi = atan2(0, -1); g = 9.80665
    radius = shell / 2 - plate
    lifter = height * (top + height * tangent(face * pi / 180))
    inside = (pi * radius * radius - rows * lifter) * slice
    print "| speed, of critical | filling | toe | Morrell | shoulder | Morrell | head over the axis, of the radius | power, W | Hogg and Fuerstenau | ratio |"
    print "|---|---|---|---|---|---|---|---|---|---|"
  }
  FNR == NR { head[$1] = $2; next }
  /^point/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
  /^[0-9]/ {
    phi = $column["mill.critical_speed_fraction"]
    solid = pi / 6 * ($column["charge.counts[0].count"] * 0.030 ^ 3 + $column["charge.counts[1].count"] * 0.025 ^ 3)
    J = solid / (1 - porosity) / inside
    phi_c = 0.35 * (3.364 - J); if (phi > phi_c) phi_c = phi
    toe = 2.5307 * (1.2796 - J) * (1 - exp(-19.42 * (phi_c - phi))) + pi / 2
    shoulder = pi / 2 - (toe - pi / 2) * ((0.3386 + 0.1041 * phi) + (1.54 - 2.5673 * phi) * J)
    omega = phi * sqrt(g / radius)
    power = omega * solid * density * g * radius * sin(35 * pi / 180) * (1 - 1.065 * J)
    printf "| %.2f | %.1f %% | %.0f ± %.1f | %.0f | %.0f ± %.1f | %.0f | %.2f | %.0f ± %.0f | %.0f | %.2f |\n",
      phi, 100 * J, $column["toe_deg"], $column["toe_deg_se"], toe * 180 / pi, $column["shoulder_deg"],
      $column["shoulder_deg_se"], shoulder * 180 / pi, head[$column["point"]] / radius, $column["power_w"],
      $column["power_w_se"], power, $column["power_w"] / power
  }' "$heads" "$folder/study.csv"
