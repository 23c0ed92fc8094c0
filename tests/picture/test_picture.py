#!/usr/bin/python3
"""Tests of the picture of a run: the surface, the panels, and the page."""

import itertools
import unittest
from types import SimpleNamespace

from shapes import contact_on, cylinder_side, hexahedra, joined, mesh_of, side

# found by shapes, which ends with "skipped" where there is no numpy
import matplotlib
import numpy as np
import render
from render_parts import meshes, page, panels


class Surface(unittest.TestCase):
    """The faces on the outside of a mesh."""

    def test_points_up_to_rounding(self):
        points = np.array([[0, 0, 1 / 3], [0, 0, np.float32(1 / 3)], [0, 0, 1]])
        first, number = meshes.merge(points)
        self.assertEqual(len(first), 2)
        self.assertEqual(number[0], number[1])
        self.assertNotEqual(number[0], number[2])

    def test_brick_is_closed_and_seen_from_outside(self):
        points, faces = mesh_of(hexahedra((3, 2, 4), high=(3, 1, 2)))
        self.assertEqual(len(points), 4 * 3 * 5)
        areas = meshes.vector_areas(points[faces])
        self.assertAlmostEqual(np.linalg.norm(areas, axis=1).sum(), 22)
        outwards = points[faces].mean(axis=1) - [1.5, 0.5, 1]
        self.assertTrue(((areas * outwards).sum(axis=1) > 0).all())

    def test_no_faces_between_large_and_small_cells(self):
        _, faces = mesh_of(np.concatenate([
            hexahedra((1, 1, 1)), hexahedra((2, 2, 2), (1, 0, 0), (2, 1, 1))]))
        self.assertEqual(len(faces), 5 + 5 * 4)

    def test_lips_of_a_crack(self):
        corners = hexahedra((1, 1, 2))
        below = np.repeat([True, False], 8)
        places = corners.reshape(-1, 3)
        cut = places[:, 2] == 0.5
        for opening, n_points, n_faces in ((0.1, 16, 12), (1e-9, 12, 10)):
            moved = np.tile([1.0, 0, 0], (16, 1))
            moved[below, 2] = -opening
            first, number = meshes.merge(places, moved=moved)
            self.assertEqual(len(first), n_points)
            cells = number.reshape(-1, 8)
            self.assertEqual(len(meshes.outer_faces(cells, n_points)), n_faces)
            # the lips are on the surface even where they do not part
            lips = meshes.outer_faces(cells, n_points, number[cut & below][None])
            self.assertEqual(len(lips), 12)

    def test_three_lips_at_one_place(self):
        moved = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 0, 0]])
        first, number = meshes.merge(np.ones((4, 3)), moved=moved)
        self.assertEqual(len(first), 3)
        self.assertEqual(number[1], number[3])

    def test_outline_of_a_cube_is_its_edges(self):
        points, faces = mesh_of(hexahedra((2, 2, 2)))
        edges = meshes.outline(points, faces, np.array([1, -1, 1]))
        self.assertEqual(len(edges), 12 * 2)


