"""Hertz' contact and the flat punch, without friction."""

import math

import numpy as np

from .case import Curve, Plot, Row, order, sections

MODULUS = 210000 / (1 - 0.3**2)  # E*
SOURCE = "Hertz (1882), Johnson, Contact Mechanics, 4.2"


def pressed(run):
    """Nodes in contact: distance from the axis, pressure and force."""
    nodes = run.contact()
    return (np.hypot(nodes["points"][:, 0], nodes["points"][:, 1]), nodes["pressure"],
            nodes["pressure"] * nodes["area"])


def sphere(solver, quick):
    """hertz.prm on finer and finer meshes."""
    P, R = 4 * 769.2307692, 100
    a = (3 * P * R / 4 / MODULUS) ** (1 / 3)
    p0 = 1.5 * P / math.pi / a**2
    levels = (2, 3) if quick else (2, 3, 4)
    errors = {"largest pressure": [], "radius of contact": []}
    for level in levels:
        r, p, force = pressed(solver.shipped("hertz.prm",
                                             {"Geometry/Global refinement": level}))
        found = {"largest pressure": p.max(),
                 "radius of contact": math.sqrt(2.5 * (force * r**2).sum() / force.sum())}
        for name, exact in (("largest pressure", p0), ("radius of contact", a)):
            errors[name].append(found[name] / exact - 1)
    allowed = 0.03 if quick else 0.01
    rows = [Row("largest pressure", found["largest pressure"], p0, SOURCE, allowed),
            Row("radius of contact", found["radius of contact"], a, SOURCE, allowed),
            Row("order in h of the radius", order(errors["radius of contact"]), 1,
                "the edge of contact is where a node is", 0, "order")]
    x = np.linspace(0, 1, 100)
    near = r < 1.6 * a
    return rows, [Plot("Sphere on a block", "r/a", "p/p0", [
        Curve("Hertz", x, np.sqrt(1 - x**2)),
        Curve("nodes", r[near] / a, p[near] / p0, ".")])]


def cylinder(solver, quick):
    """A cylinder on a block in plane strain."""
    P, R, size = 400.0, 50.0, 16.0  # N/mm of the whole, mm
    a = math.sqrt(4 * P * R / math.pi / MODULUS)
    p0 = 2 * P / math.pi / a
    for level in (3,) if quick else (3, 4):
        width = size / 8 / 2**level
        run = solver(sections(
            Geometry={"Lengths": f"{size}, {width}, {size}",
                      "Subdivisions": f"{8 * 2**level}, 1, {8 * 2**level}",
                      "Global refinement": 0, "Contact refinement": 1 if quick else 2,
                      "Contact refinement where": "2 - x"},
            Material={"Young's modulus": 210000, "Poisson ratio": 0.3},
            Boundary_conditions={
                "Prescribed displacement": "bottom : 0; 0; 0 | left : 0; free; free | "
                                           "front : free; 0; free | back : free; 0; free",
                "Contact boundary": "top",
                "Obstacle": f"cylinder : 0; 0; {size + R}; 0; 1; 0; {R}",
                "Obstacle force": f"0; 0; {-P * width / 2}"},
            Friction={"Law": "frictionless"}, Contact_solver={"Tolerance": "1e-8"}))
        nodes = run.contact()
        x, p = nodes["points"][:, 0], nodes["pressure"]
        force = p * nodes["area"]
        radius = 2 * math.sqrt((force * x**2).sum() / force.sum())
    allowed = 0.05 if quick else 0.02
    rows = [Row("half-width of contact", radius, a, SOURCE, allowed),
            Row("largest pressure", p.max(), p0, SOURCE, allowed)]
    s = np.linspace(0, 1, 100)
    near = x < 1.6 * a
    return rows, [Plot("Cylinder on a block, plane strain", "x/a", "p/p0", [
        Curve("Hertz", s, np.sqrt(1 - s**2)), Curve("nodes", x[near] / a, p[near] / p0,
                                                    ".")])]


def punch(solver, quick):
    """A flat round punch: pressures inside, away from its edge."""
    P, a, size = 1000.0, 1.0, 12.0
    errors = []
    for level in (3, 4) if quick else (4, 5, 6):
        run = solver(sections(
            Geometry={"Lengths": f"{size}, {size}, {size}", "Subdivisions": "6, 6, 6",
                      "Global refinement": 0, "Contact refinement": level,
                      "Contact refinement where": "2.2 - x^2 - y^2"},
            Material={"Young's modulus": 210000, "Poisson ratio": 0.3},
            Boundary_conditions={
                "Prescribed displacement": "bottom : 0; 0; 0 | left : 0; free; free | "
                                           "front : free; 0; free",
                "Contact boundary": "top", "Obstacle": "foundation",
                "Initial gap": f"if(x^2 + y^2 < {a * a + 1e-9}, 0, 1)",
                "Obstacle force": f"0; 0; {-P / 4}"},
            Friction={"Law": "frictionless"}, Contact_solver={"Tolerance": "1e-8"}))
        r, p, _ = pressed(run)
        exact = P / 2 / math.pi / a / np.sqrt(np.maximum(a**2 - r**2, 1e-12))
        inside = r < 0.5 * a
        errors.append(p[inside].sum() / exact[inside].sum() - 1)
    rows = [Row("mean pressure within half of its radius, of the exact one",
                1 + errors[-1], 1, "p = P/(2πa√(a² − r²)), Johnson, 3.8",
                0.1 if quick else 0.03)]
    if not quick: # two meshes of nodes around a circle tell no order
        rows.append(Row("order in h", order(errors), 0.5,
                        "the pressure is singular at the edge", 0, "order"))
    x = np.linspace(0, 0.99, 100)
    return rows, [
        Plot("Flat round punch", "r/a", "p πa²/P", [
            Curve("half-space", x, 0.5 / np.sqrt(1 - x**2)),
            Curve("nodes", r[r < a] / a, p[r < a] * math.pi * a**2 / P, ".")])]


CASES = {"Hertz, sphere": sphere, "Hertz, cylinder": cylinder, "flat punch": punch}
