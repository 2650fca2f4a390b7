# The index by which search.js finds words of the manual: for each section of each page a line with
# its address, the titles of page and section, and its text. Usage: awk -f search_index.awk PAGE.html...
function plain(html) {
  gsub(/<[^>]*>/, " ", html)
  gsub(/&lt;/, "<", html); gsub(/&gt;/, ">", html); gsub(/&quot;/, "\"", html); gsub(/&#39;/, "'", html); gsub(/&#160;|&nbsp;|&#9670;/, " ", html); gsub(/&amp;/, "\\&", html)
  gsub(/\[[0-9]+\/[0-9]+\]|More\.\.\./, "", html) # numbers of overloads, and links to the section itself
  gsub(/[ \t]+/, " ", html); sub(/^ /, "", html); sub(/ $/, "", html)
  return html
}
function quoted(text) { gsub(/[\\"]/, "\\\\&", text); return "\"" text "\"" }
function finish() {
  if (section != "" || text != "") print "[" quoted(page anchor) ", " quoted(title) ", " quoted(section) ", " quoted(plain(text)) "],"
  text = section = anchor = ""
}
BEGIN { print "manualIndex([" }
FNR == 1 { finish(); page = FILENAME; title = ""; inside = heading = 0 }
/<div class="title">/ { title = $0; sub(/.*<div class="title">/, "", title); sub(/<div.*/, "", title); title = plain(title) }
/<div class="contents">/ { inside = 1 }
/<!-- contents -->/ { inside = 0 }
!inside { next }
/<h[1-4]><a class="anchor" id=|<h2 class="memtitle">/ {
  finish()
  anchor = $0
  sub(/.*<h[1-4]><a class="anchor" id="|.*<h2 class="memtitle"><span class="permalink"><a href="#/, "", anchor)
  sub(/".*/, "", anchor)
  anchor = "#" anchor
  heading = 1
}
heading { section = section " " $0; if (/<\/h[1-4]>/) { heading = 0; section = plain(section) }; next }
{ text = text " " $0 }
END { finish(); print "]);" }
