#!/bin/sh
# The compiler evaluates several contacts at once: a change of the loop that keeps it from doing so
# makes the DEM a quarter slower and breaks nothing else.
#   vector_units_test.sh LIBRARY
set -eu
case $(uname -m) in x86_64) ;; *) echo "not an x86-64 processor"; exit 77 ;; esac
command -v objdump >/dev/null || { echo "no objdump"; exit 77; }
member=hertz_contacts.cpp.o
count=$(objdump --disassemble "$1" | awk -v member="$member" '/file format/ { inside = $1 == member ":" }
  inside && /v?sqrtpd/ { n++ } END { print n + 0 }')
[ "$count" -gt 0 ] || { echo "$member takes its square roots one by one"; exit 1; }
