"""What the files of a run hold, as numpy arrays."""

import json
import os
from xml.etree import ElementTree
from types import SimpleNamespace

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from . import Unusable, meshes, panels, words
from .data import nearest

HEXAHEDRON, QUADRILATERAL = 12, 9

# Of the largest elastic energy of a history: less is left of a body that was released.
RELEASED = 1e-12


def read_grid(file, reader, fields):
    """The grid in a file, with no more than these point data."""
    if not os.path.isfile(file):
        raise Unusable(f"there is no file {file}, run stiction first (with "
                       "'Output/Write solution = true').")
    reader.SetFileName(file)
    reader.UpdateInformation()
    reader.GetPointDataArraySelection().DisableAllArrays()
    for field in fields:
        reader.GetPointDataArraySelection().EnableArray(field)
    reader.Update()
    grid = reader.GetOutput()
    if reader.GetErrorCode() or grid.GetNumberOfCells() == 0:
        raise Unusable(f"{file} or one of the files it names cannot be read.")
    return grid


def point_data(grid, field, default):
    """A field at the points, where the file has it."""
    array = grid.GetPointData().GetArray(field)
    return default if array is None else vtk_to_numpy(array).astype(float)


def read_mesh(file, cell_type, corners, fields, wanted=None):
    """Points, cells and point data of cells that are all of one type.

    wanted: a field and the one that it is read from where there is none.
    """
    choice = list(wanted or ())
    grid = read_grid(file, vtk.vtkXMLPUnstructuredGridReader(),
                     fields + choice + ["body"])
    if (vtk_to_numpy(grid.GetCellTypesArray()) != cell_type).any():
        raise Unusable(f"{file} has cells of another type than stiction's.")
    mesh = SimpleNamespace(
        points=vtk_to_numpy(grid.GetPoints().GetData()).astype(float),
        cells=vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        .reshape(-1, corners))
    for field in fields:
        array = grid.GetPointData().GetArray(field)
        if array is None:
            raise Unusable(f"{file} has no point data '{field}'.")
        setattr(mesh, field, vtk_to_numpy(array).astype(float))
    mesh.body = point_data(grid, "body", np.zeros(len(mesh.points)))
    for field in choice:
        array = grid.GetPointData().GetArray(field)
        if array is not None:
            setattr(mesh, choice[0], vtk_to_numpy(array).astype(float))
            return mesh
    if choice:
        raise Unusable(f"{file} has no point data '{choice[-1]}'.")
    return mesh


def read_summary(directory):
    """summary.json."""
    file = os.path.join(directory, "summary.json")
    try:
        with open(file, encoding="utf-8") as stream:
            return json.load(stream)
    except (OSError, ValueError) as error:
        raise Unusable(f"{file} cannot be read: {error}.") from error


def is_certified(summary):
    """Whether the run ended with what it was asked for."""
    return summary["converged"] and not summary.get("interrupted", False)


def steps_of(directory):
    """The certified steps of which there are files: t, and what the names of these
    have behind the word, "_0001", or nothing where there is one step."""
    if not os.path.isdir(directory):
        raise Unusable(f"there is no directory {directory}, run stiction first.")
    file = os.path.join(directory, "contact.pvd")
    if not os.path.isfile(file):
        return []
    try:
        return [(float(entry.get("timestep")),
                 entry.get("file")[len("contact"):-len(".pvtu")])
                for entry in ElementTree.parse(file).iter("DataSet")]
    except (OSError, ElementTree.ParseError, TypeError, ValueError) as error:
        raise Unusable(f"{file} cannot be read: {error}.") from error


def last_tag(directory):
    """That of the end of the run, be it certified or not."""
    if os.path.isfile(os.path.join(directory, "contact_uncertified.pvtu")):
        return "_uncertified"
    return ([(0, "")] + steps_of(directory))[-1][1]


