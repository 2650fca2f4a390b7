#!/usr/bin/env bash
# round-edges: a box, open boxes, edges that stay, what is written, and what is refused.
. "$(dirname "$0")/functions.sh"
box=$data/box.g2

refused() { run 2 round-edges "${@:2}" && says err "$1"; } # refused TEXT ARGUMENTS...: the error contains the text

run 0 round-edges "$box" --set-back 1 -o rounded.g2 --plot rounded.svg
says out "0 u0 - 1 u0: 90" " degrees, rounded by surface 6: G2 and G2" "a hole at (12, 8, 6), between the surfaces 2, 4, 5" \
  "6 surfaces, 12 edges rounded, 8 corners left open" "G2 along all new edges, proved exactly"
holds [ "$(grep -c '^200' rounded.g2)" -eq 18 ]
holds grep -q '<svg' rounded.svg
run 0 verify --surfaces rounded.g2 --require G2 && says out "18 patches: 24 G2, 0 G1, 0 G0, 24 boundary"
# one digit altered
sed '0,/9.6/s//9.7/; 0,/48\/5/s//49\/5/' rounded.g2 >altered.g2 && holds [ "$(cmp -s rounded.g2 altered.g2; echo $?)" -eq 1 ]
run 1 verify --surfaces altered.g2 --require G2

# JSON
run 0 round-edges "$box" --set-back 1 --json
if command -v python3 >/dev/null; then
  python3 - out <<'END' || holds false
import json, sys
r = json.load(open(sys.argv[1]))
assert r["summary"] == {"surfaces": 6, "rounded": 12, "open_corners": 8, "beyond_max_kink": 0, "below_min_kink": 0, "not_rounded": 0, "g2": True}
assert all(b["order_a"] == b["order_b"] == "G2" and b["possible_fold"] is None for b in r["blends"])
assert [b["surface"] for b in r["blends"]] == list(range(6, 18))
assert [c["patches"] for c in r["open_corners"] if c["point"] == ["12", "8", "6"]] == [[2, 4, 5]]
END
fi

# edges that stay
run 0 round-edges "$box" --set-back 1 --max-kink 80 -o same.g2 && says out "0 edges rounded" "12 beyond --max-kink" && lacks out "proved"
run 0 verify --surfaces same.g2 && says out "6 patches: 0 G2, 0 G1, 12 G0 (12 creases)"
run 0 round-edges "$box" --set-back 1 --min-kink 100 && says out "12 below --min-kink"
run 0 round-edges "$box" --set-back 1 --min-kink 100 --json && says out '"blends":[],' '"open_corners":[],'
# without bottom and top: no corner of three
awk '/^200/ { ++n } n > 1 && n < 6' "$box" >open.g2
run 0 round-edges open.g2 --set-back 1 -o - && says out "200 1 0 0" && says err "4 surfaces, 4 edges rounded, 0 corners left open"
# nothing is sharp in the teapot: its normals vanish
run 0 round-edges "$teapot" --set-back 0.1 && says out "32 surfaces, 0 edges rounded" "with vanishing normals or more than two surfaces"

# what is refused
refused "no file is given" --set-back 1
refused "--set-back R is needed" "$box"
refused "is not a positive length" "$box" --set-back 0
refused "is not a positive length" "$box" --set-back -1
refused "--min-kink: 181 is not between 0 and 180 degrees" "$box" --set-back 1 --min-kink 181
refused "--max-kink: -1 is not between 0 and 180 degrees" "$box" --set-back 1 --max-kink -1
refused "patch 0 u" "$box" --set-back 5 -o no.g2
says err "parameter_outside_domain"
refused "is not less than that of the opposite edge" "$box" --set-back 100 -o no.g2
refused "$(basename "$L"):1" "$L" --set-back 1 -o no.g2
refused "--max-work N allows" "$box" --set-back 1 --max-work 10 -o no.g2
refused "cannot_read_file" none.g2 --set-back 1
holds [ ! -e no.g2 ]
