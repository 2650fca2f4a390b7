#!/usr/bin/env bash
# Opens the pages of the manual in a browser without a network: every formula is typeset, and no
# page but those of examples shows TeX. Usage: test_manual.sh HTML_FOLDER
set -eu
cd "$1"
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "skipped: there is no Chromium"
  exit 77
}
[ -d mathjax ] || {
  echo "skipped: libjs-mathjax is not installed"
  exit 77
}
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
failures=0 formulas=0
# figures are linked to scenes of the page of the browser where it is there
links=$(grep -ho 'href="geometric_continuity.html#' -- *.html | wc -l) wanted=0
[ ! -e geometric_continuity.html ] || wanted=$(cat "$(dirname "$0")"/*.txt | grep -c '^\\play{')
fail() {
  echo "$1"
  failures=$((failures + 1))
}
[ "$links" -eq "$wanted" ] || fail "$links links to scenes, not $wanted"
[ "$(wc -c <index.html)" -le 40000 ] || fail "index.html: more than 40 kB"
# the pages of the manual: the main page, and those of texts, which doxygen names after their labels
for page in index.html Geometric_continuity_[A-Z]*.html; do
  [ "$(wc -c <"$page")" -le 250000 ] || fail "$page: too long to read"
  wanted=$(grep -oE '\\\(|\\\[|\\begin\{eqnarray' "$page" | wc -l)
  timeout 100 "$browser" --headless --no-sandbox --disable-gpu --disable-extensions --no-first-run --user-data-dir="$profile" \
    --host-resolver-rules='MAP * ~NOTFOUND' --allow-file-access-from-files --virtual-time-budget=60000 --dump-dom "file://$PWD/$page" \
    >"$profile/dom" 2>/dev/null </dev/null || fail "$page: the browser fails"
  set_in_type=$(grep -oE 'class="MathJax"' "$profile/dom" | wc -l)
  [ "$set_in_type" -eq "$wanted" ] || fail "$page: $set_in_type of $wanted formulas are typeset"
  # a bar inside of a formula ends a cell, and with it the table
  rows=$(sed -e '/<div class="fragment"/,/<!-- fragment -->/d' -e '/<pre/,/<\/pre>/d' "$page" | grep -cE '^(<p>)?\| ' || true)
  [ "$rows" -eq 0 ] || fail "$page: $rows rows of a table are left as text"
  # a quotation mark inside of backticks ends the code for doxygen, and all that follows is turned
  # over
  ticks=$(sed '/<div class="line">/d' "$page" | grep -c '`' || true)
  [ "$ticks" -eq 0 ] || fail "$page: $ticks lines with backticks"
  raw=$(sed -e '/<script/,/<\/script>/d' "$profile/dom" | grep -oE '\\\(|\\\[|\\f\$' | wc -l)
  [ "$raw" -eq 0 ] || fail "$page: $raw formulas are left as TeX"
  ! grep -q 'class="MathJax_Error"\|class="merror"\|\[Math Processing Error\]' "$profile/dom" || fail "$page: a formula has an error"
  formulas=$((formulas + set_in_type))
done
echo "$formulas formulas, $failures failures"
[ "$failures" -eq 0 ] && [ "$formulas" -gt 500 ]
