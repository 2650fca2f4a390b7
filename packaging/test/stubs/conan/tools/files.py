"""A stand-in for the functions of Conan on files."""

import fnmatch
import os
import shutil


def copy(conanfile, pattern, src, dst):
    """Copies the files below src whose paths fit the pattern, as that of Conan does."""
    copied = []
    for base, _, names in os.walk(src):
        for path in (os.path.relpath(os.path.join(base, name), src) for name in names):
            if fnmatch.fnmatch(path, pattern):
                os.makedirs(os.path.dirname(os.path.join(dst, path)), exist_ok=True)
                copied.append(shutil.copy(os.path.join(src, path), os.path.join(dst, path)))
    assert copied, f"nothing fits {pattern}"
    return copied
