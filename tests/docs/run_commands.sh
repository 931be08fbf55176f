#!/bin/sh
# Runs every command of the pages (the lines of their ```sh blocks) and names the page and line of each
# that fails. A page's commands run in order, in a folder of the page's own, which holds what the pages
# speak of: `build/release/millwear`, `cases/`, `my_mill.toml` with its finished campaign in
# `runs/my_mill`, gauge readings, a scan, a drawing, dumps of a run of the user's own. The mill is tests/docs/small_mill.toml, whose campaign
# takes seconds; cases/pilot_mill has it too, for two cycles.
#
# Some commands are only looked up, because they build this very tree, or take minutes to hours:
#   make TARGET           the target exists (`make -n`)
#   cmake, ctest          the preset exists
#   scripts/...           the script exists and is valid shell
#   ... --slurm           check_pages.sh knows the options; tests/slurm submits to a Slurm of its own
#
#   tests/docs/run_commands.sh FOLDER_OF_PROGRAMS [PAGE...]     from the root of the sources
#
# SHOW=yes prints what every command prints; PREPARE=no leaves out all but the program.
set -eu
programs=$(cd "$1" && pwd)
shift
sources=$(pwd)
[ $# -gt 0 ] || set -- README.md CONTRIBUTING.md docs/*.md
tests=$sources/tests/docs
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tab=$(printf '\t')

# The rows of a step of a campaign as a profile: profile_of STEP_OF_CYCLE
profile_of() {
  echo "# millwear profile 1"
  echo "xi_m,eta_m"
  awk -F, -v step="$1" '$1 "/" $2 == step { print $5 "," $6 }' runs/my_mill/results/profiles.csv
}

# The dumps of a LIGGGHTS run of the user's own: the deck lines of docs/how_to_postprocess.md, in its
# ```text blocks, behind the deck that fills the small mill; with fewer steps and its radius.
own_dumps() {
  awk '/^```/ { inside = !inside; deck = 0; next }
    inside && !deck && /^(compute|run) / { deck = 1 } inside && deck' "$sources/docs/how_to_postprocess.md" |
    sed 's/^run  *50000/run 2000/; s/^run  *200000/run 10000/; s/cylinder y 0 0 0.42/cylinder y 0 0 0.1/' >own_lines
  millwear deck --quiet my_mill.toml --out own
  mix=own/cycle_000/mix
  sed -i 's/^timestep .*/timestep 2e-5/' $mix/contact_model.in
  awk '/^run / { while ((getline line < "own_lines") > 0) print line; next } { print }' $mix/deck.in >$mix/own.in
  (cd $mix && liggghts -in own.in >/dev/null)
  mv $mix/contacts.dump $mix/particles.dump .
  rm -r own own_lines
}

# What the pages speak of, once; every page gets a copy.
prepare() {
  mkdir -p "$work/tree/build/release"
  cd "$work/tree"
  ln -s "$programs/millwear" "$programs/millwear-recorder" build/release/
  PATH=$work/tree/build/release:$PATH
  [ "${PREPARE:-yes}" = yes ] || { cd "$sources"; return; }
  cp -r "$sources/cases" "$sources/examples" .
  cp "$tests/small_mill.toml" my_mill.toml
  sed -e 's/"my_mill"/"pilot_mill"/; s/^cycle_limit.*/cycle_limit = 2/' my_mill.toml >cases/pilot_mill/case.toml
  millwear run --quiet my_mill.toml
  millwear run --quiet cases/pilot_mill/case.toml

  # A scan of the new liner with its leading corner worn, in millimetres and a frame of its own.
  millwear mesh --quiet my_mill.toml --out drawn
  awk -F, 'BEGIN { print "x,y" } /^[-0-9]/ {
    if ($1 > 0.019 && $1 < 0.021) { put(0.012, 0.039); put(0.0215, 0.034); next }
    put($1, $2) }
    function put(xi, eta) { printf "%.3f,%.3f\n", 1000 * xi + 412, 1000 * eta - 35 }' \
    drawn/profile.csv >scan.csv
  # A drawing, and profiles in the master frame, from the campaign's own liners.
  profile_of 2/3 >worn.csv
  profile_of 1/5 >scanned.csv
  profile_of 2/1 >predicted.csv
  millwear mesh --quiet my_mill.toml --profile worn.csv --out drawn
  mv drawn/profile.dxf drawing.dxf
  rm -r drawn

  [ ! -f "$sources/docs/how_to_postprocess.md" ] || own_dumps

  mkdir gauge
  cat >gauge/gauge_readings.csv <<'END'
# millwear gauge readings 1
operating_hours,lifter_height_m,plate_thickness_m,profile_csv,error_m
0,0.040,0.035,,0.001
4000,0.0374,,,0.001
8000,0.0352,,,0.001
16000,0.0302,,,0.001
24000,0.0235,,,0.001
END
  cd "$sources"
}

# Why a command that is not run here would fail; empty if it would not.
fault_of_named() {
  case $1 in
    "make -f "*)
      file=$(echo "$1" | awk '{ print $3 }')
      make -n -f "$file" CASE=cases/pilot_mill/case.toml mesh >/dev/null 2>&1 || echo "there is no $file that make reads"
      ;;
    "make "*)
      target=$(echo "$1" | awk '{ print $2 }')
      make -n "$target" >/dev/null 2>&1 || echo "there is no target $target"
      ;;
    "cmake "* | "ctest "*)
      for preset in $(echo "$1" | grep -oE -- '--preset [a-z-]+' | cut -d' ' -f2); do
        grep -q "\"name\": \"$preset\"" CMakePresets.json || echo "there is no preset $preset"
      done
      ;;
    scripts/*)
      script=$(echo "$1" | cut -d' ' -f1)
      { [ -x "$script" ] && sh -n "$script"; } || echo "there is no script $script"
      ;;
  esac
}

failed=0
prepared=no
for page in "$@"; do
  awk -f "$tests/commands_in_pages.awk" "$page" >"$work/commands"
  [ -s "$work/commands" ] || continue
  rm -rf "$work/page"
  while IFS="$tab" read -r place command; do
    case $command in
      *" --slurm"*) continue ;;
      "make "* | "cmake "* | "ctest "* | scripts/*)
        fault=$(fault_of_named "$command")
        [ -z "$fault" ] || { echo "$place: $command"; echo "  $fault"; failed=1; }
        continue
        ;;
    esac
    [ $prepared = yes ] || { prepare >/dev/null; prepared=yes; }
    if [ ! -d "$work/page" ]; then
      cp -r "$work/tree" "$work/page"
      # These two make my_mill.toml themselves.
      case $page in
        README.md | docs/tutorial.md) rm -r "$work/page/my_mill.toml" "$work/page/runs/my_mill" ;;
      esac
    fi
    if ! (cd "$work/page" && PATH=$work/page/build/release:$PATH sh -ec "$command") \
      >"$work/printed" 2>&1 </dev/null; then
      echo "$place: $command"
      sed 's/^/  /' "$work/printed"
      failed=1
    elif [ -n "${SHOW:-}" ]; then
      echo "\$ $command"
      cat "$work/printed"
    fi
    # A campaign of the case that was written would take minutes.
    case $command in
      *"millwear new my_mill.toml"*) cp "$tests/small_mill.toml" "$work/page/my_mill.toml" ;;
    esac
  done <"$work/commands"
done
exit $failed
