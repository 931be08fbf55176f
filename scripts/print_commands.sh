#!/bin/sh
# Prints docs/commands.md from the program's own --help:
#   scripts/print_commands.sh build/release/millwear > docs/commands.md
set -eu
program=$1

cat <<'END'
# Commands: verbs, options, exit codes

    millwear VERB CASE [options]

This page is the program's own `--help`, verb by verb. Results go to standard output, messages to standard
error. `NO_COLOR` in the environment switches colours off.

## Exit codes
| code | meaning | what to do |
|---|---|---|
| 0 | done | |
| 1 | internal error | report it: it is a fault of the program |
| 2 | wrong command line | see `millwear VERB --help` |
| 3 | bad input: case file, profile, readings or another file | change the line that the message names |
| 4 | an external program failed or is missing (LIGGGHTS, MPI, gnuplot, tachyon) | read the log that the message names |
| 5 | a DEM result was rejected, for instance because particles were lost | read the log; try a smaller `rayleigh_fraction` |
| 6 | the disk is full, or a file cannot be written | make room, then give the same command |
| 7 | another process works in the folder | wait for it |
| 130, 143 | interrupted (Ctrl-C, `kill`) | give the same command to resume |

## All verbs
```text
END
"$program" --help
echo '```'
for verb in $("$program" --help | awk '/^(Subcommands|Verbs|Commands):/ { inside = 1; next } /^[^ ]/ { inside = 0 }
    inside && /^  [a-z]/ { print $1 }'); do
  printf '\n## %s\n```text\n' "$verb"
  "$program" "$verb" --help | cat -s
  echo '```'
done
