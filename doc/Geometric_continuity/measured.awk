# Doxygen reads the output of this in place of the pages Performance and In the Browser: a line
# "\measured{PROGRAM}" becomes the table of measured/PROGRAM.txt, which the script
# benchmark/Geometric_continuity/measure writes: WORK | METHOD, least and largest time, unit, least
# and largest ratio to the first method of the same work. "\measured{PROGRAM,START}" has the works
# whose names start so. Usage: awk -v folder=... -f measured.awk PAGE
function digits(x) { return x < 1e3 ? sprintf("%.3g", x) : sprintf("%.0f", x) }
function range(low, high,  a, b) { a = digits(low); b = digits(high); return a == b ? a : a " to " b }
function time(low, high, unit) {
  if (unit == "s" && high < 1) { low *= 1e3; high *= 1e3; unit = "ms" }
  if (unit == "ns" && high >= 1e3) { low /= 1e3; high /= 1e3; unit = "µs" }
  if (unit == "µs" && high >= 1e3) { low /= 1e3; high /= 1e3; unit = "ms" }
  return range(low, high) " " unit
}
function cell(text) { gsub(/</, "\\&lt;", text); gsub(/[|]/, "\\&#124;", text); return text }
function table(program, start,  file, line, f, work, last, rows, cut) {
  file = folder "/" program ".txt"
  while ((getline line < file) > 0) {
    if (line ~ /^# /) { printf "%s.\n\n| Work | Method | Time | Times the first |\n| :--- | :----- | ---: | ---: |\n", cell(substr(line, 3)); continue }
    split(line, f, "\t")
    cut = match(f[1], / \| [^|]*$/)
    work = substr(f[1], 1, cut - 1)
    if (substr(work, 1, length(start)) != start) continue
    printf "| %s | %s | %s | %s |\n", work == last ? "" : cell(work), cell(substr(f[1], cut + 3)), time(f[2], f[3], f[4]), range(f[5], f[6])
    last = work
    ++rows
  }
  if (!rows) print "Not measured yet: `" program "`."
}
/^\\measured\{/ {
  sub(/^\\measured\{/, ""); sub(/\}.*/, "")
  comma = index($0, ",")
  table(comma ? substr($0, 1, comma - 1) : $0, comma ? substr($0, comma + 1) : "")
  next
}
{ print }
