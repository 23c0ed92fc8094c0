"""Plates and shells of others, limits of equilibrium, the reference brick."""

import numpy as np

from .case import Curve, Plot, Row, order, section, sections


def greco(solver, quick):
    """The GRECO plate: SSNV128 of Code_Aster."""
    coarse = {
        "Geometry/Subdivisions": "32, 1, 32", "Geometry/Lengths": "0.04, 0.00125, 0.04",
        "Boundary conditions/Prescribed points":
            "0.04; 0; 0 : free; free; 0 | 0.04; 0.00125; 0 : free; free; 0"}
    run = solver.shipped("greco_plate.prm", coarse if quick else {})
    nodes = run.contact()
    line = nodes["points"][:, 1] < 1e-9
    x, u = 1e3 * nodes["points"][line, 0], 1e5 * nodes["displacement"][line, 0]
    rows = []
    for name, place, value in (("A", 0, 2.8598), ("B", 1.25, 2.7208), ("C", 5, 2.2827),
                               ("D", 7.5, 1.9792), ("E", 11.25, 1.5406)):
        rows.append(Row(f"displacement of {name}, 1e-5 m", u[np.argmin(abs(x - place))],
                        value, "Code_Aster V6.03.128, quadratic elements", 0.01))
    free = solver.shipped("greco_plate.prm", {**coarse, "Friction/Law": "frictionless"})
    without = free.contact()
    corner = np.argmin(np.abs(without["points"][:, :2]).sum(axis=1))
    rows.append(Row("displacement of A without friction",
                    1e5 * without["displacement"][corner, 0], 2.8598, "has to differ", 0.2,
                    "at least"))
    rank = np.argsort(x)
    return rows, [Plot("GRECO plate", "x, mm", "displacement along the plane, 1e-5 m", [
        Curve("stiction", x[rank], u[rank]),
        Curve("Code_Aster", [0, 1.25, 5, 7.5, 11.25],
              [2.8598, 2.7208, 2.2827, 1.9792, 1.5406], "o")])]


def shells(solver, quick):
    """Two spherical shells in one another, the inner one under pressure."""
    def shell(name, radii):
        return section(f"Body {name}", {
            "Type": "generator", "Generator": "quarter_hyper_shell",
            "Generator arguments": f"0,0,0 : {radii} : 0 : true",
            "Young's modulus": "1e5", "Poisson ratio": 0.3})
    held = " | ".join(f"{name}.{side} : {how}" for name in ("inner", "outer")
                      for side, how in ((2, "0; free; free"), (3, "free; 0; free"),
                                        (4, "free; free; 0")))
    errors, levels = [], (1, 2) if quick else (1, 2, 3)
    for level in levels:
        contact = solver(
            shell("inner", "20 : 30") + shell("outer", "30 : 40") + sections(
                Geometry={"Global refinement": level}, Body_outer={"Refinement": 1},
                Boundary_conditions={
                    "Prescribed displacement": held, "Pressure": "inner.0 : 25",
                    "Contact boundary": "inner.1", "Obstacle": "boundary : outer.0",
                    "Mesh gap": "removed"},
                Friction={"Law": "frictionless"},
                Contact_solver={"Tolerance": "1e-9"})).summary["contact"]
        pressure = contact["normal_force"] / contact["area"]
        errors.append(pressure / 4.8942 - 1)
    source = "Lamé; Code_Aster V6.03.173"
    return [Row("mean pressure between them", pressure, 4.8942, source,
                0.02 if quick else 0.006),
            Row("order in h", order(errors), 2, "linear elements", 0.3, "order")], [
        Plot("Shells", "cells along a radius", "deviation of the pressure",
             [Curve("mean pressure", [2.0**level for level in levels],
                    [abs(error) for error in errors], "o-")], logarithmic=True)]


def thresholds(solver, quick):
    """A block on a slope: how steep, and how high, until nothing holds it."""
    del quick
    rows = []
    for slope, end in ((0.2999, "certified"), (0.3001, "refused")):
        rows.append(Row(f"slope {slope}, F = 0.3", solver.end_of(block(slope, 1, 0.3)), end,
                        "Coulomb", kind="same"))
    for height, end in ((3.99, "certified"), (4.01, "refused")):
        rows.append(Row(f"height {height} on slope 0.25, base 1",
                        solver.end_of(block(0.25, height, 0.5)), end,
                        "the weight acts at half of the height", kind="same"))
    rows.append(Row("slope 0.2, F = 0.1", solver.end_of(block(0.2, 1, 0.1)), "refused",
                    "friction is what holds it", kind="same"))
    return rows, []


def block(slope, height, coefficient):
    """A block that its weight presses on a slope."""
    return sections(
        Geometry={"Lengths": f"1, 1, {height}", "Subdivisions": "4, 4, 4",
                  "Global refinement": 0},
        Material={"Young's modulus": "1e6", "Poisson ratio": 0.3, "Density": 1},
        Boundary_conditions={"Gravity": f"{slope}; 0; -1", "Contact boundary": "bottom",
                             "Obstacle": "foundation"},
        Friction={"Law": "coulomb", "Coefficient": coefficient},
        Contact_solver={"Tolerance": "1e-6"})


def reference_brick(solver, quick):
    """The brick of the paper at small sizes: forces and states of its nodes."""
    source = "recomputed by an independent program in Python, 2026"
    known = {("coulomb", 1): ((-3.983695e7, -6.998529e7, 5.273469e8), (0, 13, 41)),
             ("coulomb", 2): ((-3.976076e7, -7.128451e7, 5.268047e8), (25, 35, 120)),
             ("coulomb", 3): ((-3.974534e7, -7.158390e7, 5.265854e8), (61, 63, 254)),
             ("given", 1): ((-3.979409e7, -5.461809e7, 5.275008e8), (6, 24, 30)),
             ("given", 2): ((-3.965936e7, -5.733979e7, 5.270135e8), (25, 84, 96)),
             ("given", 3): ((-3.962652e7, -5.799868e7, 5.268582e8), (71, 178, 200))}
    rows = []
    for (law, level), (force, states) in known.items():
        if quick and level > 1:
            continue
        contact = solver.shipped("brick.prm", {
            "Geometry/Table 1 level": level, "Friction/Law": law,
            "Friction/Slip stress": 1.5e7, "Contact solver/Tolerance": 1e-7}
        ).summary["contact"]
        rows += [Row(f"force along {axis}, {law}, k = {level}", contact["force_on_body"][c],
                     force[c], source, 2e-6) for c, axis in enumerate("xyz")]
        rows.append(Row(f"open, stick, slip, {law}, k = {level}", str(
            tuple(contact[name] for name in ("open", "stick", "slip"))), str(states), source,
            kind="same"))
    return rows, []


CASES = {"GRECO plate": greco, "two shells": shells, "limits of equilibrium": thresholds,
         "reference brick": reference_brick}
