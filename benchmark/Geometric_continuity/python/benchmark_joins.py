# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A million joins of cubic curves: `failing_joins` on an array of NumPy against the call of C++, by turns in one run, and against a check
that is written in NumPy, with a tolerance. Usage: benchmark_joins.py PYTHON_BENCHMARK [CURVES], where the program is the target
python_benchmark of the same build as the module."""

import subprocess
import sys
import tempfile
import time

import numpy

import geometric_continuity as gc


def chain(n, dimension):
    """The Bezier curves of a uniform cubic spline, with one joint of a hundred that is not G2."""
    d = 6. * numpy.random.default_rng(7).integers(-1000, 1000, (n + 3, dimension))
    a, b, c, e = d[:-3], d[1:-2], d[2:-1], d[3:]
    curves = numpy.stack([(a + 4 * b + c) / 6, (2 * b + c) / 3, (b + 2 * c) / 3, (b + 4 * c + e) / 6], axis=1)
    curves[::100, 2] += 0.25
    return curves


def numpy_check(curves, tolerance=1e-9):
    """G2 within a tolerance: ends, directions of the legs and curvature vectors."""
    p, q = curves[:-1], curves[1:]
    a, b = p[:, 3] - p[:, 2], q[:, 1] - q[:, 0]
    r, s = p[:, 3] - 2 * p[:, 2] + p[:, 1], q[:, 2] - 2 * q[:, 1] + q[:, 0]

    def curvature(leg, second):
        square = (leg * leg).sum(1, keepdims=True)
        return (second - leg * (leg * second).sum(1, keepdims=True) / square) / square

    with numpy.errstate(all="ignore"):
        unit_a, unit_b = (v / numpy.sqrt((v * v).sum(1, keepdims=True)) for v in (a, b))
        bad = abs(p[:, 3] - q[:, 0]).max(1) > tolerance
        bad |= ~(abs(unit_a - unit_b).max(1) <= tolerance)
        bad |= ~(abs(curvature(a, r) - curvature(b, s)).max(1) <= tolerance)
    return numpy.flatnonzero(bad)


def main():
    n = int(sys.argv[2]) if len(sys.argv) > 2 else 1000001
    print("| joins of cubics | C++ [ns] | from NumPy [ns] | ratio | written in NumPy, with a tolerance [ns] |")
    print("| :-------------- | -------: | --------------: | ----: | -------------------------------------: |")
    for dimension, name in ((2, "plane"), (3, "space")):
        curves = chain(n, dimension)
        with tempfile.NamedTemporaryFile() as file:
            curves.tofile(file)
            file.flush()
            program = subprocess.Popen([sys.argv[1], file.name, str(dimension)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
            assert program.stdout.readline() == "ready\n"
            times = {"C++": [], "module": [], "numpy": []}
            for _ in range(15):
                print(file=program.stdin, flush=True)
                failing, seconds = program.stdout.readline().split()
                times["C++"].append(float(seconds))
                begin = time.perf_counter()
                found = gc.failing_joins(curves, "G2")
                times["module"].append(time.perf_counter() - begin)
                assert len(found) == int(failing)
                begin = time.perf_counter()
                numpy_check(curves)
                times["numpy"].append(time.perf_counter() - begin)
            program.stdin.close()
            program.wait()
        best = {key: min(t) / (n - 1) * 1e9 for key, t in times.items()}
        print(f"| {name} | {best['C++']:.1f} | {best['module']:.1f} | {best['module'] / best['C++']:.2f} | {best['numpy']:.0f} |")


if __name__ == "__main__":
    main()
