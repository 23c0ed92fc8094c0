"""Random small bodies: all methods agree, and what is certified is judged once more from
the files alone."""

import os
import random
import tempfile

import numpy as np

from .case import Row, sections, stiction

METHODS = ("newton", "gauss seidel", "mpgp", "admm", "newton multigrid")
OBSTACLES = ("foundation", "plane : 0; 0; -0.001; 0.05; 0.03; 1",
             "sphere : 0.4; 0.6; -3.001; 3", "formula : z + 0.001 + 0.03*(x-0.5)^2",
             "cylinder : 0.5; 0; -2.001; 0; 1; 0; 2")


def problem(number):
    """A brick of random size, material, loads, support, obstacle and law."""
    rng = random.Random(number)
    pull = [rng.uniform(-1, 1) for _ in range(3)]
    push = rng.uniform(1, 5)
    law = rng.choice(("coulomb", "coulomb", "given", "frictionless"))
    held, free = rng.choice((("left", "right"), ("back", "front"), ("right", "back")))
    lengths = [rng.uniform(0.7, 1.5) for _ in range(3)]
    text = sections(
        Geometry={"Lengths": ", ".join(map(str, lengths)),
                  "Subdivisions": ", ".join(str(rng.randint(3, 5)) for _ in range(3)),
                  "Global refinement": 0},
        Material={"Young's modulus": 10 ** rng.uniform(1, 4),
                  "Poisson ratio": rng.uniform(0, 0.45)},
        Boundary_conditions={
            "Prescribed displacement": f"{held} : 0; 0; 0",
            "Traction": f"top : 0; 0; {-push} | {free} : " + "; ".join(map(str, pull)),
            "Contact boundary": "bottom", "Obstacle": rng.choice(OBSTACLES)},
        Friction={"Law": law, "Coefficient": rng.uniform(0.05, 0.9),
                  "Slip stress": rng.uniform(0.05, 1)},
        Contact_solver={"Tolerance": "1e-9"},
        Output={"Double precision": "true", "Write solution": "true"},
        Refinement={"Estimate error": "false"})
    areas = {"top": lengths[0] * lengths[1], "right": lengths[1] * lengths[2],
             "back": lengths[0] * lengths[2], "front": lengths[0] * lengths[2]}
    load = areas[free] * np.array(pull) - np.array([0, 0, areas["top"] * push])
    return text, load


def matrix_market(name):
    """A dense array, symmetric or not."""
    with open(name, encoding="utf-8") as file:
        head = file.readline()
        lines = [line for line in file if not line.startswith("%")]
    rows, columns = map(int, lines[0].split())
    values = np.array([float(line) for line in lines[1:]])
    if "symmetric" not in head:
        return values.reshape(columns, rows).T.squeeze()
    full = np.zeros((rows, rows))
    full[np.triu_indices(rows)] = values  # the lower triangle by columns
    return full + np.triu(full, 1).T


def judge(directory, energy):
    """How far an exported solution is from the conditions, in scales of its own: the sum
    of its forces and twice the strain energy over it."""
    def read(name):
        path = os.path.join(directory, name + ".mtx")
        return matrix_market(path) if os.path.exists(path) else None
    Q, h, x = read("Q"), read("h"), read("lambda")
    m = len(h) // 3
    F, given = read("friction_coefficient"), read("slip_bound")
    g = F * np.maximum(x[:m], 0) if F is not None else given
    force = np.linalg.norm(x.reshape(3, m), axis=0).sum()
    if not force > 0:
        return 0.0 if (Q @ x - h)[:m].min() >= 0 else np.inf
    way = 2 * energy / force
    scale = np.maximum(read("areas"), 0) * force / read("areas").sum()
    r = (Q @ x - h).reshape(3, m) / way
    x = x.reshape(3, m) / scale
    target = x - r
    normal = np.maximum(target[0], 0)
    size = np.hypot(target[1], target[2])
    shrink = np.minimum(1, g / scale / np.maximum(size, 1e-300))
    return np.sqrt((x[0] - normal) ** 2 + (x[1] - shrink * target[1]) ** 2
                   + (x[2] - shrink * target[2]) ** 2).max()


def methods(solver, quick):
    """All methods on a few random bodies."""
    apart, worst, unbalanced, touching, friction = 0.0, 0.0, 0.0, 0, 0
    for number in range(4 if quick else 12):
        text, load = problem(number)
        reference = None
        for method in METHODS:
            run = solver(text, {"Contact solver/Method": method})
            table = stiction.read_table(os.path.join(run.directory, "contact.csv"))
            forces = np.column_stack([table["force_" + c] for c in "xyz"])
            body = stiction.read_table(os.path.join(run.directory, "displacement.csv"))
            reactions = np.array([body["reaction_" + c].sum() for c in "xyz"])
            unbalanced = max(unbalanced, np.linalg.norm(
                load + reactions + forces.sum(axis=0)) / np.linalg.norm(load))
            if reference is None:
                reference = forces
                touching += np.abs(forces).max() > 0
                friction += np.abs(forces[:, :2]).max() > 1e-3 * np.abs(forces).max() > 0
            apart = max(apart, np.linalg.norm(forces - reference) / np.linalg.norm(load))
        with tempfile.TemporaryDirectory() as exported:
            run = solver(text, {"Contact solver/Method": "newton",
                                "Output/Export directory": exported})
            worst = max(worst, judge(exported, run.summary["energy"]["strain"]))
    return [Row("forces of two methods, where they differ most, of the loads", apart, 0,
                "one solution", 1e-5, "absolute"),
            Row("conditions of contact and friction, from the exported files", worst, 0,
                "judged here", 1e-6, "absolute"),
            Row("loads, reactions and contact forces, from displacement.csv and "
                "contact.csv, of the loads", unbalanced, 0, "balance", 1e-6, "absolute"),
            Row("bodies that touch", touching, 0, "something has to", 2, "at least"),
            Row("bodies with friction", friction, 0, "something has to", 1, "at least")
            ], []


CASES = {"random bodies": methods}
