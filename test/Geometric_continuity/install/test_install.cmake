# Configures the project from SOURCE without its program, for which CGAL is enough, and installs it
# into WORK without building anything; configures, builds and runs the separate project in USER,
# which finds it, and then has it as a part of its own.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(options -DCMAKE_CXX_COMPILER=${CXX} -DCGAL_DIR=${CGAL_DIR})
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/headers ${options} -DGEOMETRIC_CONTINUITY_WITH_PROGRAM=OFF
    -DCMAKE_DISABLE_FIND_PACKAGE_EXPAT=ON -DCMAKE_DISABLE_FIND_PACKAGE_Freetype=ON -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON)
run(${CMAKE_COMMAND} --install ${WORK}/headers --prefix ${WORK}/prefix)

run(${CMAKE_COMMAND} -S ${USER} -B ${WORK}/finds ${options} -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${WORK}/finds)
run(${WORK}/finds/uses_geometric_continuity)

# The licences are there, and pkg-config tells what a compiler needs.
foreach(licence LGPL GPL)
  if(NOT EXISTS ${WORK}/prefix/share/doc/geometric-continuity/LICENSE.${licence})
    message(FATAL_ERROR "LICENSE.${licence} is not installed")
  endif()
endforeach()
find_program(pkg_config pkg-config)
if(pkg_config)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${WORK}/prefix/share/pkgconfig
                          ${pkg_config} --cflags --libs geometric-continuity
                  RESULT_VARIABLE code OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "pkg-config does not find geometric-continuity")
  endif()
  separate_arguments(flags UNIX_COMMAND "${flags}")
  file(GLOB user_sources ${USER}/*.cpp)
  run(${CXX} ${user_sources} ${flags} -o ${WORK}/by_pkg_config)
  run(${WORK}/by_pkg_config)
endif()

run(${CMAKE_COMMAND} -S ${USER} -B ${WORK}/contains ${options} -DPACKAGE_SOURCE=${SOURCE} -DCMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${WORK}/contains)
run(${WORK}/contains/uses_geometric_continuity)
run(${CMAKE_COMMAND} --install ${WORK}/contains --prefix ${WORK}/nothing)
file(GLOB_RECURSE installed ${WORK}/nothing/*)
if(installed)
  message(FATAL_ERROR "As a part of another project the package installs ${installed}")
endif()
# fetched it is the same, and so it is with its options, of which the program is built on demand
run(${CMAKE_COMMAND} -S ${USER} -B ${WORK}/fetches ${options} -DPACKAGE_SOURCE=${SOURCE} -DFETCHED=ON)
foreach(fetched OFF ON)
  run(${CMAKE_COMMAND} -S ${USER} -B ${WORK}/with_program_${fetched} ${options} -DPACKAGE_SOURCE=${SOURCE} -DFETCHED=${fetched}
      -DGEOMETRIC_CONTINUITY_WITH_PROGRAM=ON -DGEOMETRIC_CONTINUITY_WARNINGS_AS_ERRORS=ON)
endforeach()

# The built program is installed as well.
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/whole)
run(${WORK}/whole/bin/geometric_continuity --version)
