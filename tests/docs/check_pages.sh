#!/bin/sh
# Checks what can be checked in the pages without running their commands, and names page and line:
#   - every link leads to a file, and to a heading if it names one; sources name only pages that exist;
#   - every code block says what it holds, and commands stand in ```sh blocks, which run_commands.sh runs;
#   - every verb and option of millwear that a page names is in `millwear VERB --help`;
#   - every key in a ```toml block is in docs/case_file.md or docs/how_to_run_a_study.md;
#   - docs/commands.md is what scripts/print_commands.sh prints, and CONTRIBUTING.md has every sub-room.
#
#   tests/docs/check_pages.sh PROGRAM [PAGE...]     from the root of the sources
set -eu
program=$1
shift
all=$#
[ $# -gt 0 ] || set -- README.md CONTRIBUTING.md CHANGELOG.md docs/*.md $(find cases -name '*.md')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tab=$(printf '\t')
failed=0
fault() { echo "$1"; failed=1; }

# The anchors of a page's headings: lower case, without punctuation, spaces as hyphens.
anchors_of() {
  awk '/^```/ { code = !code } !code && /^#+ / { sub(/^#+ /, ""); print tolower($0) }' "$1" |
    sed 's/[^a-z0-9 _-]//g; s/ /-/g'
}

# "line<TAB>target" of every link and picture of a page.
links_of() {
  awk '/^```/ { code = !code } !code {
    while (match($0, /\]\([^)]*\)/)) {
      print FNR "\t" substr($0, RSTART + 2, RLENGTH - 3); $0 = substr($0, RSTART + RLENGTH) } }' "$1"
}

check_links() {
  links_of "$1" >"$work/links"
  while IFS="$tab" read -r line target; do
    case $target in http://* | https://*) continue ;; esac
    file=${target%%#*} anchor=${target#*#}
    [ "$anchor" != "$target" ] || anchor=
    if [ -z "$file" ]; then path=$1; else path=$(dirname "$1")/$file; fi
    if [ ! -e "$path" ]; then
      fault "$1:$line: there is no $target"
    elif [ -n "$anchor" ] && ! anchors_of "$path" | grep -qx -- "$anchor"; then
      fault "$1:$line: $path has no heading #$anchor"
    fi
  done <"$work/links"
}

check_blocks() {
  awk '
    /^ *```/ {
      if (inside) { inside = 0; next }
      inside = 1; kind = $0; gsub(/[ `]/, "", kind)
      if (kind == "") print FILENAME ":" FNR ": the block does not say what it holds; commands are ```sh, else ```text"
      next }
    inside && kind != "sh" && kind != "make" && FILENAME != "docs/commands.md" &&
      /^ *(build\/release\/)?millwear [a-z]+ [^ ]*\.toml/ {
        print FILENAME ":" FNR ": a command outside of a ```sh block, so nobody runs it" }
    ' "$1" >"$work/faults"
  [ ! -s "$work/faults" ] || fault "$(cat "$work/faults")"
}

# "line<TAB>text" of everything that names commands: code spans and the lines of ```sh and ```make blocks.
commands_of() {
  awk '
    /^ *```/ { inside = !inside; kind = $0; gsub(/[ `]/, "", kind); next }
    inside { if (kind == "sh" || kind == "make") print FNR "\t" $0; next }
    { while (match($0, /`[^`]+`/)) {
        print FNR "\t" substr($0, RSTART + 1, RLENGTH - 2); $0 = substr($0, RSTART + RLENGTH) } }' "$1"
}

"$program" --help >"$work/help"
awk '/^(Subcommands|Verbs|Commands):/ { inside = 1; next } /^[^ ]/ { inside = 0 }
  inside && /^  [a-z]/ { print $1 }' "$work/help" >"$work/verbs"
while read -r verb; do
  "$program" "$verb" --help | grep -oE -- '--?[a-z][a-z-]*' | sort -u >"$work/options.$verb"
done <"$work/verbs"
grep -oE -- '--?[a-z][a-z-]*' "$work/help" >"$work/options.all"
cat "$work"/options.* | sort -u >"$work/any_option"

check_commands() {
  commands_of "$1" >"$work/commands"
  while IFS="$tab" read -r line text; do
    case $text in
      --*)
        option=$(echo "$text" | grep -oE -- '^--[a-z-]+')
        grep -qx -- "$option" "$work/any_option" || fault "$1:$line: no verb has $option"
        continue
        ;;
      "millwear "* | build/release/"millwear "* | *[!a-z#]" millwear "* | "$tab"millwear*) ;;
      *) continue ;;
    esac
    words=${text##*millwear }
    verb=$(echo "$words" | cut -d' ' -f1)
    case $verb in VERB | -*) continue ;; esac
    if ! grep -qx "$verb" "$work/verbs"; then
      # Files name their format so: `millwear summary`.
      [ "$1" = docs/file_formats.md ] || fault "$1:$line: millwear has no verb $verb"
      continue
    fi
    for option in $(echo "$words" | sed 's/#.*//' | grep -oE -- ' --[a-z-]+'); do
      grep -qx -- "$option" "$work/options.$verb" || fault "$1:$line: millwear $verb has no $option"
    done
  done <"$work/commands"
}

sed -n 's/^| `\([a-z_]*\)` |.*/\1/p' docs/case_file.md docs/how_to_run_a_study.md docs/cluster.md >"$work/keys"
check_keys() {
  awk '/^ *```/ { inside = !inside && $0 ~ /```toml/; next }
    inside && /^ *[a-z_]+ *=/ { print FNR "\t" $1 }' "$1" >"$work/used"
  while IFS="$tab" read -r line key; do
    grep -qx "$key" "$work/keys" || fault "$1:$line: neither case file nor study file has a key $key"
  done <"$work/used"
}

for page in "$@"; do
  check_links "$page"
  check_blocks "$page"
  check_commands "$page"
  check_keys "$page"
done
[ "$all" = 0 ] || exit $failed

scripts/print_commands.sh "$program" | cmp -s - docs/commands.md ||
  fault "docs/commands.md is out of date; scripts/print_commands.sh $program > docs/commands.md"
for place in mill/* liggghts_inputs/* wear/* recorder/* orchestrator/*; do
  [ -d "$place" ] && [ "$(basename "$place")" != bench ] || continue
  grep -q "^| \`$place\` |" CONTRIBUTING.md || fault "CONTRIBUTING.md has no line for the room $place"
done
grep -rnoE 'docs/[a-z_]+\.(md|png)' Makefile CMakeLists.txt scripts mill meshgen liggghts_inputs wear recorder \
  orchestrator cases --include='*' | while IFS=: read -r source line page; do
  [ -e "$page" ] || echo "$source:$line: there is no $page"
done >"$work/faults"
[ ! -s "$work/faults" ] || fault "$(cat "$work/faults")"
exit $failed
