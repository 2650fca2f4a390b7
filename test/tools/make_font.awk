# Writes a font as octal escapes for printf, from lines that describe its glyphs:
#   glyph NAME [CODE]     begins a glyph, the first one number 0, with the code of its character
#   contour X,Y ...       a closed contour; behind a point, * says that it is a control point
#   component N X Y [S]   glyph number N, moved, and scaled by S
# Variables: em, the units per em, 1000 if not given; outlines=cff for cubic curves; container=ttc
# for a collection of the font twice, container=woff; bearing, a left side bearing of all glyphs
# that is to be where x is 0; family and style; names=no to leave out the names of the glyphs.
function byte(x) { out = out sprintf("\\%03o", x % 256) }
function u16(x) { if (x < 0) x += 65536; byte(int(x / 256)); byte(x) }
function u32(x) { u16(int(x / 65536)); u16(x % 65536) }
function text(s, i) { for (i = 1; i <= length(s); ++i) byte(index(ascii, substr(s, i, 1)) + 31) }
function size() { return length(out) / 4 }
function pad() { while (size() % 4 != 0) byte(0) }
function begin_table() { out = "" }
function end_table(tag) { # tables in the order of their tags
  tag_of[tables] = tag; length_of[tables] = size(); pad(); bytes_of[tables++] = out
}
BEGIN {
  ascii = " !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~"
  tables = glyphs = 0
  if (em == "") em = 1000
  if (family == "") family = "Test"
  if (style == "") style = "Regular"
}
/^glyph/ { name[glyphs] = $2; code[glyphs++] = $3 }
/^contour/ { # points behind points
  g = glyphs - 1
  n = points[g] + 0
  for (i = 2; i <= NF; ++i) {
    split($i, xy, ",")
    on[g, n] = xy[2] !~ /\*/
    px[g, n] = xy[1] + 0
    py[g, n++] = xy[2] + 0
  }
  points[g] = n
  last[g, contours[g] + 0] = n - 1
  ++contours[g]
}
/^component/ { g = glyphs - 1; components[g, count[g] + 0] = $0; ++count[g] }

