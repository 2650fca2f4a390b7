#!/usr/bin/env bash
# match: a surface continues another one, as verify finds; all orders, edges and kinds of surfaces,
# and what is refused.
. "$(dirname "$0")/functions.sh"

# matches ORDER ARGUMENTS...: the report, and verify of the first surface and the result
matches() {
  local order=$1
  shift
  run 0 match "$@" --order "$order" -o c.g2 && says out "$order along the whole edge, proved exactly" "after: $order" && cp out report
  run 0 verify --surfaces "$1" c.g2 && says out "1 ${order/G3/G2}"
}
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n0 0 0\n4 0 1\n0 1 1\n4 1/3 0\n0 3 0\n4 3 1\n' >a.g2
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n0 3 0\n4 3 1\n0 5 1\n4 4 0\n0 6 0\n4 7 1\n' >b.g2
printf '200 1 0 0\n3 1\n2 2\n0 0 1 1\n3 3\n0 0 0 2 2 2\n0 4 0 1\n4 4 1 1\n0 5 1 1\n4 4 1 1\n0 14 0 2\n8 14 2 2\n' >rational.g2
for order in G1 G2 G3; do
  matches $order a.g2 b.g2 && says report "before: G0"
  matches $order b.g2 a.g2 --edges v0,v1
  matches $order a.g2 b.g2 --edges u1,v1
  matches $order a.g2 rational.g2 && matches $order rational.g2 a.g2 --edges v1,v0
done
# the numbers that are given
matches G2 a.g2 b.g2 --alpha 1/10 --beta 2 --alpha2 -1/3 --delta 0.25 && says report "alpha = 1/10, beta = 2, alpha2 = -1/3, delta = 1/4"
matches G1 a.g2 b.g2 --beta 3/2 && says c.g2 "2 2" && holds [ "$(sed -n 5p c.g2)" = "4 4" ]
# the rows at the other edge stay
run 0 match a.g2 b.g2 -o c.g2 && holds [ "$(tail -n 3 c.g2 | head -2)" = "$(tail -n 2 b.g2)" ]
# both surfaces in one file, and a CAD model
cat a.g2 b.g2 >ab.g2 && run 0 match ab.g2 -o c.json && says c.json '"kind":"surface"'
# the edges are those that are nearest, in any directions; where two pairs are, they are named
printf '200 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n2 2\n0 0 1 1\n4 7 1\n4 4 0\n4 3 1\n0 6 0\n0 5 1\n0 3 0\n' >turned.g2
matches G2 a.g2 turned.g2 && says report "edges: v1,u1" "before: G0 (crease), reversed, angle <= 64.1" "after: G2, reversed"
for z in 0 1; do printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 %d\n1 0 %d\n0 1 %d\n1 1 %d\n' $z $z $z $z >square$z.g2; done
run 2 match square0.g2 square1.g2 -o c.g2 && says err "several_common_edges" "are equally near; name them"
# a surface that continues the other one stays
run 0 match a.g2 c.g2 -o d.g2 && run 0 match a.g2 d.g2 -o e.g2 && run 0 verify --surfaces a.g2 e.g2

run 2 match a.g2 -o c.g2 && says err "a.g2: 1 surfaces where two are expected"
run 2 match a.g2 b.g2 && says err "match: -o C.g2 is needed"
run 2 match a.g2 b.g2 a.g2 -o c.g2 && says err "one or two files are needed"
run 2 match a.g2 b.g2 --order G4 -o c.g2 && says err "G1" "G3"
run 2 match a.g2 b.g2 --edges v1 -o c.g2 && says err "two names are needed"
run 2 match a.g2 b.g2 --beta 0 -o c.g2 && says err "nonpositive_beta"
run 2 match "$L" b.g2 -o c.g2 && says err "curve"
