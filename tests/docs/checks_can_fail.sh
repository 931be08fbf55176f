#!/bin/sh
# A page with one fault of each kind: every fault has to be found, on its line.
#   tests/docs/checks_can_fail.sh PROGRAM     from the root of the sources
set -eu
program=$1
tests=$(pwd)/tests/docs
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
page=$work/page.md
cat >"$page" <<'END'
# A page with faults

See [nothing](missing.md) and [no heading](#nowhere).
```sh
make demoo
cmake --preset nothing
false
build/release/millwear chekc my_mill.toml
```
Say `millwear compare my_mill.toml --calibrate-untill 5` and `--calibrate-untill`.
```toml
[dem]
mix_revolutons = 2.0
```
```text
millwear check my_mill.toml
```
```
a block of no kind
```
END
failed=0
# found LINE TEXT: the check named this line with this text
found() { grep -q -- "^$page:$1: .*$2" "$work/printed" || { echo "line $1 was not found: $2"; failed=1; }; }

if "$tests/check_pages.sh" "$program" "$page" >"$work/printed"; then echo "a faulty page passed"; failed=1; fi
found 3 "there is no missing.md"
found 3 "no heading #nowhere"
found 8 "no verb chekc"
found 10 "compare has no --calibrate-untill"
found 10 "no verb has --calibrate-untill"
found 13 "has a key mix_revolutons"
found 16 "nobody runs it"
found 18 "does not say what it holds"

# Neither a campaign nor a page's folder is needed to see these fail.
if PREPARE=no "$tests/run_commands.sh" "$(dirname "$program")" "$page" >"$work/printed"; then
  echo "a page with faulty commands passed"
  failed=1
fi
found 5 "make demoo"
found 6 "cmake --preset nothing"
found 7 "false"
found 8 "build/release/millwear chekc"
exit $failed