def read(directory, tag="", time=None):
    """Everything a picture shows of the run that wrote into a directory.

    tag: what the names of the files have behind the word; time: of a frame of
    which the summary does not speak.
    body: points, outer faces, and displacement and stress at the points, of all bodies;
    n_bodies: how many there are;
    contact: faces of the same points, and fields at their corners, (n, 4) or
    (n, 4, 3); obstacle: VTK's grid, or None; summary, units, name and time; certified:
    what is shown, as steps with files are; released: whether only rounding is left at
    the end, which then is zero; scale: what scale_of() returns.
    """
    solution = read_mesh(os.path.join(directory, f"solution{tag}.pvtu"), HEXAHEDRON,
                         8, ["displacement"],
                         ("von_Mises_stress_averaged", "von_Mises_stress"))
    contact = read_mesh(os.path.join(directory, f"contact{tag}.pvtu"), QUADRILATERAL,
                        4, ["pressure", "tangential_traction",
                            "normal_status", "tangential_status", "area",
                            "boundary", "displacement", "normal"])
    summary = read_summary(directory)
    certified = time is not None or is_certified(summary)
    n = len(solution.points)
    closing = largest_closing(contact, summary)
    contact = without_other_sides(contact, summary)
    first, number = meshes.merge(np.vstack([solution.points, contact.points]),
                                 np.concatenate([solution.body, contact.body]),
                                 np.vstack([solution.displacement,
                                            contact.displacement]))
    if (first >= n).any():
        raise Unusable("solution.pvtu and contact.pvtu are not of the same run.")
    faces = meshes.outer_faces(number[:n][solution.cells], len(first),
                               number[n:][contact.cells])
    released = time is None and is_released(summary)
    if released:  # what is rounding beside the history is nothing
        solution.von_Mises_stress_averaged[:] = 0
        contact.pressure[:] = 0
        contact.tangential_traction[:] = 0
    shear = np.linalg.norm(contact.tangential_traction, axis=1).max()
    contact.pressure[np.abs(contact.pressure) <= words.ROUNDING * shear] = 0  # of a tie
    body = body_of(solution, faces, first, number[:n])
    return SimpleNamespace(
        name=os.path.basename(os.path.abspath(directory)), summary=summary,
        time=time, certified=certified, released=released,
        scale=scale_of(body, contact, certified, closing),
        units=words.units_of(summary),
        body=body,
        n_bodies=len(np.unique(solution.body)),
        contact=contact_of(contact, number[n:], faces, body.points),
        obstacle=read_obstacle(directory, tag))


def largest_closing(contact, summary):
    """How much farther from the other side, along its normal, a pressed node of a pair
    was before anything moved, at most: an interference, or a gap of its own, is as if
    it were nearer."""
    paired = [entry["id"] for entry in summary["contact"].get("boundaries", ())
              if entry.get("opposite")]
    pressed = np.isin(contact.boundary, paired) & (contact.pressure > 0)
    sides, largest = contact.cells[:, 0], 0.0
    for boundary in np.unique(contact.boundary[pressed]):
        nodes = pressed & (contact.boundary == boundary)
        others = contact.boundary[sides] != boundary
        is_far = others & ~np.isin(contact.body[sides], contact.body[nodes])
        others = is_far if is_far.any() else others  # the lips of a crack are one body
        if others.any():
            before, after = (
                points[nodes] - nearest(points[nodes], points, contact.cells[others])
                for points in (contact.points, contact.points + contact.displacement))
            # without what slides along the faces and off their ends
            closed = ((after - before) * contact.normal[nodes]).sum(axis=1)
            largest = max(largest, np.abs(closed).max())
    return largest


