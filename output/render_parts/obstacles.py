"""The surfaces of the obstacles, bent to the body as it is drawn, with VTK."""

from types import SimpleNamespace

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from . import bending, meshes
from .data import points_of, set_up, surface_of

CELLS = vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS
MOST_TRIANGLES = 10000  # of which smaller ones are made
COVERING = 0.1  # parts of an obstacle that make it one to look through
BENT = 0.02  # parts of the body: an obstacle that is bent by less has its shape


def curved(run):
    """Which contact faces are of a curved boundary."""
    areas = meshes.vector_areas(run.body.points[run.contact.faces])
    result = np.zeros(len(areas), dtype=bool)
    for boundary in np.unique(run.contact.boundary):
        chosen = run.contact.boundary == boundary
        result[chosen] = not bending.has_flat_sides(areas[chosen])
    return result


def covers(obstacle, run, deformed, towards):
    """Whether obstacles cover curved contact faces to who looks. Above flat ones one would
    see nothing of them if they did not."""
    faces = run.contact.faces[curved(run)]
    if not len(faces) or not obstacle.GetNumberOfPolys():
        return False
    points, n = run.body.points, len(run.body.points)
    to_be_seen = np.isin(meshes.face_keys(run.body.faces, n), meshes.face_keys(faces, n)) & (
        meshes.vector_areas(points[run.body.faces]) @ towards > 0)
    locator = set_up(vtk.vtkCellLocator(), DataSet=deformed)
    locator.BuildLocator()
    centers = set_up(vtk.vtkCellCenters(), InputData=obstacle)
    centers.Update()
    way = 10 * np.linalg.norm(np.ptp(points, axis=0)) * towards
    # from a little before the obstacle, which may be in the face that it touches
    at, numbers = [0.0] * 3, (vtk.reference(0.0), vtk.reference(0), vtk.reference(0))
    return np.mean([bool(locator.IntersectWithLine(
        start + 0.002 * way, start - way, 0, numbers[0], at, [0.0] * 3, numbers[1],
        numbers[2])) and to_be_seen[numbers[2].get()]
                    for start in places_of(centers.GetOutput())]) > COVERING


def drawn(run, factor):
    """All obstacles, without what is far off in the picture, their edges, and what is to
    be said of how they are drawn."""
    surfaces, edges, how = vtk.vtkAppendPolyData(), vtk.vtkAppendPolyData(), set()
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
        merged = merged.GetOutput()
        if not merged.GetNumberOfPolys():
            continue
        is_smooth = is_round(merged)
        result, words = bent(merged, is_smooth, run, boundary, factor)
        how.add(words)
        surfaces.AddInputData(result)
        # smaller triangles may be so thin that they seem folded
        edge = set_up(vtk.vtkFeatureEdges(), FeatureEdges=not is_smooth, InputData=result)
        edges.AddInputConnection(edge.GetOutputPort())
    surfaces.Update()
    edges.Update()
    return surfaces.GetOutput(), edges.GetOutput(), max(how, key=len, default="")


