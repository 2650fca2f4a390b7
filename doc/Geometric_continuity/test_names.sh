#!/usr/bin/env bash
# Checks the reference: every public name of the headers stands on a page and in a group, and no
# signature shows what is internal. Usage: test_names.sh DOC_FOLDER, in which the target doc has
# built the manual
set -eu
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report() { # RULE, places on standard input
  local places
  places=$(cat)
  [ -z "$places" ] || printf '%s\n%s\n\n' "$1" "$places" >>"$work/problems"
}

# All names, documented or not, as doxygen finds them; those of the manual; those of its groups.
(cat Doxyfile && printf '%s\n' EXTRACT_ALL=YES HIDE_UNDOC_CLASSES=NO WARNINGS=NO WARN_AS_ERROR=NO GENERATE_HTML=NO \
  "GENERATE_TAGFILE=$work/all.tag") | doxygen -
names() { # KINDS TAGFILE: classes, and the members of the namespace, or what a group contains
  sed -e 's/&lt;.*&gt;//' "$2" | awk -v kinds="$1" '
    /<compound kind=/ { kind = $2; gsub(/kind="|".*/, "", kind); wanted = match(kind, kinds); top = 1 }
    !wanted { next }
    kind ~ /class|struct/ && top && /<name>/ { top = 0; sub(/.*<name>/, ""); sub(/<.*/, ""); print; next }
    kind == "namespace" || kind == "group" {
      if (/<class /) { sub(/[^>]*>/, ""); sub(/<.*/, ""); print }
      if (/<member /) { getline; getline; sub(/.*<name>/, ""); sub(/<.*/, ""); print }
    }' | sed 's/^CGAL::Geometric_continuity:://' | grep -vE '^CGAL::|^(CGAL|std)$' | sort -u
}
names 'class|struct|namespace' "$work/all.tag" >"$work/all"
names 'class|struct|namespace' manual.tag >"$work/pages"
names group manual.tag >"$work/groups"
comm -23 "$work/all" "$work/pages" | report "A public name stands on a page (a comment with three strokes, or a place in internal/):"
grep -v :: "$work/pages" | comm -23 - "$work/groups" | report "A public name stands in a group (\\ingroup):"

# Pages call these names: `name()`, `Class::name()`. How_a_decision_is_made.txt follows calls
# through internal functions.
texts=$(sed -n 's/^ *"\(.*\/doc\/Geometric_continuity\)" .*/\1/p' Doxyfile)
module=$texts/../../browser/module/geometric_continuity.d.ts # the functions of JavaScript
{
  sed -n 's/.*<name>\(.*\)<\/name>.*/\1/p' manual.tag | sed 's/.*:://'
  [ ! -e "$module" ] || sed -n 's/^ *\([A-Za-z]*\)(.*/\1/p' "$module"
} | sort -u >"$work/members"
find "$texts" -name '*.txt' ! -name How_a_decision_is_made.txt -exec grep -ohE '`[A-Za-z_:]+\(\)`' {} + |
  sed -e 's/[`()]//g' -e '/^std::\|^CGAL::to_\|^CGAL::sqrt\|what$/d' -e 's/.*:://' | sort -u |
  comm -23 - "$work/members" | report "The manual names functions that exist:"

sed -n 's/^@[a-z]*{\(.*\),/\1/p' "$texts/geometric_continuity.bib" | while read -r key; do
  grep -qF "cgalCite{$key}" "$texts"/*.txt || echo "$key"
done | report "A reference is cited:"

# The pages of the reference as a reader sees them; those of sources and examples show code.
for page in html/class*.html html/struct*.html html/group*.html html/namespace*.html html/*_8h.html; do
  sed -e 's/<[^>]*>//g' "$page" | grep -oE '.{0,40}(internal::|CGAL_G(C|EOMETRIC_CONTINUITY)_[A-Z]).{0,40}' | sed "s|^|$page: |" || true
done | report "No signature shows what is internal (see signatures.sed):"

[ ! -e "$work/problems" ] || cat "$work/problems"
echo "$(wc -l <"$work/all") public names"
[ ! -e "$work/problems" ] && [ "$(wc -l <"$work/all")" -gt 400 ]