class Panels(unittest.TestCase):
    """Contact boundaries laid flat."""

    def setUp(self):
        self.points, self.faces = mesh_of(hexahedra((4, 3, 1), high=(4, 3, 1)))

    def test_bottom_is_seen_from_above(self):
        bottom = side(self.points, self.faces, 2, 0)
        panel, = panels.panels_of(contact_on(bottom, 4), self.points)
        self.assertEqual(panel.seen, "seen from +z")
        self.assertEqual(panel.axes, ["x", "y"])
        np.testing.assert_allclose(panel.places, self.points[bottom][:, :, :2])
        np.testing.assert_allclose(panel.friction[..., 0], 1)

    def test_every_boundary_has_its_panel(self):
        both = joined(contact_on(side(self.points, self.faces, 2, 0), 4),
                      contact_on(side(self.points, self.faces, 0, 4), 1))
        four, one = sorted(panels.panels_of(both, self.points),
                           key=lambda panel: -panel.boundary)
        self.assertEqual((len(four.faces), len(one.faces)), (12, 3))
        self.assertEqual(one.axes, ["y", "z"])

    def test_all_sides_of_a_brick_are_apart(self):
        shown = panels.panels_of(contact_on(self.faces, 0), self.points)
        self.assertEqual(len({panel.seen for panel in shown}), 6)
        self.assertIn("facing \N{MINUS SIGN}x, seen from +x",
                      [panel.seen for panel in shown])

    def test_side_of_a_cylinder_is_unrolled(self):
        points, faces = cylinder_side(2, 3)
        around = points[faces].mean(axis=1)
        contact = contact_on(faces, 0, friction=(0, 0, 1))
        contact.pressure[around[:, 0] < 1.9] = 0
        contact.normal_status[around[:, 0] < 1.9] = 0
        contact.tangential_status[around[:, 0] < 1.9] = 0
        panel, = panels.panels_of(contact, points)
        low, high = (f(panel.places.reshape(-1, 2), axis=0)
                     for f in (np.min, np.max))
        np.testing.assert_allclose(high - low, [4 * np.pi, 3], rtol=0.01)
        np.testing.assert_allclose(panel.friction[..., 1], 1)
        middle = panel.places[panel.pressure.all(axis=1)].mean(axis=(0, 1))
        self.assertAlmostEqual(middle[0], 0)
        self.assertTrue(panel.enlarged)

    def test_part_of_a_cylinder_is_unrolled(self):
        points, faces = cylinder_side(2, 3)
        around = points[faces].mean(axis=1)
        for least, length, seen in ((-0.1, 2, "unrolled"), (1.7, 2, "seen from"),
                                    (-1.5, 3, "unrolled")):
            contact = contact_on(faces[around[:, 0] > least], 0)
            contact.pressure[points[contact.faces][..., 1] < 0] = 0  # at one end
            panel, = panels.panels_of(contact, points)
            self.assertIn(seen, panel.seen)
            ends = panel.places[..., 0]
            self.assertAlmostEqual(ends.min(), -ends.max())
            if seen == "unrolled":
                self.assertAlmostEqual(np.ptp(ends) / np.pi, length, delta=0.4)
                self.assertEqual(panel.axes[0], "arc from +x")

    def test_side_that_nothing_presses_or_all_around(self):
        points, faces = cylinder_side(2, 3)
        for pressure in 0., 2.:
            contact = contact_on(faces, 0)
            contact.pressure[:] = pressure
            panel, = panels.panels_of(contact, points)
            self.assertTrue(np.isfinite(panel.places).all())
            self.assertEqual(panel.axes[0], "arc from \N{MINUS SIGN}y")

    def test_hanging_nodes_are_not_counted(self):
        contact = contact_on(side(self.points, self.faces, 2, 0), 4)
        contact.area[contact.faces == contact.faces[0, 0]] = 0
        panel, = panels.panels_of(contact, self.points)
        self.assertEqual(panels.counts(panel), {panels.SLIP: 19})

    def test_every_status_is_drawn_as_itself(self):
        bottom = side(self.points, self.faces, 2, 0)
        for status, kind in (((0, 0), panels.OPEN), ((1, 0), panels.CLOSED),
                             ((1, 1), panels.SLIP), ((1, 2), panels.STICK),
                             ((0, 1), panels.OPEN_SLIP),
                             ((0, 2), panels.OPEN_STICK),
                             ((3, 1), panels.MAYBE_SLIP),
                             ((3, 2), panels.MAYBE_STICK),
                             ((-1, -1), panels.CLAMPED),
                             ((3, 0), panels.UNDECIDED),
                             ((0, 3), panels.UNDECIDED),
                             ((1, 3), panels.UNDECIDED),
                             ((3, 3), panels.UNDECIDED)):
            panel, = panels.panels_of(contact_on(bottom, 4, status), self.points)
            self.assertEqual(panels.counts(panel), {kind: 20}, status)
            self.assertEqual(len(panels.quarters(panel, kind)), 48)
            self.assertEqual(panel.pressure.max(), 0 if status[0] in (0, 3) else 2)

    def test_a_run_that_is_not_certified_shows_its_pressure(self):
        bottom = side(self.points, self.faces, 2, 0)
        contact = contact_on(bottom, 4, (3, 3))
        contact.pressure[self.points[bottom][:, :, 0] < 0.5] = 1e-9
        self.assertEqual(panels.shown_pressure(contact, True).max(), 0)
        panel, = panels.panels_of(contact, self.points, certified=False)
        self.assertEqual(panel.pressure.max(), 2)
        self.assertEqual(panels.counts(panel), {panels.UNDECIDED: 4,
                                                panels.PRESSED: 16})

    def test_window_has_all_nodes_with_forces(self):
        bottom = side(self.points, self.faces, 2, 0)
        contact = contact_on(bottom, 4, (0, 0))
        corner = (self.points[bottom][:, :, :2] < 0.5).all(axis=2)
        for status in ((1, 0), (0, 2), (3, 3)):
            contact.normal_status[corner], contact.tangential_status[corner] = \
                status
            panel, = panels.panels_of(contact, self.points)
            self.assertTrue(panel.enlarged)
            np.testing.assert_allclose(panel.window, [[0, 0], [1.15, 1.15]])

    def test_frames_show_what_is_touched_in_any(self):
        bottom = side(self.points, self.faces, 2, 0)
        frames = []
        for corner in ((self.points[bottom][:, :, :2] < 0.5).all(axis=2),
                       (self.points[bottom][:, :, :2] > (3.5, 2.5)).all(axis=2)):
            contact = contact_on(bottom, 4, (0, 0))
            contact.normal_status[corner] = 1
            frames.append(contact)
        layout = render.largest_of(*map(panels.touched, frames))
        windows = [panels.panels_of(contact, self.points, True, layout)[0].window
                   for contact in frames]
        np.testing.assert_allclose(windows, 2 * [[[0, 0], [4, 3]]])

    def test_names_of_directions(self):
        self.assertEqual(panels.name_of(np.array([1, -1, 4e-17]) / np.sqrt(2)),
                         "(0.71, \N{MINUS SIGN}0.71, 0)")
        self.assertEqual(panels.name_of(np.array([-1, 0, 0]), signed=True),
                         "\N{MINUS SIGN}x")

    def test_scale_of_pressure(self):
        """A node at an edge does not set it, the middle of a small contact does."""
        belt, areas = np.append(np.linspace(4, 8, 100), 40), np.append(np.ones(100), 0.1)
        self.assertAlmostEqual(panels.scale_of(belt, areas), 1.2 * 7.7, delta=0.2)
        ball = np.append(np.full(1000, 1.0), np.linspace(0, 400, 50))
        self.assertEqual(panels.scale_of(ball, np.ones(ball.size)), 400)
        for nothing in (np.zeros(3), -np.ones(3)):
            self.assertEqual(panels.scale_of(nothing, np.ones(3)), 0)

    def test_a_pale_boundary_has_colours_of_its_own(self):
        ends = np.array([100, 40, 30, 1, 1e-9, 0])
        self.assertEqual([panels.end_of_colors(ends, i) for i in range(6)],
                         [100, 100, 30, 1, 100, 100])
        self.assertEqual(panels.end_of_colors(np.zeros(1), 0), 0)

    def test_corners_share_out_a_face(self):
        panel, = panels.panels_of(contact_on(side(self.points, self.faces, 2, 0),
                                             4), self.points)
        parts = panels.quarters(panel, panels.SLIP)
        areas = meshes.vector_areas(np.pad(parts, ((0, 0), (0, 0), (0, 1))))
        np.testing.assert_allclose(np.abs(areas[:, 2]), 0.25)


