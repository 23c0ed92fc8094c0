#!/usr/bin/python3
"""Draw the result of one run of stiction: the body and its contact face.

Call:   xvfb-run -a python3 output/render.py DIRECTORY [PICTURE.png]
For instance, after './run parameters/brick.prm':
        xvfb-run -a python3 output/render.py output/brick

DIRECTORY holds solution.pvtu and contact.pvtu, written on any number of
ranks; without PICTURE.png the picture is DIRECTORY.png. Needs the Debian
packages python3-vtk9, and xvfb and xauth where there is no screen.

Left: the deformed body, exaggerated, with the von Mises stress (the values of
all cells at a node averaged), its undeformed edges, and the foundation where
it is flat. Right: the contact face, a plane across one of the axes, seen
along that axis. Every node colours the part of the face nearest to it, so
that no status is ever interpolated. Arrows start at their nodes; on fine
meshes only some of the nodes have one.
"""

import math
import os
import sys

try:
    import vtk
except ImportError:
    sys.exit(f"render.py: {sys.executable} has no module vtk, install the "
             "package python3-vtk9 and call Debian's own /usr/bin/python3.")

# Pixels count from the lower left corner of the picture.
WIDTH, HEIGHT = 1600, 800
SHARPER = 2  # drawn this many times larger, then shrunk: smooth lines
FACE = (910, 163, 645, 484)  # left, bottom, largest width and height
BAR = (160, 78, 478, 20)
TICK = 10
FONT = 20

STATUS = {  # name and colour; they differ in lightness as well as in hue
    0: ("open", 0xD3E9F7),
    1: ("slip", 0xF2B13C),
    2: ("stick", 0x3F8FC6),
    -1: ("clamped", 0xB8B8B8),
}
TEXT, GREY, PLATE, WHITE = 0x212121, 0x737373, 0xDEDEDE, 0xFFFFFF
VIRIDIS = (0x440154, 0x482878, 0x3E4989, 0x31688E, 0x26828E, 0x1F9E89,
           0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725)


def fail(sentence):
    """End with one sentence on stderr and exit status 1."""
    sys.exit(f"render.py: {sentence}")


# --- the result files ------------------------------------------------------

def read(directory, name, fields):
    """Return a grid, its points, and the values of these fields at them."""
    file = os.path.join(directory, name)
    if not os.path.isfile(file):
        fail(f"there is no file {file}, run stiction first.")
    reader = vtk.vtkXMLPUnstructuredGridReader()
    reader.SetFileName(file)
    grid = output_of(reader)
    if reader.GetErrorCode() or grid.GetNumberOfCells() == 0:
        fail(f"{file} or one of the files it names cannot be read.")
    everywhere = range(grid.GetNumberOfPoints())
    result = [grid, [grid.GetPoint(i) for i in everywhere]]
    for field in fields:
        array = grid.GetPointData().GetArray(field)
        if array is None:
            fail(f"{file} has no point data '{field}'.")
        values = [array.GetTuple(i) for i in everywhere]
        result.append([v[0] if len(v) == 1 else v for v in values])
    return result


class Body:
    """The surface of the body with its stress, and the displacements."""

    def __init__(self, directory):
        cells, points, displacements, stresses = read(
            directory, "solution.pvtu", ("displacement", "von_Mises_stress"))
        self.displacement = dict(zip(points, displacements))
        self.largest = max(math.hypot(*u) for u in displacements)

        # every cell has its own copy of its vertices: average, then merge
        at_node = {}
        for point, stress in zip(points, stresses):
            at_node.setdefault(point, []).append(stress / 1e6)
        average = {p: sum(of) / len(of) for p, of in at_node.items()}
        self.highest = max(average.values()) or 1
        array = vtk.vtkFloatArray()
        array.SetName("stress_MPa")
        for point in points:
            array.InsertNextValue(average[point])
        cells.GetPointData().SetScalars(array)
        merge = vtk.vtkAppendFilter()
        merge.MergePointsOn()
        self.surface = output_of(vtk.vtkDataSetSurfaceFilter(),
                                 output_of(merge, cells))


