#!/bin/sh
# Makes the man page or the bash completion from what the program says to --help.
#   scripts/command_pages.sh man|completion PROGRAM
set -eu
page=${1:-} program=${2:-}
help=$("$program" --help)
verbs=$(echo "$help" | awk '/^Subcommands:/ { on = 1; next } on && !/^  [a-z]/ { exit } on { print $1 }')
[ -n "$verbs" ] || { echo "$program --help lists no subcommands" >&2; exit 1; }

options_of() {  # every option of a verb, on one line
  "$program" "$1" --help | awk '/^  -/ { sub(/,/, " "); for (i = 1; i <= 2; ++i) if ($i ~ /^-/) printf "%s ", $i }'
}

verbatim() {  # lines as they are, for roff
  sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/" -e '1i .nf' -e '$a .fi'
}

man_page() {
  printf '.TH MILLWEAR 1 "" "%s"\n' "$("$program" --version)"
  printf '.SH NAME\nmillwear \\- predicts how the lifters of a tumbling mill wear\n'
  printf '.SH SYNOPSIS\n.B millwear\n.I VERB CASE\n[\n.I OPTIONS\n]\n'
  printf '.SH DESCRIPTION\n%s\n' "$(echo "$help" | head -n 1)"
  printf '.SH VERBS\n'
  for verb in $verbs; do
    printf '.SS %s\n' "$verb"
    "$program" "$verb" --help | cat -s | verbatim
  done
  printf '.SH EXAMPLES AND EXIT CODES\n'
  echo "$help" | awk '/^Subcommands:/ { on = 1; next } on && /^$/ { after = 1 } after' | cat -s | sed 1d | verbatim
}

completion() {
  echo '# Bash completion of millwear.'
  echo '_millwear() {'
  echo '  local word=${COMP_WORDS[COMP_CWORD]} words='
  echo '  if [ "$COMP_CWORD" -eq 1 ]; then'
  echo "    words='$(echo $verbs) --help --version'"
  echo '  elif [ "${word#-}" != "$word" ]; then'
  echo '    case ${COMP_WORDS[1]} in'
  for verb in $verbs; do
    echo "      $verb) words='$(options_of "$verb")' ;;"
  done
  echo '    esac'
  echo '  fi'
  echo '  COMPREPLY=($(compgen -W "$words" -- "$word"))'
  echo '}'
  echo 'complete -o default -F _millwear millwear'
}

case $page in
  man) man_page ;;
  completion) completion ;;
  *) echo "usage: $0 man|completion PROGRAM" >&2; exit 2 ;;
esac
