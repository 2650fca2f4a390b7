#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Alters one token of a header at a time, and lists the alterations that no test notices:

    mutate.py [--sample N] [--seed S] [--work FOLDER] [--jobs N] [--seconds S] [--again] [--manual] [PART_OF_A_PATH...]

The unit tests, of the long ones only five, and the program are built once, by clang++, from a copy of the sources in FOLDER with all alterations of the sample; a
program chooses one of them when it runs (mutants.h). Each test case is run once without any, to see which it comes across and how long it takes. Then
each alteration meets the test cases that come across it, those of the module of the header first, the quick ones before the others, until one fails or
does not end; those that take S seconds together, at most. FOLDER/results.txt keeps what was found: another call goes on where the last one ended, and with --again tries
again what no test has noticed and nothing explains. The table counts the sample; --manual puts it into the manual. equivalent.txt lists
alterations that change no answer, with the reason.

What is known to the compiler is not altered: template arguments, lengths of arrays, constants of types. Nor is what does not compile when altered."""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import threading
from pathlib import Path

here = Path(__file__).resolve().parent
root = here.parents[1]
headers = Path("include/CGAL/Geometric_continuity")
manual = root / "doc/Geometric_continuity/What_the_program_promises.txt"

LONG_TESTS = {"parallel_tests", "test_Edge_enclosure", "test_Fair", "test_curve_from_curvatures", "program_cad", "program_cad_verdicts"}  # which alone reach what they test
OTHERS = {"+": "-", "-": "+", "*": "+", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+=": "-=", "-=": "+=", "*=": "+="}
TOKEN = re.compile(
    r'(?P<skipped>//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|\boperator\s*[^\s\w(]+'
    r"|static_assert\s*\([^;]*;|template\s*<[^;{]*>|\benum\b[^{;]*\{[^}]*\}|\bcase\b(?:[^:]|::)*:|\bCGAL_assertion\([^;]*;"
    r"|\bconst [\w:]+ \w+ = [-\d\s.*+/()<N]*;|\bconstexpr\b[^({;]*=[^;]*;|\b(?!return|else|throw)[\w:>]+ \w+(?:\[\w+\])+)"
    r"|(?P<word>[A-Za-z_]\w*)|(?P<number>\d(?:[eEpP][-+]|[\w.])*)|(?P<operator>[-+*<>=!&|/]+)|(?P<bracket>[()\[\]{}])|(?P<other>::|[?:;,])",
    re.M | re.S,
)


def is_spaced(text, token):
    return text[token.start() - 1].isspace() and text[token.end()].isspace()


def balanced(text, begin, opening, closing):
    """The end of the brackets that open at begin; of <...> those count that are no operators, which have spaces around them."""
    depth = 0
    for i in range(begin, len(text)):
        is_operator = opening == "<" and (text[i - 1] in " -" or text[i : i + 2] == "<=")
        if not is_operator and text[i] in (opening, closing):
            depth += 1 if text[i] == opening else -1
            if depth == 0:
                return i + 1
        if text[i] == ";" and opening == "<":
            return begin
    return begin


def operand_end(text, tokens, i):
    """The end of what stands on the right of && or ||, the token i."""
    depth, end = 0, 0
    for token in tokens[i + 1 :]:
        kind = token.lastgroup
        if depth == 0 and end and (token.group() in ("&&", "||") and is_spaced(text, token) or kind == "other" and token.group() != "::"):
            return end
        if kind == "bracket":
            depth += 1 if token.group() in "([{" else -1
            if depth < 0:
                return end
        if kind != "skipped" or token.group()[0] in "\"'":
            end = token.end()
    return end


def alterations(text):
    """For each alteration its line, its place in words, and which text takes the place of which so that programs can choose it, as number @."""
    found, known_to_compiler, lines, known = [], 0, text.splitlines(), collections.Counter()
    tokens = [t for t in TOKEN.finditer(text)]
    arguments = 0  # the end of the last template arguments
    for i, token in enumerate(tokens):
        word, begin, end = token.group(), *token.span()
        if token["word"] and text[end] == "<" and not text[end + 1].isspace():
            arguments = max(arguments, balanced(text, end, "<", ">"))
        if word == "if" and text.startswith("if constexpr (", begin):
            known_to_compiler = balanced(text, text.index("(", begin), "(", ")")
        if begin < known_to_compiler or begin < arguments or token["skipped"]:
            continue
        edits = None
        if token["number"] and re.fullmatch(r"\d+", word):
            edits = (f"{word} -> {int(word) + 1}", [(begin, end, f"(::mutants::is_chosen(@) ? {int(word) + 1} : {word})")])
        elif word in ("true", "false"):
            other = "false" if word == "true" else "true"
            edits = (f"{word} -> {other}", [(begin, end, f"(::mutants::is_chosen(@) ? {other} : {word})")])
        elif word in ("min", "max") and text[begin - 5 : begin] == "std::" and text[end] in "()":
            other = "max" if word == "min" else "min"
            edits = (f"{word} -> {other}", [(begin - 5, end, f"::mutants::Extremum<@, {str(word == 'min').lower()}>{{}}")])
        elif word == "!" and not is_spaced(text, token):
            edits = ("! -> nothing", [(begin, end, "::mutants::at<@> ->* ")])
        elif token["operator"] and is_spaced(text, token):
            if word in OTHERS:
                edits = (f"{word} -> {OTHERS[word]}", [(begin, end, f"{word} ::mutants::at<@> {word}")])
            elif word in ("&&", "||"):
                close = operand_end(text, tokens, i)
                chosen = "::mutants::is_chosen(@) ||" if word == "&&" else "!::mutants::is_chosen(@) &&"
                edits = (f"{word} {text[end:close].strip()} -> nothing", [(end, end, f" ({chosen} ("), (close, close, "))")])
        if edits:
            line = text.count("\n", 0, begin) + 1
            place = f"{lines[line - 1].strip()}    [{' '.join(edits[0].split())}"
            known[place] += 1
            found.append((line, f"{place}, {known[place]}]", edits[1]))
    return found


def write(path, text):
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def instrument(folder, mutants, left_out):
    """Writes the headers with all alterations, but those that are left out."""
    edits = collections.defaultdict(list)
    for number, (header, _, _, changes) in enumerate(mutants):
        if number not in left_out:
            edits[header] += [(begin, end, other.replace("@", str(number))) for begin, end, other in changes]
    names = subprocess.run(["git", "ls-files"], cwd=root, check=True, capture_output=True, text=True).stdout.split("\n")
    for name in filter(None, names):
        source, copy = root / name, folder / "source" / name
        if name in edits:
            text = source.read_text()
            for begin, end, other in sorted(edits[name], reverse=True):
                text = text[:begin] + other + text[end:]
            write(copy, with_include(text))
        elif source.exists() and (not copy.exists() or copy.read_bytes() != source.read_bytes()):
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
    write(folder / "source" / headers / "mutants.h", (here / "mutants.h").read_text())


def with_include(text):
    """The line of the include guard also includes mutants.h: the numbers of lines stay."""
    define = re.search(r"^#define \w+_H$", text, re.M)
    begin, rest = text[: define.end()], text[define.end() + 1 :]
    blank, rest = rest.split("\n", 1)
    assert not blank
    return begin + "\n#include <CGAL/Geometric_continuity/mutants.h>\n" + rest


def build(folder, mutants, jobs):
    """Builds the tests; leaves out alterations on lines that do not compile. Returns the numbers of those, and the commands of the tests."""
    file = folder / "left_out.json"
    left_out = set(json.loads(file.read_text())) if file.exists() else set()
    tests = [folder / "build" / "test" / "Geometric_continuity", folder / "build" / "test" / "tools"]
    while True:
        instrument(folder, mutants, left_out)
        options = ["-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_CXX_FLAGS=-w -Wno-c++11-narrowing -ferror-limit=0", "-DGEOMETRIC_CONTINUITY_PRECOMPILE_PACKAGE=ON"]
        options += ["-DGEOMETRIC_CONTINUITY_SHORT_TESTS_ONLY=ON"]
        command = ["cmake", "-G", "Unix Makefiles", "-S", folder / "source", "-B", folder / "build", *options]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        listed = "".join((f / "CTestTestfile.cmake").read_text() for f in tests)
        known = re.findall(r"^add_test\((?:\[=+\[)?([^\]\s]+)(?:\]=+\])? (.*)\)$", listed, re.M)
        long = set(re.findall(r"^set_tests_properties\((?:\[=+\[)?([^\]\s]+)(?:\]=+\])? PROPERTIES .*DISABLED", listed, re.M))
        commands = {name: shlex.split(command) for name, command in known if name not in long - LONG_TESTS | {"without_gmp"}}
        commands = {name: command for name, command in commands.items() if name.startswith("program_") or Path(command[0]).parent in tests}
        for name, values in re.findall(r"^set_tests_properties\((?:\[=+\[)?([^\]\s]+)(?:\]=+\])? PROPERTIES .*ENVIRONMENT \"([^\"]*)\"", listed, re.M):
            if name in commands:
                commands[name] = ["env", *values.split(";"), *commands[name]]
        helpers = {"make_cad_models", "check_cad_conversion"} & {w.rsplit("/", 1)[1] for c in commands.values() if c[0] == "env" for w in c if "=" in w}
        programs = sorted(helpers | {tested_program(command, folder).name for command in commands.values()})
        for targets in (["test_kernels"], programs):  # the precompiled headers first
            make = ["make", "-C", folder / "build", "-k", f"-j{jobs}", *targets]
            result = subprocess.run(make, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
            if result.returncode != 0:
                break
        else:
            return left_out, commands
        places = {(str(headers / p), int(line)) for p, line in re.findall(r"CGAL/Geometric_continuity/(\S+?\.h):(\d+):", result.stderr)}
        wrong = {n for n, (header, line, _, _) in enumerate(mutants) if (header, line) in places} - left_out
        (folder / "errors.txt").write_text(result.stderr)
        if not wrong:
            sys.exit(result.stderr[-20000:])
        left_out |= wrong
        file.write_text(json.dumps(sorted(left_out)))
        print(f"{len(left_out)} alterations cannot be chosen when a program runs", flush=True)


def tested_program(command, folder):
    """The program that a test runs, itself or by a script."""
    return next(Path(word) for word in command if word.startswith(str(folder / "build")))


def test_cases(commands):
    """All test cases as commands: those of a program of Boost.Test by their names, of a template together."""
    for test, command in commands.items():
        listed = subprocess.run([command[0], "--list_content"], capture_output=True, text=True, check=False)
        if listed.returncode != 0 or "*" not in listed.stderr:
            yield test, command
            continue
        path, names, leaves, disabled = [], [], set(), set()
        for line in listed.stderr.splitlines():
            depth = (len(line) - len(line.lstrip())) // 4
            path = [*path[:depth], re.sub(r"<.*", "<*", line.strip().split(":")[0].rstrip("*"))]
            leaves.discard("/".join(path[:-1]))
            names.append("/".join(path))
            leaves.add(names[-1])
            disabled |= set(names[-1:]) if not line.rstrip().endswith("*") else set()
        for name in dict.fromkeys(names):
            if name in leaves - disabled:
                yield f"{test} {name}", [*command, f"--run_test={name}"]


def run(command, folder, seconds, **variables):
    """How a command ends within so many seconds of the processor: None if well."""

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 1))

    work = folder / "work" / str(threading.get_ident())
    work.mkdir(parents=True, exist_ok=True)
    if "bash" in command:
        command = [*command[:-1], str(work / Path(command[-1]).name)]  # the last argument is the folder of the test
    try:
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        result = subprocess.run(command, cwd=work, env={**os.environ, **variables}, timeout=100 + 10 * seconds, check=False, preexec_fn=limit, **quiet)
    except subprocess.TimeoutExpired:
        return "does not end"
    if result.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "does not end"
    return None if result.returncode == 0 else "fails"


def used_time():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def run_all(folder, commands):
    """Each test case, its command, its time, and the alterations that it comes across; only those of programs that have changed are run."""
    file, reached = folder / "cases.json", folder / "reached.txt"
    known = json.loads(file.read_text()) if file.exists() else {}
    library = folder / "build" / "test" / "Geometric_continuity" / "libtest_headers.so"
    found = {}
    for name, command in test_cases(commands):
        built = max(path.stat().st_mtime for path in (tested_program(command, folder), library))
        if name in known and known[name]["built"] == built:
            found[name] = known[name]
            continue
        reached.unlink(missing_ok=True)
        begin = used_time()
        how = run(command, folder, 600, MUTANTS_REACHED=str(reached))
        if how:
            print(f"{name} {how} without any alteration", flush=True)
            continue
        across = sorted({int(n) for n in reached.read_text().split()}) if reached.exists() else []
        found[name] = {"command": [str(word) for word in command], "built": built, "seconds": used_time() - begin, "across": across}
    file.write_text(json.dumps(found))
    return [(name, case["command"], case["seconds"], set(case["across"])) for name, case in found.items()]


def module(header):
    return header[len(str(headers)) + 1 :].split("/")[0]


def key(header, place):
    return f"{header[len(str(headers)) + 1:]}: {place}"


def notices(number, header, cases, folder, seconds):
    """Tells which test case notices an alteration."""
    across = sorted((c for c in cases if number in c[3]), key=lambda c: (c[2] > 1 or module(header) not in c[0], c[2]))
    spent = 0
    for name, command, usual, _ in across:
        if spent and spent + usual > seconds:
            break
        spent += usual
        how = run(command, folder, 10 + 10 * usual, MUTANT=str(number))
        if how:
            return f"noticed: {name} {how}"
    if across:
        return "lives"
    return "does not compile" if any(~number in c[3] for c in cases) else "not reached"


def explained_alterations():
    lines = (here / "equivalent.txt").read_text().splitlines()
    return {line.split("] -- ", 1)[0] + "]" for line in lines if "] -- " in line}


def table(results):
    """The rows of the table of the manual: module, tried, noticed, equivalent, lives, not reached."""
    explained = explained_alterations()
    counts = collections.defaultdict(collections.Counter)
    for place, how in results.items():
        kind = "equivalent" if how in ("lives", "not reached") and place in explained else how.split(":")[0]
        for name in (place.split("/")[0], "all"):
            counts[name][kind] += 1
    rows = []
    for name, count in sorted(counts.items(), key=lambda c: (c[0] == "all", c[0])):
        found = [sum(count.values()), *(count[kind] for kind in ("noticed", "equivalent", "lives", "not reached"))]
        rows.append(f"| {name if name == 'all' else f'`{name}`'} | {' | '.join(map(str, found))} |")
    return rows, counts["all"]


def write_manual(rows):
    text = manual.read_text()
    head = re.search(r"^\| Module \| Tried .*\n\|.*\n", text, re.M)
    rest = re.compile(r"(?:\|.*\n)*").match(text, head.end())
    manual.write_text(text[: head.end()] + "\n".join(rows) + "\n" + text[rest.end() :])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, default=600)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--work", type=Path, default=root / "build" / "mutation")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=100)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--manual", action="store_true")
    parser.add_argument("paths", nargs="*")
    given = parser.parse_args()
    folder = given.work.resolve()
    mutants = []
    for path in sorted((root / headers).rglob("*.h")):
        header = str(path.relative_to(root))
        if not given.paths or any(part in header for part in given.paths):
            mutants += [(header, *alteration) for alteration in alterations(path.read_text())]
    # a sample that stays what it is where headers stay what they are
    mutants.sort(key=lambda m: hashlib.sha256(f"{given.seed} {m[0]} {m[2]}".encode()).digest())
    print(f"{min(given.sample, len(mutants))} of {len(mutants)} alterations", flush=True)
    mutants = mutants[: given.sample]
    (folder / "source").mkdir(parents=True, exist_ok=True)
    left_out, commands = build(folder, mutants, given.jobs)
    cases = run_all(folder, commands)
    print(f"{len(cases)} test cases, {sum(c[2] for c in cases):.0f} s; {len(left_out)} alterations do not compile", flush=True)

    file = folder / "results.txt"
    results = dict(line.split("\t") for line in file.read_text().splitlines()) if file.exists() else {}

    explained = explained_alterations()

    def is_open(number):
        place = key(mutants[number][0], mutants[number][2])
        known = results.get(place)
        return number not in left_out and (not known or given.again and known in ("lives", "not reached") and place not in explained)

    with open(file, "a", encoding="utf-8") as log, concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        chosen = [number for number in range(len(mutants)) if is_open(number)]
        running = {pool.submit(notices, number, mutants[number][0], cases, folder, given.seconds): number for number in chosen}
        for found in concurrent.futures.as_completed(running):
            number, how = running[found], found.result()
            header, line, place, _ = mutants[number]
            results[key(header, place)] = how
            log.write(f"{key(header, place)}\t{how}\n")
            log.flush()
            if how in ("lives", "not reached"):
                print(f"{how}: {header}:{line}: {place}", flush=True)
    sample = {key(header, place) for header, _, place, _ in mutants}  # not what headers have no more
    rows, counts = table({place: how for place, how in results.items() if place in sample and how != "does not compile"})
    print("module, tried, noticed, equivalent, lives, not reached", *rows, sep="\n")
    if given.manual:
        write_manual(rows)
    return 1 if counts["lives"] + counts["not reached"] else 0


sys.exit(main())
