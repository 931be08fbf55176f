#!/bin/sh
# Sees scripts/check_includes.sh pass on the sources, and fail on each kind of forbidden source. The
# forbidden ones are added to a small house, one at a time.
#   check_includes_test.sh FOLDER-OF-THE-SOURCES
set -eu
check=$1/scripts/check_includes.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
wrong=0

# Sees that a folder of sources is accepted.
accepted() {
  if ! said=$(sh "$check" "$1" 2>&1); then
    echo "$1 is refused:"
    echo "$said"
    wrong=1
  fi
}

# Puts every room into the house with one source that breaks no rule.
build_house() {
  rm -rf "$house"/*
  for room in mill/base meshgen liggghts_inputs/decks wear/rate recorder/run \
    orchestrator/campaign orchestrator/report orchestrator/app; do
    mkdir -p "$house/$room"
    echo '#pragma once' >"$house/$room/sound.h"
    echo "#include \"$room/sound.h\"" >"$house/$room/sound.cpp"
  done
}

# Adds a line to a source of the house, which may be new, and sees the check fail with the words.
#   refused "words" file "line"
refused() {
  build_house
  mkdir -p "$(dirname "$house/$2")"
  echo "$3" >>"$house/$2"
  if said=$(sh "$check" "$house" 2>&1); then
    echo "$2 was accepted with: $3"
    wrong=1
  elif ! echo "$said" | grep -qF "$1"; then
    echo "$2 with $3 is refused without the words \"$1\":"
    echo "$said"
    wrong=1
  fi
}

accepted "$1"
build_house
accepted "$house"
refused "orchestrator/report may include only from:" orchestrator/report/sound.cpp \
  '#include "orchestrator/campaign/sound.h"'
refused "orchestrator/report/sound.cpp:2:orchestrator/campaign/sound.h" orchestrator/report/sound.cpp \
  '#include "orchestrator/campaign/sound.h"'
refused "orchestrator/campaign may include only from:" orchestrator/campaign/sound.cpp \
  '#include "orchestrator/app/sound.h"'
refused "wear/rate may include only from:" wear/rate/sound.cpp \
  '#include "liggghts_inputs/decks/sound.h"'
refused "wear/guesses is a room without a rule" wear/guesses/guess.h '#pragma once'
refused "these lie in no sub-room" wear/loose.h '#pragma once'
refused "wear/rate/alone.cpp has no header of its name" wear/rate/alone.cpp 'int alone;'
refused "gmsh may be included only by: meshgen/gmsh_kernel.cpp" meshgen/sound.cpp '#include <gmsh.h>'
refused "wear is pure but for its stores:" wear/rate/sound.cpp '#include <fstream>'
exit $wrong
