"""The surfaces of the obstacles, bent to the body as it is drawn, with VTK."""

from types import SimpleNamespace

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from . import bending, meshes
from .data import points_of, set_up, surface_of

CELLS = vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS
MOST_TRIANGLES = 10000  # of which smaller ones are made


def curved(run):
    """Which contact faces are of a curved boundary."""
    areas = meshes.vector_areas(run.body.points[run.contact.faces])
    result = np.zeros(len(areas), dtype=bool)
    for boundary in np.unique(run.contact.boundary):
        chosen = run.contact.boundary == boundary
        result[chosen] = not bending.has_flat_sides(areas[chosen])
    return result


def how(run, factor):
    """What is to be said of how the obstacles are drawn."""
    if factor == 1:
        return ""
    return " bent to touch" if curved(run).any() else " with its gaps as large"


def split_by_sight(obstacle, run, deformed, towards):
    """What of the obstacles does not cover curved contact faces to who looks, and
    what does. Above flat ones it has to be, or one would see nothing of it."""
    covered = run.contact.faces[curved(run)]
    if not len(covered) or not obstacle.GetNumberOfPolys():
        return obstacle, vtk.vtkPolyData()
    n_points = len(run.body.points)
    is_covered = np.isin(meshes.face_keys(run.body.faces, n_points),
                         meshes.face_keys(covered, n_points))
    locator = set_up(vtk.vtkCellLocator(), DataSet=deformed)
    locator.BuildLocator()
    centers = set_up(vtk.vtkCellCenters(), InputData=obstacle)
    centers.Update()
    starts = vtk_to_numpy(centers.GetOutput().GetPoints().GetData()).astype(float)
    way = 10 * np.linalg.norm(np.ptp(run.body.points, axis=0)) * towards
    # from a little before the obstacle, which may be in the face that it touches
    at, numbers = [0.0] * 3, (vtk.reference(0.0), vtk.reference(0), vtk.reference(0))
    covers = [bool(locator.IntersectWithLine(
        start + 0.002 * way, start - way, 0, numbers[0], at, [0.0] * 3, numbers[1], numbers[2]))
        and is_covered[numbers[2].get()] for start in starts]
    return [chosen_cells(obstacle, np.array(covers) == side) for side in (False, True)]


def chosen_cells(surface, chosen):
    """A surface of some of the polygons."""
    marked = vtk.vtkPolyData()
    marked.ShallowCopy(surface)
    marked.GetCellData().SetScalars(numpy_to_vtk(chosen.astype(float), deep=True))
    part = set_up(vtk.vtkThreshold(), InputData=marked, LowerThreshold=0.5,
                  UpperThreshold=1.5)
    part.SetInputArrayToProcess(0, 0, 0, CELLS, vtk.vtkDataSetAttributes.SCALARS)
    result = vtk.vtkGeometryFilter()
    result.SetInputConnection(part.GetOutputPort())
    result.Update()
    return result.GetOutput()


def drawn(run, factor):
    """All obstacles, without what is far off in the picture, and their edges."""
    surfaces, edges = vtk.vtkAppendPolyData(), vtk.vtkAppendPolyData()
    for boundary in np.unique(run.contact.boundary):
        part = set_up(vtk.vtkThreshold(), InputData=run.obstacle,
                      LowerThreshold=boundary, UpperThreshold=boundary)
        part.SetInputArrayToProcess(0, 0, 0, CELLS, "boundary")
        surface = vtk.vtkGeometryFilter()
        surface.SetInputConnection(part.GetOutputPort())
        surface.Update()
        # triangles may be so thin that smaller ones of them would leave cracks
        merged = set_up(vtk.vtkCleanPolyData(), Tolerance=1e-3 * (
            surface.GetOutput().GetPolys().GetMaxCellSize() == 3))
        merged.SetInputConnection(surface.GetOutputPort())
        merged.Update()
        if not merged.GetOutput().GetNumberOfPolys():
            continue
        is_smooth = is_round(merged.GetOutput())
        clip = set_up(vtk.vtkClipPolyData(), InsideOut=True,
                      Value=0.3 * np.ptp(run.body.points, axis=0).max(),
                      InputData=bent(
                          merged.GetOutput(), is_smooth, run.body,
                          run.contact.faces[run.contact.boundary == boundary], factor))
        surfaces.AddInputConnection(clip.GetOutputPort())
        # smaller triangles may be so thin that they seem folded
        edge = set_up(vtk.vtkFeatureEdges(), FeatureEdges=not is_smooth)
        edge.SetInputConnection(clip.GetOutputPort())
        edges.AddInputConnection(edge.GetOutputPort())
    surfaces.Update()
    edges.Update()
    return surfaces.GetOutput(), edges.GetOutput()


