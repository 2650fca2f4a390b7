#!/usr/bin/env bash
# The bounds of a filter are proved by Gappa (Debian: gappa): those for the coarsest rounding at the
# small end of the range, with ALL=1 for each way of rounding at both ends. Usage: prove_bounds.sh
# PRINT_BOUNDS FOLDER
set -eu
print=$1 work=$2
command -v gappa >/dev/null || { echo "Gappa is not installed"; exit 77; }
rm -rf "$work"
mkdir -p "$work/bounds" "$work/too_good"
prove() { xargs -P "$(nproc)" -n 1 sh -c 'gappa "$0" >/dev/null 2>&1 && echo "$0"' || true; } # names what is proved

"$print" "$work/bounds"
if [ -n "${ALL-}" ]; then chosen='*.g'; else chosen='*_small_*_up.g'; fi
find "$work/bounds" -name "$chosen" | sort > "$work/theorems"
prove < "$work/theorems" | sort > "$work/proved"
echo "$(wc -l < "$work/proved") of $(wc -l < "$work/theorems") bounds are proved"
[ -s "$work/theorems" ] || { echo "no theorems"; exit 1; }
diff "$work/theorems" "$work/proved"

# Bounds of a quarter are not.
"$print" "$work/too_good" 0.25
find "$work/too_good" -name '*_small_*g[12]_*up.g' > "$work/wrong_theorems"
[ -s "$work/wrong_theorems" ] || { echo "no theorems that are too good to be true"; exit 1; }
prove < "$work/wrong_theorems" > "$work/wrong"
if [ -s "$work/wrong" ]; then
  echo "proved, though too good to be true:"
  cat "$work/wrong"
  exit 1
fi
