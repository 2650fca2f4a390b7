# The page of the references from a file of BibTeX, one field a line, for a doxygen without BibTeX.
# Usage: awk -f bibliography.awk FILE.bib
function add(before, what, after) { return what == "" ? "" : before what after }
function entry() {
  where = f["journal"] f["booktitle"]
  printf "- \\anchor cite_%s <b>[%s]</b>%s%s%s%s%s.\n", key, key, add(" ", f["author"], "."),
    add(where f["publisher"] == "" ? " <em>" : " ", f["title"], where f["publisher"] == "" ? "</em>." : "."),
    add(" <em>", where, "</em>") add(" ", f["volume"], "") add("(", f["number"], ")") add(where == "" ? "" : ", ", f["pages"], "") \
      add(where == "" ? " " : ", ", f["publisher"], ""),
    add(where f["publisher"] == "" ? " " : ", ", f["year"], ""), add(f["year"] == "" ? " " : ". ", f["note"], "")
}
BEGIN { print "/*!\n\\page citelist Bibliography\n" }
/^@/ { key = $0; gsub(/^@[a-z]*\{|,.*/, "", key); split("", f) }
/^  [a-z]* = / { value = $0; sub(/^[^{]*\{/, "", value); sub(/\},?$/, "", value); gsub(/--/, "–", value); f[$1] = value }
/^}/ { entry() }
END { print "*/" }
