#!/usr/bin/env bash
# Packs what the build folder has as packages of Debian, and looks at them; lintian finds no error
# where it is there.
# Usage: test_deb.sh BUILD_FOLDER WORK_FOLDER
set -u
build=$1 work=$2 failures=0 checks=0
for program in cpack dpkg-deb dpkg-shlibdeps file; do
  command -v $program >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done
holds() {
  checks=$((checks + 1))
  "$@" || { failures=$((failures + 1)); echo "not true: $*"; }
}
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
# With the name of this generator CPack packs what is built, and does not build the rest first.
cpack --config "$build/CPackConfig.cmake" -G DEB -B "$work" -D CPACK_CMAKE_GENERATOR=Ninja >log 2>&1 || { cat log; exit 1; }

deb=$(ls geometric-continuity_*.deb)
dpkg-deb -c "$deb" | sed 's/.* \././' >files
for file in bin/geometric_continuity bin/check_certificate include/CGAL/Geometric_continuity.h \
  share/man/man1/geometric_continuity.1.gz share/bash-completion/completions/geometric_continuity \
  share/zsh/vendor-completions/_geometric_continuity share/fish/vendor_completions.d/geometric_continuity.fish \
  share/doc/geometric-continuity/{copyright,changelog.gz,CHANGES.md.gz,LICENSE.LGPL,LICENSE.GPL} \
  share/geometric_continuity/{apply_moves,write_font}.py share/pkgconfig/geometric-continuity.pc; do
  holds grep -qx "./usr/$file" files
done
holds grep -q '/cmake/Geometric_continuity/Geometric_continuityConfig.cmake$' files
depends=$(dpkg-deb -f "$deb" Depends)
for library in libc6 libexpat1 libfreetype6 libgmp10 libmpfr6 libstdc[+][+]6 zlib1g python3; do
  holds [ "$(grep -cE "(^|, )$library(,| |$)" <<<"$depends")" -eq 1 ]
done
holds [ "$(grep -c occt <<<"$depends")" -eq 0 ]
holds [ "$(dpkg-deb -f "$deb" Recommends)" = "libcgal-dev (>= 5.5)" ]
for cad in geometric-continuity-cad_*.deb; do
  [ -e "$cad" ] || continue
  for needed in 'geometric-continuity (= ' 'libocct-data-exchange'; do
    holds grep -qF "$needed" <<<"$(dpkg-deb -f "$cad" Depends)"
  done
  holds [ "$(dpkg-deb -c "$cad" | grep -c '/usr/libexec/geometric_continuity/geometric_continuity_cad$')" -eq 1 ]
  holds [ "$(grep -c geometric_continuity_cad files)" -eq 0 ]
done
if command -v lintian >/dev/null; then
  lintian --allow-root --no-cfg --fail-on error ./*.deb >lintian.log 2>&1 || { failures=$((failures + 1)); grep '^E' lintian.log; }
fi
echo "$checks checks, $failures failures"
[ $failures -eq 0 ]
