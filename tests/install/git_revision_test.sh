#!/bin/sh
# The git revision is looked up at build time, and its source rewritten only where it changed.
#   git_revision_test.sh CHECKOUT EMPTY_FOLDER
set -eu
checkout=$1 work=$2
rm -rf "$work"
mkdir -p "$work/tree"

failed() { echo "FAILED: $1" >&2; exit 1; }
look_up() {
  cmake -DSOURCE="$work/$1" -DTEMPLATE="$checkout/mill/base/version.cpp.in" -DPROJECT_VERSION=9.8.7 \
    -DOUTPUT="$work/version.cpp" -P "$checkout/cmake/GitRevision.cmake"
}
says() { grep -qF "$1" "$work/version.cpp" || failed "$2: $(cat "$work/version.cpp")"; }
git_in() { git -C "$work/tree" -c user.name=test -c user.email=test@localhost "$@" >/dev/null; }

git_in init -q -b main
look_up tree
says '9.8.7 (git unknown)' 'a repository without a commit has no revision'

git_in commit --allow-empty -m first
look_up tree
says "(git $(git -C "$work/tree" rev-parse --short HEAD))" 'the revision is that of the commit'

touch -d 2001-01-01 "$work/version.cpp"
look_up tree
[ "$(date -r "$work/version.cpp" +%Y)" = 2001 ] || failed 'the same revision leaves the source alone'

git_in commit --allow-empty -m second
look_up tree
says "(git $(git -C "$work/tree" rev-parse --short HEAD))" 'the next commit is seen'

mkdir "$work/tree/unpacked"
look_up tree/unpacked
says '(git unknown)' 'an archive inside another repository has not the revision of that'
