# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import json
import os
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import geometric_continuity as gc

KINK = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L20 0.5"/></svg>'
CHAIN = "100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 0\n1 1/3\n100 1 0 0\n2 0\n2 2\n0 0 1 1\n1 1/3\n2 2/3\n"


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_the_record_is_that_of_the_program(self):
        for path, options in ((self.file("chain.g2", CHAIN), {}), (self.file("kink.svg", KINK), {"require": "G1"})):
            arguments = [f"--{k}={v}" for k, v in options.items()]
            done = subprocess.run([gc.program(), "verify", "--json", *arguments, path], stdout=subprocess.PIPE)
            record = gc.verify(path, **options)
            self.assertEqual(record, json.loads(done.stdout))
            if options:
                self.assertEqual((done.returncode, record["met"]), (1, False))
        self.assertEqual(gc.verify(self.file("chain.g2", CHAIN))["joins"][0]["g_order"], 3)
        self.assertEqual(gc.verify(self.file("-chain.g2", CHAIN), max_order=2)["joins"][0]["g_order"], 2)

    def test_bad_input(self):
        path = self.file("bad.g2", CHAIN.replace("1/3", "x", 1))
        with self.assertRaises(gc.Error) as caught:
            gc.verify(path)
        self.assertEqual(caught.exception.code, "malformed_input")
        self.assertEqual(caught.exception.place, path + ":6")
        self.assertIn("x", caught.exception.reason)
        for files, options in (((), {}), ((self.file("chain.g2", CHAIN),), {"require": "H2"})):
            with self.assertRaises(gc.Error) as caught:
                gc.verify(*files, **options)
            self.assertEqual(caught.exception.code, "bad_input")
        with self.assertRaises(gc.Error) as caught:
            gc.verify(os.path.join(self.folder, "missing.g2"))
        self.assertEqual(caught.exception.code, "cannot_read_file")

    def test_timeout(self):
        pipe = os.path.join(self.folder, "pipe.g2")
        os.mkfifo(pipe)
        with self.assertRaises(gc.Error) as caught:
            gc.verify(pipe, timeout=0.3)
        self.assertEqual(caught.exception.code, "time_limit")

    def test_record_of_a_file(self):
        kink = self.file("kink.svg", KINK)
        record = gc.file_record(kink, require="G1")
        self.assertEqual((record["file"], record["exit_code"]), (kink, 1))
        self.assertEqual(record["report"], gc.verify(kink, require="G1"))
        self.assertEqual((record["asked"], record["size"]), (["--require=G1"], os.path.getsize(kink)))
        with open(os.path.join(os.fsencode(self.folder), b"n\xe8.svg"), "w") as file:
            file.write(KINK)
        record = gc.file_record(os.path.join(self.folder, os.fsdecode(b"n\xe8.svg")))
        self.assertEqual(record["name_bytes"], os.path.join(os.fsencode(self.folder), b"n\xe8.svg").hex())
        self.assertEqual(gc.file_record(self.file("bad.g2", "100"))["error"]["code"], "malformed_input")
        pipe = os.path.join(self.folder, "pipe.g2")
        os.mkfifo(pipe)
        self.assertEqual(gc.file_record(pipe, time_limit=0.3)["error"]["code"], "time_limit")
        for name, options in ((kink, {"format": "json"}), ("two\nfiles", {})):
            with self.assertRaises(gc.Error):
                gc.file_record(name, **options)

    def test_baseline(self):
        kink, baseline = self.file("kink.svg", KINK), os.path.join(self.folder, "base.sarif")
        with open(baseline, "wb") as file:
            subprocess.run([gc.program(), "verify", kink, "--require=G1", "--format=sarif"], stdout=file)
        record = gc.verify(kink, require="G1", baseline=baseline)
        self.assertEqual((record["met"], record["findings"], record["claims"]["known"]), (None, [], 1))
        self.file("kink.svg", KINK.replace("L20 0.5", "L20 0.5 L30 1.5"))
        record = gc.verify(kink, require="G1", baseline=baseline)
        self.assertEqual((record["met"], len(record["findings"])), (False, 1))

    def test_module_as_program(self):
        done = subprocess.run([sys.executable, "-m", "geometric_continuity", "--version"], stdout=subprocess.PIPE)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith(b"geometric_continuity "))

    def test_missing_program(self):
        empty = {"GEOMETRIC_CONTINUITY_PROGRAM": "", "PATH": self.folder}
        with mock.patch.dict(os.environ, empty), mock.patch("os.access", return_value=False):
            with self.assertRaises(FileNotFoundError):
                gc.program()


if __name__ == "__main__":
    unittest.main()