def is_round(surface):
    """Whether a surface of triangles is folded everywhere a little, nowhere sharply."""
    return surface.GetPolys().GetMaxCellSize() == 3 and bending.is_round(
        vtk_to_numpy(surface.GetPoints().GetData()).astype(float),
        vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def bent(obstacle, is_smooth, body, faces, factor):
    """An obstacle bent to its contact boundary, scalars: how far off it is."""
    areas = meshes.vector_areas(body.points[faces])
    is_curved = not bending.has_flat_sides(areas)
    is_flat = not is_curved and bending.has_flat_sides(areas_of(obstacle))
    result = vtk.vtkPolyData()
    result.DeepCopy(obstacle if is_flat else refined(obstacle, is_smooth))
    places = vtk_to_numpy(result.GetPoints().GetData()).astype(float)
    normals = meshes.node_normals(faces, areas, len(body.points))
    moved, off = bending.bent(
        places, nearest(places, body, faces, normals), factor, is_curved, is_flat,
        0.003 * np.ptp(body.points, axis=0).max())
    result.SetPoints(points_of(bending.widened(moved)))
    result.GetPointData().SetScalars(numpy_to_vtk(off, deep=True))
    return result


def refined(surface, is_smooth):
    """A surface of triangles with smaller ones, which follow a small dent.

    They are round where it is: where a gap is drawn much larger, so are chords.
    """
    if (surface.GetPolys().GetMaxCellSize() > 3
            or surface.GetNumberOfPolys() > MOST_TRIANGLES):
        return surface
    finer = set_up(vtk.vtkButterflySubdivisionFilter() if is_smooth
                   else vtk.vtkLinearSubdivisionFilter(),
                   InputData=surface, NumberOfSubdivisions=2)
    finer.Update()
    # empty where the triangles do not make a surface
    return finer.GetOutput() if finer.GetOutput().GetNumberOfPolys() else surface


def areas_of(surface):
    """The vector areas of the polygons of a surface, up to a factor."""
    normals = set_up(vtk.vtkPolyDataNormals(), InputData=surface,
                     ComputePointNormals=False, ComputeCellNormals=True)
    normals.Update()
    return vtk_to_numpy(normals.GetOutput().GetCellData().GetNormals()).astype(float)


def nearest(places, body, faces, normals):
    """The points of deformed faces nearest to places: place before loading,
    displacement and unit normal there."""
    triangles = faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    deformed = body.points + body.displacement
    locator = set_up(vtk.vtkCellLocator(), DataSet=surface_of(
        deformed, triangles, body.stress))
    locator.BuildLocator()
    cell, number = vtk.vtkGenericCell(), vtk.reference(0)
    sub, distance = vtk.reference(0), vtk.reference(0.0)
    found, numbers = np.empty(places.shape), np.empty(len(places), dtype=int)
    for i, place in enumerate(places):
        locator.FindClosestPoint(place, found[i], cell, number, sub, distance)
        numbers[i] = number
    corners = triangles[numbers]
    weights = bending.weights_of(deformed[corners], found)[..., None]
    place, displacement, normal = (
        (weights * values[corners]).sum(axis=1)
        for values in (body.points, body.displacement, normals))
    return SimpleNamespace(place=place, displacement=displacement,
                           normal=meshes.unit(normal))
