#!/usr/bin/env python3
"""Which lines of the program no test ran.

Call:   tests/coverage/coverage.py BUILD [--lines]

BUILD is a directory of its own, in which tests were run:

    cmake -S . -B BUILD -G Ninja -DCMAKE_CXX_FLAGS=--coverage
    ninja -C BUILD all stiction_test_executables && ctest --test-dir BUILD

Prints the part of the lines of source/ and include/ that ran, for each file and in all;
with --lines those that did not.
"""

import collections
import glob
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def counts(build):
    """How often each line ran: by file and number."""
    total = collections.defaultdict(collections.Counter)
    for data in glob.glob(os.path.join(build, "**", "*.gcda"), recursive=True):
        report = subprocess.run(["gcov", "--json-format", "--stdout", data], cwd=build,
                                capture_output=True, text=True, check=True).stdout
        for part in report.splitlines():
            for file in json.loads(part)["files"]:
                path = os.path.normpath(os.path.join(build, file["file"]))
                name = os.path.relpath(path, ROOT)
                if name.startswith(("source/", "include/")):
                    for line in file["lines"]:
                        total[name][line["line_number"]] += line["count"]
    return total


def main():
    """Print."""
    if len(sys.argv) < 2 or not os.path.isdir(sys.argv[1]):
        sys.exit(__doc__)
    build = os.path.abspath(sys.argv[1])
    n_all = n_run = 0
    for name, lines in sorted(counts(build).items()):
        missed = sorted(line for line, count in lines.items() if count == 0)
        n_all += len(lines)
        n_run += len(lines) - len(missed)
        print(f"{100 * (1 - len(missed) / len(lines)):5.1f} %  {name}")
        if missed and "--lines" in sys.argv:
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                text = file.read().split("\n")
            for line in missed:
                print(f"         {line:4d}  {text[line - 1]}")
    if n_all == 0:
        sys.exit(f"{build} holds no counts of lines")
    print(f"{100 * n_run / n_all:5.1f} %  of {n_all} lines")


if __name__ == "__main__":
    main()
