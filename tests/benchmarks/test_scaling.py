#!/usr/bin/env python3
"""Tests of the benchmark of scaling, with programs that only pretend."""

import contextlib
import csv
import io
import json
import os
import re
import sys
import tempfile
import unittest
import unittest.mock
from dataclasses import replace

import scaling
from parts import figures, machine, runs, scaling_cases, stream, weak_scaling
from parts.errors import BenchmarkError
from parts.scaling_cases import Case, Size
from parts.scaling_results import Results

# A solver of optimal cost, unless the environment says what is wrong with it.
PRETENDER = """#!{python}
import json, os, sys, time
if "--version" in sys.argv:
    print("pretender 1.0")
    sys.exit(0)
wrong = os.environ.get("PRETENDED_FAULT", "")
ranks = int(os.environ.get("PRETENDED_RANKS", "1"))
entries = dict(word.split("=", 1) for word in sys.argv if "=" in word)
get = entries.get
directory = sys.argv[sys.argv.index("--output") + 1]
refinement = int(get("Geometry/Global refinement", 0))
dofs = 3
for n in get("Geometry/Subdivisions", "26,18,12").split(","):
    dofs *= int(n) * 2**refinement + 1
if wrong == "memory" and refinement == 6:
    print("stiction: 9 cells that need 9 GB of memory, 1 GB are here.",
          file=sys.stderr)
    if ranks > 1:
        print("mpirun has a long story to tell", file=sys.stderr)
    sys.exit(1)
if wrong == "slow" and refinement >= 4:
    time.sleep(60)
elastic = 1e-6 * dofs / ranks
steps, krylov = 5, 12
if wrong == "everything":
    elastic *= ranks
    steps += int(float(get("Friction/Coefficient", 0)) > 1) * 8
    krylov = 24 if dofs < 1e6 else 40
    if "Lengths=4000" in " ".join(sys.argv):
        steps += 1
contact = 1.5 * elastic * (dofs / 1e5) ** (0.4 if wrong == "everything" else 0)
os.makedirs(directory)
with open(directory + "/summary.json", "w") as file:
    json.dump(dict(
        converged=True,
        problem=dict(dofs=dofs, contact_nodes=int(dofs ** (2 / 3))),
        solver=dict(newton_steps=steps, krylov_iterations=krylov,
            coarse_krylov_iterations=20, elastic_solve_iterations=10, fallbacks=0,
            levels=[dict(dofs=120, newton_steps=2, krylov_iterations=20),
                    dict(dofs=dofs, newton_steps=steps, krylov_iterations=krylov)]),
        seconds=dict(mesh=1.0, assembly=0.5, stiffness_setup=0.1, output=0.1,
            contact_solve=contact, elastic_solve=elastic,
            elastic_solve_iteration=0.5 * elastic, total=2.0 + contact + 2 * elastic),
        certificate=dict(kkt_residual=2e-9, force_balance=1e-9, slip_angle=1.0),
        contact=dict(force_on_body=[1.0, 2.0,
            3.0 + (ranks > 1) * (1e-6 if wrong == "everything" else 1e-10)]),
        peak_memory_MB=dofs * (2000 if wrong == "everything" else 500) / 2**20),
        file)
if wrong == "certificate" and refinement == 4:
    print("NOT CONVERGED: kkt_residual is 0.01.")
    sys.exit(2)
"""
MPIRUN = """#!/bin/sh
[ "$1 $2" = "--oversubscribe -n" ] || exit 3
export PRETENDED_RANKS=$3
shift 3
exec "$@"
"""
REFERENCE = """#!{python}
import json, os, sys
level = int(sys.argv[1])
dofs = 3 * (4 * 2**level + 1) * (3 * 2**level + 1) * (2**level + 1)
print(json.dumps(dict(dofs=dofs, ranks=int(os.environ["PRETENDED_RANKS"]),
    iterations=11, setup_seconds=9.0, solve_seconds=1.5e-6 * dofs,
    peak_memory_MB=100.0)))
"""
MEMORY = {"processes": 2, "megabytes": 1, "alone": 1e10, "together": 1.2e10}


