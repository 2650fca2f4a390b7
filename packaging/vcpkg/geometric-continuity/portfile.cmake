# The overlay port of this repository: it builds the tree in which it lies. There are no libraries,
# of which debuggers would want versions of their own.
set(VCPKG_BUILD_TYPE release)
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES program GEOMETRIC_CONTINUITY_WITH_PROGRAM)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
                      OPTIONS ${FEATURE_OPTIONS} -DBUILD_TESTING=OFF -DGEOMETRIC_CONTINUITY_WITH_OPENCASCADE=OFF
                              -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON
                      MAYBE_UNUSED_VARIABLES GEOMETRIC_CONTINUITY_WITH_OPENCASCADE)
if("program" IN_LIST FEATURES)
  vcpkg_cmake_build(TARGET geometric_continuity)
endif()
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Geometric_continuity CONFIG_PATH lib/cmake/Geometric_continuity)
vcpkg_fixup_pkgconfig()
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES geometric_continuity)
  file(INSTALL "${CURRENT_PACKAGES_DIR}/bin/check_certificate"
       DESTINATION "${CURRENT_PACKAGES_DIR}/tools/${PORT}" USE_SOURCE_PERMISSIONS)
endif()
# vcpkg wants no empty folders: lib is one, now that CMake's files have moved to share.
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/bin" "${CURRENT_PACKAGES_DIR}/lib" "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE.LGPL" "${SOURCE_PATH}/LICENSE.GPL")
