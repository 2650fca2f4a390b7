# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Two thousand files on three workers of Dask, of which one is killed in the middle: every file has exactly one record, that of one process."""

import glob
import importlib.util
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import geometric_continuity as gc

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "demo", "Geometric_continuity", "data")
FILES = 2000


def make_files(folder):
    """Drawings, chains, small fonts and CAD models, some of them damaged."""
    originals = sorted(glob.glob(os.path.join(DATA, "*.svg")) + glob.glob(os.path.join(DATA, "lm*.g2")))
    originals += sorted(glob.glob("/usr/share/fonts/truetype/noto/NotoSans*.ttf"), key=os.path.getsize)[:3]
    models = sorted(glob.glob(os.path.join(DATA, "*.step"))) + glob.glob("/usr/share/opencascade/data/occ/w*.brep")
    names = []
    for i in range(FILES):
        original = models[i // 100 % len(models)] if i % 100 == 50 and models else originals[i % len(originals)]
        name = f"{i:04}{os.path.splitext(original)[1]}"
        shutil.copy(original, os.path.join(folder, name))
        if i % 97 == 13:
            os.truncate(os.path.join(folder, name), 60)
        names.append(name)
    return names


@unittest.skipIf(importlib.util.find_spec("distributed") is None, "not installed: distributed")
class Dask(unittest.TestCase):
    def test_killed_worker(self):
        from distributed import Client, LocalCluster, as_completed

        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                names = make_files(folder)
                begin = time.monotonic()
                done = subprocess.run([gc.program(), "verify", "--jsonl", "-", "--require=G1"], input="\n".join(names).encode(),
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                alone = time.monotonic() - begin
                expected = {}
                for line in done.stdout.decode().splitlines():
                    record = json.loads(line)
                    self.assertNotIn(record["file"], expected)
                    expected[record["file"]] = record
                self.assertEqual(set(expected), set(names))
                self.assertEqual({r["exit_code"] for r in expected.values()}, {0, 1, 2})

                begin = time.monotonic()
                records, killed = [], None
                with LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, \
                        Client(cluster) as client:
                    pids = client.run(os.getpid)
                    futures = client.map(gc.file_record, names, require="G1", retries=3, pure=False)
                    for future in as_completed(futures):
                        records.append(future.result())
                        if len(records) == FILES // 4:
                            killed = sorted(pids.values())[0]
                            os.kill(killed, signal.SIGKILL)
                    again = client.run(os.getpid)
                    self.assertNotIn(killed, again.values())
                shared_out = time.monotonic() - begin
                self.assertEqual(len(records), FILES)
                self.assertEqual({r["file"]: r for r in records}, expected)
                print(f"\n{FILES / alone:.0f} files/s by verify --jsonl, {FILES / shared_out:.0f} files/s by three workers of Dask", end="")
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
