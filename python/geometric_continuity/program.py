# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program `geometric_continuity`, which reads files, for Python."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from typing import Optional, Union

from .errors import Error
from .hints import check_flag, keywords

Path = Union[str, "os.PathLike[str]"]


def program() -> str:
    """Returns the path of the program: the environment variable GEOMETRIC_CONTINUITY_PROGRAM, the program that was installed with this
    package, or the one on the path.

    Raises FileNotFoundError where there is none.
    """
    given = os.environ.get("GEOMETRIC_CONTINUITY_PROGRAM")
    if given:
        return given
    installed = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "geometric_continuity")
    if os.access(installed, os.X_OK):
        return installed
    # a script of this name may be the one that calls this function
    folders = [f for f in os.environ.get("PATH", "").split(os.pathsep) if os.path.abspath(f) != os.path.dirname(sys.executable)]
    found = shutil.which("geometric_continuity", path=os.pathsep.join(folders))
    if not found:
        raise FileNotFoundError("the program geometric_continuity is not installed: build it by demo/run, or name it in GEOMETRIC_CONTINUITY_PROGRAM")
    return found


def _argument(name: str, value) -> list:
    if name == "closed" and value is not None:
        check_flag("verify", name, value, "call verify(file, closed=True)")
    option = "--" + name.rstrip("_").replace("_", "-")
    if value is None or value is False:
        return []
    return [option] if value is True else [option, str(value)]


def _error(text: str, place: str) -> Error:
    lines = [line for line in text.splitlines() if line.startswith("geometric_continuity: ")]
    message = lines[-1].split(": ", 1)[1] if lines else text.strip() or "no output"
    code, _, rest = message.partition(": ")
    if rest and code.replace("_", "").isalpha() and "_" in code:
        where, _, reason = rest.partition(": ")
        return Error(code, where, reason or code.replace("_", " "))
    return Error("bad_input", place, message)


def _name(file) -> str:
    if not isinstance(file, (str, bytes, os.PathLike)):
        raise TypeError(f"{type(file).__name__!r} object is no file: verify() takes files; chain_joins(curve) "
                        "decides the joins of a spline or a list of curves")
    return os.fsdecode(file)


_OPTIONS = {"order": 'require="G1" asks for an order', "tolerance": 'within="0.01,1deg,5%" has tolerances of gap, angle and curvature jump'}


@keywords(**_OPTIONS)
def verify(*files: Path, timeout: Optional[float] = None, **options) -> dict:
    """Decides every join or edge of files, and returns the record that the program writes with --json, as a dict.

    files: .g2, .svg, fonts (TrueType, OpenType, Type 1, WOFF, folders of these), .step, .iges, .brep; several of one kind together, as
        the program takes them.
    options: those of `geometric_continuity verify`, with _ for -: require="G2", within="0.01,1deg,5%", closed=True, surfaces=True,
        kink_angle=3, glyphs="a-z", baseline="BASELINE.json", ...
    timeout: seconds after which the program is ended.

    A requirement that is not met is no exception: record["met"] says so. The call can be interrupted; the program is ended then.

    Raises Error for bad input, with its code, place and reason: `malformed_input`, `cannot_read_file`, ..., `bad_input` for options that
    do not fit and where there is nothing to decide, `time_limit` after the timeout; TypeError for what is no path.
    """
    names = [_name(f) for f in files]
    # a name that begins with - is no option
    arguments = [os.path.join(".", n) if n.startswith("-") and n != "-" else n for n in names]
    given = [a for name, value in options.items() for a in _argument(name, value)]
    command = [program(), "verify", "--json"] + given + arguments
    place = ", ".join(names)
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=timeout)
    except subprocess.TimeoutExpired:
        raise Error("time_limit", place, f"more than {timeout} seconds") from None
    if done.returncode not in (0, 1):
        raise _error(done.stderr.decode("utf-8", "replace"), place)
    return json.loads(done.stdout)


@keywords(**_OPTIONS)
def file_record(file: Path, *, time_limit: float = 60, memory_limit: float = 4096, **options) -> dict:
    """Verifies one file and returns the record that `geometric_continuity verify --jsonl` writes of it, as a dict: `file`, `exit_code`, and
    `claims` and `report`, or `error` with `code` and `message`; and `name_bytes` where the name is no UTF-8, `asked`, `version`, `size` and
    `sha256`, by which a record answers no other question. Bad files, crashes and limits are records, no exceptions, so that many
    files can be shared out to many processes.

    file: its name has no line break.
    time_limit: seconds of processor time; memory_limit: MiB of addresses.
    options: those of `geometric_continuity verify`, as for `verify`.

    Raises Error `bad_input` for options or a name that the program refuses.
    """
    name = _name(file)
    limits = {"time_limit": time_limit, "memory_limit": memory_limit, "jobs": 1}
    command = [program(), "verify", "--jsonl", "-"] + [a for n, v in {**limits, **options}.items() for a in _argument(n, v)]
    done = subprocess.run(command, input=os.fsencode(name) + b"\n", stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    lines = done.stdout.splitlines()
    if len(lines) != 1:
        raise _error(done.stderr.decode("utf-8", "replace"), name)
    return json.loads(lines[0])


def main() -> None:
    """Becomes the program, with the arguments of the command line."""
    os.execv(program(), ["geometric_continuity"] + sys.argv[1:])
