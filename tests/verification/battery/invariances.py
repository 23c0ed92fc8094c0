"""The answer does not depend on how the problem is put."""

import math
import os
import tempfile

import numpy as np

from .case import Row, section, sections
from .mesh import cube

ANGLE, AXIS = 0.7, np.array([1.0, 2.0, 0.5]) / math.sqrt(5.25)


def turned(v, turn):
    """A vector turned about the axis."""
    c, s = math.cos(turn), math.sin(turn)
    return c * np.asarray(v) + s * np.cross(AXIS, v) + (1 - c) * AXIS.dot(v) * AXIS


def text_of(v):
    """A vector as entries want it."""
    return "; ".join(f"{x:.17g}" for x in v)


def block(turn=0.0, mirror=1, length=1.0, force=1.0, stiffness=1.0):
    """A block that is held at its left, pressed on a plane and pulled along it."""
    pull = turned([0.6 * force, mirror * 0.9 * force, 0.1 * force], turn) / length**2
    push = turned([0, 0, -3 * force], turn) / length**2
    normal = turned([0.02, mirror * 0.03, 1], turn)
    point = turned([0.3 * length, mirror * 0.2 * length, -0.001 * length], turn)
    degrees = math.degrees(turn)
    return section("Body block", {
        "Lengths": ", ".join([f"{length * x:.17g}" for x in (1.5, 1, 0.8)]),
        "Subdivisions": "5, 4, 3", "Translation": text_of(turned(
            [0, 0 if mirror == 1 else -length, 0], turn)),
        "Rotation": f"0; 0; 0; {text_of(AXIS)}; {degrees:.17g}",
        "Young's modulus": f"{100 * force * stiffness / length**2:.17g}",
        "Poisson ratio": 0.3}) + sections(
            Boundary_conditions={
                "Prescribed displacement": "block.left : 0; 0; 0",
                "Traction": f"block.top : {text_of(push * stiffness)} | block.right : "
                            f"{text_of(pull * stiffness)}",
                "Contact boundary": "block.bottom",
                "Obstacle": f"plane : {text_of(point)}; {text_of(normal)}"},
            Friction={"Law": "coulomb", "Coefficient": 0.5},
            Contact_solver={"Tolerance": "1e-11"}, Refinement={"Estimate error": "false"})


def force_of(run):
    """That on the body."""
    return np.array(run.summary["contact"]["force_on_body"])


def how_it_is_put(solver, quick):
    """Rotation, mirror, units, stiffness, ranks."""
    base = solver(block())
    reference, states = force_of(base), base.summary["contact"]
    rows = [Row("nodes that slip and that stick", min(states["slip"], states["stick"]), 0,
                "all states occur", 1, "at least")]

    def compare(what, force, allowed=1e-8):
        rows.append(Row(what, np.linalg.norm(force - reference)
                        / np.linalg.norm(reference), 0, "the same answer", allowed,
                        "absolute"))

    compare("turned by 40 degrees about a slanting axis",
            turned(force_of(solver(block(turn=ANGLE))), -ANGLE))
    compare("mirrored", force_of(solver(block(mirror=-1))) * [1, -1, 1])
    compare("in other units (lengths times 1000, forces times 1e-3)",
            force_of(solver(block(length=1000, force=1e-3))) * 1e3)
    compare("moduli and loads times 1e6", force_of(solver(block(stiffness=1e6))) / 1e6)
    for ranks in (2,) if quick else (2, 3, 4):
        compare(f"on {ranks} ranks", force_of(solver(block(), ranks=ranks)))
    for name, settings in (
            ("Stiffness solver amg", {"Stiffness solver/Type": "amg"}),
            ("Stiffness solver multigrid", {"Stiffness solver/Type": "multigrid"}),
            ("Dual operator by solves", {"Dual operator/Form": "by solves"})):
        compare(name, force_of(solver(block(), settings)), 1e-6)
    return rows, []


def numbering(solver, quick):
    """Nodes and cells of a mesh file in another order."""
    forces = []
    with tempfile.TemporaryDirectory() as directory:
        for seed in (None, 1) if quick else (None, 1, 2, 3):
            name = os.path.join(directory, f"cube_{seed}.msh")
            with open(name, "w", encoding="utf-8") as file:
                file.write(cube(5, seed))
            forces.append(force_of(solver(sections(
                Geometry={"Mesh file": name},
                Material={"Young's modulus": 100, "Poisson ratio": 0.3},
                Boundary_conditions={
                    "Prescribed displacement": "wall : 0; 0; 0",
                    "Traction": "top : 0.5; 0.8; -3", "Contact boundary": "sole",
                    "Obstacle": "foundation"},
                Friction={"Law": "coulomb", "Coefficient": 0.3},
                Contact_solver={"Tolerance": "1e-11"},
                Refinement={"Estimate error": "false"}))))
    return [Row(f"order {k}", np.linalg.norm(force - forces[0])
                / np.linalg.norm(forces[0]), 0, "the same answer", 1e-8, "absolute")
            for k, force in enumerate(forces[1:], 1)], []


UNDECIDED = 3  # of a status, doc/results.md


def under_a_tighter_tolerance(solver, quick):
    """What is said of a node stays when the tolerance is a hundredth."""
    problems = (("brick.prm", {"Geometry/Table 1 level": 3}),
                ("sphere.prm", {"Geometry/Global refinement": 2}),
                ("ball_press_drag_return.prm", {"Time/Steps": 4}),
                ("several_bodies/pin_in_hole.prm", {}))
    methods = ("newton", "newton multigrid", "mpgp", "gauss seidel", "admm")
    methods = methods[:2] if quick else methods
    rows = []
    for name, settings in problems[:2] if quick else problems:
        changed, decided = [], []
        for method in methods:
            one, other = (solver.shipped(name, {
                **settings, "Contact solver/Method": method,
                "Contact solver/Tolerance": tolerance}).contact()
                for tolerance in ("1e-4", "1e-6"))
            for status in ("normal_status", "tangential_status"):
                is_decided = one[status] != UNDECIDED
                changed.append(np.sum(is_decided & (one[status] != other[status])))
                decided.append(np.mean(is_decided))
        label = name.removesuffix(".prm")
        rows.append(Row(f"{label}: statuses that change, {len(methods)} methods",
                        int(sum(changed)), 0, "tolerance 1e-4 and 1e-6", 0, "absolute"))
        rows.append(Row(f"{label}: part that is decided", min(decided), 0,
                        "not all are left open", 0.7, "at least"))
    return rows, []


CASES = {"invariances": how_it_is_put, "numbering of nodes and cells": numbering,
         "statuses under a tighter tolerance": under_a_tighter_tolerance}
