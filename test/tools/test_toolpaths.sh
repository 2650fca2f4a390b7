#!/usr/bin/env bash
# verify and report of programs in G-code: the joins of lines, arcs and splines in a plane, and what
# is not covered.
. "$(dirname "$0")/functions.sh"

# joins CODE LINES TEXT...: a program whose output says each text
joins() {
  local code=$1 lines=$2
  shift 2
  printf '%s\n' "$lines" >program.ngc && run "$code" verify program.ngc --allow-empty && says out "$@"
}
start=$'G21 G90 G17\nG0 X0 Y0'

# tangent arcs on the left and on the right, by centre and by radius, half and whole circles
joins 0 "$start"$'\nG1 X10\nG3 X12 Y2 I0 J2\nG1 Y9\nG2 X14 Y11 R2\nG2 X16 Y9 I0 J-2' \
  "lines 3 G1 - 4 G3 at (10, 0): G1, curvature jumps from 0 to 0.5" "lines 4 G3 - 5 G1 at (12, 2): G1" "lines 5 G1 - 6 G2 at (12, 9): G1" \
  "lines 6 G2 - 7 G2 at (14, 11): G3 or more" "4 joins in 1 subpath"
joins 0 "$start"$'\nG2 X4 Y0 I2\nG2 X0 Y0 I-2\nG0 X9\nG3 I3' "4 joins in 2 subpaths: 4 G3 or more"
joins 0 "$start"$'\nG1 X4\nG3 X4 Y6 R-3\nG3 X4 Y0 R3' "lines 3 G1 - 4 G3 at (4, 0): G1" "lines 4 G3 - 5 G3 at (4, 6): G3 or more"
# a centre that is rounded: the arc leads to its end, about the nearest point of the bisector
joins 0 "$start"$'\nG1 X10\nG3 X12.0002 Y2 I0 J2\nG1 Y9' "G0, kink of 0.00286" "G0, kink of 0.00286"
joins 1 "$start"$'\nG1 X10\nG3 X12.1 Y2 I0 J2\nG1 Y9' "line 4): not verified, the ends of the arc are not equally far from its centre"
joins 1 "$start"$'\nG3 X12 Y0 R5.9\nG3 X14 Y0\nG2 X14 Y0 R1' "the radius of the arc is less than half" "the arc has no radius and no centre" \
  "the arc has a radius, and ends where it starts"
# relative moves, centres that are absolute, inches, lathes
joins 0 $'G21 G91\nG0 X1 Y1\nG90 G0 X0 Y0\nG91 G1 X10\nG3 X2 Y2 J2\nG90 G90.1 G3 X10 Y4 I10 J2' "lines 4 G1 - 5 G3 at (10, 0): G1" "lines 5 G3 - 6 G3 at (12, 2): G3"
joins 0 $'G20 G0 X0 Y0\nG1 X1\nG21 G1 X50.8\nG3 X50.8 Y25.4 J12.7' "lines 2 G1 - 3 G1 at (1, 0): G3 or more" "lines 3 G1 - 4 G3 at (2, 0): G1"
joins 0 $'G18 G7\nG0 X20 Z0\nG1 Z-5\nG2 X24 Z-7 K0 I2' "lines 3 G1 - 4 G2 at (-5, 10): G1"
joins 0 $'G19 G0 Y0 Z0\nG1 Y5\nG3 Y7 Z2 J0 K2' "at (5, 0): G1"
# splines, with the mirrored handle, and quadratics
joins 0 "$start"$'\nG5 I0 J4 P0 Q-4 X2 Y2\nG5 P0 Q-4 X4 Y4\nG5.1 I0 J4 X6 Y9' "lines 3 G5 - 4 G5 at (2, 2): G1" "lines 4 G5 - 5 G5 at (4, 4): G1"
# comments, blanks, small letters, numbers of lines and programs, what has no effect, the end
joins 0 $'%\nO1000\n(G1 X5)\nn10 g0x0 y0 ; G1 X7\nN20 G1 X 1 . 5 F100 S3 M3\nN30Y2T1*71\nM117 Hello: 100 %\nG64 P0.1\nM2\nG1 X1' "1 join in 1 subpath: 1 G0" \
  "lines 5 G1 - 6 G1 at (1.5, 0): G0, corner of 90"
# a subpath ends at rapid moves, at moves down, and where nothing is extruded; one that ends at its
# start is closed
joins 0 "$start"$'\nG1 X1\nG1 Y1\nG1 Z-1\nG1 X2\nG0 X5\nG1 Y3\nY0\nX0\nG0 X9' "3 joins in 3 subpaths"
joins 0 "$start"$'\nG1 X1 E1\nG1 Y1 E2\nG1 X5\nG1 Y5 E3\nG92 E0\nG1 X0 E1' "1 join in 3 subpaths"
joins 0 "$start"$'\nG1 X1\nY1\nX0\nY0\nG0 Z1' "4 joins in 1 subpath"

# what is not covered, with its lines
joins 1 $'G0 X0\nG1 X5\nG1 X6 Y0\nG1 X7\nY3' "toolpath (line 2): not verified, where the move starts or ends is not told by the program (up to line 3)" "1 join in 1"
joins 1 "$start"$' Z0\nG1 X5\nG1 X6 Z-1\nX7 Z-2\nX8' "not verified, it moves along three axes at once, and joins are decided in a plane (up to line 5)"
joins 1 "$start"$'\n#1=5 (five)\nG1 X#1\nG1 X[#1+1] Y#<depth>\nG1 X-SIN[30]\nX1 Y1\nX2' "line 4): not verified, a coordinate is given by a parameter or an expression" "0 joins"
joins 1 "$start"$'\nG1 X1\no100 call [3]\nG1 X2\nY2' "line 4): not verified, subprograms, loops and conditions are not followed"
joins 1 "$start"$'\nG1 X1\nM98 P1\nG1 X2' "subprograms are not followed"
joins 1 "$start"$'\n/G1 X1\nG1 X2 Y2\nG1 A90\nG33 Z-5 K1\nG28\nG1 X3\nG123 X4' "an optional line" "rotary" "G33 is not a move that is verified" "G123 is not known"
joins 1 "$start"$'\nG1 X1\nG1 X (2\nG1 X1.2.3\nX!\nG1X2\n' "a comment without an end" "not a number: '1.2.3'" "the letter X without a number"
joins 1 $'G21\nX5' "a position without a move before it" && joins 0 $'G28\nM104 S200\nG80' "0 joins"

# in the formats of reports, with the line of the move; a page; standard input
printf '%s\nG1 X10\nG1 X20 Y0.5\n' "$start" >kink.nc
run 1 verify kink.nc --require G1 --format sarif && says out '"startLine":4'
run 0 verify kink.nc --json && says out '"left_command":3,"left_letter":"G1","right_command":4,"right_letter":"G1"'
run 0 report kink.nc -o kink.html && says kink.html "lines 3 G1 - 4 G1"
"$program" verify - <kink.nc >out 2>err && says out "kink of 2.86"
run 2 repair kink.nc -o no.nc && says err "a toolpath: verify and report read it; repair reads"
run 2 verify kink.nc --closed && says err "not for drawings and toolpaths"
run 2 verify kink.nc "$S" && says err "cannot be verified together"
run 2 verify kink.nc --certificate out.txt && says err "not for toolpaths"
