#!/bin/sh
# What sampling the wall contacts costs in truth: a table of the recorder's and the dumps' errors by
# their sampling interval, on the pilot mill. Minutes on one core; the table is in docs/physics.md.
#   scripts/bench/sampling.sh [revolutions]
set -eu
cd "$(dirname "$0")/../.."
scripts/install_packages.sh test
cmake --preset ci >/dev/null
cmake --build --preset ci --target sampling_table >/dev/null
build/ci/tests/needs_liggghts/sampling_table "${1:-0.3}"
