# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Two extensions of Inkscape, Extensions > Modify Path > Smooth Kinks and Round Corners Smoothly: `geometric_continuity repair` and
`geometric_continuity blend --corners all` of the drawing. They need nothing but the program, on the path or as GEOMETRIC_CONTINUITY_PROGRAM,
and these three files in the folder of extensions (~/.config/inkscape/extensions)."""

import argparse
import os
import subprocess
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kink_angle", default="5")
    parser.add_argument("--to", default="G1")
    parser.add_argument("--distance")  # to round corners
    parser.add_argument("--arcs", default="false")  # of which that is the radius
    parser.add_argument("drawing")
    options, _ = parser.parse_known_args()  # --id=... of what is selected
    program = os.environ.get("GEOMETRIC_CONTINUITY_PROGRAM", "geometric_continuity")
    with tempfile.TemporaryDirectory() as folder:
        result = os.path.join(folder, "result.svg")
        command = [program, "blend" if options.distance else "repair", options.drawing, "-o", result, "--kink-angle", options.kink_angle]
        if options.distance:
            command += ["--corners", "all", "--radius" if options.arcs == "true" else "--distance", options.distance]
        else:
            command += ["--to", options.to, "--allow-undecided", "--allow-uncovered"]
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        except FileNotFoundError:
            sys.exit("The program geometric_continuity is not installed.")
        if done.returncode not in (0, 1):
            sys.exit(done.stderr.decode("utf-8", "replace"))
        if done.returncode == 1:  # Inkscape shows it
            print(done.stdout.decode("utf-8", "replace"), file=sys.stderr)
        with open(result, "rb") as file:
            sys.stdout.buffer.write(file.read())


main()
