#!/usr/bin/python3
"""Tests of the picture of a history: its curves, its steps, and whether it ends in rest."""

import os
import tempfile
import unittest

import shapes  # pylint: disable=unused-import

# found by shapes, which ends with "skipped" where there is no numpy
import numpy as np
from render_parts import Unusable, history, results, words


class Released(unittest.TestCase):
    """Whether a history ends with a body that was let go."""

    def check(self, energies, released):
        steps = [{} if energy is None else {"energy": {"elastic_energy": energy}}
                 for energy in energies]
        self.assertEqual(results.is_released({"steps": steps}), released)

    def test_energies(self):
        self.check([1, 2, 1e-20], True)
        self.check([1, 2, 1e-3], False)
        self.check([0], False)
        self.assertFalse(results.is_released({}))

    def test_a_last_step_that_is_not_certified(self):
        self.check([1, 2, None], False)


class Steps(unittest.TestCase):
    """The steps of which there are files."""

    def test_a_directory_that_is_not_there(self):
        for find in (results.steps_of, results.last_tag):
            with self.assertRaisesRegex(Unusable, "there is no directory nowhere"):
                find("nowhere")


class Curves(unittest.TestCase):
    """The diagrams of a history."""

    PRESSED = "normal_force,moment_x,moment_y,moment_z,open_area,slip_area,stick_area," \
        "center_y,center_z,"
    HEADER = "t,boundary,force_x,force_y,force_z,center_x," \
        "obstacle_x,obstacle_y,obstacle_z,obstacle_angle,torque,dissipated_total\n"

    def read(self, rows, pressed="5,0,0,0,0,0,1,"):
        """What a directory with these rows has, each with how it is pressed."""
        rows = "".join(pressed + "0,0," + row for row in rows.splitlines(keepends=True))
        with tempfile.TemporaryDirectory() as directory:
            with open(os.path.join(directory, "history.csv"), "w",
                      encoding="utf-8") as stream:
                stream.write(self.PRESSED + self.HEADER + rows)
            return history.read(directory)

    def test_diagrams(self):
        boundaries = self.read('1,"a,b",0,0,0,,0,0,0,0,0,0\n1,c,1,0,2,0,0,0,0,0,4,0\n'
                               '2,"a,b",1,0,-5,0,0.1,0,0,0,0,3\n2,c,1,0,2,0,0,0,0,0.2,5,0\n')
        self.assertEqual(list(boundaries), ["a,b", "c"])
        self.assertTrue(np.isnan(boundaries["a,b"]["center_x"][0]))
        figure = history.draw(boundaries, words.units_of(
            {"units": {"length": "mm", "force": "N", "moment": "N mm", "stress": "MPa"}}))
        figure.canvas.draw()
        over_t, over_x, over_angle = figure.axes
        self.assertEqual(over_t.get_xlabel(), "t")
        self.assertIn("along x [mm]", over_x.get_xlabel())
        self.assertEqual([text.get_text() for text in over_x.get_legend().texts],
                         ["x", "z"])
        self.assertEqual(len(over_t.get_legend().texts), 4)
        self.assertEqual(over_angle.get_xlabel(), "obstacle turned by [rad]")
        self.assertIn("torque on the body [N mm]", over_angle.get_ylabel())
        self.assertIsNone(over_angle.get_legend())

    def test_curves_over_t_begin_at_the_start(self):
        boundaries = self.read("1,a,0,0,-5,0,0,0,-0.1,0,0,2\n2,a,0,0,-9,0,0,0,-0.2,0,0,3\n",
                               "5,0,0,0,0,1,0,")
        for start, before in ((0.5, [[[[0.5, 1], [0, -5]]], [], [[[0.5, 1], [0, 2]]]]),
                              (3, [[], [], []])):  # of another run
            figure = history.draw(boundaries, words.units_of({}), start)
            self.assertEqual(before, [[
                line.get_xydata().T.tolist() for line in axes.lines
                if line.get_linestyle() == ":"] for axes in figure.axes])

    def test_names_of_pairs(self):
        header, self.HEADER = self.HEADER, "pair,opposite," + self.HEADER
        boundaries = self.read("floor,,1,a,0,0,-5,,0,0,0,0,0,0\n"
                               "key,slot,1,b,0,0,-5,,0,0,0,0,0,0\n"
                               ",,1,c,0,0,-5,,0,0,0,0,0,0\n"
                               ",,1,floor,0,0,-5,,0,0,0,0,0,0\n")
        self.HEADER = header
        self.assertEqual(list(boundaries), ["floor, a", "key", "c", "floor"])

    def test_small_curves_of_many(self):
        for n, left_out in ((8, 0), (9, 8)):
            figure = history.draw(self.read("".join(
                f"1,{name},0,0,{-0.1 if name else -50},0,0,0,0,0,0,0\n"
                for name in range(n))), words.units_of({}))
            said = [text.get_text() for text in figure.axes[0].get_legend().texts]
            self.assertEqual(said[-1].startswith(f"and {left_out} below 2 %"), left_out > 0)
            self.assertEqual(len(said), n if not left_out else 2)

    def test_nothing_moves_and_no_force(self):
        figure = history.draw(self.read("1,a,0,0,0,,0,0,0,0,0,0\n"),
                              words.units_of({}))
        figure.canvas.draw()
        self.assertEqual(len(figure.axes), 1)

    def test_twist_by_a_punch_under_a_force(self):
        """What it settles while it turns is hardly a part of its way: no curve over it."""
        boundaries = self.read("1,a,0,0,-5,1,0,0,-0.1119,0,0,0\n"
                               "2,a,0,0,-5,1,0,0,-0.1120,0.012,1.8,1\n"
                               "3,a,0,0,-5,1,0,0,-0.1121,0.024,2.1,2\n")
        for summary in ({}, {"units": {"length": "mm", "moment": "N mm"}}):
            figure = history.draw(boundaries, words.units_of(summary))
            figure.canvas.draw()
            _, over_angle = figure.axes
            curve, = [line for line in over_angle.lines if len(line.get_xdata()) == 3]
            np.testing.assert_allclose(curve.get_xdata(), [0, 0.012, 0.024])
            np.testing.assert_allclose(curve.get_ydata(), [0, 1.8, 2.1])

    def test_clutch(self):
        """Moments are shown beside forces that press and do not make them."""
        for moment, shown in ((3, 3), (1e-3, 2)):
            figure = history.draw(self.read(
                "1,a,0,0,-5,0,0,0,0,0,0,0\n2,a,0,0,-5,0,0,0,0,0,0,7\n",
                f"5,0,0,{moment},0,1,0,"), words.units_of({}))
            self.assertEqual(len(figure.axes), shown)

    def test_fit(self):
        """Of forces that add up to rounding the moments are shown, and of moments that
        do as well how hard bodies are pressed together."""
        for moment, shown in (("-3", "moment on the body [N mm]"),
                              ("1e-8", "normal force [N]")):
            figure = history.draw(
                self.read("1,a,1e-9,0,0,,0,0,0,0,0,0\n2,a,0,0,1e-9,,0,0,0,0,0,7\n",
                          f"5,0,0,{moment},0,1,0,"),
                words.units_of({"units": {"force": "N", "moment": "N mm",
                                          "energy": "mJ"}}))
            figure.canvas.draw()
            over_t, dissipated = figure.axes
            self.assertEqual(over_t.get_ylabel(), shown)
            self.assertEqual(dissipated.get_ylabel(), "dissipated by friction [mJ]")

    def test_line_that_was_being_written(self):
        rows = self.read("1,a,0,0,1,,0,0,0,0,0,0\n2,a,0,0,1,,0")["a"]
        self.assertEqual(list(rows["t"]), [1])


if __name__ == "__main__":
    unittest.main()
