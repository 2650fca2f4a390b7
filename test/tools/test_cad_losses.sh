#!/usr/bin/env bash
# CAD models: what a file names and OpenCASCADE leaves out, shells that are not closed, faces side
# by side that share no edge, and sewing.
. "$(dirname "$0")/functions.sh"

made_by MAKE_CAD_MODELS models

# An entity is not in the file, but another one refers to it: two faces with a kink in between are
# no longer connected, or one of them is gone.
run 1 verify models/kinks.step --require G1 && says out "2 kinks"
id() { sed -n "s/^\(#[0-9]*\) = $1(.*/\1/p" "$2" | sed -n "$3p"; } # TYPE FILE NUMBER
without() { awk -v id="$1" '$1 == id && $2 == "=" { gone = 1 } !gone; /;/ { gone = 0 }' "$2"; } # ID FILE
for type in EDGE_CURVE ADVANCED_FACE ORIENTED_EDGE EDGE_LOOP FACE_BOUND VERTEX_POINT OPEN_SHELL PLANE; do
  gone=$(id $type models/kinks.step 1)
  without "$gone" models/kinks.step >dangling.step
  "$program" verify dangling.step --require G0 --allow-empty >out 2>err
  case $? in
  1) says out "not read: $gone: not in the file, but #" " refers to it" "not met, because not all was decided" ;;
  2) grep -qE 'no shape in this STEP file|the library that reads it crashes' err || holds false ;;
  *) holds false ;;
  esac
done
gone=$(id EDGE_CURVE models/kinks.step 1)
without "$gone" models/kinks.step >dangling.step
run 1 verify dangling.step && says out "not covered: 1 element, it cannot be read" "its boundary does not close"
run 1 verify dangling.step --json && says out '"lost":1' && run 1 verify dangling.step --format sarif && says out '"not-verified"'
# each lost edge once
gone=$(id ADVANCED_FACE models/kinks.step 1)
without "$gone" models/kinks.step >dangling.step
run 1 verify dangling.step --allow-empty && says out ' EDGE_CURVE: no face has it'
holds [ "$(grep '^not read: ' out | sort | uniq -d | wc -l)" -eq 0 ]
# entities of no known type, and faces that nothing refers to
sed 's/EDGE_CURVE(/EDGE_KURVE(/' models/kinks.step >unknown.step
"$program" verify unknown.step --allow-empty >out 2>err
holds [ $? -eq 1 ] && says out ' EDGE_KURVE: of no known type'
sed 's/^\(#[0-9]* = OPEN_SHELL(.*,(\)#[0-9]*,/\1/' models/kinks.step >orphan.step
run 1 verify orphan.step --allow-empty && says out ' ADVANCED_FACE: no shape has it'
# edges of another known type, uses that name no edge, and what nothing refers to
edge=$(id EDGE_CURVE models/fillet.step 1) use=$(id ORIENTED_EDGE models/fillet.step 1) bound=$(id FACE_BOUND models/fillet.step 1)
for type in CARTESIAN_POINT VERTEX_POINT VECTOR EDGE; do
  sed "s/^$edge = EDGE_CURVE(/$edge = $type(/" models/fillet.step >retyped.step
  "$program" verify retyped.step --require G1 --allow-empty >out 2>err
  holds [ $? -ne 0 ]
done
sed "s/^\($use = ORIENTED_EDGE(.*,\)#[0-9]*,/\1\$,/" models/fillet.step >unnamed.step
"$program" verify unnamed.step --require G1 --allow-empty >out 2>err
holds [ $? -eq 1 ] && says out "$use ORIENTED_EDGE: it names no edge with a curve"
sed "s/^\(#[0-9]* = EDGE_LOOP('',(\)$use,/\1/" models/fillet.step >unused.step
"$program" verify unused.step --require G1 --allow-empty >out 2>err
holds [ $? -eq 1 ] && says out "$use ORIENTED_EDGE: nothing refers to it"
# units and the precision belong to the shape
without "$(sed -n 's/^\(#[0-9]*\) = ( *GEOMETRIC_REPRESENTATION_CONTEXT(3).*/\1/p' models/fillet.step | head -n 1)" models/fillet.step >context.step
run 1 verify context.step --require G1 && says out "not in the file, but #" "REPRESENTATION refers to it"
# what says nothing of the shape may be missing
for type in PRODUCT_RELATED_PRODUCT_CATEGORY APPLICATION_PROTOCOL_DEFINITION; do
  without "$(id $type models/fillet.step 1)" models/fillet.step >remark.step
  run 0 verify remark.step --require G1
