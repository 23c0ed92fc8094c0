"""The deformed body, its outline before loading and the obstacle, with VTK."""

import math
from types import SimpleNamespace

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from . import meshes

OUTLINE, OBSTACLE, MESH = 0x555555, 0xA8A8A8, 0xFFFFFF
CELLS = vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS


def set_up(this, **settings):
    """Call this.SetName(value) for every Name=value, return this."""
    for name, value in settings.items():
        getattr(this, "Set" + name)(value)
    return this


def rgb(color):
    """Red, green and blue from 0 to 1."""
    return [(color >> shift & 255) / 255 for shift in (16, 8, 0)]


def rounded(number):
    """A positive number rounded to its first digit."""
    power = 10.0 ** math.floor(math.log10(number))
    return power * round(number / power)


def exaggeration(points, largest):
    """How many times larger than it is the displacement is drawn."""
    size = np.ptp(points, axis=0).max()
    return max(1, rounded(0.1 * size / largest)) if largest > 0 else 1


def view_basis(points):
    """To the right, upwards and towards who looks, at the larger sides."""
    lengths = np.maximum(np.ptp(points, axis=0), 1e-12)
    sides = lengths.prod() / lengths
    towards = meshes.unit(np.array([1, -0.6, 0.55])
                          * (sides / sides.max()) ** 0.35)
    right = meshes.unit(np.cross([0, 0, 1], towards))
    return np.array([right, np.cross(towards, right), towards])


def cells_of(points, cells):
    """VTK's points and cells, and which of the points they are."""
    used, corners = np.unique(cells, return_inverse=True)
    result = vtk.vtkCellArray()
    result.SetData(cells.shape[1], numpy_to_vtk(
        corners.astype(np.int64).reshape(-1), deep=True,
        array_type=vtk.VTK_ID_TYPE))
    return points_of(points[used]), result, used


def points_of(points):
    """VTK's points."""
    return set_up(vtk.vtkPoints(), Data=numpy_to_vtk(
        np.ascontiguousarray(points), deep=True))


def surface_of(points, faces, scalars):
    """VTK's surface of these faces, with a number at every point."""
    places, polygons, used = cells_of(points, faces)
    surface = set_up(vtk.vtkPolyData(), Points=places, Polys=polygons)
    surface.GetPointData().SetScalars(numpy_to_vtk(scalars[used], deep=True))
    return surface


def lines_of(points, edges):
    """VTK's lines between pairs of points."""
    places, lines, _ = cells_of(points, edges)
    return set_up(vtk.vtkPolyData(), Points=places, Lines=lines)


def actor_of(data, color=OUTLINE, ambient=1.0, **settings):
    """Data in one colour, lit unless ambient is 1; settings: its property."""
    if isinstance(data, vtk.vtkAlgorithm):
        data.Update()
        data = data.GetOutput()
    mapper = set_up(vtk.vtkPolyDataMapper(), InputData=data,
                    ScalarVisibility=False)
    actor = set_up(vtk.vtkActor(), Mapper=mapper)
    set_up(actor.GetProperty(), Color=rgb(color), Lighting=ambient < 1,
           Ambient=ambient, Diffuse=1 - ambient, **settings)
    return actor


def stress_actor(surface, highest, colors):
    """The body coloured by its stress from 0 to the highest."""
    table = set_up(vtk.vtkLookupTable(), NumberOfTableValues=len(colors),
                   TableRange=(0, highest))
    for i, color in enumerate(colors):
        table.SetTableValue(i, *color[:3], 1)
    actor = actor_of(surface, ambient=0.7)
    set_up(actor.GetMapper(), ScalarVisibility=True, LookupTable=table,
           UseLookupTableScalarRange=True, InterpolateScalarsBeforeMapping=True)
    return actor


def drawn_obstacles(run, factor):
    """The obstacles, their gaps as many times larger as the displacement.

    So a point of the body that touches one does so in the picture. What is far
    off then is left out.
    """
    append = vtk.vtkAppendPolyData()
    for boundary in np.unique(run.contact.boundary):
        part = set_up(vtk.vtkThreshold(), InputData=run.obstacle,
                      LowerThreshold=boundary, UpperThreshold=boundary)
        part.SetInputArrayToProcess(0, 0, 0, CELLS, "boundary")
        surface = vtk.vtkGeometryFilter()
        surface.SetInputConnection(part.GetOutputPort())
        surface.Update()
        if surface.GetOutput().GetNumberOfPoints():
            faces = run.contact.faces[run.contact.boundary == boundary]
            append.AddInputData(moved_away(surface.GetOutput(), run.body.points,
                                           faces, factor))
    clip = set_up(vtk.vtkClipPolyData(), InsideOut=True,
                  Value=0.3 * np.ptp(run.body.points, axis=0).max())
    clip.SetInputConnection(append.GetOutputPort())
    clip.Update()
    return clip.GetOutput()


