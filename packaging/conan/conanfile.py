# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The recipe of Conan 2 for the headers of this repository: conan create packaging/conan"""

import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain
from conan.tools.files import copy


class GeometricContinuity(ConanFile):
    name = "geometric-continuity"
    description = "Curves and surfaces that join smoothly, and a proof that they do"
    license = "LGPL-3.0-or-later"
    author = "The Geometric_continuity developers"
    topics = ("bezier", "spline", "curvature", "cad", "exact")
    package_type = "header-library"
    settings = "os", "compiler", "build_type", "arch"

    def _top(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        with open(os.path.join(self._top(), "CMakeLists.txt"), encoding="utf-8") as file:
            self.version = re.search(r"project\(Geometric_continuity VERSION ([0-9.]+)", file.read()).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE.*", "include/*", "figures/include/*",
                        "packaging/geometric-continuity.pc.in"):
            copy(self, pattern, self._top(), self.export_sources_folder)

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True, transitive_libs=True)

    def package_id(self):
        self.info.clear()

    def generate(self):
        dependencies = CMakeDeps(self)
        # Otherwise CMake refuses a CGAL 6 where the project asks for 5.5 or newer.
        dependencies.set_property("cgal", "cmake_config_version_compat", "AnyNewerVersion")
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["GEOMETRIC_CONTINUITY_WITH_PROGRAM"] = False
        toolchain.generate()

    def build(self):
        CMake(self).configure()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE.*", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "Geometric_continuity")
        self.cpp_info.set_property("cmake_target_name", "Geometric_continuity::Geometric_continuity")
        self.cpp_info.set_property("pkg_config_name", "geometric-continuity")
        self.cpp_info.requires = ["cgal::cgal"]
