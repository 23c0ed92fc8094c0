"""VTK's data sets from numpy arrays."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk


def set_up(this, **settings):
    """Call this.SetName(value) for every Name=value, return this."""
    for name, value in settings.items():
        getattr(this, "Set" + name)(value)
    return this


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


def nearest(places, points, faces):
    """The point of these faces that is nearest to each place."""
    distance = set_up(vtk.vtkImplicitPolyDataDistance(),
                      Input=surface_of(points, faces, np.zeros(len(points))))
    found = np.empty(places.shape)
    for place, closest in zip(places, found):
        distance.EvaluateFunctionAndGetClosestPoint(place, closest)
    return found


def lines_of(points, edges):
    """VTK's lines between pairs of points."""
    places, lines, _ = cells_of(points, edges)
    return set_up(vtk.vtkPolyData(), Points=places, Lines=lines)
