# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What continuous integration calls: the commands of action.yml and .pre-commit-hooks.yaml are run as they stand there."""

import glob
import importlib.util
import json
import os
import re
import shutil
import subprocess
import tempfile
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

    @unittest.skipIf(importlib.util.find_spec("yaml") is None, "not installed: yaml")
    def test_action(self):
        import yaml

        action = yaml.safe_load(read("action.yml"))
        self.assertEqual(action["runs"]["using"], "composite")
        defaults = {name: given.get("default") for name, given in action["inputs"].items()}

        def run(action_path, **inputs):
            """The steps in their order, as GitHub runs them: with what they say about the environment, until one fails."""
            values = {**{f"inputs.{name}": value for name, value in {**defaults, **inputs}.items()}, "github.action_path": action_path}

            def value(text):
                return re.sub(r"\$\{\{ *([\w.]+) *\}\}", lambda match: values[match.group(1)], text)

            for step in action["runs"]["steps"]:
                self.assertEqual(step["shell"], "bash")
                done = self.run_in_folder("bash", "--noprofile", "--norc", "-e", "-o", "pipefail", "-c", value(step["run"]),
                                          **{name: value(text) for name, text in step.get("env", {}).items()})
                if done.returncode != 0:
                    break
            return done.returncode

        def results(name):
            with open(os.path.join(self.folder, name)) as file:
                report = json.load(file)
            if importlib.util.find_spec("jsonschema"):
                import jsonschema

                schema = glob.glob(os.path.join(TOP, "test", "tools", "schemas", "sarif*.json"))
                with open(schema[0]) as file:
                    jsonschema.validate(report, json.load(file))
            return [r["ruleId"] for r in report["runs"][0]["results"] if r["level"] == "error"]

        # what is built is not built again
        self.assertEqual(run("/nowhere", files="smooth.svg kink.svg"), 1)
        self.assertEqual(results(defaults["sarif"]), ["kink"])
        self.assertEqual(run("/nowhere", files="smooth.svg"), 0)
        self.assertEqual(results(defaults["sarif"]), [])
        self.assertEqual(run("/nowhere", files="kink.svg", options="--require G1 --summary", sarif="known.sarif"), 1)
        self.assertEqual(run("/nowhere", files="smooth.svg kink.svg", baseline="known.sarif", sarif="new.sarif"), 0)
        self.assertEqual(results("new.sarif"), [])
        self.assertEqual(run("/nowhere", files="missing.svg"), 2)
        # what is not built is built by python/install, with the folder as its argument
        os.unlink(os.path.join(self.folder, "geometric_continuity", "bin", "geometric_continuity"))
        os.makedirs(os.path.join(self.folder, "action", "python"))
        with open(os.path.join(self.folder, "action", "python", "install"), "w") as file:
            file.write(f'#!/bin/sh\nln -s "{os.path.abspath(gc.program())}" "$1/bin/geometric_continuity"\n')
        os.chmod(file.name, 0o755)
        self.assertEqual(run(os.path.join(self.folder, "action"), files="kink.svg"), 1)

    @unittest.skipUnless(shutil.which("pre-commit") and shutil.which("git"), "not installed: pre-commit")
    def test_hooks(self):
        """pre-commit itself, on a repository whose hooks are those of this one."""
        def git(folder, *arguments):
            subprocess.run(["git", "-C", folder, "-c", "user.name=a", "-c", "user.email=a@example.com", "-c", "init.defaultBranch=main", *arguments],
                           check=True, stdout=subprocess.DEVNULL)

        hooks, drawings = os.path.join(self.folder, "hooks"), os.path.join(self.folder, "drawings")
        os.makedirs(os.path.join(hooks, "python"))
        for name in (".pre-commit-hooks.yaml", "python/hook"):
            shutil.copy(os.path.join(TOP, name), os.path.join(hooks, name))
        os.makedirs(drawings)
        os.rename(os.path.join(self.folder, "kink.svg"), os.path.join(drawings, "kink.svg"))
        os.rename(os.path.join(self.folder, "smooth.svg"), os.path.join(drawings, "smooth.svg"))
        for folder in (hooks, drawings):
            git(folder, "init", "-q")
            git(folder, "add", ".")
            git(folder, "commit", "-qm", "first")
        with open(os.path.join(drawings, ".pre-commit-config.yaml"), "w") as file:
            file.write(f"repos:\n- repo: {hooks}\n  rev: HEAD\n  hooks:\n  - id: geometric-continuity-drawings\n  - id: geometric-continuity-fonts\n")
        environment = dict(self.environment, PRE_COMMIT_HOME=os.path.join(self.folder, "home"), GEOMETRIC_CONTINUITY_PROGRAM=gc.program(),
                           GIT_CONFIG_COUNT="1", GIT_CONFIG_KEY_0="protocol.file.allow", GIT_CONFIG_VALUE_0="always")

        def run(*files):
            done = subprocess.run(["pre-commit", "run", "--files", *files], cwd=drawings, env=environment, stdout=subprocess.PIPE)
            return done.returncode, done.stdout.decode()

        code, text = run("smooth.svg", "kink.svg")
        self.assertEqual(code, 1, text)
        self.assertRegex(text, r"joins of drawings\.+Failed")
        self.assertRegex(text, r"joins of fonts\.+\(no files to check\)Skipped")
        self.assertIn("kink.svg", text)
        code, text = run("smooth.svg")
        self.assertEqual(code, 0, text)
        self.assertRegex(text, r"joins of drawings\.+Passed")
        # a report for other tools besides
        with open(os.path.join(drawings, ".pre-commit-config.yaml"), "a") as file:
            file.write("    args: [--sarif, fonts.sarif, --require, G1]\n")
        with open(os.path.join(drawings, ".pre-commit-config.yaml")) as file:
            config = file.read().replace("-drawings\n", "-drawings\n    args: [--sarif, found.sarif, --require, G1]\n")
        with open(os.path.join(drawings, ".pre-commit-config.yaml"), "w") as file:
            file.write(config)
        code, text = run("smooth.svg", "kink.svg")
        self.assertEqual(code, 1, text)
        self.assertIn("kink.svg", text)
        with open(os.path.join(drawings, "found.sarif")) as file:
            results = json.load(file)["runs"][0]["results"]
        self.assertTrue(results and all("kink.svg" in json.dumps(result["locations"]) for result in results))
        with open(os.path.join(drawings, "a.ttf"), "w") as file:
            file.write("no font")
        code, text = run("a.ttf")
        self.assertRegex(text, r"joins of fonts\.+Failed")
        self.assertFalse(glob.glob(os.path.join(drawings, "fonts.sarif*")))


if __name__ == "__main__":
    unittest.main()
