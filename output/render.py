#!/usr/bin/python3
"""Draw the result of one run of stiction: the body and its contact face.

Call:   xvfb-run -a python3 output/render.py DIRECTORY [PICTURE.png]
after, for instance, './run parameters/brick.prm' with DIRECTORY output/brick.

DIRECTORY holds solution.pvtu and contact.pvtu, written on any number of
ranks; without PICTURE.png the picture is DIRECTORY.png. Needs the Debian
packages python3-vtk9, and xvfb and xauth where there is no screen.

Left: the deformed body, exaggerated, with the von Mises stress (the values of
all cells at a node averaged), its undeformed edges, and the foundation where
it is flat. Right: the contact face, a side of a brick cut into rectangles,
seen along the axis across it. Every node colours the part of the face nearest
to it, so that no status is ever interpolated. Arrows start at their nodes; on
fine meshes only some of the nodes have one.
"""

import math
import os
import sys
from types import SimpleNamespace

try:
    import vtk
except ImportError:
    sys.exit(f"render.py: {sys.executable} has no module vtk, install the "
             "package python3-vtk9 and call Debian's own /usr/bin/python3.")

# Lengths are pixels, counted from the lower left corner of the picture.
SIZE = (1600, 800)
SHARPER = 2  # drawn this many times larger, then shrunk: smooth lines
FACE = ((1232, 405), (645, 484))  # its middle, and room for width and height
BAR = (160, 90, 638, 110)  # left, bottom, right, top, as of every box
LEGEND = 910
TICK = 10
FONT = 20
ALIGN = {"middle": (1, 1), "left": (0, 1), "right": (2, 1), "top": (1, 2)}

CLAMPED = -1
# name and colour; the colours differ in lightness as well as in hue
STATUS = {0: ("open", 0xD3E9F7), 1: ("slip", 0xF2B13C),
          2: ("stick", 0x3F8FC6), CLAMPED: ("clamped", 0xB8B8B8)}
TEXT, EDGES, PLATE, WHITE = 0x212121, 0x737373, 0xDEDEDE, 0xFFFFFF
VIRIDIS = (0x440154, 0x482878, 0x3E4989, 0x31688E, 0x26828E, 0x1F9E89,
           0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725)


def fail(sentence):
    """End with one sentence on stderr and exit status 1."""
    sys.exit(f"render.py: {sentence}")


def set_up(this, **settings):
    """Call this.SetName(value) for every Name=value, return this."""
    for name, value in settings.items():
        getattr(this, "Set" + name)(value)
    return this


def output_of(algorithm, data=None, **settings):
    """Run a VTK reader, source or filter."""
    if data is not None:
        algorithm.SetInputData(data)
    set_up(algorithm, **settings).Update()
    return algorithm.GetOutput()


def float_array(tuples):
    """Return a VTK array of these tuples."""
    array = set_up(vtk.vtkFloatArray(), NumberOfComponents=len(tuples[0]))
    for values in tuples:
        array.InsertNextTuple(values)
    return array


def rgb(color):
    """Return red, green and blue from 0 to 1."""
    return [(color >> shift & 255) / 255 for shift in (16, 8, 0)]


def rounded(number, digits=range(1, 11)):
    """Return a positive number, rounded to one of these first digits."""
    power = 10 ** math.floor(math.log10(number))
    return power * min(digits, key=lambda d: abs(number / power - d))


def read(directory, name, *fields):
    """Return a grid, its points, and these fields at the points."""
    file = os.path.join(directory, name)
    if not os.path.isfile(file):
        fail(f"there is no file {file}, run stiction first.")
    reader = vtk.vtkXMLPUnstructuredGridReader()
    grid = output_of(reader, FileName=file)
    if reader.GetErrorCode() or grid.GetNumberOfCells() == 0:
        fail(f"{file} or one of the files it names cannot be read.")
    everywhere = range(grid.GetNumberOfPoints())
    points = [grid.GetPoint(i) for i in everywhere]
    result = SimpleNamespace(grid=grid, points=points)
    for field in fields:
        array = grid.GetPointData().GetArray(field)
        if array is None:
            fail(f"{file} has no point data '{field}'.")
        values = [array.GetTuple(i) for i in everywhere]
        setattr(result, field, [v[0] if len(v) == 1 else v for v in values])
    return result


def add_data(view, data, color=None, width=1, opacity=1, ambient=1):
    """Show a surface or lines in one colour, or in those of its data."""
    mapper = set_up(vtk.vtkPolyDataMapper(), InputData=data,
                    ScalarVisibility=color is None,
                    ColorMode=vtk.VTK_COLOR_MODE_DIRECT_SCALARS)
    actor = set_up(vtk.vtkActor(), Mapper=mapper)
    set_up(actor.GetProperty(), Color=rgb(color or 0), Opacity=opacity,
           LineWidth=width * SHARPER, Lighting=ambient < 1, Ambient=ambient,
           Diffuse=1 - ambient)
    view.AddActor(actor)
    return mapper


