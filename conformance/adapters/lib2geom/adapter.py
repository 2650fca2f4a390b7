# SPDX-License-Identifier: CC0-1.0
"""lib2geom, the geometry of Inkscape: the derivatives of the curves that it reads from path data."""

import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from answers import Unsupported, claim, least, order_of_derivatives, serve  # noqa: E402


def decide(file, order, within):
    text = Path(file).read_text(encoding="utf-8")
    found = re.findall(r'<(\w+)([^>]*)>', text)
    names = [name for name, _ in found]
    if names != ["svg", "path"] or "transform" in text:
        raise Unsupported("what is more than one path")
    if 'fill="none"' not in text and "Z" not in text.upper():
        raise Unsupported("what filling closes")
    data = re.search(r'\sd="([^"]*)"', text).group(1)
    done = subprocess.run([str(HERE / "build/derivatives"), data], capture_output=True, text=True, timeout=20)
    if done.returncode:
        raise RuntimeError(done.stderr.strip() or f"exit code {done.returncode}")
    orders = []
    for part in done.stdout.split("path ")[1:]:
        closed, *lines = part.splitlines()
        rows = [[float(x) for x in line.split()] for line in lines if line.strip()]
        spans = []
        for v in rows:
            n = len(v) // 4  # rows of each side
            spans.append([[v[2 * (side * n + k) : 2 * (side * n + k) + 2] for k in range(n)] for side in (0, 1)])
        pairs = list(zip(spans, spans[1:])) + ([(spans[-1], spans[0])] if closed == "1" and spans else [])
        orders += [order_of_derivatives(a[1], b[0], order, within) for a, b in pairs]
    if not orders:
        raise RuntimeError("no join")
    return least(orders) if within else claim(least(orders))


serve(decide)
