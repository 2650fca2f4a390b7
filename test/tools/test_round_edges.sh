#!/usr/bin/env bash
# round-edges: a box, open boxes, edges that stay, what is written, and what is refused; and solids.
. "$(dirname "$0")/functions.sh"
box=$data/box.g2

refused() { run 2 round-edges "${@:2}" && says err "$1"; } # refused TEXT ARGUMENTS...: the error contains the text

run 0 round-edges "$box" --open --set-back 1 -o rounded.g2 --plot rounded.svg
says out "0 u0 - 1 u0: 90" " degrees, rounded by surface 6: G2 and G2" "a hole at (12, 8, 6), between the surfaces 2, 4, 5" \
  "6 surfaces, 12 edges rounded, 8 corners left open" "G2 along all new edges, proved exactly"
holds [ "$(grep -c '^200' rounded.g2)" -eq 18 ]
holds grep -q '<svg' rounded.svg
run 0 verify --surfaces rounded.g2 --require G2 && says out "18 patches: 24 G2, 0 G1, 0 G0, 24 boundary"
# one digit altered
sed '0,/9.6/s//9.7/; 0,/48\/5/s//49\/5/' rounded.g2 >altered.g2 && holds [ "$(cmp -s rounded.g2 altered.g2; echo $?)" -eq 1 ]
run 1 verify --surfaces altered.g2 --require G2

# JSON
run 0 round-edges "$box" --open --set-back 1 --json
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
run 0 round-edges "$box" --open --set-back 1 --max-kink 80 -o same.g2 && says out "0 edges rounded" "12 beyond --max-kink" && lacks out "proved"
run 0 verify --surfaces same.g2 && says out "6 patches: 0 G2, 0 G1, 12 G0 (12 creases)"
run 0 round-edges "$box" --open --set-back 1 --min-kink 100 && says out "12 below --min-kink"
run 0 round-edges "$box" --open --set-back 1 --min-kink 100 --json && says out '"blends":[],' '"open_corners":[],'
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
refused "patch 0 u" "$box" --open --set-back 5 -o no.g2
says err "parameter_outside_domain"
refused "is not less than that of the opposite edge" "$box" --open --set-back 100 -o no.g2
refused "$(basename "$L"):1" "$L" --set-back 1 -o no.g2
refused "--max-work N allows" "$box" --open --set-back 1 --max-work 10 -o no.g2
refused "cannot_read_file" none.g2 --set-back 1
holds [ ! -e no.g2 ]

# solids: all is closed
run 0 round-edges "$box" --set-back 1 -o closed.g2 --plot closed.svg
says out "closed: edges " "6 plane faces, 12 edges rounded by 6 blends, 0 corners left open" \
  "closed: G2 along all 40 rails and 2 seams, proved exactly"
run 0 verify --surfaces closed.g2 --require G2 && says out ", 0 G1, 0 G0, 0 boundary, 0 collapsed"
holds grep -q '<svg' closed.svg
# a bracket of patches, edges of which consist of two, in one plane
rectangle() { # three corners
  printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n%s\n%s\n%s\n' "$1" "$2" "$3"
  awk -v p="$1 $2 $3" 'BEGIN { split(p, c); print c[4] + c[7] - c[1], c[5] + c[8] - c[2], c[6] + c[9] - c[3] }'
}
while read -r a b c d e f; do # a wall over each piece of the outline
  rectangle "$a $b 0" "$c $d 0" "$a $b 2"
done >bracket.g2 <<'END'
0 0 2 0
2 0 4 0
4 0 4 2
4 2 2 2
2 2 2 4
2 4 0 4
0 4 0 0
END
for z in 0 2; do # the second rectangle has a side that consists of two edges
  rectangle "0 0 $z" "4 0 $z" "0 2 $z"
  rectangle "0 2 $z" "2 2 $z" "0 4 $z"
done >>bracket.g2
run 0 round-edges bracket.g2 --set-back 0.25 -o ell.g2 && says out "8 plane faces, " "0 corners left open"
run 0 verify --surfaces ell.g2 --require G2 && says out ", 0 G1, 0 G0, 0 boundary"
# a bracket with wide turns, the arms of which are four times as wide as the set-back
{
  printf 'OFF\n12 8 0\n'
  for z in 0 20; do printf '%s\n' "0 0 $z" "40 0 $z" "40 10 $z" "10 10 $z" "10 40 $z" "0 40 $z"; done
  printf '6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n'
  for i in 0 1 2 3 4 5; do echo "4 $i $(((i + 1) % 6)) $(((i + 1) % 6 + 6)) $((i + 6))"; done
} >wide.off
run 0 round-edges wide.off --set-back 2.5 -o wide.g2 && says out "18 edges rounded" "60 rails and 2 seams, proved exactly"
# a mesh; one edge with its own distance, and a profile that is tighter
cat >tetrahedron.off <<'END'
OFF
4 4 6
0 0 0
8 0 0
0 8 0
0 0 8
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
END
run 0 round-edges tetrahedron.off --set-back 0.5 -o tetrahedron.g2 && says out "4 plane faces, 6 edges rounded"
run 0 verify --surfaces tetrahedron.g2 --require G2 && says out ", 0 G1, 0 G0, 0 boundary"
run 0 round-edges tetrahedron.off --set-back 0.5 --set-back 2=0.25 --profile 0.75 --json && says out '"rounded":6,"sharp":0' '"g2":true'
# some edges: a chain that is whole, and one that runs out
run 0 round-edges "$box" --set-back 1 --edges 0u0 -o one.g2 && says out "1 edge rounded by 1 blend" "11 edges left sharp"
run 0 verify --surfaces one.g2 && says out "0 boundary"
refused "there is no edge '99'; \`verify\` lists the edges" tetrahedron.off --set-back 1 --edges 99
refused "--profile: 'fine' is neither fair nor a number between 0 and 1" tetrahedron.off --set-back 1 --profile fine
refused "the set-back 4 must be less than" "$box" --set-back 4 -o no.g2
refused "round-edges: one solid is expected" tetrahedron.off tetrahedron.off --set-back 1
refused "--open: only with models .g2" tetrahedron.off --set-back 1 --open
refused "only with solids" open.g2 --set-back 1 --edges 0u0
refused "one distance for all edges is expected" open.g2 --set-back 0u0=1
sed -i '$d; s/^4 4 6/4 3 6/' tetrahedron.off
refused "tetrahedron.off: " tetrahedron.off --set-back 1
holds [ ! -e no.g2 ]
