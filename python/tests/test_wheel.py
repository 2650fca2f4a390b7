# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What pip gets: the wheel of the build folder in which the tests run is packed, unpacked and used. Nothing is compiled."""

import base64
import email
import hashlib
import importlib
import os
import re
import subprocess
import sys
import tarfile
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
            self.assertIn(info + "/licenses/LICENSE.LGPL", names)
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


class Description(unittest.TestCase):
    """What the wheel and the source distribution say about themselves; neither is compiled here."""

    def setUp(self):
        sys.path.insert(0, os.path.join(TOP, "python", "build_backend"))
        self.addCleanup(sys.path.pop, 0)
        self.backend = importlib.import_module("build_wheel")

    def metadata(self, address):
        with mock.patch.object(self.backend, "_address", return_value=address):
            return email.message_from_string(self.backend._metadata())

    def test_metadata(self):
        fields = self.metadata("")
        self.assertEqual(fields["License-Expression"], "LGPL-3.0-or-later")
        self.assertEqual(fields.get_all("License-File"), ["LICENSE.LGPL", "LICENSE.GPL"])
        self.assertIn("Programming Language :: Python :: 3", fields.get_all("Classifier"))
        self.assertIsNone(fields["Project-URL"])
        fields = self.metadata("https://example.org/curves")
        version = fields["Version"]
        self.assertEqual(fields.get_all("Project-URL"), ["Homepage, https://example.org/curves", "Repository, https://example.org/curves",
                                                         f"Changelog, https://example.org/curves/blob/v{version}/CHANGES.md"])

    def test_pictures_and_links(self):
        """Nothing that the description links is relative, and its pictures are those of the repository."""
        for address in ("", "https://example.org/curves"):
            text = self.metadata(address).get_payload()
            links = re.findall(r"(!?)\[[^]]*\]\(([^)]*)\)", text)
            pictures = [target for mark, target in links if mark]
            self.assertEqual(len(pictures), 2)
            for _, target in links:
                self.assertRegex(target, "^(https|data):")
            for target in pictures if address else []:
                path = re.match(r"https://example\.org/curves/raw/v[0-9.]+/(.*)", target).group(1)
                self.assertTrue(os.path.exists(os.path.join(TOP, path)), path)
            if not address:
                kinds = [re.match("data:image/([a-z+]*);base64,(.*)", target).groups() for target in pictures]
                self.assertEqual([kind for kind, _ in kinds], ["svg+xml", "svg+xml"])
                self.assertTrue(base64.b64decode(kinds[0][1]).decode().rstrip().endswith("</svg>"))

    @unittest.skipUnless(any(os.path.exists(os.path.join(TOP, name)) for name in (".git", "SOURCES.txt")), "there is no list of files")
    def test_source_distribution(self):
        """What was unpacked packs the same again, in a place where there is no git."""
        with tempfile.TemporaryDirectory() as folder:
            name = self.backend.build_sdist(folder)
            with tarfile.open(os.path.join(folder, name)) as archive:
                first = {entry.name: entry.size for entry in archive}
                archive.extractall(folder)
            top = os.path.join(folder, name.replace(".tar.gz", ""))
            for needed in ("PKG-INFO", "CMakeLists.txt", "LICENSE.LGPL", "python/build_backend/build_wheel.py", "browser/build"):
                self.assertIn(os.path.basename(top) + "/" + needed, first)
            with open(os.path.join(top, "stray.txt"), "w", encoding="utf-8"):
                pass
            os.mkdir(os.path.join(folder, "again"))
            code = "import build_wheel, sys; print(build_wheel.build_sdist(sys.argv[1]))"
            subprocess.run([sys.executable, "-c", code, os.path.join(folder, "again")], cwd=folder, check=True, stdout=subprocess.PIPE,
                           env={"PYTHONPATH": os.path.join(top, "python", "build_backend"), "PATH": ""})
            with tarfile.open(os.path.join(folder, "again", name)) as archive:
                self.assertEqual({entry.name: entry.size for entry in archive}, first)

    def test_missing_headers(self):
        """What the module needs and does not find ends the build before anything is compiled."""
        options = ["-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON", "-DCMAKE_CXX_COMPILER_LAUNCHER=false"]
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(subprocess.CalledProcessError) as raised:
            self.backend.build_wheel(folder, {"cmake": options})
        self.assertIn("-S", raised.exception.cmd)

    def test_nothing_is_downloaded(self):
        self.assertEqual(self.backend.get_requires_for_build_wheel(), [])
        with open(os.path.join(TOP, "pyproject.toml"), encoding="utf-8") as file:
            self.assertIn("requires = []", file.read())


if __name__ == "__main__":
    unittest.main()
