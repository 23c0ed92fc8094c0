"""The deformed body, its outline before loading and the obstacle, with VTK."""

import math
from types import SimpleNamespace

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from . import meshes, obstacles
from .data import lines_of, set_up, surface_of

TOO_FAR = 10  # sizes of the body
INTO_OTHERS = 0.005  # of the size: what bodies are drawn apart or into one another
THIN = 0.1  # of its other extents: a plane model
ASIDE = 0.17  # of the larger side's: what is seen of the other ones of a plane model
OUTLINE, OBSTACLE, MESH, EDGE = 0x555555, 0xA8A8A8, 0xFFFFFF, 0x000000


def rgb(color):
    """Red, green and blue from 0 to 1."""
    return [(color >> shift & 255) / 255 for shift in (16, 8, 0)]


def rounded(number):
    """A positive number rounded to its first digit."""
    power = 10.0 ** math.floor(math.log10(number))
    return power * round(number / power)


def exaggeration(points, largest, closing=0):
    """How many times larger than it is the displacement is drawn, not at all where
    nothing else would be seen: of a body that flew off.

    closing: the largest gap or overlap that loads close.
    """
    size = np.ptp(points, axis=0).max()
    if largest > TOO_FAR * size:
        return 0
    factor = rounded(0.1 * size / largest) if largest > 0 else 1
    if closing > meshes.SINGLE_PRECISION * size:
        factor = min(factor, rounded(1 + INTO_OTHERS * size / closing))
    return max(1, factor)


def view_basis(points):
    """To the right, upwards and towards who looks, at the larger sides, and at a plane
    model nearly from the front: then y is upwards if it lies in the plane of x and y."""
    lengths = np.maximum(np.ptp(points, axis=0), 1e-12)
    sides = lengths.prod() / lengths
    shares = (sides / sides.max()) ** 0.35
    thin, medium, _ = np.argsort(lengths)
    is_plane = lengths[thin] < THIN * lengths[medium]
    if is_plane:
        shares[shares < 1] = np.minimum(shares[shares < 1], ASIDE)
    up = 1 if is_plane and thin == 2 else 2
    towards = meshes.unit(shares * [1, 0.6 if up == 1 else -0.6, 0.55])
    right = meshes.unit(np.cross(np.eye(3)[up], towards))
    return np.array([right, np.cross(towards, right), towards])


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


def reach_of(scene):
    """From where to where the actors of a scene go in directions of the view, (2, 3)."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for actor in scene.actors:
        data = actor.GetMapper().GetInput()
        if data.GetNumberOfPoints():
            seen = vtk_to_numpy(data.GetPoints().GetData()) @ scene.basis.T
            low = np.minimum(low, seen.min(axis=0))
            high = np.maximum(high, seen.max(axis=0))
    return low, high


def camera_of(basis, low, high):
    """A parallel view without its size, and extents of what goes so far in it."""
    middle, far = (low + high) / 2 @ basis, 2 * np.linalg.norm(high - low)
    camera = set_up(vtk.vtkCamera(), ParallelProjection=True,
                    FocalPoint=middle, Position=middle + far * basis[2],
                    ViewUp=basis[1])
    return camera, (high - low)[:2]


def picture(run, colors, box, reach=None):
    """Draw the body so that it fills a box, width and height in pixels.

    reach: from where to where scenes of all frames go. Returns the image, an array of
    rows from the top, and what was done: the factor of exaggeration, the highest stress,
    the axes on the picture, and how the obstacles were drawn, None where there are none.
    """
    scene = scene_of(run, colors)
    camera, extents = camera_of(scene.basis, *(reach_of(scene) if reach is None else reach))
    return SimpleNamespace(image=rendered(scene.actors, camera, extents, box),
                           factor=scene.factor, highest=run.scale.stress,
                           axes=scene.basis[:2].T, obstacle=scene.obstacle)


def scene_of(run, colors):
    """What is drawn, how large displacements are, and how it is looked at."""
    body = run.body
    factor = 1 if run.released else exaggeration(
        body.points, run.scale.displacement, run.scale.closing)
    basis = view_basis(body.points)
    moved = body.points + factor * body.displacement
    deformed = surface_of(moved, body.faces, body.stress)
    faint = min(0.3, 14 / math.sqrt(len(body.faces)))
    edges = set_up(vtk.vtkExtractEdges(), InputData=deformed)
    outline = meshes.outline(body.points, body.faces, basis[2])
    actors = [stress_actor(deformed, run.scale.stress or 1, colors),
              actor_of(edges, MESH, LineWidth=1, Opacity=faint),
              actor_of(lines_of(body.points, outline), LineWidth=2)]
    if run.n_bodies > 1:  # which of them is where
        actors.append(actor_of(lines_of(moved, outline), EDGE, LineWidth=2))
    how = None
    if run.obstacle is not None:
        obstacle, rim, how = obstacles.drawn(run, factor)
        faint = obstacles.covers(obstacle, run, deformed, basis[2])
        actors += [actor_of(obstacle, OBSTACLE, 0.6, Opacity=0.2 if faint else 0.4),
                   actor_of(rim, OBSTACLE, LineWidth=2)]
    return SimpleNamespace(actors=actors, basis=basis, factor=factor, obstacle=how)


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
