# Sourced by the studies: the first load of the 8 m SAG mill, 40 % filled, as the desktop case has it
# but for what a study varies. The study defines `settings NAME`, which sets what differs from
# `standard`, and calls `study DIR NAME...`, which runs what is missing in DIR and prints the table, or
# `run_missing DIR NAME...` alone.
here=$(cd "$(dirname "$0")/../.." && pwd)
desktop=$here/cases/seed_mill_8m_desktop
millwear=${MILLWEAR:-$here/build/release/millwear}

# cut [m], whether rocks of 180 and 122 mm stay, softening of steel and of ore, grain size, slice [m],
# share of the Rayleigh time, seed, revolutions mixed and measured, speed [rpm], a measured profile in
# place of the new lifter, and the greatest number of loads
standard() {
  cycles=1
  cut=0.063 rocks=no steel=400 ore=100 grain=1 slice=0.25 rayleigh=0.3 seed=1 mix=0.9 measure=0.5 speed=11.4 profile=""
}

case_of() {
  awk -v name="$1" -v cut="$cut" -v rocks="$rocks" -v steel="$steel" -v ore="$ore" -v grain="$grain" -v slice="$slice" \
      -v rayleigh="$rayleigh" -v seed="$seed" -v mix="$mix" -v measure="$measure" -v speed="$speed" \
      -v profile="$profile" -v cycles="$cycles" '
    function scaled(line,   n, part, i, text) {
      n = split(line, part, /, */); text = ""
      for (i = 1; i <= n; i++) text = text (i > 1 && part[i] != "" ? ", " : "") (part[i] != "" ? part[i] * grain : "")
      return text
    }
    /^\[/ { table = $0 }
    /^name = "seed/ { print "name = \"" name "\""; next }
    /^slice_length_m/ { print "slice_length_m =", slice; next }
    /^speed_rpm/ { print "speed_rpm =", speed; next }
    profile != "" && /^(height_m|top_width_m|leading_face_angle_deg|trailing_face_angle_deg)/ { next }
    profile != "" && /^plate_thickness_m/ { print; print "profile_csv = \"" profile "\""; next }
    table == "[[materials]]" && /^modulus_reduction/ { print "modulus_reduction =", steel; next }
    /^modulus_reduction/ { print "modulus_reduction =", ore; next }
    /^truncate_below_m/ { print "truncate_below_m =", cut * grain - 1e-6; next }
    /^size_m = \[.*\]/ { gsub(/size_m = \[|\].*/, ""); print "size_m = [" scaled($0) "]"; next }
    /^size_m = \[$/ { sizes = 1; print; next }
    sizes && /^\]/ { sizes = 0 }
    sizes { print "  " scaled($0) ","; next }
    rocks == "yes" { sub(/0.00, 0.00, 0.66,/, "0.10, 0.10, 0.46,") }
    /^rayleigh_fraction/ { print "rayleigh_fraction =", rayleigh; next }
    /^mix_until_steady/ { next }
    /^mix_revolutions/ { print "mix_revolutions =", mix "\nseed = " seed "\nranks = 1"; next }
    /^measure_revolutions/ { print "measure_revolutions =", measure; next }
    /^pair_revolutions/ { print "pair_revolutions = 0"; next }
    /^cycle_limit/ { print "cycle_limit =", cycles; next }
    /^(tune|seed|ranks|skin_m|rank_split)/ { next }
    { print }' "$desktop/case.toml"
}

