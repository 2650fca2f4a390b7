# The libraries that results and times are compared with, where they are on this machine: the target
# `peers`.
add_library(peers INTERFACE)
target_include_directories(peers INTERFACE ${CMAKE_CURRENT_LIST_DIR}) # peers.h

find_path(OCCT_INCLUDE_DIR Geom_BezierCurve.hxx PATH_SUFFIXES opencascade)
foreach(library TKBool TKTopAlgo TKGeomAlgo TKBRep TKG3d TKG2d TKGeomBase TKMath TKernel)
  find_library(OCCT_${library} ${library})
  list(APPEND occt_libraries ${OCCT_${library}})
endforeach()
if(OCCT_INCLUDE_DIR AND OCCT_TKG3d)
  target_compile_definitions(peers INTERFACE GEOMETRIC_CONTINUITY_WITH_OCCT)
  target_include_directories(peers SYSTEM INTERFACE ${OCCT_INCLUDE_DIR})
  target_link_libraries(peers INTERFACE ${occt_libraries})
endif()

find_library(SISL_LIBRARY sisl)
find_path(SISL_INCLUDE_DIR sisl.h)
if(SISL_LIBRARY AND SISL_INCLUDE_DIR)
  target_compile_definitions(peers INTERFACE GEOMETRIC_CONTINUITY_WITH_SISL)
  target_include_directories(peers SYSTEM INTERFACE ${SISL_INCLUDE_DIR})
  target_link_libraries(peers INTERFACE ${SISL_LIBRARY})
endif()
