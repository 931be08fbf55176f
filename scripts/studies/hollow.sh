#!/bin/sh
# Do loads level a hollow or deepen it? The pilot mill's lifter half worn, with hollows on both plates
# and on the crest and a bump on the leading face, is measured for twenty loads in one. Prints for each
# what the DEM wears at its middle and beside it, and what the program makes of that in its first step.
#   scripts/studies/hollow.sh FOLDER
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
millwear=${MILLWEAR:-$here/build/release/millwear}
folder=${1:?usage: hollow.sh FOLDER}
mkdir -p "$folder"

# A lifter 28 mm high with a top of 40 mm; cosine hollows 24 mm wide and 1.5 mm deep, whose sharpest
# curvature (19 mm) a ball of 15 mm follows, and a bump 20 mm wide and 1 mm high.
awk '
  function asin(v) { return atan2(v, sqrt(1 - v * v)) }
  function plate(v) { return R - sqrt(R * R - v * v) }
  function put(a, b) { x[n] = a; y[n] = b; n++ }
  function arc(from, to, s) { put(R * sin(from + (to - from) * s), R - R * cos(from + (to - from) * s)) }
  function line(a, b, c, d, s) { put(a + (c - a) * s, b + (d - b) * s) }
  function cosine(v, centre, width, depth) {
    v = (v - centre) / width
    return v < -0.5 || v > 0.5 ? 0 : depth * 0.5 * (1 + cos(2 * pi * v))
  }
  function higher(a, b) {
    if (b < 0.0265 && a > 0.0195 && a < 0.0302) return cosine(b, 0.0145, 0.020, 0.0010)
    if (b > 0.0275) return -cosine(a, 0, 0.024, 0.0015)
    return -cosine(a, 0.075, 0.024, 0.0015) - cosine(a, -0.075, 0.024, 0.0015)
  }
  BEGIN {
    n = 0; pi = atan2(0, -1); R = 0.465; half = pi / 12; foot = 0.0302
    for (i = 0; i <= 60; i++) arc(-half, asin(-foot / R), i / 60)
    for (i = 1; i <= 30; i++) line(-foot, plate(-foot), -0.02, 0.028, i / 30)
    for (i = 1; i <= 40; i++) line(-0.02, 0.028, 0.02, 0.028, i / 40)
    for (i = 1; i <= 30; i++) line(0.02, 0.028, foot, plate(foot), i / 30)
    for (i = 1; i <= 60; i++) arc(asin(foot / R), half, i / 60)
    print "# millwear profile 1\nxi_m,eta_m"
    for (i = 0; i < n; i++) {
      a = i > 0 ? i - 1 : i; b = i < n - 1 ? i + 1 : i
      tx = x[b] - x[a]; ty = y[b] - y[a]; l = sqrt(tx * tx + ty * ty); d = higher(x[i], y[i])
      printf "%.8f,%.8f\n", x[i] - d * ty / l, y[i] + d * tx / l
    }
  }' >"$folder/hollow.csv"
awk '/^name = "pilot/ { print "name = \"hollow\""; next }
  /^(height_m|top_width_m|leading_face_angle_deg|trailing_face_angle_deg)/ { next }
  /^plate_thickness_m/ { print; print "profile_csv = \"hollow.csv\""; next }
  /^measure_revolutions/ { print "measure_revolutions = 15.0\nranks = 1"; next }
  /^time_blocks/ { print "time_blocks = 20"; next }
  /^threshold/ { print "threshold = 0.02"; next }
  /^steps_per_cycle/ { print "steps_per_cycle = 1"; next }
  /^height_limit_m/ { print "height_limit_m = 0.010"; next }
  /^cycle_limit/ { print "cycle_limit = 1"; next }
  { print }' "$here/cases/pilot_mill/case.toml" >"$folder/hollow.toml"
"$millwear" run "$folder/hollow.toml" --out "$folder/run" --quiet >"$folder/run.log" 2>&1 ||
  { echo "the run failed; see $folder/run.log" >&2; exit 1; }
"$millwear" wear "$folder/hollow.toml" --out "$folder/run" --csv "$folder/rates.csv" --quiet >/dev/null

# The raw rates by bin, laid on the profile; the motion of the first step along the normal.
awk -F, '
  function place(s,   j, u) {
    j = 1; while (j < n && at[j + 1] < s) j++
    u = (s - at[j]) / (at[j + 1] - at[j]); px = x[j] + u * (x[j + 1] - x[j]); py = y[j] + u * (y[j + 1] - y[j])
  }
  function take(name, part, rate, error) { sum[name, part] += rate; var[name, part] += error * error; count[name, part]++ }
  # the middle and what is beside it, by the coordinate along the feature
  function sort_in(name, v, centre, inner, from, to, rate, error,   d) {
    d = v > centre ? v - centre : centre - v
    if (d < inner) take(name, "middle", rate, error); else if (d > from && d < to) take(name, "beside", rate, error)
  }
  function features(rate, error) {
    if (py > 0.0240 && px > -0.019 && px < 0.019) sort_in("hollow, crest", px, 0, 0.004, 0.012, 0.017, rate, error)
    else if (px > 0.0195 && px < 0.0302 && py > 0.002) sort_in("bump, leading face", py, 0.0145, 0.004, 0.009, 0.0115, rate, error)
    else if (px > 0.035) sort_in("hollow, plate before", px, 0.075, 0.004, 0.012, 0.020, rate, error)
    else if (px < -0.035) sort_in("hollow, plate behind", px, -0.075, 0.004, 0.012, 0.020, rate, error)
  }
  FNR == 1 { file++ }
  file == 1 && /^[0-9]/ && $2 == 0 { n++; x[n] = $5; y[n] = $6; at[n] = n > 1 ? at[n-1] + sqrt((x[n]-x[n-1])^2 + (y[n]-y[n-1])^2) : 0 }
  file == 1 && /^[0-9]/ && $2 == 1 { m++; wx[m] = $5; wy[m] = $6; hours = $3 }
  file == 2 && /^[0-9]/ { place($4); features($5, $6) }
  END {
    for (key in sum) { raw[key] = sum[key] / count[key]; se[key] = sqrt(var[key]) / count[key] }
    split("", sum); split("", var); split("", count)
    for (i = 1; i <= 400; i++) {
      place(at[n] * (i - 0.5) / 400); least = 1
      for (j = 1; j < m; j++) {
        dx = wx[j+1] - wx[j]; dy = wy[j+1] - wy[j]; l = dx * dx + dy * dy
        if (l == 0) continue
        u = ((px - wx[j]) * dx + (py - wy[j]) * dy) / l; u = u < 0 ? 0 : u > 1 ? 1 : u
        d = sqrt((px - wx[j] - u * dx)^2 + (py - wy[j] - u * dy)^2); if (d < least) least = d
      }
      features(least / hours / 3600, 0)
    }
    print "depth rate [1e-10 m/s]  | DEM, twenty loads: middle, beside | first step: middle, beside"
    split("hollow, crest;bump, leading face;hollow, plate before;hollow, plate behind", names, ";")
    for (k = 1; k <= 4; k++) {
      a = names[k] SUBSEP "middle"; b = names[k] SUBSEP "beside"
      printf "%-22s | %.2f +- %.2f, %.2f +- %.2f | %.2f, %.2f\n", names[k], 1e10 * raw[a], 1e10 * se[a], 1e10 * raw[b], 1e10 * se[b],
        1e10 * sum[a] / count[a], 1e10 * sum[b] / count[b]
    }
  }' "$folder/run/results/profiles.csv" "$folder/rates.csv"
