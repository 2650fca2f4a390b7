"""A stand-in for Conan, with what the recipe calls."""


class ConanFile:
    pass
