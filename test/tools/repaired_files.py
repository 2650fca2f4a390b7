# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The files that repair_drawings.py and repair_fonts.py check, and what they print of them."""

import os
import re
import subprocess
import sys
import tempfile


def files(paths, pattern):
    """Each file with a name like this, and its content, once for equal ones."""
    seen = set()
    for path in paths:
        for folder, _, names in os.walk(path) if os.path.isdir(path) else [("", [], [path])]:
            for name in sorted(names):
                file = os.path.join(folder, name)
                if re.search(pattern, name, re.I) and os.path.isfile(file):
                    with open(file, "rb") as f:
                        data = f.read()
                    if hash(data) not in seen:
                        seen.add(hash(data))
                        yield file, data


def run(*arguments):
    return subprocess.run(arguments, capture_output=True, encoding="utf-8", errors="replace")


def main(pattern, names, check):
    """Prints what check(PROGRAM, file, data, folder, options, angle, sums) yields for each file, and the sums with these names.

    `angle` are the options of repair that verify has, too."""
    arguments, options = sys.argv[1:], []
    if "--" in arguments:
        arguments, options = arguments[: arguments.index("--")], arguments[arguments.index("--") + 1 :]
    angle = [o for i, o in enumerate(options) if o == "--kink-angle" or (i > 0 and options[i - 1] == "--kink-angle")]
    sums = dict.fromkeys(names, 0)
    failures = 0
    for file, data in files(arguments[1:], pattern):
        with tempfile.TemporaryDirectory() as folder:
            for problem in check(arguments[0], file, data, folder, options, angle, sums):
                failures += 1
                print("%s: %s" % (file, problem.strip()), flush=True)
    print(", ".join("%s %s" % (value, name) for name, value in sums.items()))
    print("%d failures" % failures)
    sys.exit(failures != 0 or sums[names[0]] == 0)
