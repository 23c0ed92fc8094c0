#!/usr/bin/env python3
"""Tests of the benchmark of products, with a program that only pretends."""

import contextlib
import csv
import io
import os
import stat
import sys
import tempfile
import unittest

import products

PRETENDER = """#!{python}
import json, sys
level = int(sys.argv[1])
if level == 8:
    sys.exit("too large")
for cells in ("congruent", "general"):
    for product, seconds in (("FEEvaluation", 0.5), ("baseline", 0.0625)):
        print(json.dumps(dict(level=level, dofs=1000 * level, cells=cells,
            number="double", product=product, best_seconds=seconds,
            median_seconds=seconds, bytes=int(sys.argv[2]))))
"""


class Products(unittest.TestCase):
    """From the command line to the tables."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.output = os.path.join(directory.name, "output")
        self.program = os.path.join(directory.name, "program")
        with open(self.program, "w", encoding="utf-8") as file:
            file.write(PRETENDER.format(python=sys.executable))
        os.chmod(self.program, stat.S_IRWXU)

    def run_benchmark(self, *arguments):
        """The exit status and what was said."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            status = products.main(
                ["--program", self.program, "--output", self.output, *arguments]
            )
        return status, said.getvalue()

    def test_tables(self):
        """Rates and ratios are right in both files."""
        status, said = self.run_benchmark("--levels", "2-3", "--repetitions", "7")
        self.assertEqual(status, 0, said)
        with open(os.path.join(self.output, "products.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 8)
        self.assertEqual(rows[1]["ratio"], "8.0")
        self.assertEqual(rows[1]["dofs_per_second"], "32000.0")
        self.assertEqual(rows[1]["bytes"], "7")
        with open(os.path.join(self.output, "products.md"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn("## Level 3: 3000 unknowns", text)
        self.assertIn("| baseline | 0.0 (8.0) | 0.0 (8.0) |", text)

    def test_errors(self):
        """One sentence each."""
        for arguments, expected in (
            (["--levels", "0"], "'0' is no number or range from 1 to 8"),
            (["--levels", "8"], "failed: too large"),
            (["--repetitions", "0"], "--repetitions must be at least 1"),
            (["--program", "/nowhere"], "cannot run '/nowhere'"),
        ):
            status, said = self.run_benchmark(*arguments)
            self.assertEqual(status, 1)
            self.assertIn(expected, said)


if __name__ == "__main__":
    unittest.main()
