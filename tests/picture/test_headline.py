#!/usr/bin/python3
"""Tests of what is written on the picture of a run: the numbers that matter, and units."""

import unittest
from types import SimpleNamespace

import shapes  # pylint: disable=unused-import

# found by shapes, which ends with "skipped" where there is no numpy
import numpy as np
from render_parts import headline, words


class Headline(unittest.TestCase):
    """The numbers above the picture."""

    def numbers(self, released=False, max_pressure=0, max_tension=0):
        """The line of a pair with these numbers."""
        boundary = {"name": "a", "opposite": "b", "force_on_body": [0, 0, -1],
                    "normal_force": 1}
        return headline.numbers(SimpleNamespace(
            certified=True, released=released, contact=SimpleNamespace(
                tangential_traction=np.array([[[0, 3e-6, 4e-6]]])), units={"force": "N", "stress": "MPa"},
            summary={"contact": {"boundaries": [boundary], "max_pressure": max_pressure,
                                 "max_tension": max_tension, "tied": 9}}))

    def test_what_is_largest(self):
        self.assertEqual(self.numbers(max_pressure=3, max_tension=2),
                         "largest pressure 3 MPa   contact force on a (0, 0, "
                         "\N{MINUS SIGN}1) N   nodes: tied 9")
        self.assertIn("largest tension 2 MPa", self.numbers(max_tension=2))
        self.assertIn("largest shear 5$\\times10^{-6}$ MPa",
                      self.numbers(max_pressure=1e-14, max_tension=1e-13))

    def test_a_body_that_was_let_go(self):
        self.assertEqual(self.numbers(released=True, max_pressure=1e-12),
                         "nothing is pressed   nodes: tied 9")


class Numbers(unittest.TestCase):
    """Numbers and units as they are written."""

    def test_units(self):
        self.assertEqual(words.label("pressure", ""), "pressure")
        self.assertEqual(words.label("x", "mm"), "x [mm]")
        self.assertEqual(words.label("pressure", "Pa", 6), "pressure [$10^{6}$ Pa]")
        self.assertEqual(words.quantity("N", 1.5, -2, 1e-12),
                         "(1.5, \N{MINUS SIGN}2, 0) N")
        self.assertEqual(words.quantity("", 1.582e8), "158.2$\\times10^{6}$")


if __name__ == "__main__":
    unittest.main()
