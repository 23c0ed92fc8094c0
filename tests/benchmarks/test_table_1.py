#!/usr/bin/env python3
"""Tests of the benchmark's own parts, with a program that only pretends."""

import contextlib
import csv
import io
import math
import os
import sys
import tempfile
import unittest
import unittest.mock

import table_1
from parts import cases, figures, results, runs, tables
from parts.errors import BenchmarkError

# Obeys the method it is given: solves it, refuses it, sleeps or dies.
PRETENDER = """#!{python}
import json, os, sys, time
if "--version" in sys.argv:
    print("pretender 1.0")
    sys.exit(0)
entries = dict(word.split("=", 1) for word in sys.argv if "=" in word)
method = entries["Contact solver/Method"]
k = int(entries["Geometry/Table 1 level"])
directory = sys.argv[sys.argv.index("--output") + 1]
if method == "mpgp":
    print("stiction: no such method.", file=sys.stderr)
    sys.exit(1)
if method == "admm":
    time.sleep(60)
if method == "newton":
    os.abort()
os.makedirs(directory)
with open(directory + "/convergence.csv", "w") as file:
    file.write("step,dual_multiplications,kkt_residual\\n1,7,1e-3\\n2,9,1e-9\\n")
force = [3.0, 4.0, 0.0 if method == "gauss seidel" else 0.5]
with open(directory + "/summary.json", "w") as file:
    json.dump({{"seconds": {{"total": 1.0 * k, "dual_iteration": 0.5 * k}},
               "solver": {{"dual_multiplications": 9}},
               "contact": {{"force_on_body": force}}}}, file)
if method == "squares":
    print("NOT CONVERGED: kkt_residual is 0.01.")
    sys.exit(2)
"""


class Parsing(unittest.TestCase):
    """What comes from the command line and from the program's files."""

    def test_levels(self):
        self.assertEqual(figures.parse_levels("1-3,6,2", range(1, 7)), [1, 2, 3, 6])
        for bad in ("", "0", "7", "4-2", "1-9", "a", "1.5", "1,,2"):
            with self.assertRaises(BenchmarkError, msg=bad):
                figures.parse_levels(bad, range(1, 7))

    def test_names(self):
        allowed = {"A": "A", "nodes": "A", "B": "B"}
        self.assertEqual(figures.parse_names("--r", "b,Nodes", allowed), ["A", "B"])
        with self.assertRaisesRegex(BenchmarkError, "'C' is none of A, nodes, B"):
            figures.parse_names("--r", "A,C", allowed)

    def test_history_finds_columns_by_name(self):
        text = "kkt_residual,x,dual_multiplications\n1e-3,0,7\n1e-7,0,9.5\n"
        history = figures.parse_history(text)
        self.assertEqual(history, [[7.0, 1e-3], [9.5, 1e-7]])
        self.assertEqual(figures.products_to(history, 1e-6), 9.5)
        self.assertIsNone(figures.products_to(history, 1e-8))

    def test_history_without_the_columns_or_cut_short(self):
        self.assertEqual(figures.parse_history("step,residual\n1,2\n"), [])
        cut = "dual_multiplications,kkt_residual\n7,1e-3\n9\n11,nan\n"
        self.assertEqual(figures.parse_history(cut), [[7.0, 1e-3]])

    def test_iteration_seconds(self):
        seconds = {"contact_solve": 5.0, "stiffness_setup": 1.0, "dual_operator": 1.5}
        self.assertEqual(figures.iteration_seconds({"seconds": seconds}), 2.5)
        seconds["dual_iteration"] = 2.0
        self.assertEqual(figures.iteration_seconds({"seconds": seconds}), 2.0)
        self.assertIsNone(figures.iteration_seconds({}))
        self.assertIsNone(figures.iteration_seconds(None))

    def test_short(self):
        self.assertEqual(figures.short(1e-8), "1e-8")
        self.assertEqual(figures.short(1e-12), "1e-12")