def add_boxes(page, boxes):
    """Fill boxes, {box: its colour}."""
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    for left, bottom, right, top in boxes:
        corners = (left, bottom), (right, bottom), (right, top), (left, top)
        cells.InsertNextCell(4, [points.InsertNextPoint(*corner, 0)
                                 for corner in corners])
    data = set_up(vtk.vtkPolyData(), Points=points, Polys=cells)
    data.GetCellData().SetScalars(float_array(list(boxes.values())))
    add_data(page, data)


def add_arrows(view, tails, vectors):
    """Draw arrows from these points."""
    points = set_up(vtk.vtkPoints(), Data=float_array(tails))
    data = set_up(vtk.vtkPolyData(), Points=points)
    data.GetPointData().SetVectors(float_array(vectors))
    arrow = output_of(vtk.vtkArrowSource(), TipRadius=0.14, ShaftRadius=0.035)
    add_data(view, output_of(vtk.vtkGlyph3D(), data, SourceData=arrow,
                             ScaleMode=vtk.VTK_SCALE_BY_VECTOR), TEXT)


def add_text(view, text, *point, align="middle", size=FONT):
    """Write so that this part of the text is at the point."""
    actor = set_up(vtk.vtkTextActor(), Input=text)
    set_up(actor.GetTextProperty(), FontSize=size * SHARPER, Bold=size > FONT,
           Color=rgb(TEXT), Justification=ALIGN[align][0],
           VerticalJustification=ALIGN[align][1])
    set_up(actor.GetPositionCoordinate(), CoordinateSystem=vtk.VTK_WORLD,
           Value=(*point, 0)[:3])
    view.AddActor2D(actor)


def add_title(page, middle, title, subtitle):
    """Write a title and a smaller line below it."""
    add_text(page, title, middle * SIZE[0], 764, size=FONT + 6)
    add_text(page, subtitle, middle * SIZE[0], 728)


def add_scale(page, name, low, high, start, end, beside, upwards=False):
    """Draw a scale from low to high, between the pixels start and end."""
    def place(along, off):
        return (beside - off, along) if upwards else (along, beside - off)

    boxes = [(*place(start, 0.5), *place(end, -0.5))]
    per_value = (end - start) / (high - low)
    step = rounded(80 / per_value, (1, 2, 5, 10))
    for i in range(math.ceil(low / step - 1e-6),
                   math.floor(high / step + 1e-6) + 1):
        along = start + (i * step - low) * per_value
        boxes.append((*place(along - 0.5, TICK), *place(along + 0.5, 0)))
        add_text(page, f"{i * step:g}", *place(along, 1.5 * TICK),
                 align="right" if upwards else "top")
    add_boxes(page, {box: rgb(TEXT) for box in boxes})
    add_text(page, name, *place((start + end) / 2, 81 if upwards else 61))


def surface_of(body):
    """Return the surface with the stress in MPa, and the highest stress."""
    # every cell has its own copy of its vertices: average, then merge
    stresses = {}
    for point, stress in zip(body.points, body.von_Mises_stress):
        stresses.setdefault(point, []).append(stress / 1e6)
    mean = {point: sum(s) / len(s) for point, s in stresses.items()}
    body.grid.GetPointData().SetScalars(
        float_array([[mean[point]] for point in body.points]))
    merged = vtk.vtkUnstructuredGrid()
    merge = set_up(vtk.vtkMergeCells(), UnstructuredGrid=merged,
                   TotalNumberOfDataSets=1, PointMergeTolerance=0,
                   TotalNumberOfCells=body.grid.GetNumberOfCells(),
                   TotalNumberOfPoints=len(body.points))
    merge.MergeDataSet(body.grid)
    merge.Finish()
    surface = output_of(vtk.vtkDataSetSurfaceFilter(), merged)
    return surface, max(mean.values()) or 1


def add_foundation(view, body, face, factor):
    """Show the foundation, factor times as far off as it is, if it is flat."""
    level = face.points[0][face.across]
    outward = 1 if level > body.grid.GetCenter()[face.across] else -1
    displacement = dict(zip(body.points, body.displacement))
    initial = [gap + outward * displacement[p][face.across] for p, gap, status
               in zip(face.points, face.gap, face.status) if status != CLAMPED]
    if initial and max(initial) - min(initial) <= 1e-3 * body.largest:
        near = level + outward * factor * sum(initial) / len(initial)
        far = near + outward * 0.016 * body.size
        bounds = [b + sign * 0.08 * body.size for b, sign
                  in zip(body.grid.GetBounds(), (-1, 1, -1, 1, -1, 1))]
        bounds[2 * face.across:2 * face.across + 2] = sorted((near, far))
        plate = output_of(vtk.vtkCubeSource(), Bounds=bounds)
        add_data(view, plate, PLATE, ambient=0.6)


