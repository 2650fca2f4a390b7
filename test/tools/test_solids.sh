#!/usr/bin/env bash
# Closed shells that are written as solids: their splines are read as the same doubles, FreeCAD
# finds closed solids, and `verify` the orders that they are made with.
. "$(dirname "$0")/functions.sh"
check_solids=$here/cad/check_solids.py make_solids=$here/make_solids.py
made_by MAKE_CAD_SHELLS shells >made

for ending in step brep; do
  run 0 verify shells/box.$ending --require G2 --within 1e-9,1e-5deg,1e-5% && says out "6 faces; edges: 12 inner, 0 seams, 0 boundary" "12 corners"
  run 0 verify shells/rounded.$ending --require G2 --within 1e-9,1e-5deg,1e-5% && says out "15 inner, 0 seams, 0 boundary" "2 G2, 0 G1, 13 G0" "13 corners"
  # closed surfaces have a seam, where they are G2
  run 0 verify shells/ring.$ending --require G1 --within 1e-9,1e-5deg,1e-2% && says out "2 inner, 2 seams, 0 boundary" "seam: G2, exactly G2"
  run 0 verify shells/cushion.$ending --require G2 --within 1e-9,1e-5deg,1e-5% && says out "2 inner, 1 seam, 0 boundary" "3 G2"
done
run 0 verify shells/rounded.step && says out '"front"' '"blend 0"'

# by FreeCAD: closed, valid and of the right volume
arguments=()
for ending in step brep; do
  arguments+=(shells/box.$ending 5.999999 6.000001 shells/rounded.$ending 5.99303 5.99304 shells/ring.$ending 52.795 52.805 shells/cushion.$ending 77.74 77.75)
done
python3 "$check_solids" "${arguments[@]}"
code=$?
[ $code -eq 77 ] && echo "not checked by FreeCAD, which is not there" || holds [ $code -eq 0 ]

# Polyhedra in, closed solids out, which are proved G2 along all edges and valid for FreeCAD: less
# than before, and more than if planes cut the edges off.
python3 "$make_solids" >made || holds false
arguments=()
while read -r name distance least most; do
  for ending in step brep; do
    run 0 round-edges $name.off --set-back "$distance" -o $name.$ending && says out "G2"
    arguments+=($name.$ending "$least" "$most")
  done
  run 0 verify $name.step --require G2 --within 1e-9,1e-5deg,1e-3%
  says out " 0 boundary" " 0 G1, 0 G0, 0 gaps, 0 undecided; 0 corners, 0 fading corners, 0 kinks"
done <made
holds [ "${#arguments[@]}" -eq 36 ]
python3 "$check_solids" "${arguments[@]}"
code=$?
[ $code -eq 77 ] || holds [ $code -eq 0 ]

# One solid is read from a mesh and from CAD models, whose planes are taken.
for ending in step brep; do
  run 0 round-edges shells/box.$ending --set-back 0.2 -o again.$ending && run 0 verify again.$ending --require G2 --within 1e-9,1e-5deg,1e-3%
done
run 0 round-edges shells/box.step --set-back 0.2 -o some.step --edges 0,2 && run 0 verify some.step && says out " 0 boundary" " 0 gaps, 0 undecided"

# what is no solid of planes is refused, with the face
refused '"blend 0"): B-spline surface, neither a plane nor a wall' round-edges shells/rounded.step --set-back 0.1 -o none.step
refused '"outside"): B-spline surface, neither a plane nor a wall' round-edges shells/ring.step --set-back 0.1 -o none.step && says err "ring.step: face 0 (#"
holds [ ! -e none.step ]
bad() { # TEXT SED: the mesh, changed by sed, is refused
  sed "$2" box.off >bad.off
  refused "$1" round-edges bad.off --set-back 1 -o none.step && holds [ ! -e none.step ]
}
bad "bad.off:1: the word OFF is expected" 's/OFF/COFF/'
bad "bad.off:2: a number of things is expected, not '-8'" 's/^8 /-8 /'
bad "bad.off:3: not a number" '3s/0 /x /'
bad "there are more than three numbers for each vertex" '10s/$/ 7/'
bad "bad.off:11: vertex 9: there are only 8, counted from 0" '11s/[0-9]$/9/'
bad "bad.off:11: vertex 0 comes twice" '11s/.*/4 0 1 0 2/'
bad "bad.off:16: the file ends where face 6 is expected" '2s/6 0/7 0/'
bad "bad.off: face 0: edge 1 has no other face: the shell is open" '2s/6 0/5 0/'
bad "bad.off: vertex" '3s/^0/1/'

# Plates with rounded outlines, holes and bosses: G2 with planes and walls, and between an arc and a
# line as smooth as the outline.
plates() {
  arguments=()
  while read -r name distance least most edges g1; do
    for ending in step brep; do
      run 0 round-edges $name.step --set-back "$distance" -o round_$name.$ending && says out ", $edges edges rounded" "closed: G2 along"
      arguments+=(round_$name.$ending "$least" "$most")
    done
    [[ $name = turned_* ]] || says out "proved exactly"
    run 0 verify round_$name.step --require G1 --within 1e-9,1e-5deg,1e-2%
    says out " 0 boundary" " $g1 G1, 0 G0, 0 gaps, 0 undecided; 0 corners, 0 fading corners, 0 kinks"
  done <made
  python3 "$check_solids" "${arguments[@]}"
  holds [ $? -eq 0 ]
  # lines that meet in a corner: blends break in a mitre there, and the edge along the walls stays
  run 0 round-edges half_plate.step --set-back 1 --edges 1,4,7,10,13,16 -o half.step && says out "; 2 mitres; 6 edges left sharp"
  run 0 verify half.step && says out " 0 boundary" " 0 gaps, 0 undecided; 8 corners, 2 fading corners, 0 kinks"
  refused "edge 0: it runs along the walls of an outline" round-edges half_plate.step --set-back 1 -o none.step
  # what there is no room for, with the bound
  refused "it bends to the side of its plane with the radius 6; the set-back 7 must be less" round-edges plate.step --set-back 7 --edges 1,4,7,10,13,16,19,22 -o none.step
  refused "which is 5 high; the set-back must be less than 2.5" round-edges disc.step --set-back 3 -o none.step
  refused "3.9 must be less than 3.5" round-edges plate_holes.step --set-back 3.9 --edges 15,16 -o none.step
  refused "of the same outline" round-edges plate.step --set-back 1 --set-back 1=2 -o none.step
  refused "edge 0 is smooth: there is nothing to round" round-edges plate.step --set-back 1 --edges 0 -o none.step
  refused "there is no edge '99'" round-edges plate.step --set-back 1 --edges 99 -o none.step
  refused "is written to a CAD model" round-edges plate.step --set-back 1 -o none.g2
  holds [ ! -e none.step ]
}
python3 "${make_solids%solids.py}plates.py" >made
code=$?
[ $code -eq 77 ] && echo "no plates are made without FreeCAD" || { holds [ $code -eq 0 ] && plates; }
