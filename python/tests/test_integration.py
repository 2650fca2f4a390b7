# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What continuous integration calls: the commands of action.yml and .pre-commit-hooks.yaml are run as they stand there."""

import json
import os
import re
import shlex
import subprocess
import tempfile
import textwrap
import unittest

import geometric_continuity as gc

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
KINK = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L20 0.5"/></svg>'


def read(name):
    with open(os.path.join(TOP, name), encoding="utf-8") as file:
        return file.read()


class Integration(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        for name, text in (("kink.svg", KINK), ("smooth.svg", KINK.replace("0.5", "0"))):
            with open(os.path.join(self.folder, name), "w") as file:
                file.write(text)
        programs = os.path.join(self.folder, "geometric_continuity", "bin")
        os.makedirs(programs)
        os.symlink(os.path.abspath(gc.program()), os.path.join(programs, "geometric_continuity"))
        self.environment = dict(os.environ, RUNNER_TEMP=self.folder, PATH=programs + os.pathsep + os.environ["PATH"])

    def run_in_folder(self, *command, **more):
        return subprocess.run(command, cwd=self.folder, env=dict(self.environment, **more), stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)

    def test_action(self):
        steps = re.findall(r"      run: \|\n((?:        .*\n)+)", read("action.yml"))
        self.assertEqual(len(steps), 2)
        install, verify = (textwrap.dedent(step) for step in steps)
        # what is built is not built again
        self.assertEqual(self.run_in_folder("bash", "-ec", install, FOLDER="/nowhere").returncode, 0)
        defaults = {"OPTIONS": "--require G1", "BASELINE": "", "SARIF": "report.sarif"}
        done = self.run_in_folder("bash", "-ec", verify, FILES="smooth.svg kink.svg", **defaults)
        self.assertEqual(done.returncode, 1, done.stderr)
        with open(os.path.join(self.folder, "report.sarif")) as file:
            results = json.load(file)["runs"][0]["results"]
        self.assertEqual([r["ruleId"] for r in results if r["level"] == "error"], ["kink"])
        defaults.update(BASELINE="report.sarif", SARIF="new.sarif")
        self.assertEqual(self.run_in_folder("bash", "-ec", verify, FILES="smooth.svg kink.svg", **defaults).returncode, 0)
        self.assertEqual(self.run_in_folder("bash", "-ec", verify, FILES="missing.svg", **defaults).returncode, 2)

    def test_hooks(self):
        hooks = re.findall(r"- id: (\S+)\n(?:  .*\n)*?  entry: (.*)\n  args: \[(.*)\]\n(?:  .*\n)*?  files: (.*)\n",
                           read(".pre-commit-hooks.yaml"))
        self.assertEqual([h[0] for h in hooks], ["geometric-continuity-drawings", "geometric-continuity-fonts"])
        for name, entry, arguments, files in hooks:
            command = shlex.split(entry) + [a.strip() for a in arguments.split(",")]
            if "drawings" in name:
                self.assertTrue(re.search(files, "a/kink.svg") and not re.search(files, "a/kink.svg.txt"))
                self.assertEqual(self.run_in_folder(*command, "smooth.svg", "kink.svg").returncode, 1)
                self.assertEqual(self.run_in_folder(*command, "smooth.svg").returncode, 0)
            else:
                self.assertTrue(re.search(files, "a.ttf") and re.search(files, "a.woff2"))
                self.assertEqual(self.run_in_folder(*command, "smooth.ttf").returncode, 2)


if __name__ == "__main__":
    unittest.main()
