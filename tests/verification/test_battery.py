"""Rows that must fail do, and so does the command; output/stiction.py reads what a run
wrote. Call: test_battery.py PROGRAM"""

import base64
import contextlib
import io
import os
import sys
import tempfile
import unittest
import zlib
from unittest import mock
from xml.etree import ElementTree

import numpy as np

import verify
from battery.case import ROOT, Row, Solver, order, stiction
from battery.random_bodies import judge

PROGRAM = os.path.abspath(sys.argv.pop(1))
BRICK = os.path.join(ROOT, "parameters", "brick.prm")


class Rows(unittest.TestCase):
    """What passes and what does not."""

    def test_kinds(self):
        for row, passes in (
                (Row("", 1.01, 1, "", 0.02), True), (Row("", 1.03, 1, "", 0.02), False),
                (Row("", -1, 1, "", 0.02), False),
                (Row("", 0.01, 0, "", 0.02, "absolute"), True),
                (Row("", 0.03, 0, "", 0.02, "absolute"), False),
                (Row("", 1.5, 1, "", 0.2, "at least"), True),
                (Row("", 1.1, 1, "", 0.2, "at least"), False),
                (Row("", 0.3, 0, "", 0.2, "at least"), True),
                (Row("", 0.1, 0, "", 0.2, "at least"), False),
                (Row("", 2.5, 2, "", 0.1, "order"), True),
                (Row("", 1.8, 2, "", 0.1, "order"), False),
                (Row("", "a", "a", "", kind="same"), True),
                (Row("", "a", "b", "", kind="same"), False)):
            self.assertEqual(bool(row.passed), passes, row)
        for kind in ("relative", "absolute", "at least", "order"):
            self.assertFalse(Row("", float("nan"), 1, "", 0.1, kind).passed, kind)

    def test_order(self):
        self.assertAlmostEqual(order([0.16, -0.04, 0.01]), 2)

    def test_command(self):
        for value, status in ((1.0, 0), (1.1, 1)):
            cases = {"case": lambda solver, quick, v=value: ([Row("q", v, 1, "s", 0.01)], [])}
            with tempfile.TemporaryDirectory() as directory, \
                    mock.patch.dict(verify.CASES, cases, clear=True), \
                    contextlib.redirect_stdout(io.StringIO()) as said:
                self.assertEqual(verify.main(["--output", directory]), status)
                with open(os.path.join(directory, "verification.md"),
                          encoding="utf-8") as file:
                    self.assertIn("FAIL" if status else "pass", file.read())
            self.assertIn("FAIL" if status else "pass", said.getvalue())

    def test_not_certified(self):
        solver = Solver(PROGRAM, lambda: None)
        solver(BRICK, {"Geometry/Table 1 level": 1, "Contact solver/Maximum iterations": 1})
        self.assertEqual([row.passed for row in solver.rows], [False])


