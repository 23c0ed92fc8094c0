#!/usr/bin/python3
"""Tests of how the body is seen in the picture of a run; they need VTK."""

import sys
import unittest

import shapes  # pylint: disable=unused-import

# found by shapes, which ends with "skipped" where there is no numpy
import numpy as np

try:
    from render_parts import body
except ImportError as error:
    print(f"Skipped: {error}")
    sys.exit(77)


class View(unittest.TestCase):
    """Where the camera is."""

    def test_plane_models_are_seen_nearly_from_the_front(self):
        for axis, upwards in ((0, 2), (1, 2), (2, 1)):
            for thickness in (1e-9, 0.1, 1.9):
                lengths = np.array([60.0, 40, 20])
                lengths[axis] = thickness
                basis = body.view_basis(np.array([np.zeros(3), lengths]))
                np.testing.assert_allclose(basis @ basis.T, np.eye(3), atol=1e-12)
                self.assertGreater(np.linalg.det(basis), 0.99)
                self.assertGreater(abs(basis[2, axis]), 0.9)
                self.assertGreater(basis[1, upwards], 0.9)
                self.assertGreater(basis[2, upwards], 0)  # from above
                self.assertGreater(basis[0, 1 if axis == 0 else 0], 0.9)

    def test_a_slab_is_seen_from_aside(self):
        basis = body.view_basis(np.array([[0, 0, 0], [60.0, 20, 3]]))
        self.assertLess(basis[2].max(), 0.9)
        self.assertAlmostEqual(basis[0, 2], 0)


if __name__ == "__main__":
    unittest.main()