def draw_body(page, view, axes, body, face):
    """Draw the deformed body, its axes and the scale of its stress."""
    surface, highest = surface_of(body)
    surface.GetPointData().SetActiveVectors("displacement")
    factor = rounded(0.1 * body.size / body.largest) if body.largest else 1
    deformed = output_of(vtk.vtkWarpVector(), surface, ScaleFactor=factor)
    colors = vtk.vtkColorTransferFunction()
    for i, color in enumerate(VIRIDIS):
        colors.AddRGBPoint(highest * i / (len(VIRIDIS) - 1), *rgb(color))
    set_up(add_data(view, deformed, ambient=0.7), LookupTable=colors,
           InterpolateScalarsBeforeMapping=True,
           ColorMode=vtk.VTK_COLOR_MODE_MAP_SCALARS)
    faint = min(0.3, 14 / math.sqrt(deformed.GetNumberOfCells()))
    mesh = output_of(vtk.vtkExtractEdges(), deformed)
    add_data(view, mesh, WHITE, 0.5, faint)
    add_data(view, output_of(vtk.vtkFeatureEdges(), surface), EDGES)
    add_foundation(view, body, face, factor)

    for name, axis in (("x", (1, 0, 0)), ("y", (0, 1, 0)), ("z", (0, 0, 1))):
        add_arrows(axes, [(0, 0, 0)], [axis])
        add_text(axes, name, *(1.25 * a for a in axis))
    for renderer in (view, axes):
        set_up(renderer.GetActiveCamera(), ViewUp=(0, 0, 1), ViewAngle=20,
               Position=(1, -0.6, 0.55))
        renderer.ResetCamera()
    view.GetActiveCamera().SetWindowCenter(0, -0.08)  # above the bar

    left, bottom, right, top = BAR
    add_boxes(page, {(x, bottom, x + 1, top):
                     colors.GetColor(highest * (x - left) / (right - left))
                     for x in range(left, right)})
    add_scale(page, "von Mises stress [MPa]", 0, highest, left, right, bottom)
    add_title(page, 0.25, "The deformed body", "displacement exaggerated "
              f"{factor:g} times, grey lines: before loading")


def arrows_of(friction, largest_traction):
    """Return {node: arrow in m}, the usual friction in Pa, and m per Pa."""
    sizes = sorted(math.hypot(*t) for t in friction.values())
    usual = sizes[int(0.95 * (len(sizes) - 1))] or sizes[-1]
    if usual <= 1e-6 * largest_traction:
        return {}, 0, 0
    lines = [sorted(set(places)) for places in zip(*friction)]
    some = [set(places[::math.ceil(len(places) / 40)]) for places in lines]
    tails = [p for p in friction if p[0] in some[0] and p[1] in some[1]]
    area = math.prod(places[-1] - places[0] for places in lines)
    per_Pa = 1.3 * math.sqrt(area / len(tails)) / usual
    return {p: [per_Pa * t for t in friction[p]] for p in tails}, usual, per_Pa


def draw_contact(page, face):
    """Draw the status of the nodes and the friction on them."""
    axes = [c for c in range(3) if c != face.across]  # to the right and up
    nodes = [tuple(p[c] for c in axes) for p in face.points]
    status = dict(zip(nodes, face.status))
    friction = dict(zip(nodes, ([t[c] for c in axes] for t in face.traction)))
    largest = max(math.hypot(*t) for t in face.traction)
    arrows, usual, per_Pa = arrows_of(friction, largest)

    # the scales stand off where arrows reach out of the face beyond the ticks
    low, high = zip(*((min(c), max(c)) for c in zip(*nodes)))
    off = max([0] + [max(low[c] - p[c] - v[c], p[c] + v[c] - high[c])
                     for p, v in arrows.items() for c in (0, 1)])
    off *= off > 0.015 * max(b - a for a, b in zip(low, high))
    scale = min(room / (b - a + 2 * off)
                for room, a, b in zip(FACE[1], low, high))
    origin = [m - scale * (a + b) / 2 for m, a, b in zip(FACE[0], low, high)]

    def pixel(*point):
        return [o + scale * p for o, p in zip(origin, point)]

    (left, bottom), (right, top) = pixel(*low), pixel(*high)
    off *= scale
    names = ["xyz"[c] + " [m]" for c in axes]
    add_scale(page, names[0], low[0], high[0], left, right, bottom - off)
    add_scale(page, names[1], low[1], high[1], bottom, top, left - off, True)

    # a dark box behind the cells leaves an outline of one pixel
    boxes = {(left - 1, bottom - 1, right + 1, top + 1): rgb(TEXT)}
    for cell in range(face.grid.GetNumberOfCells()):
        bounds = face.grid.GetCell(cell).GetBounds()
        xs, ys = (bounds[2 * c:2 * c + 2] for c in axes)
        middle = pixel(sum(xs) / 2, sum(ys) / 2)
        for node in ((x, y) for x in xs for y in ys):
            if node not in status:
                fail("the cells of the contact face are no rectangles.")
            boxes[(*pixel(*node), *middle)] = rgb(STATUS[status[node]][1])
    x, y = LEGEND, top + off + 39
    for value, (name, color) in STATUS.items():
        text = f"{name} {list(status.values()).count(value)}"
        if value in face.status or value != CLAMPED:
            boxes[(x, y - 11, x + 22, y + 11)] = rgb(color)
            add_text(page, text, x + 32, y, align="left")
            x += 58 + 12.3 * len(text)
    add_boxes(page, boxes)

    if arrows:
        key = rounded(usual / 1e6)
        x, y = LEGEND + 174, bottom - off - 106
        length = scale * per_Pa * key * 1e6
        add_arrows(page, [(*pixel(*p), 1) for p in arrows] + [(x, y, 1)],
                   [(scale * v[0], scale * v[1], 0) for v in arrows.values()]
                   + [(length, 0, 0)])
        add_text(page, f"{key:g} MPa of friction on the body",
                 x + length + 10, y, align="left")
    add_title(page, 0.75, "The contact face", "status of the nodes, with "
              f"their number, seen from {('+x', '-y', '+z')[face.across]}")


