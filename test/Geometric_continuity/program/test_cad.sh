#!/usr/bin/env bash
# CAD models: what is read of STEP, IGES and BREP, the kinds of edges, the verdicts, reports, and damaged files.
. "$(dirname "$0")/functions.sh"

# Without the module the program says what is missing, and how to get it; it finds the module next to itself.
printf 'ISO-10303-21;\n' >any.step
cp "$program" alone
"$PWD/alone" verify any.step >out 2>err
holds [ $? -eq 2 ] && says err "any.step: STEP, IGES and BREP are read by an optional part of this program" "libocct-data-exchange-dev"
if [ -z "${MAKE_CAD_MODELS-}" ]; then
  echo "skipped: built without OpenCASCADE"
  exit 77
fi
mkdir models && (cd models && "$MAKE_CAD_MODELS") || exit 1
holds "$CHECK_CAD_CONVERSION" models/*

# kinds COUNTS FILE...: the kinds of edges of each file
kinds() {
  local counts=$1 file
  shift
  for file in "$@"; do run 0 verify "models/$file" --allow-empty && says out "$counts"; done
}
kinds "7 faces; edges: 15 inner, 0 seams, 0 boundary, 0 degenerate, 0 non-manifold" fillet.brep fillet.step fillet.igs
kinds "14 faces; edges: 30 inner, 0 seams, 0 boundary, 0 degenerate, 0 non-manifold" moved.brep
kinds "3 faces; edges: 2 inner, 1 seams, 0 boundary, 0 degenerate, 0 non-manifold" cylinder.brep cylinder.step prism.brep prism.step
kinds "2 faces; edges: 1 inner, 1 seams, 0 boundary, 1 degenerate, 0 non-manifold" sphere.brep cone.brep
kinds "2 faces; edges: 1 inner, 1 seams, 0 boundary, 0 degenerate, 0 non-manifold" sphere.step cone.step
kinds "1 face; edges: 0 inner, 2 seams, 0 boundary, 0 degenerate, 0 non-manifold" torus.brep torus.step periodic.brep revolution.brep offset.brep
kinds "3 faces; edges: 2 inner, 0 seams, 8 boundary, 0 degenerate, 0 non-manifold" wall.brep
kinds "3 faces; edges: 0 inner, 0 seams, 9 boundary, 0 degenerate, 1 non-manifold" three.brep
kinds "1 face; edges: 0 inner, 0 seams, 4 boundary, 0 degenerate, 0 non-manifold" bezier.brep
kinds "0 faces; edges: 0 inner, 0 seams, 0 boundary, 0 degenerate, 0 non-manifold" wire.brep
run 2 verify models/wire.brep && says err "there is no edge of two sides" "--allow-empty"
run 2 verify models/bezier.brep --require G1 && says err "there is no edge of two sides"

# what cannot be compared is named, is undecided, and does not meet a requirement
run 0 verify models/differing.brep && says out "curves of different parameters" "1 edge not covered, hence undecided"
run 1 verify models/differing.brep --require G0 && says out "1 of them not G0 within the tolerance"
run 0 verify models/three.brep --allow-empty && run 1 verify models/three.brep --allow-empty --strict
says out "not met, because not all was verified"

# options and names
cp models/fillet.step UPPER.STP
run 0 verify UPPER.STP && says out "7 faces"
run 2 verify models/fillet.step $S && says err "cannot be read together"
for option in --surfaces --closed --kernel=double --max-order=2 --max-work=5 --worst=3; do
  run 2 verify models/fillet.step $option
done
run 2 verify models/fillet.step --require C1 && says err "of CAD models G0, G1 and G2 are decided"
run 2 verify models/fillet.step --require G3 && run 2 verify models/fillet.step --require F1
run 2 verify models/fillet.step --require G2 && says err "--require G2: needs more bounds than --within vda-4955"
run 2 verify models/fillet.step --require G1 --within 0.1 && says err "needs more bounds"
run 2 verify models/fillet.step --within 0.01,0.1deg,1%,0.1 && says err "GAP,ANGLEdeg,CURVATURE%"
run 2 verify models/fillet.step --within 0.01,0.1 && run 2 verify models/fillet.step --within class-x

# damaged files: an error with the reason
size=$(wc -c <models/fillet.step)
for part in 1 20 50 90 99; do
  head -c $((size * part / 100)) models/fillet.step >cut.step
  run 2 verify cut.step && says err "cut.step: not a complete STEP file" && holds [ ! -s out ]
done
size=$(wc -c <models/fillet.brep)
for part in 1 20 50 90; do
  head -c $((size * part / 100)) models/fillet.brep >cut.brep
  run 2 verify cut.brep && says err "cut.brep: "
done
size=$(wc -c <models/fillet.igs)
for part in 1 20; do
  head -c $((size * part / 100)) models/fillet.igs >cut.igs
  run 2 verify cut.igs && says err "cut.igs: "
done
awk 'BEGIN { srand(1); for (i = 0; i < 5000; ++i) printf "%c", 1 + int(255 * rand()) }' >junk
for extension in step stp iges igs brep brp; do
  cp junk "junk.$extension" && run 2 verify "junk.$extension" && says err "junk.$extension: "
  : >"empty.$extension" && run 2 verify "empty.$extension" && says err "empty.$extension: "
  run 2 verify "none.$extension" && says err "none.$extension: No such file"
done