class Choices(unittest.TestCase):
    """Sizes and cases."""

    def test_unknowns(self):
        numbers = [size.unknowns for size in scaling_cases.SIZES[:4]]
        self.assertEqual(numbers, [22275, 162435, 1238787, 9672195])

    def test_sizes(self):
        sizes = scaling_cases.choose_sizes("4x3x1r5, 6x4x1r3,4x3x1r5", 1e12)
        self.assertEqual([size.name for size in sizes], ["6x4x1r3", "4x3x1r5"])
        unknowns = [size.unknowns for size in scaling_cases.choose_sizes(None, 1e7)]
        self.assertEqual(unknowns, sorted(unknowns))
        self.assertEqual(len(unknowns), 10)
        for bad in ("", "4x3r5", "4x0x1r2", "4x3x1", "4x3x1r10", "a"):
            with self.assertRaises(BenchmarkError, msg=bad):
                scaling_cases.choose_sizes(bad + ",", 1e12)

    def test_cases_differ(self):
        options = scaling.parse_options([])
        keys = {
            (*case.settings(1e-8), case.ranks, case.repetition)
            for case in options.cases
        }
        self.assertEqual(len(keys), len(options.cases))
        labels = {case.label for case in options.cases}
        self.assertEqual(len(labels), len(options.cases))
        self.assertFalse([name for name in labels if "/" in name or " " in name])

    def test_large_sizes_are_not_repeated(self):
        sizes = [Size((4, 3, 1), 3), Size((4, 3, 1), 6)]
        cases = scaling_cases.size_cases(sizes, [1, 2], 3, 1e6)
        self.assertEqual([case.repetition for case in cases], [0, 1, 2] * 2 + [0, 0])

    def test_millimetres(self):
        settings = scaling_cases.unit_cases()[3].settings(1e-8)
        self.assertIn("Geometry/Lengths=4000,3000,1000", settings)
        self.assertIn("Material/Young's modulus=211900.0", settings)
        expected = "=5 : 0; 0; if(y > 1500.0, -100.0, 0) | 3 : 10.0; 20.0; 20.0"
        self.assertIn("Boundary conditions/Traction" + expected, settings)


class Figures(unittest.TestCase):
    """What the criteria are made of."""

    def test_flatness(self):
        self.assertAlmostEqual(figures.flatness([0.8, 1.2, None, 1.0]), 0.2)
        self.assertIsNone(figures.flatness([1.0, None]))

    def test_three_answers(self):
        self.assertIs(figures.all_true([True, None, False]), False)
        self.assertIsNone(figures.all_true([True, None]))
        self.assertIsNone(figures.all_true([]))
        self.assertIs(figures.all_true([True, True]), True)
        self.assertIsNone(figures.at_most(None, 1))
        self.assertIs(figures.at_least(2, 1), True)

    def test_best_of_repetitions(self):
        size = Size((4, 3, 1), 3)
        cases = scaling_cases.size_cases([size], [1], 2, 1e12)
        times = [(3.0, 1.0), (2.0, 1.25)]
        rows = {}
        for case, (contact, elastic) in zip(cases, times):
            seconds = {"contact_solve": contact, "elastic_solve": elastic}
            seconds["total"] = 10.0 + 2 * elastic
            rows[case] = stored_row({"seconds": seconds})
        (entry,) = Results(cases, rows).entries.values()
        self.assertEqual(entry["contact_solve_s"], 2.0)
        self.assertEqual(entry["equivalents"], 2.0)
        self.assertEqual(entry["whole_s"], 10.0)
        self.assertIsNone(entry["bytes_per_unknown"])
        rows[cases[1]]["status"] = runs.NOT_CERTIFIED
        (entry,) = Results(cases, rows).entries.values()
        self.assertEqual(entry["status"], runs.NOT_CERTIFIED)

    def test_getfem_is_scaled_by_the_yardstick(self):
        case = Case("row6", "with the yardstick", 1, ())
        row = stored_row({"seconds": {"elastic_solve": 0.5}})
        result = Results([case], {case: row})
        self.assertEqual(result.getfem_seconds(None), 50.0)
        self.assertEqual(result.getfem_seconds(0.25), 100.0)
        self.assertEqual(Results([], {}).getfem_seconds(0.25), 50.0)


