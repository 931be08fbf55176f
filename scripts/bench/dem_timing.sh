# Sourced by the benchmarks of LIGGGHTS's speed, from the project's folder with $ranks set. Builds
# millwear (or takes the program MILLWEAR) and leaves: $work, a folder that goes when the script ends; $millwear; $recorder, which runs
# LIGGGHTS with the search and the loop of its own; $own_pairs, an option for the pairs with which it leaves the
# loop to LIGGGHTS; $mpi, the launch.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=""; [ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
mpi="mpirun -np $ranks --bind-to none $root"
[ -n "${MILLWEAR:-}" ] || make -s build >&2
millwear=${MILLWEAR:-$PWD/build/release/millwear}
recorder=$millwear-recorder
own_pairs="tangential_damping on"   # as it is anyway, but any option will do

# The median of the numbers that come in, one a line.
median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }

# seconds of the last run's loop in a log of LIGGGHTS
loop_seconds() { awk '/^Loop time of/ { t = $4 } END { print t }' "$1"; }

# the time step [s] of a stretch's folder
time_step() { awk '/^timestep/ { print $2 }' "$1/contact_model.in"; }

# the value of a key of the case that a campaign's folder holds
in_case() { awk -v key="$2" '$1 == key { print $3; exit }' "$1/case.lock.toml"; }
