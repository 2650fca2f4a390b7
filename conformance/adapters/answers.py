# SPDX-License-Identifier: CC0-1.0
"""What adapters in Python have in common: one file named by arguments, or many by lines of standard input."""

import os
import sys


class Unsupported(Exception):
    """The system has no answer to such a question."""


def tolerances(text):
    """{quantity: text} of gap=0.001,angle_degrees=0.1"""
    return dict(part.split("=") for part in text.split(",")) if text else None


def serve(decide):
    """Calls decide(file, order, tolerances or None), which returns what is to be printed."""
    def answer(arguments):
        try:
            return decide(arguments[0], arguments[1], tolerances(arguments[2] if len(arguments) > 2 else ""))
        except Unsupported as reason:
            return f"unsupported {reason}"
        except Exception as error:  # whatever a foreign library throws is a refusal
            return f"refused {type(error).__name__}: {str(error).splitlines()[0] if str(error) else ''}"
    if len(sys.argv) > 1:
        print(answer(sys.argv[1:]))
        return
    # Some libraries write to standard output; the runner takes only lines that begin with "= ".
    for line in sys.stdin:
        words = line.split()
        if words:
            sys.stdout.write(f"\n= {answer(words)}\n")
            sys.stdout.flush()
    os._exit(0)
