"""Runs the recipe of Conan, with stand-ins for its functions: what it exports must be all that its build needs.
Usage: run_conanfile.py CONANFILE WORK_FOLDER CMAKE_OPTION..."""

import importlib.util
import os
import sys
import types

specification = importlib.util.spec_from_file_location("conanfile", sys.argv[1])
module = importlib.util.module_from_spec(specification)
specification.loader.exec_module(module)
recipe = module.GeometricContinuity()
work = sys.argv[2]
recipe.recipe_folder = os.path.dirname(sys.argv[1])
recipe.export_sources_folder = recipe.source_folder = os.path.join(work, "source")
recipe.build_folder, recipe.package_folder = os.path.join(work, "build"), os.path.join(work, "package")
recipe.options_of_cmake = sys.argv[3:]
required = []
recipe.requires = lambda reference, **traits: required.append(reference)
recipe.info = types.SimpleNamespace(clear=lambda: None)
recipe.cpp_info = types.SimpleNamespace(set_property=lambda name, value: None)

recipe.set_version()
assert recipe.version.count(".") == 2, recipe.version
recipe.export_sources()
recipe.requirements()
recipe.generate()
recipe.build()
recipe.package()
recipe.package_id()
recipe.package_info()
assert [reference.split("/")[0] for reference in required] == ["cgal"] and recipe.cpp_info.requires == ["cgal::cgal"]
# Conan's file for CGAL 6 says by default that it is not for those who ask for 5.5.
assert recipe.properties_of_dependencies == {("cgal", "cmake_config_version_compat"): "AnyNewerVersion"}