def scale_of(body, contact, certified, closing):
    """What everything is drawn with.

    displacement and stress: the largest; closing: the gap or overlap of a pair that is
    closed; peak: the largest pressure; by the id of a
    boundary pressure, where its colours may end, force, that presses it, and friction,
    the usual and the largest there; dented: flat boundaries with a dent that is deep in
    the picture.
    """
    pressure = panels.shown_pressure(contact, certified)[contact.cells]
    areas = np.linalg.norm(meshes.vector_areas(contact.points[contact.cells]), axis=1)
    boundary = contact.boundary[contact.cells[:, 0]].astype(int)
    sizes = np.linalg.norm(contact.tangential_traction, axis=1)[contact.cells]
    force = np.bincount(boundary, areas * np.abs(pressure).mean(axis=1))
    ends, friction = np.zeros(len(force)), np.zeros((len(force), 2))
    for i in np.unique(boundary):
        chosen = boundary == i
        ends[i] = panels.scale_of(pressure[chosen].reshape(-1), np.repeat(areas[chosen], 4))
        of_boundary = sizes[chosen[:, None] & (sizes > 0)]
        if len(of_boundary):
            friction[i] = np.percentile(of_boundary, (95, 100))
    return SimpleNamespace(
        displacement=np.linalg.norm(body.displacement, axis=1).max(), closing=closing,
        stress=body.stress[np.unique(body.faces)].max(), pressure=ends,
        peak=max(pressure.max(), 0), force=force, friction=friction, dented=set())


def is_released(summary):
    """Whether a history ends, certified, with next to none of the elastic energy it had."""
    steps = summary.get("steps") or ()
    if not all("energy" in step for step in steps):  # a step was not certified
        return False
    energies = [step["energy"]["elastic_energy"] for step in steps]
    return len(energies) > 1 and energies[-1] < RELEASED * max(energies)


def without_other_sides(contact, summary):
    """The contact faces but for those whose pressure the summary gives at the boundary
    opposite to them."""
    known = [entry["id"] for entry in summary["contact"].get("boundaries", ())
             if "id" in entry]
    shown = np.isin(contact.boundary[contact.cells[:, 0]], known)
    if shown.any():
        contact.cells = contact.cells[shown]
    return contact


def body_of(solution, faces, first, number):
    """The body with points merged and the stress averaged at them.

    The file has averages over cells of the same material already, unless it was
    written without them.
    """
    count = np.bincount(number)
    return SimpleNamespace(
        points=solution.points[first],
        displacement=solution.displacement[first],
        stress=np.bincount(number, solution.von_Mises_stress_averaged) / count,
        faces=faces)


def contact_of(contact, number, outer, points):
    """The contact faces, turned so that they are seen from outside."""
    faces = number[contact.cells]
    # the two sides of a closed crack are known by which way they look
    normals = contact.normal[contact.cells].mean(axis=1)
    keys = meshes.face_keys(outer, len(points))
    wanted = meshes.face_keys(faces, len(points))
    order = np.argsort(keys)
    at = np.searchsorted(keys, wanted, sorter=order)
    place = order[at % len(keys)]
    other = order[(at + 1) % len(keys)]
    looks = [(meshes.vector_areas(points[outer[side]]) * normals).sum(axis=1)
             for side in (place, other)]
    place = np.where((keys[other] == wanted) & (looks[1] > looks[0]), other, place)
    if (keys[place] != wanted).any():
        raise Unusable("the faces in contact.pvtu are not on the surface of "
                       "the body in solution.pvtu.")
    fields = {name: values[contact.cells]
              for name, values in vars(contact).items()
              if name not in ("points", "cells", "body", "displacement", "normal")}
    fields["boundary"] = fields["boundary"][:, 0].astype(int)
    # where there is no contact node, the pressure of the others of the face
    known = fields["normal_status"] >= 0
    mean = (known * fields["pressure"]).sum(axis=1) / np.maximum(
        known.sum(axis=1), 1)
    fields["pressure"] = np.where(known, fields["pressure"], mean[:, None])
    # the corner after the first one tells which way round the other file goes
    outside = outer[place]
    start = np.argmax(outside == faces[:, :1], axis=1)
    rows = np.arange(len(faces))
    reverse = outside[rows, (start + 1) % 4] != faces[:, 1]
    for values in (faces, *fields.values()):
        if values.ndim > 1:
            values[reverse] = values[reverse][:, [0, 3, 2, 1]]
    return SimpleNamespace(faces=faces, **fields)


def read_obstacle(directory, tag):
    """The surfaces of the obstacles, or None where there is no such file."""
    file = os.path.join(directory, f"obstacle{tag}.vtu")
    if not os.path.isfile(file):
        return None
    return read_grid(file, vtk.vtkXMLUnstructuredGridReader(), [])
