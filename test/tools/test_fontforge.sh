#!/usr/bin/env bash
# The moves that repair writes for a font, applied by FontForge: what is generated has no kinks
# where none are left. Skipped without it.
script=$(realpath "$(dirname "$0")/../../tools/fontforge/apply_moves.py")
command -v fontforge >/dev/null && fontforge -lang=py -c 'import fontforge' >/dev/null 2>&1 || exit 77
. "$(dirname "$0")/functions.sh"

apply() { fontforge -script "$script" "$@" >applied 2>&1; }
# mends ENDING: nothing is left of what repair finds in the font given.ENDING
mends() {
  run 0 repair "given.$1" -o moves.json && holds apply "given.$1" moves.json "mended.$1"
  run 0 verify "mended.$1" --require G1 && says out "0 kinks"
}

font given.ttf <<'END'
glyph .notdef
glyph base 65
contour 0,0 100,0 200,3* 300,300 0,300
glyph composed 66
component 1 400 0
component 1 900 50
END
run 1 verify given.ttf --require G1
run 0 repair given.ttf -o moves.json && says out "1 consist of components" "every join is free of kinks, proved exactly"
says moves.json '{"glyph":"base","index":1,"used_by":["composed"],"contour":0,"point":2,"node":[100,0],"from":[200,3],"to":[200,0]}'
holds [ "$(grep -c '"glyph"' moves.json)" = 1 ]
holds apply given.ttf moves.json mended.ttf && says applied "1 handles of 1 glyphs are moved"
run 0 verify mended.ttf --require G1 && says out "0 kinks"
# without the list the script calls the program
GEOMETRIC_CONTINUITY_PROGRAM=$program holds apply given.ttf called.ttf && says applied "1 handles of 1 glyphs are moved"
run 0 verify called.ttf --require G1 && says out "0 kinks"
# another font than the one that was repaired is left alone
apply mended.ttf moves.json again.ttf && holds false
says applied "there is no handle at" && holds [ ! -e again.ttf ]

# cubic curves, and names that the font does not have
font given.otf -v outlines=cff <<'END'
glyph .notdef
glyph curve 65
contour 0,0 100,0 150,3* 260,100* 300,300 0,300
END
run 1 verify given.otf --require G1
mends otf

# handles of two nodes at one place, and a contour that is there twice: each move names its node and
# its contour
font given.otf -v outlines=cff <<'END'
glyph .notdef
glyph twins 65
contour 0,0 100,0 200,3* 200,3* 300,300 0,300
contour 0,0 100,0 200,3* 200,3* 300,300 0,300
END
run 1 verify given.otf --require G1 && says out "2 kinks"
mends otf && says applied "2 handles of 1 glyphs are moved"
says moves.json '"contour":1,"point":2,"node":[100,0],"from":[200,3],"to":[200,0]}'
# of two handles in one contour the number of the point tells which one moves; contours that are a
# single point do not count
font given.ttf <<'END'
glyph .notdef
glyph twice 65
contour 7,7
contour 100,-100 100,0 200,3* 300,300 0,300 0,0 100,0 200,3* 300,300 50,400
END
mends ttf
# FontForge counts in the other direction: each move has a handle of its own
font given.otf -v outlines=cff <<'END'
glyph .notdef
glyph twice 65
contour 0,0 100,0 150,3* 260,100* 300,300 300,400 300,500 300,600 0,600 0,0 100,0 150,3* 260,100* 300,300 300,400 300,500 300,600 0,600
END
mends otf
# glyphs with the same name are told apart by their numbers
font given.ttf <<'END'
glyph .notdef
glyph same 65
contour 0,0 100,0 200,3* 300,300 0,300
glyph same 66
contour 0,0 100,0 200,4* 300,300 0,300
END
mends ttf && says applied "2 handles of 2 glyphs"
# moves name the points of the table, wherever a glyph is drawn because of its left side bearing
font given.ttf -v bearing=5 <<'END'
glyph .notdef
glyph drawn 65
contour 0,0 100,0 200,3* 300,300 0,300
END
mends ttf && says moves.json '"node":[100,0],"from":[200,3],"to":[200,0]}'

# where a move puts a node in the middle of its handles, TrueType may leave it out: repairing again
# changes nothing
font given.ttf <<'END'
glyph .notdef
glyph middle 65
contour 727,1333 776,1583* 622,1583 463,1583* 421,1363 367,1083* 524,1082 681,1083*
END
run 0 repair given.ttf -o moves.json && holds apply given.ttf moves.json mended.ttf
run 0 repair mended.ttf -o moves.json && says out "1 off by rounding" && says moves.json '{"moves":[],'
