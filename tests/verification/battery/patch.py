"""Patch tests: constant stress is exact on any mesh of trilinear elements."""

import math

import numpy as np

from .case import Row, section, sections

E, NU, STRAIN = 1000.0, 0.3, 0.01
G, LAME = E / 2 / (1 + NU), E * NU / (1 + NU) / (1 - 2 * NU)
PRESSURE = (LAME + 2 * G) * STRAIN
SOURCE = "linear elasticity, u = (γz + s, 0, −εz)"


def sheared_block(angle, shift, coefficient):
    """A brick pressed by a strain and shifted at its top, all faces loaded so that its
    stress is constant; sticking or slipping."""
    shear = min(G * shift, coefficient * PRESSURE)
    c, s = math.cos(angle), math.sin(angle)
    side, along, across = -LAME * STRAIN, shear * c, shear * s
    load = (f"left : {-side}; 0; {-along} | right : {side}; 0; {along} | "
            f"front : 0; {-side}; {-across} | back : 0; {side}; {across}")
    return sections(
        Geometry={"Lengths": "1, 1, 1", "Subdivisions": "3, 4, 3",
                  "Global refinement": "0"},
        Material={"Young's modulus": E, "Poisson ratio": NU},
        Boundary_conditions={
            "Prescribed displacement": f"top : {shift * c}; {shift * s}; {-STRAIN}",
            "Traction": load, "Contact boundary": "bottom", "Obstacle": "foundation"},
        Friction={"Law": "coulomb", "Coefficient": coefficient},
        Contact_solver={"Tolerance": "1e-11"}), shear


def sheared(solver, quick):
    """Stick and slip, along several directions."""
    rows, forces = [], {}
    for name, shift in (("stick", 0.002), ("slip", 0.02)):
        for degrees in (0,) if quick else (0, 17, 45, 200):
            text, shear = sheared_block(math.radians(degrees), shift, 0.3)
            contact = solver(text).summary["contact"]
            force = np.array(contact["tangential_force"][:2])
            forces[name] = np.linalg.norm(force)
            expected = -shear * np.array([math.cos(math.radians(degrees)),
                                          math.sin(math.radians(degrees))])
            where = f"{name}, {degrees}°"
            rows += [Row(f"normal force, {where}", contact["normal_force"], PRESSURE,
                         SOURCE, 1e-9),
                     Row(f"friction, {where}", forces[name], shear, SOURCE, 1e-9),
                     Row(f"its direction, {where}", np.linalg.norm(force - expected)
                         / shear, 0, SOURCE, 1e-9, "absolute")]
    rows.append(Row("friction of a slipping block beside a sticking one", forces["slip"],
                    forces["stick"], "has to differ", 0.1, "at least"))
    return rows, []


def brick(name, lengths, cells, place):
    """A body."""
    return section(f"Body {name}", {"Lengths": lengths, "Subdivisions": cells,
                                    "Translation": place, "Young's modulus": E,
                                    "Poisson ratio": NU})


def across_a_pair(solver, quick):
    """Meshes that do not match, pressed on one another, and tied and pulled."""
    rows = []
    for law, load in (("coulomb", 1.0), ("tied", -1.0)):
        for side in ("boundary",) if quick else ("boundary", "obstacle"):
            text = (brick("lower", "1, 1, 1", "5, 4, 2", "0; 0; 0")
                    + brick("upper", "1, 1, 1", "3, 3, 2", "0; 0; 1") + sections(
                        Boundary_conditions={
                            "Pressure": f"lower.bottom : {load} | upper.top : {load}",
                            "Contact boundary": "lower.top",
                            "Obstacle": "boundary : upper.bottom", "Slave side": side},
                        Friction={"Law": law, "Coefficient": 0.5},
                        Contact_solver={"Tolerance": "1e-11"}))
            nodes = solver(text).contact()
            nodes = {key: values[nodes["area"] > 0] for key, values in nodes.items()}
            worst = nodes["pressure"][np.argmax(np.abs(nodes["pressure"] - load))]
            rows.append(Row(f"the pressure farthest off, {law}, forces on {side}", worst,
                            load, "uniaxial stress; fields have single precision", 1e-6))
    return rows, []


CASES = {"patch, stick and slip": sheared, "patch, across a pair": across_a_pair}
