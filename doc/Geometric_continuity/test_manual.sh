#!/usr/bin/env bash
# Opens the pages of the manual in a browser without a network: every formula is typeset, no page
# but those of examples shows TeX, the search finds words of the text, the text is as wide as a
# narrow window, and titles in the tree are not cut. Links lead somewhere, and without doxygen the
# target doc says so. Usage: test_manual.sh HTML_FOLDER SOURCE_FOLDER
set -eu
texts=$(cd "$(dirname "$0")" && pwd)
python3 "$texts/test_links.py" "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake -S "$2" -B "$work" -DCMAKE_DISABLE_FIND_PACKAGE_Doxygen=ON -DBUILD_TESTING=OFF -DGEOMETRIC_CONTINUITY_WITH_OPENCASCADE=OFF >/dev/null
! cmake --build "$work" --target doc >"$work/out" 2>&1 || { echo "without doxygen there seems to be a manual"; exit 1; }
grep -q 'apt install doxygen' "$work/out" || { cat "$work/out"; exit 1; }
cd "$1"
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "skipped: there is no Chromium"
  exit 77
}
[ -d mathjax ] || {
  echo "skipped: libjs-mathjax is not installed"
  exit 77
}
profile=$work/profile
mkdir "$profile"
open() { # PAGE: as it is after its scripts, in the file dom
  timeout 100 "$browser" --headless --no-sandbox --disable-gpu --disable-extensions --no-first-run --user-data-dir="$profile" \
    --host-resolver-rules='MAP * ~NOTFOUND' --allow-file-access-from-files --virtual-time-budget=60000 --dump-dom "file://$1" \
    >"$profile/dom" 2>/dev/null </dev/null
}
failures=0 formulas=0
# figures are linked to scenes of the page of the browser where it is there
links=$(grep -ho 'href="geometric_continuity.html#' -- *.html | wc -l) wanted=0
[ ! -e geometric_continuity.html ] || wanted=$(cat "$texts"/*.txt | grep -c '^\\play{')
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
  open "$PWD/$page" || fail "$page: the browser fails"
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

# The main page in a frame, as on a telephone and as on a desk. Each answer is a line with an @.
cat >"$work/frame.html" <<FRAME
<iframe width="390" height="800" src="file://$PWD/index.html"></iframe><pre></pre>
<script>
const say = (text) => { document.querySelector('pre').append('\n@' + text); };
const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
onload = async () => {
  const frame = document.querySelector('iframe'), page = frame.contentDocument;
  await wait(3000);
  const { width } = page.querySelector('div.contents p').getBoundingClientRect();
  say('the text is ' + (width > 340 && width < 390 ? 'as wide as the window' : width + ' pixels wide'));
  for (const words of ['python', 'fillet', 'STEP', 'is_g2_join', 'word that is nowhere']) {
    const field = page.querySelector('#search-manual input');
    field.value = words;
    field.dispatchEvent(new Event('input'));
    await wait(3000);
    say(words + ': ' + [...page.querySelectorAll('#search-manual li a')].map((a) => a.getAttribute('href')).join(' ') + ' .');
  }
  frame.width = 1280;
  await wait(1000);
  const labels = [...page.querySelectorAll('#nav-tree .label')], end = page.getElementById('nav-tree').clientWidth;
  say((labels.length > 30 ? 'cut labels: ' : 'too few labels: ') + labels.filter((label) => label.getBoundingClientRect().right > end).map((label) => label.textContent).join(', ') + '.');
  say('');
};
</script>
FRAME
open "$work/frame.html" || fail "the browser fails"
for answer in 'the text is as wide as the window' 'python: Geometric_continuity_Python.html ' 'fillet: .*Geometric_continuity_Surfaces.html#Geometric_continuity_Rounded_edges ' \
  'STEP: .*Geometric_continuity_Cad.html' 'is_g2_join: .*group__PkgGeometricContinuityContinuity.html#' 'word that is nowhere:  .$' 'cut labels: .$'; do
  grep -q "^@$answer" "$profile/dom" || fail "not among the answers of the browser: $answer"
done
[ "$failures" -eq 0 ] || grep '^@' "$profile/dom" || true
echo "$formulas formulas, $failures failures"
[ "$failures" -eq 0 ] && [ "$formulas" -gt 500 ]