# Rate of loss [mm in 1,000 h] by place on the lifter, with the standard error from the time blocks of
# each bin (neighbouring bins taken as independent).
zones() {
  awk -F, -v plate="$(awk '$1 == "shell_diameter_m" { d = $3 } $1 == "plate_thickness_m" { t = $3 }
      END { print d / 2 - t }' "$1/case.lock.toml")" '
    FNR == NR { if (/^[-0-9]/) { n++; x[n] = $1; y[n] = $2; up = plate - sqrt(x[n]^2 + (plate - y[n])^2)
      if (up > height) height = up
      s[n] = n > 1 ? s[n-1] + sqrt((x[n]-x[n-1])^2 + (y[n]-y[n-1])^2) : 0 } next }
    /^[0-9]/ { j = 1; while (j < n - 1 && s[j+1] < $4) j++
      u = ($4 - s[j]) / (s[j+1] - s[j]); px = x[j] + u * (x[j+1] - x[j]); py = y[j] + u * (y[j+1] - y[j])
      up = plate - sqrt(px^2 + (plate - py)^2)
      zone = up > height - 0.015 ? 3 : up < 0.012 ? (px < 0 ? 1 : 5) : (px < 0 ? 2 : 4)
      rate[zone] += $5; square[zone] += $6 ^ 2; bins[zone]++ }
    END { for (z = 1; z <= 5; z++) printf " %7.2f +-%5.2f", 3.6e9 * rate[z] / bins[z], 3.6e9 * sqrt(square[z]) / bins[z] }
  ' "$1/cycle_000/mesh/profile.csv" "$2"
}

# The first kept profile of a campaign's RESULTS that is as low as HEIGHT_MM, as a profile's file.
profile_at() {
  awk -F, -v height="$2" '
    FNR == NR { if (FNR == 2) for (i = 1; i <= NF; i++) column[$i] = i
      if (/^[0-9]/) above[$1, $2] = 1e3 * $column["lifter_height_m"]; next }
    FNR == 1 { print "# millwear profile 1\nxi_m,eta_m" }
    /^[0-9]/ && !found && above[$1, $2] <= height { found = 1; cycle = $1; step = $2 }
    found && $1 == cycle && $2 == step { print $5 "," $6 }
  ' "$1/history.csv" "$1/profiles.csv"
}

run_missing() {
  dir=$1; shift
  mkdir -p "$dir"
  for variant in "$@"; do
    standard; settings "$variant"
    case_of "$variant" >"$dir/$variant.toml"
    [ ! -e "$dir/$variant/results/history.csv" ] || continue
    start=$(date +%s)
    $millwear run "$dir/$variant.toml" --out "$dir/$variant" --quiet >"$dir/$variant.log" 2>&1 ||
      { tail -3 "$dir/$variant.log" >&2; exit 1; }
    echo $(($(date +%s) - start)) >"$dir/$variant.seconds"
  done
}

study() {
  run_missing "$@"
  dir=$1; shift
  printf '%-14s %9s %10s %6s %16s %16s %16s %16s %16s %13s %13s %13s %8s\n' variant particles "step, us" path \
    "plate behind" "trailing face" "top" "leading face" "plate before" "power, kW" "shoulder" "toe" "hits, kW"
  for variant in "$@"; do
    run=$dir/$variant
    $millwear wear "$dir/$variant.toml" --out "$run" --csv "$dir/$variant.csv" --quiet >/dev/null
    printf '%-14s %9s %10.0f %6.2f' "$variant" \
      "$(awk '/ atoms$/ { print $1 }' "$run/cycle_000/mix/charge.data")" \
      "$(awk '/^timestep/ { print 1e6 * $2 }' "$run/cycle_000/mix/contact_model.in")" \
      "$(awk '/"path_over_slip"/ { getline; print $1 }' "$run/results/summary.json")"
    zones "$run" "$dir/$variant.csv"
    awk -F, -v slice="$(awk '/^slice_length_m/ { print $3 }' "$dir/$variant.toml")" '
      NR == 2 { for (i = 1; i <= NF; i++) at[$i] = i }
      NR == 3 { printf " %6.1f +- %3.1f %6.1f +- %3.1f %6.1f +- %3.1f %8.2f\n",
        $at["power_w"] / 1e3 * 0.25 / slice, $at["power_w_se"] / 1e3 * 0.25 / slice, $at["shoulder_deg"],
        $at["shoulder_deg_se"], $at["toe_deg"], $at["toe_deg_se"], $at["bare_hit_power_w"] / 1e3 * 0.25 / slice }
    ' "$run/results/history.csv"
  done
}
