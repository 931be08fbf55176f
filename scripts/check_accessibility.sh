#!/bin/sh
# Looks for barriers in pages with axe-core in headless Chromium, in light and dark and at the width of
# a phone. Prints what it finds; fails where something is serious or critical. Gets axe-core with npm.
#   scripts/check_accessibility.sh PAGE.html...
set -eu
[ $# -gt 0 ] || { echo "usage: scripts/check_accessibility.sh PAGE.html..." >&2; exit 2; }
command -v npm >/dev/null || { echo "npm is missing: install Node.js with npm" >&2; exit 4; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
npm install --silent --no-save --prefix "$work" axe-core@4 >/dev/null
axe=$work/node_modules/axe-core/axe.min.js

# The page with axe-core and what runs it at its end; the findings become the page's only text.
with_axe() { # page
  sed '/<\/body>/,$d' "$1"
  echo '<script>'; cat "$axe"; echo '</script><script>'
  cat <<'SCRIPT'
addEventListener("load", () => setTimeout(async () => {
  const {violations} = await axe.run(document, {resultTypes: ["violations"]});
  const lines = violations.flatMap(({id, impact, help, nodes}) => nodes.map(({target}) => `${impact}: ${id}: ${help}: ${target}`));
  document.body.textContent = ["AXE BEGIN", ...lines, "AXE END"].join("\n");
}, 1500));
SCRIPT
  echo '</script></body></html>'
}

bad=0
for page in "$@"; do
  with_axe "$page" >"$work/page.html"
  for look in "1300,2000#theme=light" "1300,2000#theme=dark" "390,2000#theme=light"; do
    chromium --headless --no-sandbox --disable-gpu --user-data-dir="$work/browser" --window-size="${look%%#*}" \
      --virtual-time-budget=20000 --dump-dom "file://$work/page.html#${look#*#}" 2>/dev/null |
      sed -n '/AXE BEGIN/,/AXE END/p' >"$work/found"
    grep -q 'AXE END' "$work/found" || { echo "$page ($look): axe-core did not finish"; bad=1; continue; }
    found=$(sed '/AXE BEGIN/d;s/AXE END.*//;/^$/d' "$work/found")
    echo "$page ($look): ${found:-nothing found}"
    ! grep -qE '^(serious|critical):' "$work/found" || bad=1
  done
done
exit $bad
