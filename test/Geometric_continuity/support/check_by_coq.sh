#!/usr/bin/env bash
# The proofs that Gappa finds for the bounds of a filter (prove_bounds.sh) are checked by Coq
# (Debian: coq, libcoq-gappa, libcoq-flocq): those for rounding to nearest, since the library of Coq
# does not have all theorems that Gappa uses for other ways of rounding. Prints what is not checked.
# Minutes for a filter. Usage: check_by_coq.sh PRINT_BOUNDS FOLDER [START], of the names of theorems
set -eu
print=$1 work=$2 start=${3-}
for program in gappa coqc; do
  command -v $program >/dev/null || { echo "$program is not installed"; exit 77; }
done
rm -rf "$work"
mkdir -p "$work"
"$print" "$work"
check() { # a theorem
  gappa -Bcoq "$1" >"${1%.g}.v" 2>/dev/null && coqc "${1%.g}.v" >/dev/null 2>&1 && echo "$1"
}
export -f check
find "$work" -name "$start*_ne.g" | sort >"$work/theorems"
[ -s "$work/theorems" ] || { echo "no theorems"; exit 1; }
xargs -P "$(nproc)" -I {} bash -c 'check {} || true' <"$work/theorems" | sort >"$work/checked"
echo "Coq has checked $(wc -l <"$work/checked") of $(wc -l <"$work/theorems") bounds"
diff "$work/theorems" "$work/checked"
