#!/usr/bin/python3
"""Tests of how the body is seen in the picture of a run; they need VTK."""

import sys
import unittest
from types import SimpleNamespace
from unittest import mock

from shapes import contact_on, hexahedra, mesh_of, side

# found by shapes, which ends with "skipped" where there is no numpy
import numpy as np

try:
    import render
    from render_parts import body, panels
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


class Frames(unittest.TestCase):
    """What the frames of a history on several meshes have in common."""

    def run_on(self, cells, place, moved):
        """A brick of these cells that is moved along x and touches with one node."""
        points, faces = mesh_of(hexahedra(cells, high=(4, 3, 1)))
        bottom = side(points, faces, 2, 0)
        contact = contact_on(bottom, 0, (0, 0))
        contact.normal_status[(points[bottom] == (*place, 0)).all(axis=2)] = 1
        displacement = np.tile([moved, 0, 0], (len(points), 1))
        return SimpleNamespace(
            contact=contact, n_bodies=1, obstacle=None, released=False,
            body=SimpleNamespace(points=points, faces=faces, displacement=displacement,
                                 stress=np.zeros(len(points))),
            scale=SimpleNamespace(displacement=abs(moved), closing=0, stress=1, dented=set()))

    def test_on_several_meshes_they_show_the_same(self):
        runs = {"_1": self.run_on((4, 3, 1), (0, 0), 0),
                "_2": self.run_on((8, 6, 2), (2, 1.5), 0.1)}
        with mock.patch.object(render.results, "read", lambda _, tag, time: runs[tag]):
            shared = render.shared_by_frames("", [(1, "_1"), (2, "_2")])
        np.testing.assert_allclose(shared.windows, [[[0, 0], [2.65, 2.15]]])
        for run in runs.values():
            panel, = panels.panels_of(run.contact, run.body.points, True, shared.layout)
            panels.show(panel, *shared.windows[0])
            self.assertTrue(panel.enlarged)
            self.assertEqual(panel.places[panel.shown][:, :, 0].max(), 3)
        first, last = (body.reach_of(body.scene_of(run, ())) for run in runs.values())
        np.testing.assert_allclose(shared.reach, (np.minimum(first[0], last[0]),
                                                  np.maximum(first[1], last[1])))
        self.assertGreater(shared.reach[1][0], first[1][0])
        with mock.patch.object(body, "rendered") as rendered:
            for run in runs.values():
                body.picture(run, (), (1, 1), shared.reach)
        views = [(call.args[1].GetFocalPoint(), call.args[1].GetPosition(), *call.args[2])
                 for call in rendered.call_args_list]
        self.assertEqual(views[0], views[1])


if __name__ == "__main__":
    unittest.main()
