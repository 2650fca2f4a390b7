# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Many files: `verify --jsonl` on one core and on all, and `file_record` on one and two workers of Dask, with the seconds of processors that a
file costs, of which those of Dask have the engine in them. Usage: benchmark_files.py [FILES], in an environment with the module; the files are
those of its test."""

import os
import resource
import subprocess
import sys
import tempfile
import time

import geometric_continuity as gc

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "python", "tests", "long"))
import test_dask


def processor_seconds():
    return sum(u.ru_utime + u.ru_stime for u in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


def measure(name, n, run):
    begin, before = time.perf_counter(), processor_seconds()
    run()
    seconds = time.perf_counter() - begin
    print(f"| {name} | {n / seconds:.0f} | {(processor_seconds() - before) / n * 1000:.1f} |", flush=True)


def by_program(names, *options):
    subprocess.run([gc.program(), "verify", "--jsonl", "-", "--require=G1", *options], input="\n".join(names).encode(),
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def by_dask(names, workers):
    from distributed import Client, LocalCluster, as_completed

    with LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, Client(cluster) as client:
        for future in as_completed(client.map(gc.file_record, names, require="G1", pure=False)):
            future.result()


def main():
    test_dask.FILES = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    print("| how | files a second | milliseconds of a processor for a file |")
    print("| :-- | -------------: | -------------------------------------: |")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        names = test_dask.make_files(folder)
        n = len(names)
        measure("`verify --jsonl --jobs 1`", n, lambda: by_program(names, "--jobs=1"))
        measure("`verify --jsonl`, all cores", n, lambda: by_program(names))
        measure("Dask, 1 worker", n, lambda: by_dask(names, 1))
        measure("Dask, 2 workers", n, lambda: by_dask(names, 2))
        os.chdir("/")


if __name__ == "__main__":
    main()
