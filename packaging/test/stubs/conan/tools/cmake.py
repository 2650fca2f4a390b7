"""A stand-in for the calls of CMake by Conan, which calls it with the options that the test gives."""

import subprocess


class CMakeDeps:
    def __init__(self, conanfile):
        self.properties = conanfile.properties_of_dependencies = {}

    def set_property(self, dependency, name, value):
        self.properties[dependency, name] = value

    def generate(self):
        pass


class CMakeToolchain:
    def __init__(self, conanfile):
        self.cache_variables = conanfile.cache_variables = {}

    def generate(self):
        pass


class CMake:
    def __init__(self, conanfile):
        self.conanfile = conanfile

    def configure(self):
        variables = [f"-D{name}={value}" for name, value in self.conanfile.cache_variables.items()]
        subprocess.run(["cmake", "-S", self.conanfile.source_folder, "-B", self.conanfile.build_folder, *variables,
                        *self.conanfile.options_of_cmake], check=True)

    def install(self):
        subprocess.run(["cmake", "--install", self.conanfile.build_folder, "--prefix", self.conanfile.package_folder], check=True)