def moved_away(obstacle, points, faces, factor):
    """An obstacle as many times as far from its contact boundary as it is.

    A little further, so that it does not shine through where it is touched.
    """
    normals = meshes.node_normals(faces, meshes.vector_areas(points[faces]),
                                  len(points))
    nodes = np.unique(faces)
    locator = set_up(vtk.vtkStaticPointLocator(), DataSet=set_up(
        vtk.vtkPolyData(), Points=points_of(points[nodes])))
    locator.BuildLocator()
    places = vtk_to_numpy(obstacle.GetPoints().GetData()).astype(float)
    nearest = nodes[[locator.FindClosestPoint(place) for place in places]]
    normal = normals[nearest]
    gap = ((places - points[nearest]) * normal).sum(axis=1)
    little = 0.003 * np.ptp(points, axis=0).max()
    moved = widened(places + ((factor - 1) * gap + little)[:, None] * normal)
    result = vtk.vtkPolyData()
    result.DeepCopy(obstacle)
    result.SetPoints(points_of(moved))
    result.GetPointData().SetScalars(numpy_to_vtk(factor * np.abs(gap),
                                                  deep=True))
    return result


def widened(places):
    """The points of a flat surface further apart, to be seen around the body.

    A foundation ends where its contact boundary does.
    """
    off = places - places.mean(axis=0)
    thickness = np.linalg.svd(off, compute_uv=False)[2]
    is_flat = thickness <= 1e-3 * np.linalg.norm(off)
    return places + 0.15 * off if is_flat else places


def camera_of(basis, actors):
    """A parallel view without its size, and extents of the actors in it."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for actor in actors:
        data = actor.GetMapper().GetInput()
        if data.GetNumberOfPoints():
            seen = vtk_to_numpy(data.GetPoints().GetData()) @ basis.T
            low = np.minimum(low, seen.min(axis=0))
            high = np.maximum(high, seen.max(axis=0))
    middle, far = (low + high) / 2 @ basis, 2 * np.linalg.norm(high - low)
    camera = set_up(vtk.vtkCamera(), ParallelProjection=True,
                    FocalPoint=middle, Position=middle + far * basis[2],
                    ViewUp=basis[1])
    return camera, (high - low)[:2]


def picture(run, colors, box):
    """Draw the body so that it fills a box, width and height in pixels.

    Returns the image, an array of rows from the top, and what was done: the
    factor of exaggeration, the highest stress, the axes on the picture.
    """
    body = run.body
    factor = exaggeration(body.points, run.scale.displacement)
    basis = view_basis(body.points)
    highest = run.scale.stress
    deformed = surface_of(body.points + factor * body.displacement, body.faces,
                          body.stress)
    faint = min(0.3, 14 / math.sqrt(len(body.faces)))
    edges = set_up(vtk.vtkExtractEdges(), InputData=deformed)
    actors = [stress_actor(deformed, highest or 1, colors),
              actor_of(edges, MESH, LineWidth=1, Opacity=faint),
              actor_of(lines_of(body.points, meshes.outline(
                  body.points, body.faces, basis[2])), LineWidth=2)]
    if run.obstacle is not None:
        obstacle = drawn_obstacles(run, factor)
        rim = set_up(vtk.vtkFeatureEdges(), InputData=obstacle)
        actors += [actor_of(obstacle, OBSTACLE, 0.6, Opacity=0.4),
                   actor_of(rim, OBSTACLE, LineWidth=2)]
    camera, extents = camera_of(basis, actors)
    image = rendered(actors, camera, extents, box)
    return SimpleNamespace(image=image, factor=factor, highest=highest,
                           axes=basis[:2].T, obstacle=run.obstacle is not None)


def rendered(actors, camera, extents, box):
    """The image of the actors as large as it fits into the box."""
    margin = 8  # for the width of lines
    extents = np.maximum(extents, 1e-3 * extents.max())
    per_unit = min(
        (side - 2 * margin) / extent for side, extent in zip(box, extents))
    size = [math.ceil(per_unit * extent) + 2 * margin for extent in extents]
    camera.SetParallelScale(size[1] / per_unit / 2)
    renderer = set_up(vtk.vtkRenderer(), Background=(1, 1, 1),
                      ActiveCamera=camera)
    for actor in actors:
        renderer.AddActor(actor)
    renderer.ResetCameraClippingRange()
    # a line on a surface has gaps when it is not drawn in front of it
    vtk.vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
    vtk.vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(0, -40)
    window = set_up(vtk.vtkRenderWindow(), OffScreenRendering=True, Size=size,
                    MultiSamples=0)
    window.AddRenderer(renderer)
    window.Render()
    grab = set_up(vtk.vtkWindowToImageFilter(), Input=window)
    grab.Update()
    image = grab.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(size[1], size[0], -1)[::-1]
