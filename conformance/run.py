#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Measures a system by the suite:  run.py --adapter ADAPTER [--formats json,svg] [--only PREFIX] [--json OUT] [--list CATEGORY]

ADAPTER is a name of the folder adapters/, or a command. The command is called as

    COMMAND FILE ORDER [TOLERANCES]      e.g. COMMAND data/plane/gap-at-bound.g2 G2 gap=0.001,angle_degrees=0.1,curvature_percent=2

and prints one line: the order that it finds, up to ORDER, or that it gives no answer. FORMAT.md has the words."""

import argparse
import json
import os
import selectors
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

HERE = Path(__file__).resolve().parent
CATEGORIES = ("right", "within its tolerance", "false smooth", "false kink", "refused", "unsupported")
QUESTIONS = ("position", "tangent", "curvature", "torsion", "C orders", "tolerances")
# Half a turn in degrees over half a turn in radians, from below and from above.
DEGREES = (Fraction("57.29577951308232087"), Fraction("57.29577951308232088"))
LEVELS = (("gap",), ("angle_degrees", "angle_radians"), ("curvature_percent", "curvature_jump"), ("torsion_jump",))


def number(text):
    return Fraction(text) if "/" in text else Fraction(Decimal(text))


def records():
    for path in sorted((HERE / "records").glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            yield json.loads(line)


def level(order):
    return -1 if order == "gap" else int(order[1])


def tolerances(text):
    """{quantity: number} of gap=0.001,angle_degrees=0.1; angles are in degrees then."""
    result = {}
    for part in filter(None, text.split(",")):
        key, _, value = part.partition("=")
        if key == "angle_radians":
            result["angle_degrees"] = number(value) * DEGREES[1]
        else:
            result[key] = number(value)
    return result


def measure(record, names, key_of_tolerance=None):
    for key in names:
        if record.get(key) is not None and key_of_tolerance in (None, key):
            return key, [number(x) for x in record[key]]
    return None, None


def orders_within(record, claimed):
    """The orders, lowest and highest, that are right for a system with these tolerances. What it does not name is 0."""
    low = high = -1
    for i, names in enumerate(LEVELS):
        given = [k for k in names if k in claimed]
        key, value = measure(record, names, given[0] if given else None)
        if key == "angle_radians":
            value = [x * d for x, d in zip(value, DEGREES)]
        tolerance = claimed.get(given[0] if given else key, 0)
        exact = level(record["order"])
        if value is None:
            # Infinite where a derivative vanishes; else a lower order fails.
            holds = (exact >= i, exact >= i or not record.get("stops"))
        else:
            holds = (value[1] <= tolerance, value[0] <= tolerance)
            if exact >= i:
                holds = (True, True)
        if holds[0] and low == i - 1:
            low = i
        if holds[1] and high == i - 1:
            high = i
    return low, high


def judge(record, answer):
    """The category of an answer, and the order that it says."""
    words = answer.split(None, 1)
    word, rest = (words + ["", ""])[:2]
    if word in ("unsupported", "refused"):
        return word
    if word == "undecided":
        return "refused"
    at_least = word.endswith("+")
    word = word.rstrip("+")
    most, true = level(record["up_to"]), level(record["order"])
    if word != "gap" and (len(word) != 2 or word[0] not in "CGF" or not word[1].isdigit()):
        return "refused"
    if (word[0] == "C") != (record["up_to"][0] == "C") and word != "gap":
        return "unsupported"
    said = min(level(word), most)
    claimed = tolerances(rest.partition("within")[2].strip()) if "within" in rest else {}
    if said == true and not (at_least and said < most):
        return "right"
    if at_least and said < most and true >= said:
        return "unsupported"  # as far as it goes it is right, and the question goes further
    if claimed and "derivative_jumps" in record:
        bounds = [claimed.get("gap", 0)] + [claimed.get("derivative_jump", 0)] * most
        for k in (0, 1):  # the lowest order that is right within the tolerance, and the highest
            holds = [number(pair[1 - k]) <= b for pair, b in zip(record["derivative_jumps"], bounds)]
            reached = next((i - 1 for i, h in enumerate(holds) if not h), most)
            if said == reached or (at_least and said < reached):
                return "within its tolerance"
    if claimed and "within" not in record and record["up_to"][0] != "C":
        low, high = orders_within(record, claimed)
        if min(low, most) <= said <= min(high, most) or (at_least and said < min(low, most)):
            return "within its tolerance"
    return "false smooth" if said > true else "false kink"


class Adapter:
    """A command, or a named one with what is said of it."""

    def __init__(self, text, formats):
        path = HERE / "adapters" / text / "adapter.json"
        self.about = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
        self.folder = path.parent if self.about else Path.cwd()
        self.command = [os.path.expandvars(w) for w in (self.about.get("command") or shlex.split(text))]
        self.formats = formats.split(",") if formats else self.about.get("formats") or ["json", "g2", "svg", "ttf", "otf", "step", "xodr"]
        self.stream = self.about.get("stream", False)
        self.name = self.about.get("name", text)
        self.process = None
        self.time_limit = float(self.about.get("time_limit", 60))

    def prepare(self):
        """Builds what is to be compiled. Returns what is missing."""
        build = self.about.get("build")
        if build:
            done = subprocess.run(build, cwd=self.folder, capture_output=True, text=True)
            if done.returncode:
                return (done.stderr or done.stdout).strip()
        return None

    def version(self):
        command = self.about.get("version")
        if not command:
            return ""
        try:
            done = subprocess.run([os.path.expandvars(w) for w in command], cwd=self.folder, capture_output=True, text=True, timeout=60)
        except (OSError, subprocess.TimeoutExpired):
            return ""
        return (done.stdout.strip().splitlines() or [""])[-1]

    def ask(self, arguments):
        if not self.stream:
            try:
                done = subprocess.run(self.command + arguments, cwd=self.folder, capture_output=True, text=True, timeout=self.time_limit)
            except subprocess.TimeoutExpired:
                return f"refused after {self.time_limit:g} s"
            except OSError as error:
                return f"refused {error}"
            line = (done.stdout.strip().splitlines() or [""])[-1]
            return line if line and done.returncode in (0, 1) else f"refused exit code {done.returncode}: {(done.stderr.strip().splitlines() or [''])[-1]}"
        if self.process is None:
            self.process = subprocess.Popen(self.command, cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0)
            self.unread = b""
        try:
            self.process.stdin.write((" ".join(arguments) + "\n").encode())
            end = time.monotonic() + self.time_limit
            with selectors.DefaultSelector() as selector:
                selector.register(self.process.stdout, selectors.EVENT_READ)
                while True:
                    line, newline, rest = self.unread.partition(b"\n")
                    if newline:
                        self.unread = rest
                        if line.startswith(b"= "):  # other lines are what the system itself prints
                            return line[2:].decode(errors="replace").strip()
                        continue
                    if not selector.select(max(0, end - time.monotonic())):
                        break
                    more = os.read(self.process.stdout.fileno(), 65536)
                    if not more:
                        raise BrokenPipeError
                    self.unread += more
            self.close()
            return f"refused after {self.time_limit:g} s"
        except (BrokenPipeError, OSError):
            code = self.process.wait()
            self.process = None
            return f"refused the process ended with {code}"

    def close(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process = None


def ask(adapter, record, extension):
    result = {"id": record["id"], "question": record["question"], "order": record["order"], "format": extension, "why": record["why"]}
    if record["flips"]:
        result.update({"quantity": record["flips"]["tolerance"], "measure": record["flips"]["at"][0]})
    result["answer"] = "unsupported format"
    if extension is not None:
        within = ",".join(f"{k}={v}" for k, v in record.get("within", {}).items())
        result["answer"] = adapter.ask([str(HERE / record["files"][extension]), record["up_to"]] + ([within] if within else []))
    result["category"] = judge(record, result["answer"])
    return result


def table(results):
    """Counts by question, and the worst of each."""
    lines = [f"{'':12}" + "".join(f"{c:>22}" if c == CATEGORIES[1] else f"{c:>14}" for c in CATEGORIES)]
    for question in QUESTIONS + ("all",):
        chosen = [r for r in results if question in ("all", r["question"])]
        counts = [sum(r["category"] == c for r in chosen) for c in CATEGORIES]
        lines.append(f"{question:12}" + "".join(f"{n:>{22 if c == CATEGORIES[1] else 14}}" for c, n in zip(CATEGORIES, counts)))
    return lines


def badness(result):
    """False smooth: how large what was passed over is. False kink: all alike."""
    at = result.get("measure")
    scale = {"gap": 0, "angle_degrees": 3, "angle_radians": 3, "curvature_percent": 2, "torsion_jump": 1}
    return (scale.get(result.get("quantity"), 0), number(at) if at else 0)


def worst(results):
    for category in ("false smooth", "false kink"):
        for question in QUESTIONS:
            chosen = [r for r in results if r["category"] == category and r["question"] == question]
            if chosen:
                r = max(chosen, key=badness)
                size = f", {r['quantity']} {float(number(r['measure'])):.3g}" if r.get("measure") else ""
                yield f"worst {category}, {question}: {r['id']} is {r['order']}, said {r['answer']}{size}\n  {r['why']}"


def worse(results, expected, only, formats):
    """Prints the answers that are not as good as those expected, and those that are missing."""
    grade = {c: i for i, c in enumerate(("right", "within its tolerance", "unsupported", "refused", "false kink", "false smooth"))}
    count = 0
    for r in results:
        before = expected.pop((r["id"], r["format"]), "unsupported")
        if grade[r["category"]] > grade[before]:
            count += 1
            print(f"worse: {r['id']} ({r['format']}) is {r['order']}, said {r['answer']}: {r['category']}, expected {before}")
    for name, format in expected:
        if name.startswith(only) and format in formats:
            count += 1
            print(f"missing: {name} ({format}) was not asked")
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--adapter", required=True, help="a name of adapters/, or a command")
    parser.add_argument("--formats", help="the formats that the adapter reads, the best first")
    parser.add_argument("--every-format", action="store_true", help="ask for each file of a record in these formats, not only the best one")
    parser.add_argument("--only", default="", help="only records whose names begin so")
    parser.add_argument("--json", help="write the answers to this file")
    parser.add_argument("--list", action="append", default=[], help="print the answers of a category, too")
    parser.add_argument("--jobs", type=int, default=1, help="ask so many at a time")
    parser.add_argument("--expect", help="exit code 1 if an answer is worse than in this file, which --json has written")
    options = parser.parse_args()
    adapter = Adapter(options.adapter, options.formats)
    missing = adapter.prepare()
    if missing:
        print(f"run.py: {adapter.name} cannot be built: {missing}", file=sys.stderr)
        return 2
    begin, asked = time.monotonic(), []
    for record in records():
        if record["id"].startswith(options.only):
            chosen = [f for f in adapter.formats if f in record["files"]]
            asked += [(record, f) for f in (chosen if options.every_format else chosen[:1] or [None])]
    # Each job has an adapter of its own, and takes every n-th question.
    results = [None] * len(asked)

    def work(k):
        own = adapter if k == 0 else Adapter(options.adapter, options.formats)
        for i in range(k, len(asked), options.jobs):
            results[i] = ask(own, *asked[i])
        own.close()
    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(work, range(options.jobs)))
    if not results:
        print("run.py: no record", file=sys.stderr)
        return 2
    version = adapter.version()
    print(f"{adapter.name} {version}".strip() + f": {len(results)} answers in {time.monotonic() - begin:.1f} s")
    print("\n".join(table(results)))
    print("\n".join(worst(results)))
    for category in options.list:
        for r in results:
            if r["category"] == category:
                print(f"{category}: {r['id']} ({r['format']}) is {r['order']}, said {r['answer']}")
    if options.json:
        head = {"system": adapter.name, "version": version, "suite": (HERE / "records/VERSION").read_text().strip(),
                **{k: adapter.about[k] for k in ("promises", "asked") if k in adapter.about}}
        # Answers that are not supported have no line.
        lines = [json.dumps({k: r[k] for k in ("id", "format", "answer", "category")}) for r in results if r["category"] != "unsupported"]
        Path(options.json).write_text(json.dumps(head)[:-1] + ', "answers": [\n' + ",\n".join(lines) + "\n]}\n", encoding="utf-8")
    if options.expect:
        expected = json.loads(Path(options.expect).read_text(encoding="utf-8"))["answers"]
        return 1 if worse(results, {(a["id"], a["format"]): a["category"] for a in expected}, options.only, adapter.formats) else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