class ContactFace:
    """The contact face: its nodes and cells, and how it lies in space."""

    def __init__(self, directory, body):
        grid, points, tractions, gaps, statuses = read(
            directory, "contact.pvtu", ("traction", "gap", "status"))
        if not STATUS.keys() >= set(statuses):
            fail(f"the status in {directory}/contact.pvtu has values other "
                 f"than {sorted(STATUS)}.")
        if not body.displacement.keys() >= set(points):
            fail("solution.pvtu and contact.pvtu are not of the same run.")
        self.low, self.high = zip(*((min(c), max(c)) for c in zip(*points)))
        extent = [b - a for a, b in zip(self.low, self.high)]
        self.across = across = extent.index(min(extent))
        self.axes = [c for c in range(3) if c != across]  # right and up
        self.seen_from = ("+x", "-y", "+z")[across]  # so it is not mirrored
        # the foundation lies on the other side of the face than the body
        middle = body.surface.GetCenter()[across]
        self.outward = 1 if self.low[across] > middle else -1

        flat = [[p[c] for c in self.axes] for p in points]
        self.status = dict(zip(map(tuple, flat), statuses))
        self.friction = {tuple(p): [t[c] / 1e6 for c in self.axes]
                         for p, t in zip(flat, tractions)}
        self.largest_traction = max(math.hypot(*t) for t in tractions) / 1e6
        self.cells = []  # the corners of every cell and their status
        for cell in range(grid.GetNumberOfCells()):
            ids = grid.GetCell(cell).GetPointIds()
            ids = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
            self.cells.append(([flat[i] for i in ids],
                               [statuses[i] for i in ids]))

        # how far off the foundation lies, None where it is not flat
        offsets = [gap + self.outward * body.displacement[p][across]
                   for p, gap, s in zip(points, gaps, statuses) if s != -1]
        self.foundation = None
        if offsets and max(offsets) - min(offsets) <= 1e-3 * body.largest:
            self.foundation = sum(offsets) / len(offsets)


# --- pieces of the drawing -------------------------------------------------

def output_of(algorithm, data=None):
    """Run a VTK reader, source or filter."""
    if data is not None:
        algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def rgb(color):
    """Return red, green and blue from 0 to 1."""
    return [(color >> shift & 255) / 255 for shift in (16, 8, 0)]


def rounded(number, digits=range(1, 11)):
    """Return a positive number, rounded to one of these first digits."""
    power = 10 ** math.floor(math.log10(number))
    return power * min(digits, key=lambda d: abs(number / power - d))


def new_view(layer, left, bottom, right, top):
    """Return a white renderer of this part of the window."""
    renderer = vtk.vtkRenderer()
    renderer.SetLayer(layer)
    renderer.SetViewport(left, bottom, right, top)
    renderer.SetBackground(1, 1, 1)
    return renderer


