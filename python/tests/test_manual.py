# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The blocks of the page "From Python" of the manual, and that of the README, are run in their order, and print what is said there."""

import contextlib
import importlib.util
import io
import os
import re
import shutil
import tempfile
import unittest

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PAGE = os.path.join(TOP, "doc", "Geometric_continuity", "From_Python.txt")


class Manual(unittest.TestCase):
    def test_readme(self):
        with open(os.path.join(TOP, "README.md"), encoding="utf-8") as file:
            ((code, expected),) = re.findall(r"```python\n(.*?)```\n```\n(.*?)```", file.read(), re.DOTALL)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, "README.md", "exec"), {})
        self.assertEqual(printed.getvalue(), expected)

    def test_blocks(self):
        with open(PAGE, encoding="utf-8") as file:
            text = file.read()
        blocks = re.findall(r"\\code\{\.py\}\n(.*?)\\endcode\n(?:\\verbatim\n(.*?)\\endverbatim\n)?", text, re.DOTALL)
        self.assertGreaterEqual(len(blocks), 5)
        names, before = {}, os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for code, expected in blocks:
                    if "import matplotlib" in code and importlib.util.find_spec("matplotlib") is None:
                        continue
                    printed = io.StringIO()
                    with contextlib.redirect_stdout(printed):
                        exec(compile(code, "From_Python.txt", "exec"), names)
                    self.assertEqual(printed.getvalue(), expected or "", code)
                    if "savefig" in code and os.environ.get("FIGURES"):  # to draw them anew
                        shutil.copy("from_python.svg", os.environ["FIGURES"])
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
