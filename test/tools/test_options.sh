#!/usr/bin/env bash
# Options that do not apply, and names that say another format, are refused with the name of the
# option.
. "$(dirname "$0")/functions.sh"

# version and help
run 0 --version && holds [ "$(grep -cE '^geometric_continuity [0-9]+\.[0-9]+\.[0-9]+$' out)" -eq 1 ]
for command in blend connect extend verify plot tessellate; do run 0 $command --help && says out "Exit code: 0 " "2" "on"; done

# verify
for option in "--kernel double" "--kernel exact" "--max-order 2" --closed; do
  refused "${option%% *}: not with --surfaces" verify --surfaces "$teapot" $option
done
for option in "--kernel exact" "--within 1,1,1" --surfaces --closed; do
  refused "${option%% *}: not for drawings" verify "$data/leaf_inkscape.svg" $option
done
for bad in 1,1,1, 1,,1 ,1,1,1 ,; do refused "--within: " verify --closed "$S" --within $bad; done
refused "--max-order: 33 is not from 0 to 32" verify --closed "$S" --max-order 33
refused "'--json' cannot be specified more than once" verify --closed "$S" --json --json
refused "'--require' cannot be specified more than once" verify --closed "$S" --require G1 --require G1

# what would have no effect
refused "--max-work: only with --kernel exact" tessellate "$teapot" -o - --format off --max-work 1
printf '0 0\n1 0\n2 1\n' >points.txt
refused "--max-work: only with --kernel exact" interpolate points.txt --kernel double --max-work 1
refused "--max-work: not with --corner or --corners" blend "$S" --corners all --distance 1 --max-work 1

# what is the default may be given, and changes nothing
same() { # same DEFAULTS ARGUMENTS...
  local defaults=$1 code=0
  shift
  "$program" "$@" >given 2>&1 || code=$?
  # shellcheck disable=SC2086
  run $code "$@" $defaults && cat out err | cmp -s - given || holds false
}
same "--max-order 3 --kernel exact --format text" verify "$S" --closed
same "--format text" verify --surfaces "$teapot" --require G1
same "--kernel exact --order 2 --strategy energy3" blend "$L" "$R"
same "--to G1 --kink-angle 5" repair "$S" --closed -o -
same "--worst 10000 --kink-angle 5" report "$S" --closed -o -

# plot
for option in --shaded --isophotes "--view junk"; do
  refused "${option%% *}: only with --surfaces" plot "$S" -o no.svg $option
done
for option in --alternatives --closed --no-polygon --no-comb "--columns 2"; do
  refused "${option%% *}: not with --surfaces" plot --surfaces "$teapot" -o no.svg $option
done
refused "--closed: not with --alternatives" plot "$data/planar.g2" --alternatives --closed -o no.svg
for bad in -5 0 1001; do refused "--columns: $bad is not from 1 to 1000" plot "$S" -o no.svg --columns $bad; done
for name in no.png no no.svg.gz no.g2; do refused "--output: $name: the picture is SVG" plot "$S" -o $name; done

# blend
for option in "--s1 1" "--s2 1" "--start 0,0,0" "--end 0,0,0"; do
  refused "${option%% *}: only with --strategy free" blend "$L" "$R" -o no.g2 $option
  refused "${option%% *}: only with --strategy free" blend "$L" "$R" -o no.g2 --strategy all $option
done
refused "--start: not with --order 2" blend "$L" "$R" --strategy free --s1 0 --s2 0 --start 0,0,0
refused "--s1: not with --order 3" blend "$L" "$R" --strategy free --order 3 --start 0,0,0 --end 0,0,0 --s1 0
refused "--start: " blend "$L" "$R" --strategy free --order 3 --start 0,,0 --end 0,0,0
refused "--title: only with --plot" blend "$L" "$R" --title x
for option in "--kernel exact" "--replace 1"; do
  refused "${option%% *}: not with --representable" blend "$L" "$R" --representable $option
