#!/usr/bin/env bash
# The numbers of joins of fonts, and of kinks that are mended, on the page "Letters, Drawings and
# Reports" are those of the packages that it names.
page=$(cd "$(dirname "$0")/../../doc/Geometric_continuity" && pwd)/Letters_and_reports.txt
. "$(dirname "$0")/functions.sh"

dpkg -L fonts-dejavu-core fonts-lmodern fonts-noto-core >files 2>err || {
  echo "skipped, without the packages of fonts"
  trap - EXIT
  exit 77
}
grep -E '\.(ttf|otf|pfb|ttc)$' files | xargs "$program" verify --summary --allow-undecided --allow-uncovered >out 2>err
tail -n 1 out >total
number() { # number NAME: as the table has it
  sed -n "s/^| $1 | \([0-9 ]*\) |\$/\1/p" "$page" | tr -d ' '
}
tr -s ' \n' '  ' <"$page" >text # its sentences, wherever lines break
sentence=$(sed -n 's/.* The \([0-9]*\) fonts of the packages .* have \([0-9 ]*\) glyphs\. .*/\1 \2/p' text)
glyphs=${sentence#* }
says total "${sentence%% *} fonts, ${glyphs// /} glyphs" "$(number joins) joins: $(number corners) corners, $(number kinks) kinks," \
  "$(number "bends of two lines") bends of two lines, $(number rounding) off by rounding, $(number G1) G1, $(number "G2 or more") G2 or more"

mended() { # FONT: kinks, as verify counts them, and how many the moves mend
  "$program" repair "$(grep "/$1.otf$" files)" -o moves.json 2>err | sed -n 's/^kinks: \([0-9]*\) before, \([0-9]*\) after the moves$/\1 \2/p' |
    awk '{ print $1, $1 - $2 }'
}
read -r kinks gone < <(mended lmroman10-regular)
read -r kinks_of_sans gone_of_sans < <(mended lmsans12-regular)
says text "The moves mend $gone of the $kinks kinks of Latin Modern Roman 10," \
  "and $gone_of_sans of the $kinks_of_sans kinks of Latin Modern Sans 12."