def add_data(renderer, data, color=None, width=1, opacity=1, ambient=1):
    """Show a surface or lines in one colour, or in those of its data."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetColorModeToDirectScalars()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetLineWidth(width * SHARPER)
    look.SetOpacity(opacity)
    look.SetLighting(ambient < 1)
    look.SetAmbient(ambient)
    look.SetDiffuse(1 - ambient)
    if color is not None:
        mapper.ScalarVisibilityOff()
        look.SetColor(rgb(color))
    renderer.AddActor(actor)
    return mapper


def add_polygons(page, polygons, colors):
    """Fill polygons, given by their corners, with one colour each."""
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    shades = vtk.vtkFloatArray()
    shades.SetNumberOfComponents(3)
    for corners, color in zip(polygons, colors):
        cells.InsertNextCell(len(corners))
        for corner in corners:
            cells.InsertCellPoint(points.InsertNextPoint(*corner, 0))
        shades.InsertNextTuple(color)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetCellData().SetScalars(shades)
    add_data(page, data)


def add_line(page, start, end):
    """Draw a line between two pixels."""
    line = vtk.vtkLineSource()
    line.SetPoint1(*start, 0)
    line.SetPoint2(*end, 0)
    add_data(page, output_of(line), TEXT)


def rectangle(left, bottom, width, height):
    """Return the corners of a rectangle."""
    return [(left + a * width, bottom + b * height)
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]


def add_arrows(renderer, tails, vectors, factor=1):
    """Draw arrows from the tails, factor times as long as the vectors."""
    points, directions = vtk.vtkPoints(), vtk.vtkFloatArray()
    directions.SetNumberOfComponents(3)
    for tail, vector in zip(tails, vectors):
        points.InsertNextPoint(tail)
        directions.InsertNextTuple(vector)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().SetVectors(directions)
    arrow = vtk.vtkArrowSource()
    arrow.SetTipLength(0.35)
    arrow.SetTipRadius(0.14)
    arrow.SetTipResolution(12)
    arrow.SetShaftRadius(0.035)
    glyph = vtk.vtkGlyph3D()
    glyph.SetSourceConnection(arrow.GetOutputPort())
    glyph.SetScaleModeToScaleByVector()
    glyph.SetScaleFactor(factor)
    add_data(renderer, output_of(glyph, data), TEXT)


def add_text(renderer, text, x, y, z=0, align="Centered", size=FONT):
    """Write at a point, which is the middle of the text or its side."""
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    look = actor.GetTextProperty()
    look.SetFontSize(size * SHARPER)
    look.SetBold(size > FONT)
    look.SetColor(rgb(TEXT))
    vertical = align == "Top"
    getattr(look, "SetJustificationTo" + ("Centered" if vertical else align))()
    look.SetVerticalJustification(2 if vertical else 1)  # top or middle
    actor.GetPositionCoordinate().SetCoordinateSystemToWorld()
    actor.GetPositionCoordinate().SetValue(x, y, z)
    renderer.AddActor2D(actor)


def add_scale(page, low, high, begin, end, beside, upwards=False):
    """Draw ticks for the values from low to high at pixels begin to end."""
    per_value = (end - begin) / (high - low)
    step = rounded(80 / per_value, (1, 2, 5, 10))
    for i in range(math.ceil(low / step - 1e-6),
                   math.floor(high / step + 1e-6) + 1):
        along = begin + (i * step - low) * per_value
        line = [(along, beside), (along, beside - TICK)]
        label = (along, beside - 1.5 * TICK)
        if upwards:
            line, label = [p[::-1] for p in line], label[::-1]
        add_line(page, *line)
        add_text(page, f"{i * step:g}", *label,
                 align="Right" if upwards else "Top")


# --- the two halves of the picture -----------------------------------------

def draw_body(page, body, face):
    """Return the views of the deformed body and of the axes."""
    lows, highs = body.surface.GetBounds()[0::2], body.surface.GetBounds()[1::2]
    size = max(b - a for a, b in zip(lows, highs))
    factor = rounded(0.1 * size / body.largest) if body.largest > 0 else 1
    warp = vtk.vtkWarpVector()
    warp.SetInputArrayToProcess(0, 0, 0, 0, "displacement")
    warp.SetScaleFactor(factor)
    deformed = output_of(warp, body.surface)

    colors = vtk.vtkColorTransferFunction()
    for i, color in enumerate(VIRIDIS):
        colors.AddRGBPoint(body.highest * i / (len(VIRIDIS) - 1), *rgb(color))
    view = new_view(1, 0, 0, 0.5, 1)
    mapper = add_data(view, deformed, ambient=0.7)
    mapper.SetColorModeToMapScalars()
    mapper.SetLookupTable(colors)
    mapper.InterpolateScalarsBeforeMappingOn()
    faint = min(0.3, 14 / math.sqrt(deformed.GetNumberOfCells()))
    mapper = add_data(view, output_of(vtk.vtkExtractEdges(), deformed), WHITE,
                      0.5, faint)
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -40)
    sharp_edges = vtk.vtkFeatureEdges()
    sharp_edges.ColoringOff()
    add_data(view, output_of(sharp_edges, body.surface), GREY)

    if face.foundation is not None:
        margin = 0.08 * (face.high[face.axes[0]] - face.low[face.axes[0]])
        sides = [[a - margin, b + margin] for a, b in zip(face.low, face.high)]
        top = face.low[face.across] + face.outward * factor * face.foundation
        sides[face.across] = sorted((top, top + face.outward * 0.2 * margin))
        plate = vtk.vtkCubeSource()
        plate.SetBounds(*sides[0], *sides[1], *sides[2])
        add_data(view, output_of(plate), PLATE, ambient=0.6)

    axes = new_view(1, 0.01, 0.71, 0.09, 0.89)
    for name, axis in (("x", (1, 0, 0)), ("y", (0, 1, 0)), ("z", (0, 0, 1))):
        add_arrows(axes, [(0, 0, 0)], [axis])
        add_text(axes, name, *(1.25 * a for a in axis))
    for renderer in (view, axes):
        camera = renderer.GetActiveCamera()
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(20)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetPosition(1, -0.6, 0.55)
        renderer.ResetCamera()
    view.GetActiveCamera().SetWindowCenter(0, -0.08)  # above the bar

    left, bottom, width, height = BAR
    strips = [i / 256 for i in range(256)]
    add_polygons(page, [rectangle(left + s * width, bottom, width / 256, height)
                        for s in strips],
                 [colors.GetColor(s * body.highest) for s in strips])
    add_scale(page, 0, body.highest, left, left + width, bottom)
    add_text(page, "von Mises stress [MPa]", left + width / 2, bottom + 42)
    add_text(page, "The deformed body", 400, 764, size=FONT + 6)
    add_text(page, f"displacement exaggerated {factor:g} times, grey lines: "
             "before loading", 400, 728)
    return view, axes


def friction_arrows(face):
    """Return the nodes with an arrow, the usual friction and m per MPa."""
    sizes = sorted(math.hypot(*t) for t in face.friction.values())
    usual = sizes[int(0.95 * (len(sizes) - 1))] or sizes[-1]
    if usual <= 1e-6 * face.largest_traction:
        return [], 0, 0
    nodes = set(face.friction)
    area = 1
    for c, axis in enumerate(face.axes):
        extent = face.high[axis] - face.low[axis]
        area *= extent
        place = {p: round(p[c] / extent, 6) for p in face.friction}
        lines = sorted(set(place.values()))
        some = set(lines[::math.ceil(len(lines) / 40)])
        nodes = {p for p in nodes if place[p] in some}
    return nodes, usual, 1.3 * math.sqrt(area / len(nodes)) / usual


def draw_contact(page, face):
    """Draw the contact face."""
    low, high = ([corner[c] for c in face.axes]
                 for corner in (face.low, face.high))
    nodes, usual, factor = friction_arrows(face)
    size = max(high[0] - low[0], high[1] - low[1])
    # leave room where arrows reach farther out of the face than a tick
    room = max([0] + [max(low[c] - tip, tip - high[c]) - 0.015 * size
                      for p in nodes for c in (0, 1)
                      for tip in [p[c] + factor * face.friction[p][c]]])