function simple_glyph(g, i) {
  u16(contours[g]); for (i = 0; i < 4; ++i) u16(0)
  for (i = 0; i < contours[g]; ++i) u16(last[g, i])
  u16(0)
  for (i = 0; i < points[g]; ++i) byte(on[g, i])
  for (i = 0; i < points[g]; ++i) u16(px[g, i] - (i == 0 ? 0 : px[g, i - 1]))
  for (i = 0; i < points[g]; ++i) u16(py[g, i] - (i == 0 ? 0 : py[g, i - 1]))
}
function composite_glyph(g, i, part) {
  u16(-1); for (i = 0; i < 4; ++i) u16(0)
  for (i = 0; i < count[g]; ++i) {
    split(components[g, i], part, " ")
    u16(1 + 2 + (part[5] != "" ? 8 : 0) + (i + 1 < count[g] ? 32 : 0)) # words, offsets, a scale, more components
    u16(part[2]); u16(part[3]); u16(part[4])
    if (part[5] != "") u16(int(part[5] * 16384))
  }
}
function number(x) { # of a charstring
  if (x == int(x)) { byte(28); u16(x) } else { byte(255); u32(x < 0 ? x * 65536 + 4294967296 : x * 65536) }
}
function offset(x) { byte(29); u32(x) } # of a dictionary
function charstring(g, c, i, j, k, n, x, y) {
  begin_table()
  for (c = i = 0; c < contours[g]; ++c) {
    n = last[g, c] - i + 1
    number(px[g, i] - x); number(py[g, i] - y); byte(21) # rmoveto
    x = px[g, i]; y = py[g, i]
    for (j = 1; j < n; j += k) {
      k = on[g, i + j] ? 1 : 3
      for (m = 0; m < k; ++m) {
        q = j + m < n ? i + j + m : i
        number(px[g, q] - x); number(py[g, q] - y)
        x = px[g, q]; y = py[g, q]
      }
      byte(k == 1 ? 5 : 8) # rlineto, rrcurveto
    }
    i = last[g, c] + 1
  }
  byte(14) # endchar
  return out
}
function index_of(n, items, i, at) { # an INDEX of the texts
  u16(n); if (n == 0) return
  byte(4); at = 1
  u32(at); for (i = 0; i < n; ++i) u32(at += length(items[i]) / 4)
  for (i = 0; i < n; ++i) out = out items[i]
}
function cff(g, i, start, charset, strings) {
  for (g = 0; g < glyphs; ++g) chars[g] = charstring(g)
  for (g = 1; g < glyphs; ++g) { begin_table(); text(name[g]); texts[g - 1] = out }
  begin_table(); text(family); names_of_font[0] = out
  # header, names 7 + 4 + n, dictionary 11 + 24
  start = 4 + 11 + length(family) + 11 + 23
  strings = glyphs == 1 ? 2 : 3 + 4 * glyphs
  for (g = 1; g < glyphs; ++g) strings += length(name[g])
  charset = start + strings + 2
  begin_table(); offset(charset); byte(15); offset(charset + 1 + 2 * (glyphs - 1)); byte(17); offset(0); offset(charset); byte(18)
  dictionary[0] = out
  begin_table(); byte(1); byte(0); byte(4); byte(4)
  index_of(1, names_of_font); index_of(1, dictionary); index_of(glyphs - 1, texts); u16(0)
  byte(0); for (g = 1; g < glyphs; ++g) u16(390 + g)
  index_of(glyphs, chars)
}
function glyf_and_loca(g) {
  begin_table()
  for (g = 0; g < glyphs; ++g) {
    at[g] = size()
    if (count[g]) composite_glyph(g); else if (contours[g]) simple_glyph(g)
    pad()
  }
  at[glyphs] = size(); end_table("glyf")
}
function name_record(id, s, i) { u16(3); u16(1); u16(1033); u16(id); u16(2 * length(s)); u16(names_at); names_at += 2 * length(s) }
function wide(s, i) { for (i = 1; i <= length(s); ++i) { byte(0); text(substr(s, i, 1)) } }
END {
  if (outlines == "cff") { cff(); end_table("CFF ") }
  begin_table(); u16(0); u16(1); u16(3); u16(10); u32(12) # cmap
  for (g = 0; g < glyphs; ++g) if (code[g] != "") ++coded
  u16(12); u16(0); u32(16 + 12 * coded); u32(0); u32(coded)
  for (g = 0; g < glyphs; ++g) if (code[g] != "") { u32(code[g]); u32(code[g]); u32(g) } # codes grow
  end_table("cmap")
  if (outlines != "cff") glyf_and_loca()
  begin_table(); u32(65536); u32(65536); u32(0); u32(1594834165); u16(bearing == "" ? 0 : 2); u16(em) # head, with its magic number
  u32(0); u32(0); u32(0); u32(0); for (i = 0; i < 4; ++i) u16(0); u16(0); u16(8); u16(2); u16(1); u16(0); end_table("head")
  begin_table(); u32(65536); u16(em); u16(0); u16(0); u16(em); for (i = 0; i < 11; ++i) u16(0); u16(1); end_table("hhea")
  begin_table(); u16(em); for (g = 0; g < glyphs; ++g) u16(bearing + 0); end_table("hmtx")
  if (outlines != "cff") { begin_table(); for (g = 0; g <= glyphs; ++g) u32(at[g]); end_table("loca") }
  begin_table(); u32(outlines == "cff" ? 20480 : 65536); u16(glyphs) # maxp
  if (outlines != "cff") { u16(100); u16(20); u16(100); u16(20); u16(2); for (i = 0; i < 6; ++i) u16(0); u16(10); u16(5) }
  end_table("maxp")
  begin_table(); u16(0); u16(2); u16(30); name_record(1, family); name_record(2, style); wide(family); wide(style); end_table("name")
  begin_table(); u32(names == "no" || outlines == "cff" ? 196608 : 131072); for (i = 0; i < 7; ++i) u32(0) # post
  if (names != "no" && outlines != "cff") {
    u16(glyphs); for (g = 0; g < glyphs; ++g) u16(258 + g)
    for (g = 0; g < glyphs; ++g) { byte(length(name[g])); text(name[g]) }
  }
  end_table("post")

  flavour = outlines == "cff" ? 1330926671 : 65536
  header = container == "woff" ? 44 + 20 * tables : container == "ttc" ? 20 + 2 * (12 + 16 * tables) : 12 + 16 * tables
  total = header; for (t = 0; t < tables; ++t) total += length(bytes_of[t]) / 4
  begin_table()
  if (container == "woff") {
    text("wOFF"); u32(flavour); u32(total); u16(tables); u16(0); u32(total - header + 12 + 16 * tables)
    u16(1); for (i = 0; i < 11; ++i) u16(0)
    position = header
    for (t = 0; t < tables; ++t) {
      text(tag_of[t]); u32(position); u32(length_of[t]); u32(length_of[t]); u32(0); position += length(bytes_of[t]) / 4
    }
  } else {
    fonts = 1
    if (container == "ttc") { fonts = 2; text("ttcf"); u32(65536); u32(fonts); u32(20); u32(20 + 12 + 16 * tables) }
    for (f = 0; f < fonts; ++f) {
      u32(flavour); u16(tables); u16(0); u16(0); u16(0); position = header
      for (t = 0; t < tables; ++t) {
        text(tag_of[t]); u32(0); u32(position); u32(length_of[t]); position += length(bytes_of[t]) / 4
      }
    }
  }
  for (t = 0; t < tables; ++t) out = out bytes_of[t]
  print out
}