def is_round(surface):
    """Whether a surface of triangles is folded everywhere a little, nowhere sharply."""
    return surface.GetPolys().GetMaxCellSize() == 3 and bending.is_round(
        places_of(surface),
        vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def bent(obstacle, is_smooth, run, boundary, factor):
    """An obstacle at its contact boundary as this is drawn, and words for it."""
    body, size = run.body, np.ptp(run.body.points, axis=0).max()
    faces = run.contact.faces[run.contact.boundary == boundary]
    is_flat = bending.has_flat_sides(meshes.vector_areas(body.points[faces]))
    if is_flat and bending.has_flat_sides(areas_of(obstacle)):
        return with_large_gaps(obstacle, body, faces, factor, True)
    obstacle = cut(refined(obstacle, is_smooth), body.points[faces].reshape(-1, 3),
                   0.3 if is_flat else 0.2, size)
    places, off, way = rigid(obstacle, run, boundary, factor)
    if way > BENT * size and is_flat:
        run.scale.dented.add(boundary)
    if boundary in run.scale.dented:
        return with_large_gaps(obstacle, body, faces, factor, False)
    result = at_places(obstacle, places)
    # far from it a foundation, known along normals of the body, is no obstacle's shape
    if result.GetPolys().GetMaxCellSize() > 3:
        result = near_by(result, off, 0.3 * size)
    return result, " bent where it overlaps" * bool(way > BENT * size)


def near_by(surface, off, most):
    """A surface without what is further off."""
    surface.GetPointData().SetScalars(numpy_to_vtk(off, deep=True))
    rim = vtk.vtkFeatureEdges()
    set_up(rim, InputData=surface, FeatureEdges=False, NonManifoldEdges=False).Update()
    ends = rim.GetOutput().GetPointData().GetScalars()
    if ends is not None and ends.GetNumberOfTuples():  # where it was cut, not much nearer
        nearest_end = vtk_to_numpy(ends).min()
        most = nearest_end if 0.5 * most < nearest_end < most else most
    clip = set_up(vtk.vtkClipPolyData(), InsideOut=True, Value=most, InputData=surface)
    clip.Update()
    return clip.GetOutput()


def rigid(obstacle, run, boundary, factor):
    """The places of an obstacle moved along with what it touches, how far off they are,
    and by how much it is bent out of the body."""
    body, contact = run.body, run.contact
    chosen = contact.boundary == boundary
    faces, n = contact.faces[chosen], len(body.points)

    def at_nodes(values):
        return np.bincount(faces.reshape(-1), values.reshape(-1), n)

    normals = meshes.node_normals(faces, meshes.vector_areas(body.points[faces]), n)
    areas = np.linalg.norm(meshes.vector_areas(body.points[faces]), axis=1)
    used = np.unique(faces)
    way = bending.rigid_way(
        normals[used], body.displacement[used],
        at_nodes(areas[:, None] * np.maximum(contact.pressure[chosen], 0))[used],
        at_nodes(contact.tangential_status[chosen] == 2)[used] > 0)
    drawn_points = body.points + factor * body.displacement
    closed = at_nodes(contact.normal_status[chosen] == 1) > 0
    places = places_of(obstacle) + (factor - 1) * way
    place, normal, closed = nearest(places, drawn_points, faces, drawn_points, normals,
                                    closed[:, None])
    moved, bent_by = bending.out_of_body(places, SimpleNamespace(
        place=place, normal=meshes.unit(normal), closed=closed),
                                        np.ptp(body.points, axis=0).max())
    return moved, np.linalg.norm(moved - place, axis=1), bent_by


def with_large_gaps(obstacle, body, faces, factor, is_flat):
    """An obstacle with gaps that are as many times larger as the displacement."""
    size, places = np.ptp(body.points, axis=0).max(), places_of(obstacle)
    normals = meshes.node_normals(faces, meshes.vector_areas(body.points[faces]),
                                  len(body.points))
    place, displacement, normal = nearest(places, body.points + body.displacement, faces,
                                          body.points, body.displacement, normals)
    moved, off = bending.with_large_gaps(places, SimpleNamespace(
        place=place, displacement=displacement, normal=meshes.unit(normal)),
                                         factor, is_flat, size)
    result = near_by(at_places(obstacle, bending.widened(moved)), off, 0.3 * size)
    return result, " with its gaps as large" * (factor > 1)


def cut(obstacle, points, share, size):
    """An obstacle without what is beyond these points of a boundary by more than a
    share of their extent."""
    for c, length in enumerate(np.ptp(points, axis=0)):
        room = max(share * length, 0.05 * size)
        if length < 1e-3 * size:  # above and below a plane
            room = 0.3 * size
        for sign, most in ((1, points[:, c].max()), (-1, -points[:, c].min())):
            normal = -sign * np.eye(3)[c]
            plane = set_up(vtk.vtkPlane(), Normal=normal, Origin=-(most + room) * normal)
            clip = set_up(vtk.vtkClipPolyData(), ClipFunction=plane, InputData=obstacle)
            clip.Update()
            obstacle = clip.GetOutput()
    return obstacle


def places_of(surface):
    """The points of a surface."""
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def at_places(surface, places):
    """A surface with its points elsewhere."""
    result = vtk.vtkPolyData()
    result.DeepCopy(surface)
    result.SetPoints(points_of(places))
    return result


def refined(surface, is_smooth):
    """A surface of triangles with smaller ones, which follow a small dent.

    They are round where it is: where a gap is drawn much larger, so are chords.
    """
    # lines: of triangles that were too thin, smaller ones beside them would be folded
    if (surface.GetPolys().GetMaxCellSize() > 3 or surface.GetNumberOfLines()
            or surface.GetNumberOfPolys() > MOST_TRIANGLES):
        return set_up(surface, Verts=None, Lines=None)
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


def nearest(places, points, faces, *fields):
    """What fields at points, (n, ...), are where faces between these are nearest to
    places."""
    triangles = faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    locator = set_up(vtk.vtkCellLocator(), DataSet=surface_of(
        points, triangles, np.zeros(len(points))))
    locator.BuildLocator()
    cell, number = vtk.vtkGenericCell(), vtk.reference(0)
    sub, distance = vtk.reference(0), vtk.reference(0.0)
    found, numbers = np.empty(places.shape), np.empty(len(places), dtype=int)
    for i, place in enumerate(places):
        locator.FindClosestPoint(place, found[i], cell, number, sub, distance)
        numbers[i] = number
    corners = triangles[numbers]
    weights = bending.weights_of(points[corners], found)[..., None]
    return [(weights * values[corners]).sum(axis=1) for values in fields]
