# SPDX-License-Identifier: CC0-1.0
"""SISL: the derivatives of s1221 and s1227, from the right and from the left."""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from answers import decide_chain, serve  # noqa: E402


def derivatives(degree, knots, points, weights):
    n = len(points[0])
    rows = [[x * w for x in p] + [w] for p, w in zip(points, weights)] if weights else points
    words = [n, degree, len(points), 1 if weights else 0] + [repr(x) for x in knots] + [repr(x) for p in rows for x in p]
    done = subprocess.run([str(HERE / "build/derivatives")], input=" ".join(map(str, words)), capture_output=True, text=True, timeout=20)
    if done.returncode:
        raise RuntimeError(done.stderr.strip() or f"exit code {done.returncode}")
    for line in done.stdout.splitlines():
        values = [float(x) for x in line.split()]
        yield [[values[4 * n * side + n * k : 4 * n * side + n * (k + 1)] for k in range(4)] for side in (0, 1)]


serve(lambda file, order, within: decide_chain(derivatives, file, order, within))
