"""A solution that was chosen, with contact, and the order in which it is approached."""

import math

import numpy as np

from .case import Curve, Plot, Row, order, sections

E, NU, SIZE, WAVES = 1000.0, 0.3, 0.01, 0.3
G, LAME = E / 2 / (1 + NU), E * NU / (1 + NU) / (1 - 2 * NU)
PI = math.pi


def problem(cells, degree):
    """u = (0, 0, w), w = −SIZE sin(πz/2) (1 + WAVES cos πx cos πy) in the unit cube: its
    base is pressed on the foundation everywhere and slides without friction, its sides
    are planes of symmetry, and loads make up for the rest."""
    C, c = "cos(pi*x)*cos(pi*y)", WAVES
    s, k = "sin(pi*z/2)", "cos(pi*z/2)"
    along_x = f"{-(LAME + G) * SIZE * c * PI**2 / 2} * sin(pi*x)*cos(pi*y)*{k}"
    along_y = f"{-(LAME + G) * SIZE * c * PI**2 / 2} * cos(pi*x)*sin(pi*y)*{k}"
    along_z = (f"{-G * SIZE * 2 * c * PI**2} * {C}*{s} - "
               f"{(LAME + 2 * G) * SIZE * PI**2 / 4} * {s} * (1 + {c}*{C})")
    shear = G * SIZE * c * PI
    return sections(
        Geometry={"Lengths": "1, 1, 1", "Subdivisions": f"{cells}, {cells}, {cells}",
                  "Global refinement": 0, "Element degree": degree},
        Material={"Young's modulus": E, "Poisson ratio": NU},
        Boundary_conditions={
            "Prescribed displacement": "left : 0; free; free | right : 0; free; free | "
                                       "front : free; 0; free | back : free; 0; free",
            "Body force": f"{along_x}; {along_y}; {along_z}",
            "Traction": f"top : {shear}*sin(pi*x)*cos(pi*y); "
                        f"{shear}*cos(pi*x)*sin(pi*y); 0",
            "Contact boundary": "bottom", "Obstacle": "foundation"},
        Friction={"Law": "frictionless"}, Contact_solver={"Tolerance": "1e-10"})


def orders(solver, quick):
    """Energies of degree 1 and 2 on finer and finer meshes."""
    exact = SIZE**2 / 2 * ((LAME + 2 * G) * PI**2 / 8 * (1 + WAVES**2 / 4)
                           + G * WAVES**2 * PI**2 / 4)
    rows, curves = [], []
    for degree, levels in ((1, (4, 8, 16)), (2, (2, 4, 8))):
        levels = levels[:2] if quick else levels
        errors, pressure_errors = [], []
        for cells in levels:
            run = solver(problem(cells, degree))
            summary, nodes = run.summary, run.contact()
            x, y = nodes["points"][:, 0], nodes["points"][:, 1]
            pressure = (LAME + 2 * G) * SIZE * PI / 2 * (
                1 + WAVES * np.cos(PI * x) * np.cos(PI * y))
            pressure_errors.append(abs(nodes["pressure"] / pressure - 1).max())
            # ‖u − u_h‖² is twice what the energy lacks, of a body that loads drive
            errors.append(math.sqrt(abs(1 - summary["energy"]["strain"] / exact)))
        rows += [Row(f"error in the energy norm, degree {degree}, order in h",
                     order(errors), degree, "polynomials of that degree", 0.1, "order"),
                 Row(f"strain energy, degree {degree}", summary["energy"]["strain"], exact,
                     "the solution that was chosen", 0.02 if quick else 0.001),
                 Row(f"pressure, degree {degree}, where it is farthest off",
                     pressure_errors[-1], 0, "the solution that was chosen",
                     0.05 if quick else 0.01, "absolute")]
        curves.append(Curve(f"degree {degree}", [1 / n for n in levels], errors, "o-"))
    return rows, [Plot("Manufactured solution", "h", "error in the energy norm", curves,
                       logarithmic=True)]


CASES = {"manufactured solution": orders}
