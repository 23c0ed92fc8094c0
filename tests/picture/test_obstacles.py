#!/usr/bin/python3
"""Tests of the obstacles in the picture of a run."""

import unittest
from types import SimpleNamespace

from shapes import contact_on, cylinder_side, hexahedra, mesh_of

# found by shapes, which ends with "skipped" where there is no numpy
import numpy as np
from render_parts import bending, meshes

try:
    from render_parts import data, obstacles
except ImportError:
    obstacles = None


class Obstacles(unittest.TestCase):
    """What touches the body touches it in the picture."""

    FACTOR, LITTLE = 20, 1e-9

    def near(self, place, displacement, normal):
        """Nearest points of a contact boundary."""
        return SimpleNamespace(place=np.array(place, dtype=float),
                               displacement=np.array(displacement, dtype=float),
                               normal=np.array(normal, dtype=float))

    def bent(self, near, gap, is_curved, is_flat):
        """An obstacle with these gaps: how far from the drawn body it is drawn."""
        gap = np.array(gap, dtype=float)[:, None]
        places = near.place + near.displacement + gap * near.normal
        moved, off = bending.bent(places, near, self.FACTOR, is_curved, is_flat,
                                  self.LITTLE)
        return moved - near.place - self.FACTOR * near.displacement, off

    def test_a_foundation_touches_a_ball_and_keeps_its_true_gap(self):
        angle = np.linspace(0, 1, 7)
        normal = np.stack([np.sin(angle), 0 * angle, -np.cos(angle)], axis=1)
        gap = 0.1 * angle**2
        near = self.near(normal, -0.02 * angle[:, None] * [0.3, 0, 1], normal)
        away, off = self.bent(near, gap, True, False)
        np.testing.assert_allclose(away, gap[:, None] * normal, atol=1e-8)
        np.testing.assert_allclose(off, gap)

    def test_a_pin_that_cuts_chords_of_its_hole_does_not_in_the_picture(self):
        near = self.near([[1, 0, 0]], [[0.1, 0, 0.2]], [[-1, 0, 0]])
        away, _ = self.bent(near, [-0.03], True, False)
        np.testing.assert_allclose(away, [[-self.LITTLE, 0, 0]], atol=1e-12)

    def test_gaps_above_a_flat_boundary_are_as_large_as_the_displacement(self):
        near = self.near([[0, 0, 0], [1, 0, 0]], [[0.03, 0, -0.01], [0.01, 0, -0.02]],
                         [[0, 0, 1]] * 2)
        away, off = self.bent(near, [0, 0.05], False, False)
        np.testing.assert_allclose(away, [[0, 0, 0], [0, 0, self.FACTOR * 0.05]],
                                   atol=1e-8)
        np.testing.assert_allclose(off, [self.FACTOR * 0.01, self.FACTOR * 0.03])

    def test_a_foundation_under_a_flat_boundary_stays_a_plane(self):
        near = self.near([[0, 0, 0], [1, 0, 0]], [[0.03, 0, 0.01], [0.01, 0, 0]],
                         [[0, 0, -1]] * 2)
        places = np.array([[0, 0, 0], [1, 0, 0]], dtype=float)
        moved, off = bending.bent(places, near, self.FACTOR, False, True, self.LITTLE)
        np.testing.assert_allclose(moved, places, atol=1e-8)
        np.testing.assert_allclose(off, 0, atol=1e-12)

    def test_which_boundaries_are_flat(self):
        points, faces = mesh_of(hexahedra((4, 3, 1), high=(4, 3, 1)))
        turned = points @ np.linalg.qr(np.arange(9).reshape(3, 3) ** 2 + 1)[0]
        for places in (points, turned):
            areas = meshes.vector_areas(places[faces])
            self.assertTrue(bending.has_flat_sides(areas))
            self.assertTrue(bending.has_flat_sides(areas[:1]))
        points, faces = cylinder_side(2, 3)
        around = meshes.vector_areas(points[faces])
        self.assertFalse(bending.has_flat_sides(around))
        self.assertFalse(bending.has_flat_sides(np.vstack([[[0, 0, 1]], around])))

    def test_which_obstacles_are_round(self):
        def triangles(faces):
            return faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)

        points, faces = cylinder_side(2, 3, n=40)
        self.assertTrue(bending.is_round(points, triangles(faces)))
        points, faces = mesh_of(hexahedra((4, 3, 1), high=(4, 3, 1)))
        self.assertFalse(bending.is_round(points, triangles(faces)))
        apart = np.arange(faces.size).reshape(-1, 4)
        self.assertFalse(bending.is_round(points[faces].reshape(-1, 3),
                                          triangles(apart)))

    def test_weights_in_triangles(self):
        corners = np.array([[[0, 0, 1], [2, 0, 1], [0, 4, 1]], np.zeros((3, 3))])
        weights = bending.weights_of(corners, np.array([[0.5, 1, 1], [0, 0, 0]]))
        np.testing.assert_allclose(weights, [[0.5, 0.25, 0.25], [1 / 3] * 3])


@unittest.skipIf(obstacles is None, "needs VTK")
class Sight(unittest.TestCase):
    """What is in front of a contact face, or bent to it."""

    def setUp(self):
        points, faces = cylinder_side(2, 3)
        self.run_of = SimpleNamespace(
            body=SimpleNamespace(points=points, faces=faces, stress=np.zeros(len(points)),
                                 displacement=np.tile([-0.01, 0, 0], (len(points), 1))),
            contact=contact_on(faces[points[faces][:, :, 0].mean(axis=1) > 1], 0))
        corners = np.array([[2.5, y, z] for y in (-1, 1) for z in (1, 2)], dtype=float)
        self.plane = data.surface_of(corners, np.array([[0, 2, 3, 1]]), np.zeros(4))

    def test_an_obstacle_that_covers_the_contact_face(self):
        body = self.run_of.body
        deformed = data.surface_of(body.points, body.faces, body.stress)
        for side, covering in ((1, 1), (-1, 0)):
            parts = obstacles.split_by_sight(self.plane, self.run_of, deformed,
                                             np.array([side, 0, 0]))
            self.assertEqual([part.GetNumberOfPolys() for part in parts],
                             [1 - covering, covering])

    def test_a_plane_is_bent_to_what_is_nearest(self):
        places = np.array([[2.5, 0, 1.5], [2, 0, 0.2]])
        normals = np.tile([1.0, 0, 0], (len(self.run_of.body.points), 1))
        near = obstacles.nearest(places, self.run_of.body, self.run_of.contact.faces,
                                 normals)
        np.testing.assert_allclose(near.place, [[2, 0, 1.5], [2, 0, 0.2]], atol=1e-6)
        np.testing.assert_allclose(near.displacement, [[-0.01, 0, 0]] * 2)


if __name__ == "__main__":
    unittest.main()
