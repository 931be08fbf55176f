#!/bin/sh
# Checks that the sources are as clang-format would write them; `clang-format -i FILE` mends one.
set -eu
cd "$(dirname "$0")/.."
git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run -Werror
