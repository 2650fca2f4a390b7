# CPack runs this before it packs: it brings what was installed into the places and forms that
# Debian asks of its packages.
set(source ${CPACK_GEOMETRIC_CONTINUITY_SOURCE})
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)

# run(COMMAND...)
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed")
  endif()
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share)
  set(doc ${share}/doc/${name})
  file(MAKE_DIRECTORY ${doc})
  file(COPY_FILE ${source}/packaging/debian/copyright ${doc}/copyright)
  file(COPY_FILE ${source}/CHANGES.md ${doc}/CHANGES.md)
  file(WRITE ${doc}/changelog "${name} (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * The changes of this version are in CHANGES.md.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
  run(gzip -9nf ${doc}/CHANGES.md ${doc}/changelog)
  if(EXISTS ${source}/packaging/debian/overrides/${name})
    file(COPY ${source}/packaging/debian/overrides/${name} DESTINATION ${share}/lintian/overrides)
  endif()
  if(EXISTS ${share}/man)
    run(gzip -9nf ${share}/man/man1/geometric_continuity.1)
  endif()
  if(EXISTS ${share}/zsh/site-functions) # those of packages lie elsewhere
    file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
  endif()
  run(chmod -R u=rwX,go=rX ${CPACK_TEMPORARY_DIRECTORY}/${component})
endforeach()
