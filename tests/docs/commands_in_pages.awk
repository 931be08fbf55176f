# Prints every command of the pages: the lines of their ```sh blocks, continued lines joined, as
# "page:line<TAB>command". A line that only is a comment is none.
FNR == 1 { inside = 0; command = "" }
/^ *```/ { inside = !inside && $0 ~ /^ *```sh *$/; next }
!inside || /^ *(#|$)/ { next }
{
  if (command == "") place = FILENAME ":" FNR
  sub(/^ */, "")
  if (sub(/\\$/, "")) { command = command $0; next }
  print place "\t" command $0
  command = ""
}