class Figures(unittest.TestCase):
    """Exponents, differences, profiles."""

    def test_exponent_of_a_power(self):
        sizes = [10, 20, 50]
        costs = [3 * size**1.7 for size in sizes]
        self.assertAlmostEqual(figures.growth_exponent(sizes, costs), 1.7)
        costs[1] = None
        self.assertAlmostEqual(figures.growth_exponent(sizes, costs), 1.7)
        self.assertIsNone(figures.growth_exponent(sizes, [None, 0, 2.0]))

    def test_exponents_of_the_paper(self):
        sizes = [cases.table_n(k) for k in tables.EXPONENT_LEVELS]
        for method, exponent in {"ALG_GS": 1.11, "ALG_2": 2.03, "ALG_4": 1.92}.items():
            times = cases.PAPER_SECONDS[method][2:]
            self.assertAlmostEqual(
                figures.growth_exponent(sizes, times), exponent, places=2
            )

    def test_sizes_of_the_paper(self):
        self.assertEqual(
            [(cases.table_n(k), cases.table_m(k)) for k in cases.LEVELS],
            [
                (189, 54),
                (975, 180),
                (2793, 378),
                (6075, 648),
                (11253, 990),
                (18759, 1404),
            ],
        )

    def test_difference(self):
        self.assertAlmostEqual(figures.relative_difference([3, 4], [3, 3]), 1 / 18**0.5)
        self.assertIsNone(figures.relative_difference(None, [3, 3]))
        self.assertIsNone(figures.relative_difference([1, 1], [0, 0]))

    def test_ratio(self):
        self.assertEqual(figures.ratio(3.0, 2.0), 1.5)
        self.assertIsNone(figures.ratio(3.0, None))
        self.assertIsNone(figures.ratio(None, 2.0))

    def test_profile(self):
        # the third problem is solved by nobody, the second by b alone
        costs = {"a": [1.0, None, None], "b": [3.0, 5.0, None]}
        profile = figures.performance_profile(costs)
        self.assertEqual(profile["a"], [(1.0, 0.5)])
        self.assertEqual(profile["b"], [(1.0, 0.5), (3.0, 1.0)])
        self.assertEqual(figures.performance_profile({"a": [None]}), {"a": []})


class Resuming(unittest.TestCase):
    """Which stored runs are taken for which cases."""

    def test_key_depends_on_everything(self):
        arguments = [["A/a=1", "B/b=2"], "text", 1, "program 1"]
        key = runs.run_key(*arguments)
        self.assertEqual(key, runs.run_key(["B/b=2", "A/a=1"], *arguments[1:]))
        others = [["A/a=1", "B/b=3"], "text 2", 2, "program 2"]
        for position, other in enumerate(others):
            changed = arguments[:position] + [other] + arguments[position + 1 :]
            self.assertNotEqual(key, runs.run_key(*changed), other)

    def test_no_two_cases_have_the_same_settings(self):
        chosen = cases.all_cases(cases.LEVELS, "AB", cases.LAWS, list(cases.METHOD))
        keys = {(c.parameter_file, *sorted(c.settings(1e-8))) for c in chosen}
        self.assertEqual(len(keys), len(chosen))

    def test_finished(self):
        self.assertFalse(runs.is_finished(None, 10))
        self.assertFalse(runs.is_finished({"status": runs.ERROR}, 10))
        self.assertTrue(runs.is_finished({"status": runs.NOT_CERTIFIED}, 10))
        over = {"status": runs.LIMIT, "limit": 10}
        self.assertTrue(runs.is_finished(over, 10))
        self.assertFalse(runs.is_finished(over, 11))

    def test_store(self):
        with tempfile.TemporaryDirectory() as directory:
            store = runs.Store(directory)
            self.assertEqual(store.load(), {})
            store.save("a", {"key": "1", "wall": 2.0})
            store.save("b", {"key": "2", "wall": 3.0})
            with open(os.path.join(store.directory, "b-2.json"), "r+") as file:
                file.truncate(10)
            with contextlib.redirect_stdout(io.StringIO()) as said:
                self.assertEqual(store.load(), {"1": {"key": "1", "wall": 2.0}})
            self.assertIn("b-2.json", said.getvalue())
            store.clear()
            self.assertEqual(store.load(), {})


