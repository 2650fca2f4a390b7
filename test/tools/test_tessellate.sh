#!/usr/bin/env bash
# tessellate: triangles in every format.
. "$(dirname "$0")/functions.sh"

flat "$flat_points" >flat.g2
run 0 tessellate "$teapot" --tolerance 0.1 -o teapot.off && says out "978 points, 1888 triangles" "64 on the boundary"
says teapot.off "978 1888 0"
run 0 tessellate "$teapot" --tolerance 1/10 --kernel exact -o exact.off && says out "978 points, 1888 triangles"
for format in ply obj stl; do run 0 tessellate "$teapot" --grid 2 -o "teapot.$format"; done
says teapot.ply "element face 240" && says teapot.stl "endsolid" && holds [ "$(grep -c '^f ' teapot.obj)" -eq 240 ]
run 0 tessellate flat.g2 -o flat.off && says out "1 surface"
run 2 tessellate "$teapot" -o no.vtk && says err ".off, .obj, .ply or .stl"
for bad in 0 -1 nan 1e-12 x; do run 2 tessellate "$teapot" --tolerance "$bad" -o no.off; done
for bad in 0 -3 100000 x; do run 2 tessellate "$teapot" --grid "$bad" -o no.off; done
run 2 tessellate "$teapot" --grid 2 --tolerance 1 -o no.off && run 2 tessellate "$teapot" && run 2 tessellate -o no.off
run 2 tessellate "$L" -o no.off && says err "space_left.g2:1"
holds [ ! -e no.off -a ! -e no.vtk ]
