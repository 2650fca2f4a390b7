#!/usr/bin/env bash
# The form of a package of CGAL: what package_info/ must have, and the manual built in a tree laid
# out as that of CGAL, whose CMakeLists configure Doxyfile.in in the same way. References are
# checked where there is BibTeX. Usage: test_in_cgal.sh SOURCE DOC_FOLDER
set -eu
source=$1 defaults=$2/Doxygen_defaults name=Geometric_continuity
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fails() {
  echo "$1"
  failures=$((failures + 1))
}
info=$source/package_info/$name
for file in copyright dependencies description.txt license.txt long_description.txt maintainer; do
  [ -s "$info/$file" ] || fails "package_info/$name/$file is missing or empty"
done
LC_ALL=C sort -cu "$info/dependencies" || fails "package_info/$name/dependencies is not sorted"
grep -qx $name "$info/dependencies" || fails "the package depends on itself"
grep -qx "LGPL (v3 or later)" "$info/license.txt" || fails "license.txt does not name the license in CGAL's words"
headers=$(grep -rL "SPDX-License-Identifier: LGPL-3.0-or-later" "$source/include" "$source/figures" || true)
[ -z "$headers" ] || fails "another license: $headers"
[ "$(wc -l <"$info/description.txt")" -eq 1 ] || fails "description.txt has one line"

# The tree of a branch of CGAL, CGAL_ROOT/PACKAGE/{doc,examples,figures,include}, and what CGAL sets
# for each package.
mkdir -p "$work/cgal/$name" "$work/tags" "$work/doc_output"
for part in doc examples figures include; do ln -s "$source/$part" "$work/cgal/$name/$part"; done
cat >"$work/configure.cmake" <<'CMAKE'
set(CGAL_PACKAGE_DIR ${root}/cgal/${name})
set(CGAL_PACKAGE_DOC_DIR ${CGAL_PACKAGE_DIR}/doc/${name})
set(CGAL_PACKAGE_INCLUDE_DIR ${CGAL_PACKAGE_DIR}/include/)
set(CGAL_DOC_VERSION 6.0.1)
set(CGAL_DOC_PACKAGE_DEFAULTS ${root}/${name}_defaults.dxy)
file(WRITE ${CGAL_DOC_PACKAGE_DEFAULTS} "@INCLUDE = ${defaults}
OUTPUT_DIRECTORY = ${root}/doc_output/${name}
HTML_OUTPUT = .
EXAMPLE_PATH = ${CGAL_PACKAGE_DIR}/examples
GENERATE_TAGFILE = ${root}/tags/${name}.tag
STRIP_FROM_PATH = ${CGAL_PACKAGE_DOC_DIR}/ ${CGAL_PACKAGE_DIR}/include/
STRIP_FROM_INC_PATH = ${CGAL_PACKAGE_DOC_DIR}/ ${CGAL_PACKAGE_DIR}/include/
INPUT = ${CGAL_PACKAGE_DOC_DIR} ${CGAL_PACKAGE_DIR}/include/
IMAGE_PATH = ${CGAL_PACKAGE_DOC_DIR}/fig
ALIASES += \"cgalCite{1}=\\cite \\1\"
")
configure_file(${CGAL_PACKAGE_DOC_DIR}/Doxyfile.in ${root}/${name}.dxy)
CMAKE
cmake -Droot="$work" -Dname=$name -Ddefaults="$defaults" -P "$work/configure.cmake"
if ! command -v bibtex >/dev/null; then
  echo "without BibTeX: references are not checked"
  printf '%s\n' 'CITE_BIB_FILES =' 'ALIASES += "cgalCite{1}=[\1]"' "INPUT += $2/Bibliography.txt" >>"$work/$name.dxy"
fi
doxygen "$work/$name.dxy" || fails "the manual has warnings in the tree of CGAL"
grep -q "CGAL 6.0.1 - Geometric Continuity" "$work/doc_output/$name/index.html" || fails "the title is not that of a package of CGAL"
names() { sed -n 's/^ *<name>\(.*\)<\/name>/\1/p' "$1" | grep -v '\.h$\|citelist' | LC_ALL=C sort -u; }
names "$2/manual.tag" | diff - <(names "$work/tags/$name.tag") || fails "the manual has other names in the tree of CGAL"
exit $((failures > 0))
