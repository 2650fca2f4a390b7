#!/usr/bin/env bash
# The times of the page Performance, and of libraries of JavaScript on the page In the Browser: each
# file of measured/ has rows of a name, times and ratios in order, and becomes a table of a page;
# Performance has no times of its own.
set -eu
cd "$(dirname "$0")"
failures=0
fails() {
  echo "$1"
  failures=$((failures + 1))
}
pages=(Performance.txt In_the_browser.txt)
awk -v folder=measured -f measured.awk "${pages[@]}" >/dev/null
tables=$(sed -n 's/^\\measured{\([a-z_]*\).*/\1/p' "${pages[@]}")
[ -n "$tables" ] || fails "no table is named"
for file in measured/*.txt; do
  name=$(basename "$file" .txt)
  grep -qx "$name" <<<"$tables" || fails "$file is no table of a page"
  rows=$(awk -F'\t' '/^# / { next } NF == 6 && $1 ~ / \| / && 0 < $2 && $2 <= $3 && $5 <= $6 { ++rows; next } { exit 1 } END { print rows + 0 }' "$file") ||
    fails "$file has a row that is none"
  shown=$(awk -v folder=measured -f measured.awk <<<"\\measured{$name}" | grep -c '^| .* | .* [nµm]*s | ') || true
  [ "$shown" = "$rows" ] && [ "$rows" -gt 1 ] || fails "$file has $rows rows, and its table $shown"
done
for name in $tables; do [ -f "measured/$name.txt" ] || fails "not measured yet: $name"; done
! grep -nE '[0-9] (ns|µs|ms|s)\b' Performance.txt || fails "times of Performance.txt come from measured/"
exit $((failures > 0))