class Files(unittest.TestCase):
    """output/stiction.py."""

    def test_arrays(self):
        numbers = np.arange(3000, dtype="<f4")
        packed = [zlib.compress(part.tobytes()) for part in (numbers[:2000], numbers[2000:])]
        header = np.array([2, 8000, 4000] + [len(part) for part in packed], "<u4").tobytes()
        array = ElementTree.Element("DataArray", type="Float32", format="binary",
                                    NumberOfComponents="3")
        array.text = (base64.b64encode(header) + base64.b64encode(b"".join(packed))).decode()
        self.assertTrue((stiction.read_array(array) == numbers.reshape(-1, 3)).all())
        array = ElementTree.Element("DataArray", type="Int32", format="ascii")
        array.text = "1 2\n3"
        self.assertEqual(list(stiction.read_array(array)), [1, 2, 3])

    def test_run(self):
        for ranks in (1, 2):
            run = stiction.run(BRICK, {"Geometry/Table 1 level": 1}, ranks=ranks,
                               program=PROGRAM)
            self.assertTrue(run.certified)
            nodes = run.contact()
            force = -(nodes["traction"] * nodes["area"][:, None]).sum(axis=0)
            found = np.array(run.summary["contact"]["force_on_body"])
            self.assertEqual((nodes["area"] > 0).sum(), 54)
            self.assertLess(np.linalg.norm(abs(force) - abs(found)),
                            1e-6 * np.linalg.norm(found))
            body = run.solution()
            self.assertEqual(body["cells"].shape, (body["points"].shape[0] // 8, 8))
            self.assertAlmostEqual(
                np.linalg.norm(body["displacement"], axis=1).max()
                / run.summary["displacement"]["max"], 1, 6)

    def test_nodes_of_larger_cells_where_others_hang(self):
        # six tetrahedra with the bottom 1, 2, 4, 3; some cells touch it with an edge alone
        paths = ("1, 2, 4, 8", "1, 2, 6, 8", "1, 3, 4, 8", "1, 3, 7, 8", "1, 5, 6, 8",
                 "1, 5, 7, 8")
        with tempfile.TemporaryDirectory() as directory:
            mesh = os.path.join(directory, "cube.inp")
            with open(mesh, "w", encoding="utf-8") as file:
                print("*NODE", *(f"{k + 1}, {k & 1}, {k >> 1 & 1}, {k >> 2}"
                                 for k in range(8)),
                      "*ELEMENT, TYPE=C3D4", *(f"{k + 1}, {path}"
                                               for k, path in enumerate(paths)),
                      "*SURFACE, NAME=bottom", "1, S1", "3, S1",
                      "*SURFACE, NAME=top", "5, S3", "6, S3", sep="\n", file=file)
            run = stiction.run(f"""
                subsection Geometry
                  set Mesh file = {mesh}
                  set Element degree = 2
                  set Contact refinement = 1
                  set Contact refinement where = x < 0.3
                end
                subsection Boundary conditions
                  set Pressure = top : 1
                  set Contact boundary = bottom
                  set Obstacle = foundation
                end
                subsection Friction
                  set Law = frictionless
                end""", {"Material/Young's modulus": 1000, "Material/Poisson ratio": 0.3},
                               program=PROGRAM)
        nodes = run.contact()
        self.assertEqual((nodes["area"] > 0).sum(),
                         run.summary["contact"]["boundaries"][0]["nodes"])
        np.testing.assert_allclose((nodes["traction"] * nodes["area"][:, None]).sum(axis=0),
                                   [0, 0, 1], atol=1e-5)

    def test_history(self):
        run = stiction.run(os.path.join(ROOT, "parameters", "brick_loaded_unloaded.prm"),
                           {"Geometry/Table 1 level": 1}, program=PROGRAM)
        steps = run.summary["steps"]
        self.assertEqual(len(run.energy["t"]), steps["certified"] if isinstance(steps, dict)
                         else len(steps))
        self.assertEqual(len(run.contact(step=1)["area"]), len(run.contact()["area"]))
        self.assertEqual(run.history["boundary"][0], "bottom")

    def test_restart(self):
        steps = {"Geometry/Table 1 level": 1, "Time/Checkpoint every": 1}
        first = stiction.run(BRICK, {**steps, "Time/Steps": 1}, program=PROGRAM)
        run = stiction.run(BRICK, {**steps, "Time/Steps": 2, "Time/End": 2},
                           program=PROGRAM, restart=first.directory)
        self.assertEqual((run.certified, list(run.history["t"])), (True, [1, 2]))
        with self.assertRaisesRegex(stiction.Error, "must be what it was"):
            stiction.run(BRICK, {**steps, "Geometry/Table 1 level": 2}, program=PROGRAM,
                         restart=first.directory)

    def test_validate(self):
        with open(BRICK, encoding="utf-8") as file:
            for parameters in (BRICK, file.read()):
                said = stiction.validate(parameters, program=PROGRAM)
                self.assertIn("nothing was solved", said)
                self.assertIn("smallest gap", said)
        with self.assertRaisesRegex(stiction.Error, "unknown entry 'Low'"):
            stiction.validate(BRICK, {"Friction/Low": 1}, program=PROGRAM)

    def test_judge(self):
        with tempfile.TemporaryDirectory() as directory:
            run = stiction.run(BRICK, {"Geometry/Table 1 level": 1,
                                       "Output/Export directory": directory},
                               program=PROGRAM)
            energy = run.summary["energy"]["strain"]
            self.assertLess(judge(directory, energy), 1e-7)
            for change, least in ((lambda x: 1.001 * x, 1e-4), (lambda x: 0 * x + 1, 1e-2)):
                name = os.path.join(directory, "lambda.mtx")
                with open(name, encoding="utf-8") as file:
                    lines = file.readlines()
                first = next(k for k, line in enumerate(lines) if line[0] != "%") + 1
                with open(name, "w", encoding="utf-8") as file:
                    file.writelines(lines[:first] + [
                        f"{change(float(line)):.17g}\n" for line in lines[first:]])
                self.assertGreater(judge(directory, energy), least)

    def test_errors(self):
        for call, says in (
                (lambda: stiction.run("none.prm", program=PROGRAM), "none.prm"),
                (lambda: stiction.run(BRICK, {"Friction/Low": 1}, program=PROGRAM),
                 "unknown entry 'Low'"),
                (lambda: stiction.run(BRICK, program="none"), "cannot run 'none'"),
                (lambda: stiction.read("nowhere"), "nowhere holds no run")):
            with self.assertRaisesRegex(stiction.Error, says):
                call()
        run = stiction.run(BRICK, {"Geometry/Table 1 level": 1,
                                   "Contact solver/Maximum iterations": 1}, program=PROGRAM)
        self.assertEqual((run.certified, run.status), (False, 2))
        self.assertIn("the cap of 1 iterations", run.message)


if __name__ == "__main__":
    unittest.main()