def stored_row(summary):
    """A run as it is stored."""
    return {
        "status": runs.CERTIFIED,
        "message": "",
        "date": "today",
        "program": "1",
        "limit": 1.0,
        "summary": summary,
    }


class Model(unittest.TestCase):
    """Weak scaling."""

    def setUp(self):
        self.network = weak_scaling.Network(1e-6, 1e9, 1e10)
        self.solver = weak_scaling.Solver(2e-6, 1238787, 6, 10.0, 5.0)

    def test_one_rank_only_computes(self):
        seconds = weak_scaling.predict(self.solver, self.network, 1e6, 1)
        self.assertAlmostEqual(seconds["compute"], 2.0)
        self.assertAlmostEqual(seconds["total"], 2.0)

    def test_surface(self):
        self.assertAlmostEqual(weak_scaling.surface_unknowns(3e6), 18e4)
        self.assertEqual(weak_scaling.surface_unknowns(3), 3)

    def test_messages(self):
        network = self.network
        self.assertEqual(weak_scaling.exchange(network, 100, 8, 1), 0)
        self.assertAlmostEqual(weak_scaling.exchange(network, 1000, 8, 3), 10e-6)
        self.assertAlmostEqual(weak_scaling.exchange(network, 0, 8, 99), 26e-6)
        self.assertAlmostEqual(weak_scaling.sum_over_ranks(network, 0, 8), 3e-6)
        self.assertAlmostEqual(
            weak_scaling.sum_over_ranks(network, 1000, 4), 2e-6 + 12e-6
        )

    def test_cycle(self):
        network = weak_scaling.Network(0.0, 1e9)
        seconds = weak_scaling.cycle_exchange(self.solver, network, 2.4e7, 8, 3)
        # six exchanges of floats; a surface shrinks to a quarter
        surface = 3 * 6 * 8e6 ** (2 / 3)
        self.assertAlmostEqual(seconds, 6 * 4 * 1.25 * surface / 1e9)
        one_level = weak_scaling.cycle_exchange(self.solver, network, 120, 8, 1)
        self.assertEqual(one_level, 0)

    def test_levels(self):
        self.assertEqual(self.solver.levels(12), 1)
        self.assertEqual(self.solver.levels(22275), 4)
        self.assertEqual(self.solver.levels(9672195), 7)

    def test_growth(self):
        growing = replace(self.solver, unknowns=1e6, growth=0.5)
        seconds = weak_scaling.predict(growing, self.network, 1e6, 4)
        self.assertAlmostEqual(seconds["compute"], 4.0)

    def test_shares_and_efficiency(self):
        rows = weak_scaling.table(self.solver, self.network, 1e6, [1, 8e6, 1e9])
        self.assertEqual([row["ranks"] for row in rows], [1, 8, 1000])
        self.assertEqual(rows[0]["efficiency"], 1)
        self.assertLess(rows[2]["efficiency"], rows[1]["efficiency"])
        for row in rows:
            total = sum(row[name] for name in weak_scaling.SHARES)
            self.assertAlmostEqual(total, row["total"])

    def test_contact_limit(self):
        limit = weak_scaling.contact_limit(self.solver, self.network, 1e6)
        seconds = weak_scaling.predict(self.solver, self.network, 1e6, limit / 1e6)
        share = weak_scaling.contact_seconds(seconds) / seconds["total"]
        self.assertAlmostEqual(share, 0.5, places=2)
        distributed = weak_scaling.without_contact(self.solver)
        self.assertIsNone(weak_scaling.contact_limit(distributed, self.network, 1e6))


