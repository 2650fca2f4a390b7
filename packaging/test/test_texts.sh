#!/usr/bin/env bash
# Versions that stand in several places agree, files of other tools can be read, and release notes
# and the npm package are made by their scripts as they should be. Usage: test_texts.sh WORK_FOLDER
set -u
top=$(cd "$(dirname "$0")/../.." && pwd)
work=$1 failures=0 checks=0
[ ! -e "$work/.git" ] || { echo "$work is a repository, and would be emptied" >&2; exit 1; }
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
holds() {
  checks=$((checks + 1))
  "$@" || { failures=$((failures + 1)); echo "not true: $*"; }
}
version=$(sed -n 's/^project(Geometric_continuity VERSION \([0-9.]*\).*/\1/p' "$top/CMakeLists.txt")

holds grep -qx "version: $version" "$top/CITATION.cff"
holds grep -q "\"version\": \"$version\"," "$top/packaging/vcpkg/geometric-continuity/vcpkg.json"
holds grep -q 'run: \.ci/run$' "$top/.github/workflows/ci.yml"
holds [ -x "$top/.ci/run" ]
for script in bare_system deb release_notes try_{demo,deb,headers,npm,python}; do holds bash -n "$top/packaging/$script"; done
if python3 -c 'import yaml' 2>/dev/null; then
  for file in CITATION.cff .github/workflows/ci.yml; do
    holds python3 -c 'import sys, yaml; sys.exit(not isinstance(yaml.safe_load(open(sys.argv[1])), dict))' "$top/$file"
  done
fi

"$top/packaging/release_notes" >notes
holds [ "$(wc -l <notes)" -gt 5 ]
holds [ "$(grep -c '^## ' notes)" -eq 0 ]
holds [ -n "$(head -n 1 notes)" ]
"$top/packaging/release_notes" 0.1.0 >notes.old
holds [ -s notes.old ]
holds [ "$("$top/packaging/release_notes" 99.0 2>&1)" = "CHANGES.md has no section of version 99.0" ]

if command -v npm >/dev/null; then
  # npm packs a folder as browser/build makes it, of a project with an address; nothing is compiled.
  mkdir -p source/browser/module package
  sed 's|HOMEPAGE_URL ".*"|HOMEPAGE_URL "https://example.org/curves"|' "$top/CMakeLists.txt" >source/CMakeLists.txt
  cp "$top/browser/module/package.json" source/browser/module/
  node "$top/browser/describe.mjs" "$top" >without_address.json
  node "$top/browser/describe.mjs" source >package/package.json
  cp "$top"/browser/module/{geometric_continuity.mjs,geometric_continuity.d.ts,README.md} "$top"/LICENSE.* package/
  touch package/geometric_continuity.wasm package/geometric_continuity_files.wasm
  holds npm pack --silent --offline ./package >name
  holds tar -xzf "geometric-continuity-$version.tgz"
  field() { node -p "const p = JSON.parse(require('fs').readFileSync('$1')); $2"; }
  holds [ "$(field package/package.json p.version)" = "$version" ]
  holds [ "$(field package/package.json p.author)" = "The Geometric_continuity developers" ]
  holds [ "$(field package/package.json p.license)" = LGPL-3.0-or-later ]
  holds [ "$(field package/package.json p.homepage)" = "https://example.org/curves" ]
  holds [ "$(field package/package.json p.repository.url)" = "git+https://example.org/curves.git" ]
  holds [ "$(field without_address.json 'p.homepage || p.repository')" = undefined ]
  holds [ -e "package/$(field package/package.json p.types)" ]
  for file in README.md LICENSE.LGPL LICENSE.GPL geometric_continuity.mjs geometric_continuity.wasm; do
    holds [ "$(tar -tzf "geometric-continuity-$version.tgz" "package/$file")" = "package/$file" ]
  done
fi
echo "$checks checks, $failures failures"
[ $failures -eq 0 ]