done
refused "--replace 99: $S has 28 curves, number 0 to 27" blend "$S" --replace 99
refused "--replace 0: $L has 1 curve; at least 3 are needed" blend "$L" --replace 0
refused "--order: 4 is not from 2 to 3" blend "$L" "$R" --order 4

# names
for name in no.pdf no.OFF no.stl no.html; do
  refused "--output: $name: the format is .g2" blend "$L" "$R" -o $name
  refused "--output: $name: the format is .g2" extend "$L" --order tangent -o $name
done
# a name that says another format than the one that is written, of every command with an output;
# nothing is written
printf '0 0\n1 0\n2 1\n' >points.txt
for ending in ttf OTF woff2 pfb ttc ufo step gz; do
  lower=${ending,,}
  refused "--output: no.$ending: the format is .svg, not .$lower" repair "$data/leaf_inkscape.svg" -o no.$ending
  refused "--output: no.$ending: the format is .g2, not .$lower" repair "$S" --closed -o no.$ending
done
for name in no.ttf no.igs no.pdf no.html no.csv no.zip; do
  refused "--output: $name: the format is .g2, not" blend "$L" "$R" -o $name
  refused "--output: $name: the format is .g2, not" fit points.txt --tolerance 1 -o $name
  refused "--output: $name: the format is .g2, not" interpolate points.txt -o $name
  refused "--output: $name: the format is .g2, not" round-edges "$teapot" --set-back 1 -o $name
done
for name in no.pdf no.ttf no.svg; do refused "--output: $name: the page is HTML" report "$S" --closed -o $name; done
refused "--certificate: no.svg: the format is .txt, not .svg" verify "$S" --closed --certificate no.svg
echo "$S" >list.txt && refused "--output: no.svg: the format is .jsonl, not .svg" verify --jsonl list.txt -o no.svg
for name in kept.any kept; do run 0 blend "$L" "$R" -o $name; done # other names may be anything
refused "--output: the name is empty" blend "$L" "$R" -o ''
refused "--plot: no.g2: the picture is SVG" blend "$L" "$R" --plot no.g2
refused "both are written to -" blend "$L" "$R" -o - --plot -
echo old >both.svg && ln -s both.svg both.g2
refused "both are written to both.svg" blend "$L" "$R" -o both.g2 --plot both.svg
holds [ "$(cat both.svg)" = old ]
mkdir folder && ln -s missing.svg one.svg && ln -s ../missing.svg folder/two.g2 && ln -s folder/two.g2 three.g2 # nowhere yet
refused "both are written to one.svg" blend "$L" "$R" -o three.g2 --plot one.svg
refused "both are written to missing.svg" blend "$L" "$R" -o folder/two.g2 --plot missing.svg
rm -r folder one.svg three.g2
refused "--format off|ply|obj|stl is needed" tessellate "$teapot" -o -
refused "--format: not with no.ply" tessellate "$teapot" -o no.ply --format off
refused "is none of off, ply, obj, stl" tessellate "$teapot" -o - --format step
holds [ -z "$(ls no* 2>/dev/null)" ]

# messages name the file and the reason
refused "cannot_read_file: .: Is a directory" verify .
refused "cannot_read_file: missing.g2: No such file or directory" verify missing.g2
printf '' >empty.g2 && refused "empty.g2:1: no curve" verify empty.g2
printf '\xef\xbb\xbf' | cat - "$L" >mark.g2 && run 0 verify --closed mark.g2
printf '\xff\xfe1\0' >utf16.g2 && refused "utf16.g2:1: the text is UTF-16" verify utf16.g2
printf '1\0000\0000\000' >utf16.g2 && refused "utf16.g2:1: the text is UTF-16" verify utf16.g2
curve $'2 0\n2 2\n0 0 1 1\n0 0\n1e400 0' >far.g2 # too large for a picture: nothing is written
refused "not_finite: Svg_panel: " plot far.g2 -o no.svg
refused "not_finite: Svg_panel: " extend far.g2 --order tangent -o no.g2 --plot no.svg
refused "not_finite: Svg_panel: " blend far.g2 far.g2 -o no.g2 --plot no.svg
holds [ ! -e no.g2 -a ! -e no.svg ]