class Page(unittest.TestCase):
    """Nothing on the page is over anything else, whatever is shown."""

    def texts_of(self, lengths, sides, friction, converged=True, status=None,
                 time=None, cells=(4, 4, 4), pressure=2.0):
        """The boxes of all texts of the page of a brick with these sides."""
        points, faces = mesh_of(hexahedra(cells, high=lengths))
        contact = joined(*[
            contact_on(side(points, faces, axis, place), i, friction=friction)
            for i, (axis, place) in enumerate(sides)])
        if status is not None:
            contact.normal_status, contact.tangential_status = (
                np.resize(values, contact.faces.shape) for values in status)
        units = {"length": "mm", "force": "N", "stress": "MPa"}
        boundaries = [{"name": f"side {i}", "id": i} for i in range(len(sides))]
        run = SimpleNamespace(name="a brick", n_bodies=1, contact=contact, units=units,
                              time=time, released=False,
                              certified=converged or time is not None,
                              scale=SimpleNamespace(pressure=np.full(len(sides), pressure),
                                                    peak=max(2, np.max(pressure)),
                                                    force=np.arange(len(sides)),
                                                    friction=np.full((len(sides), 2), 1.)),
                              summary={"converged": converged, "contact": {
                                  "boundaries": boundaries, "max_pressure": 2e7,
                                  "force_on_body": [1e8, -1e8, 1e-9], "normal_force": 1e8,
                                  "open": 112, "closed": 2000, "slip": 1234,
                                  "stick": 0, "undecided": 321}})
        shown = panels.panels_of(contact, points, run.certified)
        figure = page.draw(run, shown, lambda width, height: SimpleNamespace(
            image=np.zeros((100, 150, 3)), factor=700, highest=1.2e8,
            axes=np.array([[0.5, -0.4], [0.6, 0.3], [0, 0.9]]), obstacle=" with its gaps as large"))
        figure.canvas.draw()
        found = figure.findobj(matplotlib.text.Text)
        boxes = [(text.get_text(), text.get_window_extent()) for text in found
                 if text.get_text() and text.get_visible()]
        self.check_arrows(figure)
        return figure, [(words, box) for words, box in boxes if box.width > 0]

    def check_arrows(self, figure):
        """No arrow is longer than the map is wide or high in its direction."""
        for axes in figure.axes:
            for quiver in axes.findobj(matplotlib.quiver.Quiver):
                box = axes.get_window_extent()
                longest = np.abs([quiver.U, quiver.V]).max(axis=1) * (
                    figure.dpi / quiver.scale)
                self.assertLessEqual(longest[0], 1.001 * box.width)
                self.assertLessEqual(longest[1], 1.001 * box.height)

    def check(self, *arguments, **options):
        """No texts overlap, and all of them are on the page."""
        figure, texts = self.texts_of(*arguments, **options)
        width, height = figure.canvas.get_width_height()
        for words, box in texts:
            self.assertTrue(0 <= box.x0 and box.x1 <= width and 0 <= box.y0
                            and box.y1 <= height, words)
        for (one, a), (two, b) in itertools.combinations(texts, 2):
            overlap = min(a.x1, b.x1) - max(a.x0, b.x0), \
                min(a.y1, b.y1) - max(a.y0, b.y0)
            self.assertFalse(min(overlap) > 1, f"'{one}' and '{two}'")
        return [words for words, _ in texts]

    def test_brick(self):
        words = self.check((4, 3, 1), [(2, 0)], (1, 0.5, 0))
        self.assertIn("Contact boundary side 0", words)
        self.assertIn("pressure [MPa]", words)
        self.assertFalse(any("NOT CERTIFIED" in line for line in words))
        self.assertIn("slip 25", words)
        self.assertTrue(any("nodes: open 112, closed 2000, slip 1234, "
                            "undecided 321" in line for line in words))

    def test_given_friction_tells_what_open_nodes_do(self):
        words = self.check((4, 3, 1), [(2, 0)], (1, 0.5, 0), status=(
            [0, 0, 0, 1, 1, 1, 3, 3, 3, -1], [0, 1, 2, 0, 1, 2, 1, 2, 3, -1]))
        for name in ("open ", "closed ", "open, slip", "open, stick",
                     "open or closed, slip", "open or closed, stick",
                     "undecided", "clamped or nothing opposite"):
            self.assertTrue(any(line.startswith(name) for line in words), name)

    def test_long_flat_and_tall(self):
        for lengths in ((200, 10, 10), (1e-3, 2e-2, 1), (3, 3, 0.01),
                        (1, 1e-4, 1)):
            for friction in ((0, -1, 0), (0, 0, 0)):
                self.check(lengths, [(2, 0)], friction)

    def test_a_single_cell(self):
        for lengths in ((1, 1, 1), (200, 10, 10), (10, 200, 10), (1, 1, 1e-3)):
            for friction in ((1, 0, 0), (0, -1, 0), (-1, 1, 0)):
                self.check(lengths, [(2, 0)], friction, cells=(1, 1, 1))
        self.check((1, 1, 1), [(2, 0), (0, 1), (1, 0)], (1, 1, 1), cells=(1, 1, 1))

    def test_three_boundaries_not_certified(self):
        words = self.check((2, 2, 2), [(2, 0), (0, 2), (1, 0)], (-1, -1, -1),
                           converged=False)
        self.assertIn("NOT CERTIFIED", words)
        self.assertIn("pressure, not certified [MPa]", words)
        self.assertEqual(sum("Contact boundary" in line for line in words), 3)

    def test_those_that_bear_most_of_many(self):
        words = self.check((2, 2, 2), [(2, 0), (0, 2), (1, 0)] * 4, (-1, -1, -1))
        self.assertEqual(sum("Contact boundary" in line for line in words), 8)
        self.assertIn("not drawn: 4 more maps", words)
        for i in range(12):
            self.assertEqual(f"Contact boundary side {i}" in words, i >= 4)

    def test_frame(self):
        words = self.check((4, 3, 1), [(2, 0)], (1, 0, 0), converged=False,
                           time=0.25)
        self.assertIn("t = 0.25", words)
        self.assertNotIn("NOT CERTIFIED", words)
        self.assertIn("pressure, up to 2 [MPa]", words)

    def test_frames_have_maps_of_one_size_and_arrows_of_one_scale(self):
        points, faces = mesh_of(hexahedra((4, 4, 4), high=(4, 3, 1)))
        bottom = side(points, faces, 2, 0)
        layout = SimpleNamespace(loaded=np.ones(bottom.shape, bool),
                                 pressure=np.ones(bottom.shape))
        slots = [page.Slot(panels.panels_of(
            contact_on(bottom, 4, status, friction=friction), points, True, layout)[0],
            2, np.array([1., 1.5])) for status, friction in
            (((1, 1), (1, 0.5, 0)), ((1, 2), (0.1, 0, 0)), ((0, 0), (0, 0, 0)))]
        for slot in slots[1:]:
            np.testing.assert_array_equal(slot.size, slots[0].size)
            self.assertEqual(slot.height, slots[0].height)
        self.assertEqual(slots[0].per_inch, slots[1].per_inch)
        self.assertEqual(slots[2].usual, 0)

    def test_no_friction(self):
        for friction in 0, 1e-9:  # which is rounding beside a pressure of 2
            self.assertIn("no friction",
                          self.check((4, 3, 1), [(2, 1)], (friction, 0, 0)))

    def test_a_few_nodes_beyond_the_scale(self):
        self.assertIn("pressure, up to 2 [MPa]",
                      self.check((4, 3, 1), [(2, 1)], (1, 0, 0), pressure=0.5))

    def test_boundaries_of_which_one_bears_a_hundredth(self):
        figure, _ = self.texts_of((2, 2, 2), [(2, 0), (0, 2), (1, 0)], (1, 0, 0),
                                  pressure=[200, 2, 150])
        bars = [(axes.get_xlabel(), axes.get_xlim()[1]) for axes in figure.axes
                if axes.get_xlabel().startswith("pressure")]
        self.assertEqual(bars, [("pressure, up to 2 [MPa]", end) for end in (200, 2, 200)])

    def test_ties_that_hardly_pull(self):
        for pull, is_shown in ((0.5, False), (5, True)):
            panel = SimpleNamespace(kind=np.full(2, panels.TIED),
                                    pressure=np.array([-pull, 100.]))
            self.assertEqual(panels.has_tension(panel), is_shown)
        self.assertFalse(panels.has_tension(SimpleNamespace(
            kind=np.full(2, panels.STICK), pressure=np.array([-5., 100.]))))

    def test_the_longest_words_of_a_color_bar(self):
        drawn = page.Page(5)
        drawn.color_bar(10, 1, 2.55, page.PRESSURE, 2e7,
                        "pressure, not certified, green: tension", "MPa", 1.5e7)
        drawn.figure.canvas.draw()
        box = drawn.figure.axes[0].get_tightbbox()
        self.assertLess(box.x1, drawn.figure.bbox.x1)

    def test_nothing_pressed(self):
        self.assertIn("no pressure",
                      self.check((4, 3, 1), [(2, 1)], (1, 0, 0), pressure=0))

    def test_a_tie(self):
        words = self.check((4, 3, 1), [(2, 0)], (1, 0, 0), status=([1], [4]))
        self.assertIn("tied 25", words)


if __name__ == "__main__":
    unittest.main()
