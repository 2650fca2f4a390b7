"""A stand-in for the tools of Conan."""
