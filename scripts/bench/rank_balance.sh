#!/bin/sh
# How evenly ranks share a mill in motion: particles, ghosts and touching pairs of the ranks, on the charge that
# a campaign left in one of its cycles, with LIGGGHTS's even cuts and with balanced columns. Slices longer than
# the campaign's are made of copies of its charge. The time of a step is told
# of no more ranks than there are cores.
#   scripts/bench/rank_balance.sh CAMPAIGN CYCLE [copies] [ranks...]
set -eu
campaign=$(cd "$1" && pwd) cycle=$(printf %03d "$2") copies=${3:-1}
shift 2; [ $# = 0 ] || shift
cd "$(dirname "$0")/../.."
[ $# -gt 0 ] || set -- 1 2 4 8 16 32
ranks=1
. scripts/bench/dem_timing.sh
from=$campaign/cycle_$cycle
slice=$(awk '/^slice_length_m/ { print $3 }' "$campaign/case.lock.toml")
long=$(awk -v slice="$slice" -v copies="$copies" 'BEGIN { print slice * copies }')
mkdir -p "$work/dem"
sed "s/^slice_length_m.*/slice_length_m = $long/" "$campaign/case.lock.toml" >"$work/case.toml"
awk -v copies="$copies" '/^count/ { $3 = copies * $3 } { print }' "$work/case.toml" >"$work/long.toml"
$millwear mesh "$work/long.toml" --profile "$from/mesh/profile.csv" --out "$work/mesh" --quiet >/dev/null
sed 's/liner_'"$cycle"'/liner_balance/g' "$from/dem/contact_model.in" >"$work/dem/contact_model.in"

# The charge with its velocities as a data file, with all its copies.
cat >"$work/read.in" <<DECK
atom_style    granular
atom_modify   map array sort 0 0.0
boundary      f p f
newton        off
units         si
read_restart  $from/dem/charge.restart
pair_style    none
fix           standing all nve/noforce
dump          charge all custom 1 $work/charge.dump id type radius density x y z vx vy vz omegax omegay omegaz
dump_modify   charge first yes format "%d %d %.17g %.9g %.17g %.17g %.17g %.9g %.9g %.9g %.9g %.9g %.9g"
run           0
DECK
$mpi "$recorder" run --in "$work/read.in" >"$work/log" || { tail -3 "$work/log" >&2; exit 1; }
awk -v copies="$copies" -v slice="$slice" -v m=0 '
  /^ITEM: NUMBER/ { getline; n = $1 } /^ITEM: BOX/ { getline x; getline; getline z } /^ITEM: ATOMS/ { atoms = 1; next }
  atoms { for (c = 0; c < copies; c++) { place[m] = $1 + c * n " " $2 " " 2 * $3 " " $4 " " $5 " " $6 + c * slice " " $7
            speed[m++] = $1 + c * n " " $8 " " $9 " " $10 " " $11 " " $12 " " $13 } if ($2 > types) types = $2 }
  END { print "charge\n\n" m " atoms\n" types " atom types\n" x " xlo xhi\n0 " copies * slice " ylo yhi\n" z " zlo zhi\n\nAtoms\n"
        for (i = 0; i < m; i++) print place[i]
        print "\nVelocities\n"
        for (i = 0; i < m; i++) print speed[i] }' CONVFMT=%.17g OFMT=%.17g "$work/charge.dump" >"$work/charge.data"

# counts PROCESSORS OPTIONS: largest over mean of the ranks' particles, ghosts a particle, largest over mean of
# their touching pairs, time of a step [ms], with so many ranks
counts() {
  steps=20; [ "$ranks" -gt "$(nproc)" ] || steps=200
  sed -e "s|^processors.*|processors    $1|" -e "s|^read_restart.*|read_data $work/charge.data|" \
    -e '/^fix  *drive/d' -e '/^write_restart/d' -e '/^#/d' -e 's/liner_'"$cycle"'/liner_balance/g' "$from/dem/deck.in" |
    awk -v steps=$steps '/^run/ { if (!done++) print "run 20\nrun " steps; next } { print }' >"$work/dem/deck.in"
  (cd "$work/dem" && mpirun -np "$ranks" --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 $root "$recorder" run \
    --in deck.in $2 >log 2>&1) || { grep ERROR "$work/dem/log" >&2; exit 1; }
  awk '/^Nlocal/ { n = $2; most = $4 } /^Nghost/ { ghosts = $2 } /^Neighs/ { pairs = $4 / $2 }
    /^Loop time/ { ms = 1000 * $4 / $9 } END { printf "%.2f %.2f %.2f ", most / n, ghosts / n, pairs }
    END { if (steps > 20) printf "%.2f", ms; else print "-" }' steps=$steps "$work/dem/log"
}

# row CUTS GRID OPTIONS
row() {
  numbers=$(counts "$2" "$3")
  echo "$ranks $1 $(echo "$2" | tr ' ' x) $numbers" >>"$work/table"
}

echo "slice of $long m, $(awk -v copies="$copies" '/^count/ { n += $3 } END { print n }' "$work/long.toml") particles"
echo "ranks  cuts  grid  largest/mean  ghosts/particle  pairs,largest/mean  ms/step" >"$work/table"
for ranks in "$@"; do
  [ "$ranks" != 1 ] || { row - "1 1 1" ""; continue; }
  row charge "2 $((ranks / 2)) 1" ""
  row axis "1 $ranks 1" ""
  sed "s/^rank_split.*//; s/^\\[dem\\]/[dem]\\nrank_split = \"balanced\"/" "$work/long.toml" >"$work/balanced.toml"
  $millwear deck "$work/balanced.toml" --out "$work/deck$ranks" --ranks "$ranks" --quiet >/dev/null
  grid=$(awk '/^processors/ { print $2, $3, $4 }' "$work/deck$ranks/cycle_000/dem/deck.in")
  row even "$grid" ""
  row balanced "$grid" "--columns ${grid%% *}"
done
column -t "$work/table"