def main(arguments):
    """Draw what the command line says."""
    if arguments in (["-h"], ["--help"]):
        return print(__doc__.strip())
    if len(arguments) not in (1, 2):
        fail("call it as render.py DIRECTORY [PICTURE.png].")
    directory = os.path.normpath(arguments[0])
    picture = arguments[1] if len(arguments) == 2 else directory + ".png"
    if not os.path.isdir(directory):
        fail(f"there is no directory {directory}, run stiction first.")
    if not os.environ.get("DISPLAY"):
        fail("there is no screen, put 'xvfb-run -a' before the command.")
    vtk.vtkObject.GlobalWarningDisplayOff()
    vtk.vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
    # a line on a surface has gaps when it is not drawn in front of it
    vtk.vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(0, -40)
    body = read(directory, "solution.pvtu", "displacement", "von_Mises_stress")
    face = read(directory, "contact.pvtu", "traction", "gap", "status")
    if not STATUS.keys() >= set(face.status):
        fail(f"a status in contact.pvtu is none of {sorted(STATUS)}.")
    if not set(face.points) <= set(body.points):
        fail("solution.pvtu and contact.pvtu are not of the same run.")
    body.size = max(max(c) - min(c) for c in zip(*body.points))
    body.largest = max(math.hypot(*u) for u in body.displacement)
    extent = [max(c) - min(c) for c in zip(*face.points)]
    face.across = extent.index(min(extent))

    window = set_up(vtk.vtkRenderWindow(), OffScreenRendering=True,
                    NumberOfLayers=2, Size=[SHARPER * s for s in SIZE])
    page = set_up(vtk.vtkRenderer(), Background=(1, 1, 1))
    view = set_up(vtk.vtkRenderer(), Layer=1, Viewport=(0, 0, 0.5, 1))
    axes = set_up(vtk.vtkRenderer(), Layer=1, Viewport=(0.01, 0.71, 0.1, 0.89))
    for renderer in (page, view, axes):
        window.AddRenderer(renderer)
    draw_body(page, view, axes, body, face)
    draw_contact(page, face)
    x, y = SIZE[0] / 2, SIZE[1] / 2  # the page's coordinates become pixels
    set_up(page.GetActiveCamera(), ParallelProjection=True,
           ParallelScale=y, FocalPoint=(x, y, 0), Position=(x, y, 100))
    window.Render()
    image = output_of(vtk.vtkWindowToImageFilter(), Input=window)
    image = output_of(vtk.vtkImageResize(), image, OutputDimensions=(*SIZE, 1),
                      Border=True)  # so that it averages whole pixels
    # only 64 shades of each colour, for a smaller file
    for shift, scale in ((2, 63 / 255), (0.001, 255 / 63)):
        image = output_of(vtk.vtkImageShiftScale(), image, Shift=shift,
                          Scale=scale, ClampOverflow=True,
                          OutputScalarType=vtk.VTK_UNSIGNED_CHAR)
    writer = set_up(vtk.vtkPNGWriter(), CompressionLevel=9, InputData=image,
                    FileName=picture)
    writer.Write()
    if writer.GetErrorCode():
        fail(f"the picture {picture} cannot be written.")
    print(f"Wrote {picture}")


if __name__ == "__main__":
    main(sys.argv[1:])
