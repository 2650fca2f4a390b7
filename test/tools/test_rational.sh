# Rational curves and surfaces go through every command: circles, arcs of more than half a turn, a
# cylinder with a fillet.
. "$(dirname "$0")/functions.sh"

circle='100 1 0 0
2 1
9 3
0 0 0 1 1 2 2 3 3 4 4 4
4 3 1
3 6 1
0 10 2
-3 4 1
-2 1 1
-1 -2 1
4 -2 2
5 0 1
4 3 1'
echo "$circle" >circle.g2
curve $'2 0\n2 2\n0 0 1 1\n7 -1\n9 5' >line.g2
curve $'2 1\n3 3\n0 0 0 1 1 1\n1 0 1\n1 1 1\n0 2 2' >moon.g2
curve $'2 0\n2 2\n0 0 1 1\n0 1\n1 0' >>moon.g2

# verify: exact for the numbers in the file, also piece by piece and from standard input
run 0 verify circle.g2 --closed --require G3 && says out "1 -> 2       C3 G3 F2    (-2, 1)" "4 joins: 4 G3" "proved exactly"
run 0 verify circle.g2 --closed --json && says out '"betas":["1","2","6"]' '"g_order":3'
piped circle.g2 0 verify - --closed --require G3
run 1 verify moon.g2 --require G1 && says out "corner of 135 degrees"
run 0 verify circle.g2 --within 0.001,0.001,1 --require G2 && says out "within the tolerance: order 0 proved, 1 proved, 2 proved"
run 0 verify circle.g2 --kernel double --require G2
sed '$s/4 3 1/4.000001 3 1/' circle.g2 >broken.g2
run 1 verify broken.g2 --closed --require G0 && says out "gap"

# extend: what is added is polynomial
run 0 extend circle.g2 --order torsion -o extended.g2 && says out "Bezier curve of degree 3 on [4, 5]" "the join is proved"
run 0 verify extended.g2 --require G3 && says out "4 joins: 4 G3"
run 0 extend circle.g2 --order curvature --toward 9,9 -o extended.g2 --plot extended.svg && says extended.svg "</svg>"

# blend, beside rational curves and in place of a piece
run 0 blend circle.g2 line.g2 --strategy fair -o blended.g2 --plot blended.svg && says out "proved in exact arithmetic"
run 0 verify circle.g2 blended.g2 line.g2 --require G2 && says out "5 joins"
run 0 blend circle.g2 line.g2 --strategy all && says out "min_second"
run 0 blend circle.g2 --replace 1 --strategy fair -o replaced.g2
run 0 verify replaced.g2 --closed --require G2 && says out "4 joins"
run 2 blend circle.g2 line.g2 --representable --strategy c2 && says err "--representable needs polynomial curves"
run 0 blend moon.g2 --corners all --closed --distance 0.2 -o rounded.g2 && says out "2 corners are rounded"
run 0 verify rounded.g2 --closed --require G2 && says out "4 joins"
holds grep -q '^2 1$' rounded.g2 # the arc is still one

# plot: the curve, and Hagen's alternatives at its end
run 0 plot circle.g2 line.g2 -o picture.svg && says picture.svg "</svg>"
run 0 plot circle.g2 --alternatives -o picture.svg && says picture.svg "</svg>"

# surfaces: a plane, a fillet and a cylinder; then with a blend in place of the quarter of a circle
fillet=$data/fillet.g2 smooth=$data/smooth_fillet.g2
run 0 verify --surfaces "$fillet" --require G1 &&
  says out "0 u1 - 1 u0: G1 (curvature)" "3 patches: 3 G2, 2 G1, 0 G0, 2 boundary" "proved exactly"
run 1 verify --surfaces "$fillet" --require G2
run 0 verify --surfaces "$smooth" --require G2 && says out "every shared edge and every knot line is G2, proved exactly"
run 0 verify --surfaces "$smooth" --json && says out '"summary":{"G2":5,"G1":0'
run 0 verify --surfaces "$fillet" --within 0.01,0.01
run 0 tessellate "$fillet" -o fillet.off --tolerance 0.05 && says out "3 surfaces"
run 0 tessellate "$fillet" -o fillet.ply --grid 4 --kernel exact
run 0 plot --surfaces "$fillet" -o fillet.svg && says fillet.svg "edge, G1"
curve $'3 1\n4 4\n0 0 0 0 1 1 1 1' >ribbon_edge.g2
run 2 connect ribbon_edge.g2 ribbon_edge.g2 ribbon_edge.g2 -o ribbon.g2 && says err "ribbon_edge.g2:2: a rational curve where a polynomial one is expected"

# what is wrong is refused, with the line where the object ends
curve $'2 1\n3 3\n0 0 0 1 1 1\n0 0 1\n1 1 -1\n1 0 1' >bad.g2
run 2 verify line.g2 bad.g2 && says err "bad.g2:7: zero_weight"
curve $'2 1\n3 3\n0 0 0 1 1 1\n0 0 1\n1 1\n1 0' >bad.g2
run 2 verify bad.g2 && says err "bad.g2:7: file ends after 2 of 3 control points"
curve $'2 1\n2 2\n0 0 1 1\n0 0 1e-300\n1e300 1 1e-300' >bad.g2
run 0 verify bad.g2 line.g2
run 2 plot bad.g2 -o bad.svg && says err "too far away to be drawn"