class WholeBenchmark(unittest.TestCase):
    """From the command line to the report, without the plots."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = self.write("pretender", PRETENDER)
        self.reference = self.write("reference", REFERENCE)
        self.write("mpirun", MPIRUN)
        path = self.folder + os.pathsep + os.environ["PATH"]
        for change in (
            unittest.mock.patch.dict(os.environ, PATH=path),
            # The tests run where matplotlib may be missing: nobody has it here.
            unittest.mock.patch.dict(sys.modules, {"matplotlib": None}),
            unittest.mock.patch.object(stream, "measure", lambda: dict(MEMORY)),
            unittest.mock.patch.object(machine, "others", lambda: 0.25),
        ):
            change.start()
            self.addCleanup(change.stop)

    def write(self, name, text):
        """A program; its path."""
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace("{python}", sys.executable))
        os.chmod(path, 0o755)
        return path

    def call(self, *arguments, fault=""):
        """(exit status, stdout, stderr) of the benchmark."""
        said, complained = io.StringIO(), io.StringIO()
        options = ["--program", self.program, "--reference-program", self.reference]
        options += ["--output", self.folder, *arguments]
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(
            complained
        ), unittest.mock.patch.dict(os.environ, PRETENDED_FAULT=fault):
            status = scaling.main(options)
        return status, said.getvalue(), complained.getvalue()

    def read(self):
        """{(part, size, ranks): row} of scaling.csv, and scaling.md."""
        with open(os.path.join(self.folder, "scaling.csv"), encoding="utf-8") as file:
            rows = {
                (row["part"], row["size"], row["ranks"]): row
                for row in csv.DictReader(file)
            }
        with open(os.path.join(self.folder, "scaling.md"), encoding="utf-8") as file:
            return rows, file.read()

    def verdicts(self):
        """{number of the criterion: verdict} of the report."""
        _, text = self.read()
        return dict(re.findall(r"^- \((\w+)\) .*\*\*(.*)\*\*", text, re.MULTILINE))

    def test_everything_is_met(self):
        sizes = "8x5x1r3,4x3x1r4,4x3x1r5,4x3x1r6"
        status, said, complained = self.call("--sizes", sizes, "--repeat", "1")
        self.assertEqual((status, complained), (0, ""), said)
        self.assertEqual(set(self.verdicts().values()), {"met"}, said)
        rows, text = self.read()
        row = rows["sizes", "4x3x1r6", "2"]
        self.assertAlmostEqual(float(row["equivalents"]), 1.5)
        self.assertAlmostEqual(float(row["krylov_ratio"]), 1.2)
        self.assertAlmostEqual(float(row["efficiency"]), 1.0)
        self.assertAlmostEqual(float(row["bytes_per_unknown"]), 500.0)
        self.assertAlmostEqual(float(row["force_difference"]), 1e-10 / 14**0.5)
        self.assertEqual(row["certificate"], "2e-09")
        self.assertIn("| 4x3x1r6: 9,672,195 | 5 | 12 | 20 | 1.20 | 1.50 |", text)
        self.assertIn("Everything that was asked for was solved.", text)
        self.assertIn("## Beyond this machine", text)
        self.assertIn("when a run began: 0.2 on average, at most 0.2", text)
        # nothing is left of the runs but their figures
        self.assertFalse([n for n in os.listdir(self.folder) if "running" in n])

    def test_nothing_is_met(self):
        sizes = "8x5x1r3,4x3x1r4,4x3x1r5,4x3x1r6"
        options = ["--sizes", sizes, "--repeat", "1", "--getfem-yardstick", "1"]
        status, said, _ = self.call(*options, fault="everything")
        self.assertEqual(status, 0, said)
        self.assertEqual(set(self.verdicts().values()), {"not met"}, said)

    def test_nothing_is_measured(self):
        choice = ["--sizes", "4x3x1r3", "--parts", "sizes", "--ranks", "1"]
        status, said, _ = self.call(*choice)
        self.assertEqual(status, 0, said)
        self.assertEqual(set(self.verdicts().values()), {"not measured"}, said)

    def test_ends(self):
        choice = ["--parts", "sizes,reference", "--repeat", "1", "--sizes"]
        self.call(*choice, "4x3x1r3,4x3x1r6", fault="memory")
        rows, text = self.read()
        self.assertEqual(rows["sizes", "4x3x1r6", "2"]["status"], "no memory")
        self.assertIn("9 cells that need 9 GB of memory, 1 GB are here.", text)
        self.assertNotIn("mpirun", text)

        sizes = "4x3x1r3,4x3x1r4,4x3x1r5"
        _, said, _ = self.call(
            *choice, sizes, "--fresh", "--time-limit", "1", fault="slow"
        )
        rows, text = self.read()
        self.assertEqual(rows["sizes", "4x3x1r4", "2"]["status"], "time limit")
        self.assertEqual(rows["sizes", "4x3x1r5", "1"]["status"], "skipped")
        self.assertIn("skipped, a smaller size was over the limit", said)
        self.assertIn("> 1 s", text)

        self.call(*choice, sizes, "--fresh", fault="certificate")
        rows, text = self.read()
        self.assertEqual(rows["sizes", "4x3x1r4", "1"]["status"], "not certified")
        self.assertIn("not certified. NOT CONVERGED: kkt_residual is 0.01.", text)
        self.assertIn(" †", text)

    def test_reference_that_fails(self):
        choice = ["--parts", "sizes,reference", "--sizes", "4x3x1r3"]
        self.reference = "/nowhere"
        self.assertIn("not measured: there is no program", self.call(*choice)[1])
        self.reference = self.write("mute", "#!/bin/sh\n")
        self.assertIn("no line of JSON was printed", self.call(*choice)[1])
        self.assertIn("Not measured: no line of JSON", self.read()[1])

    def test_a_second_call_repeats_nothing(self):
        choice = ["--sizes", "4x3x1r3", "--repeat", "2", "--parts", "sizes,stream"]
        self.assertIn("to run", self.call(*choice, "--list")[1])
        self.assertIn("[  4/4]", self.call(*choice)[1])
        with unittest.mock.patch.object(stream, "measure", None):
            said = self.call(*choice)[1]
        self.assertIn("4 of 4 runs are stored already", said)
        self.assertIn("certified", self.call(*choice, "--list")[1])
        self.assertIn("[  1/4]", self.call(*choice, "--fresh")[1])
        self.assertEqual(self.call(*choice, "--report-only")[0], 0)
        other = self.call("--sizes", "6x4x1r3", "--parts", "sizes", "--report-only")
        self.assertEqual(other[2], "benchmark: none of the chosen runs is stored.\n")

    def test_memory_that_cannot_be_measured(self):
        with unittest.mock.patch.object(stream, "measure", lambda: None):
            _, said, _ = self.call("--sizes", "4x3x1r3", "--parts", "sizes,stream")
        self.assertIn("not measured: numpy is missing", said)

    def test_bad_options(self):
        for bad in (
            ["--sizes", "big"],
            ["--max-unknowns", "1000"],
            ["--ranks", "0"],
            ["--ranks", "1,two"],
            ["--repeat", "0"],
            ["--friction", "-1"],
            ["--parts", "all"],
            ["--time-limit", "never"],
            ["--latency", "-1"],
            ["--unknown"],
            ["--report-only"],
            ["--fresh", "--list"],
            ["--program", "/nowhere"],
            ["--output", self.program],
        ):
            status, said, complained = self.call(*bad)
            self.assertEqual((status, said), (1, ""), bad)
            self.assertRegex(complained, r"\Abenchmark: .*\.\n\Z", bad)


class Reading(unittest.TestCase):
    """What other programs print."""

    def test_bandwidths(self):
        """Whether numpy is there or not."""
        rates = stream.bandwidths(2, 1, 0.01)
        if rates is not None:
            self.assertEqual(len(rates), 2)
            self.assertGreater(min(rates), 0)
        with unittest.mock.patch.object(sys, "executable", "/bin/false"):
            self.assertIsNone(stream.measure())

    def test_reference_line(self):
        row = {"status": runs.CERTIFIED}
        line = json.dumps({"dofs": 3})
        self.assertEqual(scaling.read_reference(row, f"x\n{line}\n")["dofs"], 3)
        self.assertEqual(scaling.read_reference(row, "")["status"], runs.CRASHED)
        failed = {"status": runs.ERROR}
        self.assertEqual(scaling.read_reference(failed, line), failed)


if __name__ == "__main__":
    unittest.main()
