# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What pip gets: the wheel of the build folder in which the tests run is packed, unpacked and used. Nothing is compiled."""

import base64
import hashlib
import importlib
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from unittest import mock

import geometric_continuity as gc

BUILD = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(gc.__file__))))
TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


@unittest.skipUnless(os.path.exists(os.path.join(BUILD, "tools", "geometric_continuity")), "the module is not in a build folder")
class Wheel(unittest.TestCase):
    def setUp(self):
        sys.path.insert(0, os.path.join(TOP, "python", "build_backend"))
        self.addCleanup(sys.path.pop, 0)
        self.backend = importlib.import_module("build_wheel")

    def test_wheel(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(self.backend, "_build") as build:
            name = self.backend.build_wheel(folder, {"build-folder": BUILD, "cmake": "-DX=1"})
            build.assert_called_once_with(BUILD, ["-DX=1"])
            info = self.backend.prepare_metadata_for_build_wheel(folder)
            self.assertTrue(name.startswith(info.replace(".dist-info", "-")))
            with zipfile.ZipFile(os.path.join(folder, name)) as archive:
                names = archive.namelist()
                record = archive.read(info + "/RECORD").decode().splitlines()
                self.assertEqual([line.split(",")[0] for line in record], names)
                for line in record[:-1]:
                    path, digest, size = line.rsplit(",", 2)
                    content = archive.read(path)
                    expected = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                    self.assertEqual((digest, int(size)), ("sha256=" + expected, len(content)))
                for text in ("METADATA", "WHEEL", "entry_points.txt"):
                    with open(os.path.join(folder, info, text), "rb") as file:
                        self.assertEqual(archive.read(f"{info}/{text}"), file.read())
                target = os.path.join(folder, "target")
                for entry in archive.infolist():
                    os.chmod(archive.extract(entry, target), entry.external_attr >> 16)
            for needed in ("py.typed", "_native.pyi", "adapters/sources.py", "bin/geometric_continuity"):
                self.assertIn("geometric_continuity/" + needed, names)
            self.assertFalse([n for n in names if "__pycache__" in n])
            environment = {k: v for k, v in os.environ.items() if k != "GEOMETRIC_CONTINUITY_PROGRAM"}
            code = ("import geometric_continuity as gc, subprocess; print(gc.program(), gc.continuity([(0, 0), (1, 1)], [(1, 1), (2, 2)]).g_order);"
                    "print(subprocess.run([gc.program(), '--version'], stdout=subprocess.PIPE, check=True).stdout.decode())")
            done = subprocess.run([sys.executable, "-c", code], cwd=folder,
                                  env=dict(environment, PYTHONPATH=target), stdout=subprocess.PIPE, check=True)
            path, order, _, version = done.stdout.decode().split()
            self.assertEqual((path, order), (os.path.join(target, "geometric_continuity", "bin", "geometric_continuity"), "3"))
            self.assertIn(version, name)

    def test_nothing_is_downloaded(self):
        self.assertEqual(self.backend.get_requires_for_build_wheel(), [])
        with open(os.path.join(TOP, "pyproject.toml"), encoding="utf-8") as file:
            self.assertIn("requires = []", file.read())


if __name__ == "__main__":
    unittest.main()