done
# placements that mirror or scale, of which OpenCASCADE reads the motion only
cad=$here/../../conformance/data/cad operator=' CARTESIAN_TRANSFORMATION_OPERATOR_3D: what it places is read without'
for name in mapped-mirror-fillet part-mirror-fillet; do
  run 1 verify "$cad/$name.step" --require G1 && says out "$operator being mirrored"
done
for name in mapped-scaled apart-part-scaled; do run 1 verify "$cad/$name.step" --require G1 && says out "$operator the scale"; done
for name in mapped-turned part-turned-fillet; do run 0 verify "$cad/$name.step" --require G1; done
# ids in texts and comments are none
sed "s/ADVANCED_FACE(''/ADVANCED_FACE('#9999 = it''s #9998'/; s/^ENDSEC;/\/* #9997 = FACE(#9996); *\/\nENDSEC;/" models/fillet.step >remark.step
run 0 verify remark.step --require G1

# a closed shell with free edges is one finding
sed 's/^\(#[0-9]* = CLOSED_SHELL(.*,(\)#[0-9]*,/\1/' models/fillet.step >open.step
run 1 verify open.step --require G1
says out "not closed: $(id CLOSED_SHELL open.step 1) CLOSED_SHELL: said to be closed, but has 4 free edges" "not covered: 1 shell, it is said to be closed, and is not"
run 1 verify open.step --json && says out '"open_shells":1' && run 1 verify open.step --format sarif && says out 'said to be closed'
run 0 report open.step -o page.html && says page.html "said to be closed"
run 0 verify models/wall.brep --require G0 # an open one is not
awk '/^Sh/ { shell = 1 } shell && /\*/ { sub(/^[-+][0-9]+ 0 /, ""); shell = 0 } { print }' models/fillet.brep >open.brep
run 1 verify open.brep --require G1 && says out "not closed: shell 0: said to be closed, but has 4 free edges" " face: nothing in the model has it"
run 0 verify models/assembly.step --allow-uncovered && lacks out "closed, but"

# faces that lie side by side and share no edge are not covered, and the hint comes first
for file in flats.brep flats_apart.igs; do
  run 1 verify models/$file --require G1 --summary
  says out "2 knot lines inside of faces" "lies beside edge 5 of face 1, not compared: see --sew" "not covered: 2 edges, it lies beside another boundary edge"
  holds [ "$(grep -v '^edge' out | head -n 1)" = "2 boundary edges lie beside others and are not compared: --sew DISTANCE joins them" ]
  lacks out ", proved"
  run 0 verify models/$file --require G1 --sew 0.001 && says out "1 inner" && lacks out "beside"
  run 0 verify models/$file --require G1 --allow-uncovered
done
run 1 verify models/flats.brep --json && says out '"beside":2' '"reason":"lies beside edge 5 of face 1, not compared: see --sew"'
run 0 report models/flats.brep -o page.html && says page.html "2 boundary edges lie beside others"
run 2 verify models/fillet_apart.igs && says out "30 boundary edges lie beside others"
# real boundaries do not, nor both sides of a narrow face, edges that part slowly, and what is
# farther apart than the gap
for file in wall.brep kinks.brep bezier.brep fading.brep trimmed.brep three.brep sliver.brep wedge.brep; do
  run 0 verify models/$file --allow-empty --allow-uncovered && lacks out "beside"
done
run 2 verify models/apart.brep && lacks out "beside"
run 2 verify models/apart.brep --within 0.04,0.1deg && says out "2 boundary edges lie beside others"
run 2 verify models/apart.brep --within 0.06,0.1deg && says out "4 boundary edges lie beside others"

# sewing keeps closed circles, and mirrors of IGES are mirrors
run 2 verify models/washer_apart.igs && says out "28 boundary edges lie beside others"
for distance in 0.1 0.001 1e-5; do
  run 0 verify models/washer_apart.igs --sew $distance --require G1
  says out "8 inner, 6 seams, 0 boundary, 0 degenerate" "14 edges sewn" "0 G2, 14 G1, 0 G0" && lacks out "said to be a point"
done
run 0 verify models/washer.step --require G1 && says out "8 inner, 6 seams, 0 boundary, 0 degenerate" "0 G2, 14 G1, 0 G0"

# every entity, one at a time
holds python3 "$here/cad/delete_entities.py" "$program" models/cylinder.step models/fillet.igs models/fillet_apart.igs models/cone.brep models/cylinder.brep
