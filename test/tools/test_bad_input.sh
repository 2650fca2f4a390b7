#!/usr/bin/env bash
# Bad input: a message with file, line and reason, exit code 2, and no output.
. "$(dirname "$0")/functions.sh"

bad() { # bad REASON: the file bad.g2 is refused
  run 2 verify bad.g2 "$L" && says err "bad.g2" "$1"
  run 2 blend bad.g2 "$R" -o no.g2 --plot no.svg && says err "bad.g2"
  holds [ ! -e no.g2 -a ! -e no.svg ]
}
printf '' >bad.g2
bad "bad.g2:1"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2' >bad.g2
bad "3 of 4"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 nan 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 inf 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1/0 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1e999999999 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4000000000 4\n0 0 0 0 1 1 1 1\n0 0 0' >bad.g2
bad "bad.g2:3"
curve $'3 2\n4 4\n0 0 0 0 1 1 1 1\n0 0 0' >bad.g2
bad "bad.g2:2"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4' >bad.g2
bad "bad.g2:9"
printf '\0\0\0\377\376' >bad.g2
bad "bad.g2:1"
printf '200 1 0 0\n' >bad.g2
bad "200"
run 2 verify missing.g2 "$L" && says err "missing.g2"
run 2 verify "$L" "$S" && says err "dimension"
run 2 blend "$L" "$S" -o no.g2 && says err "dimension_mismatch"
run 2 blend "$L" "$R" --beta 0 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --eta -1 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --beta two -o no.g2 && says err "--beta"
run 2 blend "$L" "$R" --strategy free -o no.g2 && run 2 blend "$L" "$R" --strategy best -o no.g2 && says err "energy3"
run 2 blend "$L" "$R" --order 4 -o no.g2 && run 2 blend "$L" "$R" --kernel quad -o no.g2
curve $'3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 1 1\n1 1 1' >cusp.g2
run 2 blend cusp.g2 "$R" -o no.g2 && says err "zero_tangent: blend: end of the first curve"
run 2 blend "$L" "$R" -o missing/no.g2 && says err "missing/no.g2"
echo old >old.g2
run 2 blend cusp.g2 "$R" -o old.g2
holds [ "$(cat old.g2)" = old ]
holds [ ! -e no.g2 ]
