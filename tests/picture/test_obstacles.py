#!/usr/bin/python3
"""Tests of the obstacles in the picture of a run."""

import unittest
from types import SimpleNamespace

from shapes import contact_on, cylinder_side, hexahedra, mesh_of

# found by shapes, which ends with "skipped" where there is no numpy
import numpy as np
from render_parts import bending, meshes

try:
    from render_parts import body, data, obstacles, results
except ImportError:
    obstacles = None


class Obstacles(unittest.TestCase):
    """What touches the body touches it in the picture."""

    FACTOR = 20

    def near(self, place, displacement, normal):
        """Nearest points of a flat contact boundary."""
        return SimpleNamespace(place=np.array(place, dtype=float),
                               displacement=np.array(displacement, dtype=float),
                               normal=np.array(normal, dtype=float))

    def test_an_obstacle_slides_along_a_wedge_and_goes_with_what_sticks(self):
        angle = np.linspace(0, np.pi / 2, 9)
        normals = np.stack([np.cos(angle), np.sin(angle), -np.ones(9)], axis=1) / np.sqrt(2)
        down = np.stack([-np.cos(angle), -np.sin(angle), -np.ones(9)], axis=1)
        weights, nothing = np.ones(9), np.zeros(9, dtype=bool)
        np.testing.assert_allclose(bending.rigid_way(normals, down, weights, nothing), 0,
                                   atol=1e-12)
        np.testing.assert_allclose(bending.rigid_way(
            normals, np.tile([1.0, 2, 3], (9, 1)), weights, ~nothing), [1, 2, 3])
        np.testing.assert_allclose(bending.rigid_way(normals, down, 0 * weights, nothing), 0)

    def test_a_dent_of_a_roller_does_not_drive_a_plane_sideways(self):
        x = np.linspace(0, 0.75, 9)
        normals = meshes.unit(np.stack([x, 0 * x, x - 50], axis=1))
        dent = np.stack([0 * x, 0 * x, 0.02 - x**2 / 100], axis=1)
        way = bending.rigid_way(normals, dent, np.ones(9), np.zeros(9, dtype=bool))
        self.assertLess(abs(way[0]), 1e-3)
        self.assertTrue(dent[-1, 2] < way[2] < dent[0, 2])

    def test_a_plane_is_bent_out_of_a_body_only_where_this_covers_it(self):
        """Over x there are touched nodes, a bulge below the plane, and nothing below it."""
        near = SimpleNamespace(
            place=np.array([[0, 0, 0.1], [1, 0, -0.2], [2, 0, 1], [3, 0, -0.2]]),
            normal=np.tile([0, 0, -1.0], (4, 1)), closed=np.array([[1.0], [0], [1], [0]]))
        places = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [4, 0, 0]])
        moved, way = bending.out_of_body(places, near, 10)
        np.testing.assert_allclose(moved[:, 2] + 10 * bending.LITTLE, [0.1, -0.2, 0, 0])
        np.testing.assert_allclose(moved[:, :2], places[:, :2])
        self.assertAlmostEqual(way, 0.2)

    def test_gaps_above_a_flat_boundary_are_as_large_as_the_displacement(self):
        near = self.near([[0, 0, 0], [1, 0, 0]], [[0.03, 0, -0.01], [0.01, 0, -0.02]],
                         [[0, 0, 1]] * 2)
        gap = np.array([[0], [0.05]]) * near.normal
        moved, off = bending.with_large_gaps(near.place + near.displacement + gap, near,
                                             self.FACTOR, False, 0)
        np.testing.assert_allclose(moved - near.place - self.FACTOR * near.displacement,
                                   self.FACTOR * gap, atol=1e-12)
        np.testing.assert_allclose(off, [self.FACTOR * 0.01, self.FACTOR * 0.03])

    def test_a_foundation_under_a_flat_boundary_stays_a_plane(self):
        near = self.near([[0, 0, 0], [1, 0, 0]], [[0.03, 0, 0.01], [0.01, 0, 0]],
                         [[0, 0, -1]] * 2)
        places = np.array([[0, 0, 0], [1, 0, 0]], dtype=float)
        moved, off = bending.with_large_gaps(places, near, self.FACTOR, True, 0)
        np.testing.assert_allclose(moved, places, atol=1e-12)
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
class Exaggeration(unittest.TestCase):
    """How many times larger displacements are drawn."""

    def test_it_is_seen_and_does_not_hide_the_body(self):
        points = np.array([[0, 0, 0], [20.0, 10, 5]])
        for largest, factor in ((0.001, 2000), (0.3, 7), (5, 1), (0, 1), (2e4, 0)):
            self.assertEqual(body.exaggeration(points, largest), factor)

    def test_bodies_are_drawn_side_by_side(self):
        points = np.array([[0, 0, 0], [20.0, 10, 5]])
        for closing, factor in ((1e-3, 100), (1e-2, 10), (1, 1), (1e-6, 200)):
            self.assertEqual(body.exaggeration(points, 0.01, closing), factor)

    def test_of_pressed_nodes_alone_it_counts_where_they_were(self):
        points = np.array([[x, y, z] for z in (0, 0.25) for x in (0, 1) for y in (0, 1)],
                          dtype=float)
        points[6:, 2] = 0.5  # two corners of the upper face are farther off
        contact = SimpleNamespace(
            points=points, cells=np.array([[0, 2, 3, 1], [4, 5, 7, 6]]),
            body=np.repeat([0, 1], 4), boundary=np.repeat([7, 8], 4),
            displacement=np.outer([0, 0, 0, 0, 1, 1, 2, 2], [0, 0, -0.25]),
            normal=np.tile([0.0, 0, -1], (8, 1)),
            pressure=np.array([0, 0, 0, 0, 1, 1, 0, 0.0]))
        contact.displacement[4:, 0] = -3  # and slides off
        summary = {"contact": {"boundaries": [{"id": 8, "opposite": "lower"}]}}
        self.assertAlmostEqual(results.largest_closing(contact, summary), 0.25)
        contact.pressure[6] = 1
        self.assertAlmostEqual(results.largest_closing(contact, summary), 0.5)
        summary["contact"]["boundaries"][0]["opposite"] = None
        self.assertEqual(results.largest_closing(contact, summary), 0)


@unittest.skipIf(obstacles is None, "needs VTK")
class Sight(unittest.TestCase):
    """What is in front of a contact face, nearest to it, or beside it."""

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
        for side in 1, -1:
            self.assertEqual(obstacles.covers(self.plane, self.run_of, deformed,
                                              np.array([side, 0, 0])), side == 1)

    def test_what_is_nearest(self):
        body = self.run_of.body
        moved = body.points + body.displacement
        place, displacement = obstacles.nearest(
            np.array([[2.5, 0, 1.5], [2, 0, 0.2]]), moved, self.run_of.contact.faces,
            body.points, body.displacement)
        np.testing.assert_allclose(place, [[2, 0, 1.5], [2, 0, 0.2]], atol=1e-6)
        np.testing.assert_allclose(displacement, [[-0.01, 0, 0]] * 2)

    def test_a_plane_is_cut_beside_the_boundary(self):
        points = np.array([[2.4, -0.5, 1], [2.4, 0.5, 2]])
        ends = obstacles.places_of(obstacles.cut(self.plane, points, 0.2, 2))
        np.testing.assert_allclose(np.abs(ends[:, 1]), 0.7)
        np.testing.assert_allclose(np.ptp(ends[:, 2]), 1)


if __name__ == "__main__":
    unittest.main()
