#!/bin/sh
# What it changes to compute less: the first load of the 8 m SAG mill, 40 % filled, with its sizes cut
# at 22 to 63 mm, with harder and softer contacts, with larger grains, with a wider slice, and with
# other dice. Every variant mixes for 0.9 revolutions and is measured for half a one, on one rank.
#   scripts/studies/how_much_dem.sh DIR [VARIANT...]      runs what is missing in DIR, prints the table
# docs/how_much_dem.md has the result. cut22 takes hours and cut31 an hour or two; the others minutes.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
dir=$1; shift
all="base other_seed stiff stiff_ore soft10 cut45 cut45_soft10 cut31_soft10 cut22_soft10 grain14 wide step15"
[ $# -gt 0 ] || set -- $all
millwear=${MILLWEAR:-$here/build/release/millwear}
mkdir -p "$dir"

# A variant is the desktop case with other values: cut [m], softening of steel and of ore, grain size,
# slice [m], share of the Rayleigh time, seed.
settings() {
  cut=0.063 steel=400 ore=100 grain=1 slice=0.25 rayleigh=0.3 seed=1
  case $1 in
    base) ;;
    other_seed) seed=2 ;;
    stiff) steel=100 ;;
    stiff_ore) steel=100 ore=25 ;;
    soft10) steel=4000 ore=1000 ;;
    cut45) cut=0.045 ;;
    cut45_soft10) cut=0.045 steel=4000 ore=1000 ;;
    cut31_soft10) cut=0.0315 steel=4000 ore=1000 ;;
    cut22_soft10) cut=0.022 steel=4000 ore=1000 ;;
    grain14) cut=0.045 grain=1.4 slice=0.35 ;;
    wide) slice=0.5 ;;
    step15) rayleigh=0.15 ;;
    *) echo "how_much_dem.sh: no variant $1; there are $all" >&2; exit 2 ;;
  esac
}

case_of() {
  settings "$1"
  awk -v name="$1" -v cut=$cut -v steel=$steel -v ore=$ore -v grain=$grain -v slice=$slice \
      -v rayleigh=$rayleigh -v seed=$seed '
    function scaled(line,   n, part, i, text) {
      n = split(line, part, /, */); text = ""
      for (i = 1; i <= n; i++) text = text (i > 1 && part[i] != "" ? ", " : "") (part[i] != "" ? part[i] * grain : "")
      return text
    }
    /^\[/ { table = $0 }
    /^name = "seed/ { print "name = \"" name "\""; next }
    /^slice_length_m/ { print "slice_length_m =", slice; next }
    table == "[[materials]]" && /^modulus_reduction/ { print "modulus_reduction =", steel; next }
    /^modulus_reduction/ { print "modulus_reduction =", ore; next }
    /^truncate_below_m/ { print "truncate_below_m =", cut * grain - 1e-6; next }
    /^size_m = \[.*\]/ { gsub(/size_m = \[|\].*/, ""); print "size_m = [" scaled($0) "]"; next }
    /^size_m = \[$/ { sizes = 1; print; next }
    sizes && /^\]/ { sizes = 0 }
    sizes { print "  " scaled($0) ","; next }
    /^rayleigh_fraction/ { print "rayleigh_fraction =", rayleigh; next }
    /^mix_until_steady/ { next }
    /^mix_revolutions/ { print "mix_revolutions = 0.9\nseed = " seed "\nranks = 1\nskin_m =", 0.42 * cut * grain; next }
    /^measure_revolutions/ { print "measure_revolutions = 0.5"; next }
    /^pair_revolutions/ { print "pair_revolutions = 0"; next }
    /^cycle_limit/ { print "cycle_limit = 1"; next }
    /^tune/ { next }
    { print }' "$here/cases/seed_mill_8m_desktop/case.toml"
}

# Rate of loss [mm/kh at the case's coefficient] by place on the lifter, with the standard error from
# the time blocks of each bin (neighbouring bins taken as independent).
zones() {
  awk -F, -v plate=3.9005 '
    FNR == NR { if (/^[-0-9]/) { n++; x[n] = $1; y[n] = $2
      s[n] = n > 1 ? s[n-1] + sqrt((x[n]-x[n-1])^2 + (y[n]-y[n-1])^2) : 0 } next }
    /^[0-9]/ { j = 1; while (j < n - 1 && s[j+1] < $4) j++
      u = ($4 - s[j]) / (s[j+1] - s[j]); px = x[j] + u * (x[j+1] - x[j]); py = y[j] + u * (y[j+1] - y[j])
      up = plate - sqrt(px^2 + (plate - py)^2)
      zone = up > 0.2 ? 3 : up < 0.012 ? (px < 0 ? 1 : 5) : (px < 0 ? 2 : 4)
      rate[zone] += $5; square[zone] += $6 ^ 2; bins[zone]++ }
    END { for (z = 1; z <= 5; z++) printf " %7.2f +-%5.2f", 3.6e9 * rate[z] / bins[z], 3.6e9 * sqrt(square[z]) / bins[z] }
  ' "$1/cycle_000/mesh/profile.csv" "$2"
}

for variant in "$@"; do
  case_of "$variant" >"$dir/$variant.toml"
  start=$(date +%s)
  if [ ! -e "$dir/$variant/results/history.csv" ]; then
    $millwear run "$dir/$variant.toml" --out "$dir/$variant" --quiet >"$dir/$variant.log" 2>&1 ||
      { tail -3 "$dir/$variant.log" >&2; exit 1; }
    echo $(($(date +%s) - start)) >"$dir/$variant.seconds"
  fi
done

printf '%-14s %9s %10s %16s %16s %16s %16s %16s %13s %13s %13s\n' variant particles "step, us" \
  "plate behind" "trailing face" "top" "leading face" "plate before" "power, kW" "shoulder" "toe"
for variant in "$@"; do
  run=$dir/$variant
  [ -e "$run/results/history.csv" ] || continue
  $millwear wear "$dir/$variant.toml" --out "$run" --csv "$dir/$variant.csv" --quiet >/dev/null
  slice=$(awk '/^slice_length_m/ { print $3 }' "$dir/$variant.toml")
  printf '%-14s %9s %10.0f' "$variant" \
    "$(awk '/ atoms$/ { print $1 }' "$run/cycle_000/mix/charge.data")" \
    "$(awk '/^timestep/ { print 1e6 * $2 }' "$run/cycle_000/mix/contact_model.in")"
  zones "$run" "$dir/$variant.csv"
  awk -F, -v slice="$slice" 'NR == 2 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR == 3 { printf " %6.1f +- %3.1f %6.1f +- %3.1f %6.1f +- %3.1f\n",
      $at["power_w"] / 1e3 * 0.25 / slice, $at["power_w_se"] / 1e3 * 0.25 / slice, $at["shoulder_deg"],
      $at["shoulder_deg_se"], $at["toe_deg"], $at["toe_deg_se"] }' "$run/results/history.csv"
done