class WholeBenchmark(unittest.TestCase):
    """From the command line to table_1.csv, without the plots."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = os.path.join(folder.name, "pretender")
        with open(self.program, "w", encoding="utf-8") as file:
            file.write(PRETENDER.format(python=sys.executable))
        os.chmod(self.program, 0o755)
        # The tests run where matplotlib may be missing: nobody has it here.
        hidden = unittest.mock.patch.dict(sys.modules, {"matplotlib": None})
        hidden.start()
        self.addCleanup(hidden.stop)

    def call(self, *arguments):
        """(exit status, stdout, stderr) of the benchmark."""
        said, complained = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
            status = table_1.main(
                ["--program", self.program, "--output", self.folder, *arguments]
            )
        return status, said.getvalue(), complained.getvalue()

    def read(self):
        """{(k, method): row} of table_1.csv."""
        with open(os.path.join(self.folder, "table_1.csv"), encoding="utf-8") as file:
            return {(row["k"], row["method"]): row for row in csv.DictReader(file)}

    def test_every_way_to_end(self):
        choice = ["--readings", "A", "--laws", "given", "--k", "1-2"]
        choice += ["--limit", "1", "--methods", "ALG_GS,ALG_2,MPGP,Newton,ADMM"]
        status, said, complained = self.call(*choice)
        self.assertEqual((status, complained), (0, ""), said)
        rows = self.read()
        ends = {key: row["status"] for key, row in rows.items()}
        self.assertEqual(ends["1", "ALG_GS"], "certified")
        self.assertEqual(ends["1", "ALG_2"], "not certified")
        self.assertEqual(ends["1", "MPGP"], "error")
        self.assertEqual(rows["1", "MPGP"]["message"], "no such method.")
        self.assertEqual(ends["1", "Newton"], "crashed")
        self.assertEqual(ends["1", "ADMM"], "time limit")
        self.assertEqual(ends["2", "ADMM"], results.SKIPPED)
        self.assertEqual(rows["2", "ALG_GS"]["iteration_s"], "1.0")
        self.assertEqual(rows["1", "ALG_GS"]["products_to_1e-6"], "9.0")
        self.assertEqual(rows["1", "ALG_2"]["force_reference"], "ALG_GS")
        self.assertAlmostEqual(float(rows["1", "ALG_2"]["force_difference"]), 0.1)
        self.assertTrue(math.isfinite(float(rows["1", "ALG_GS"]["memory_MB"])))
        with open(os.path.join(self.folder, "table_1.md"), encoding="utf-8") as file:
            self.assertIn("> 1 s", file.read())
        # nothing is left of the runs but their figures
        self.assertFalse([n for n in os.listdir(self.folder) if "running" in n])

    def test_a_second_call_repeats_nothing(self):
        choice = ["--readings", "B", "--k", "1", "--methods", "ALG_GS"]
        self.assertIn("to run", self.call(*choice, "--list")[1])
        self.assertIn("[  2/2]", self.call(*choice)[1])
        self.assertIn("2 of 2 runs are stored already", self.call(*choice)[1])
        self.assertIn("[  1/2]", self.call(*choice, "--fresh")[1])
        with open(self.program, "a", encoding="utf-8") as file:
            file.write("# another build\n")
        self.assertEqual(self.call(*choice, "--report-only")[0], 0)
        other = self.call(*choice, "--report-only", "--tolerance", "1e-6")
        self.assertEqual(other[2], "benchmark: none of the chosen runs is stored.\n")
        self.assertIn("[  1/2]", self.call(*choice)[1])

    def test_bad_options(self):
        for bad in (
            ["--k", "7"],
            ["--methods", "magic"],
            ["--laws", "Amontons"],
            ["--limit", "-1"],
            ["--tolerance", "0"],
            ["--threads", "1.5"],
            ["--unknown"],
            ["--report-only"],
            ["--fresh", "--list"],
            ["--laws", "coulomb", "--methods", "ALG_2"],
            ["--program", "/nowhere"],
            ["--output", self.program],
        ):
            status, said, complained = self.call(*bad)
            self.assertEqual((status, said), (1, ""), bad)
            self.assertRegex(complained, r"\Abenchmark: .*\.\n\Z", bad)


class Reporting(unittest.TestCase):
    """Single cells of the tables."""

    def test_seconds(self):
        shown = {None: "–", 0.0123: "0.0123", 1.234: "1.23", 12.34: "12.3"}
        for value, text in shown.items():
            self.assertEqual(tables.seconds(value), text)


if __name__ == "__main__":
    unittest.main()
