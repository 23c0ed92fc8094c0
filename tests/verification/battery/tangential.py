"""Cattaneo, Mindlin and Deresiewicz; Jaeger and Ciavarella."""

import math

import numpy as np

from .case import Curve, Plot, Row, section, sections

MINDLIN = "Cattaneo (1938), Mindlin & Deresiewicz (1953); Johnson, 7.2, 7.4"


def ball(solver, quick):
    """ball_press_drag_return.prm: a rigid ball on nearly incompressible rubber."""
    E, nu, R, F = 10.0, 0.49, 50.0, 0.3
    G = E / 2 / (1 + nu)
    run = solver.shipped("ball_press_drag_return.prm", {
        "Geometry/Contact refinement": 3 if quick else 5,
        "Output/Write solution": "false", "Refinement/Estimate error": "false"})
    history = run.history
    t, way = history["t"], history["obstacle_x"]
    P, Q = -2 * history["force_z"], 2 * history["force_x"]
    a = np.cbrt(3 * P * R * (1 - nu**2) / 4 / E)
    K = 3 * F * P / 16 / a * (2 - nu) / G  # the way up to where all of it slides
    q = Q / F / P
    part = 1 - np.cbrt(1 - np.clip(q, -1, 1)) ** 2
    stick = np.sqrt(2 * history["stick_area"] / math.pi) / a
    turn = np.argmin(abs(t - 2))
    end = np.argmin(abs(t - 6))
    since = (q[turn] - np.where(t <= 4, 1, -1) * q) / 2
    back = 1 - np.cbrt(1 - since) ** 2
    exact = np.where(t <= 2, part, np.where(t <= 4, 1, -1) * (part[turn] - 2 * back))
    loop = 4 * K[end] * F * P[end] * (
        q[turn] * part[turn] - 2 * q[turn] + 1.2 * (1 - (1 - q[turn]) ** (5 / 3)))
    lost = 2 * (history["dissipated_total"][end] - history["dissipated_total"][turn])
    dragged = t > 1
    rows = [
        Row("radius of sticking at t = 2, of that of contact", stick[turn],
            (1 - q[turn]) ** (1 / 3), MINDLIN, 0.1 if quick else 0.03),
        Row("way at any time, of the largest, where it is farthest off",
            (abs(way - K * exact) / 0.03)[dragged].max(), 0, MINDLIN, 0.03, "absolute"),
        Row("energy lost to and fro", lost, loop, MINDLIN, 0.05 if quick else 0.015),
    ]
    rows.append(Row("friction at t = 2, of that of sliding", q[turn], 0, "has to act", 0.1,
                    "at least"))
    return rows, [Plot("A ball dragged to and fro", "way, mm", "friction/(F P)", [
        Curve("Mindlin, Deresiewicz", (K * exact)[dragged], q[dragged], "-"),
        Curve("steps", way[dragged], q[dragged], "o")])]


def two_spheres(solver, quick):
    """Equal bodies with the gap of two spheres, moved to and fro."""
    E, nu, R, F = 10.0, 0.3, 50.0, 0.3
    G = E / 2 / (1 + nu)
    block = {"Lengths": "60, 32, 32", "Subdivisions": "15, 8, 8"}
    run = solver(
        section("Body lower", block)
        + section("Body upper", {**block, "Translation": "0; 0; 32"}) + sections(
            Geometry={"Contact refinement": 3 if quick else 5,
                      "Contact refinement where": "(x-30)^2 + y^2 < 7"},
            Material={"Young's modulus": E, "Poisson ratio": nu},
            Boundary_conditions={
                "Prescribed displacement":
                    "lower.bottom : 0; 0; 0 | lower.front : free; 0; free | "
                    "upper.front : free; 0; free | upper.top : 0.0175*if(t < 1, 0, "
                    "if(t < 2, t-1, if(t < 4, 3-t, t-5))); 0; -0.1*min(t, 1)",
                "Contact boundary": "upper.bottom", "Obstacle": "boundary : lower.top",
                "Initial gap": "((x-30)^2 + y^2)/100"},
            Friction={"Law": "coulomb", "Coefficient": F}, Time={"End": 6, "Steps": 6},
            Contact_solver={"Tolerance": "1e-8"}, Refinement={"Estimate error": "false"},
            Output={"Write solution": "false"}))
    history = run.history
    P, Q = 2 * abs(history["force_z"][-1]), 2 * abs(history["force_x"][-1])
    q = Q / F / P
    a = (3 * P * R * 2 * (1 - nu**2) / 4 / E) ** (1 / 3)
    stick = math.sqrt(history["stick_area"][-1]
                      / (history["stick_area"][-1] + history["slip_area"][-1]))
    loop = 9 * F**2 * P**2 / 10 / a * 2 * (2 - nu) / G * (
        1 - (1 - q) ** (5 / 3) - 5 * q / 6 * (1 + (1 - q) ** (2 / 3)))
    total = history["dissipated_total"]
    return [Row("radius of sticking, of that of contact", stick, (1 - q) ** (1 / 3),
                MINDLIN, 0.1 if quick else 0.02),
            Row("friction, of that of sliding", q, 0, "has to act", 0.1, "at least"),
            Row("energy lost in a loop", 2 * (total[-1] - total[1]), loop, MINDLIN,
                0.3 if quick else 0.015)], []


def strip(refinement):
    """Two equal strips in plane strain with the gap of a cylinder; their problem without
    friction and displacements."""
    def body(place):
        return {"Lengths": "48, 0.75, 24", "Subdivisions": "64, 1, 32",
                "Translation": f"-24; 0; {place}"}
    return (section("Body lower", body(-24)) + section("Body upper", body(0)) + sections(
        Geometry={"Global refinement": 0, "Contact refinement": refinement,
                  "Contact refinement where": "2 - abs(x)"},
        Material={"Young's modulus": 1000, "Poisson ratio": 0.3},
        Contact_solver={"Tolerance": "1e-9"}, Refinement={"Estimate error": "false"}))


def jaeger(solver, quick):
    """Tangential traction is the difference of two pressures without friction."""
    F, refinement = 0.4, 2 if quick else 3
    planes = " | ".join(f"{body}.{side} : free; 0; free" for body in ("lower", "upper")
                        for side in ("front", "back"))

    def problem(law, press, drag, steps):
        return strip(refinement) + sections(
            Boundary_conditions={
                "Prescribed displacement":
                    f"lower.bottom : 0; 0; 0 | {planes} | upper.top : "
                    f"{drag}*max(0, t-1); 0; {-press}*min(t, 1)",
                "Contact boundary": "upper.bottom", "Obstacle": "boundary : lower.top",
                "Slave side": "boundary", "Initial gap": "x^2/40 + x^4/500"},
            Friction={"Law": law, "Coefficient": F}, Time={"End": steps, "Steps": steps})

    def forces(run):
        contact = run.summary["contact"]["boundaries"][0]
        return abs(contact["normal_force"]), abs(contact["tangential_force"][0])

    def profile(run):
        nodes = run.contact()
        x, y = nodes["points"][:, 0], nodes["points"][:, 1]
        keep = (nodes["area"] > 0) & (y < 1e-9) & (abs(x) < 2)
        rank = np.argsort(x[keep])
        return [x[keep][rank], nodes["pressure"][keep][rank],
                nodes["tangential_traction"][keep, 0][rank]]

    dragged = solver(problem("coulomb", 0.05, 0.02, 2))
    P, Q = forces(dragged)
    x, p, q = profile(dragged)
    # the displacement that presses with P − Q/F, by secants
    wanted, press = P - Q / F, [0.04, 0.03]
    runs = [solver(problem("frictionless", way, 0, 1)) for way in press]
    for _ in range(4):
        y = [forces(run)[0] - wanted for run in runs[-2:]]
        if abs(y[-1]) < 1e-4 * P:
            break
        press.append(press[-1] - y[-1] * (press[-1] - press[-2]) / (y[-1] - y[-2]))
        runs.append(solver(problem("frictionless", press[-1], 0, 1)))
    smaller = profile(runs[-1])[1]
    difference = F * (p - smaller)
    off = abs(abs(q) - difference).sum() / (F * p.sum())
    return [Row("traction, mean difference, of the mean of the largest possible", off, 0,
                "Jaeger (1998), Ciavarella (1998): q = F [p(P) − p(P − Q/F)]",
                0.05 if quick else 0.02, "absolute"),
            Row("friction, of that of sliding", Q / F / P, 0, "has to act", 0.1,
                "at least")], [
        Plot("Two strips with a profile of fourth order", "x", "traction/(F p0)", [
            Curve("F [p(P) − p(P − Q/F)]", x, difference / F / p.max()),
            Curve("friction", x, abs(q) / F / p.max(), "."),
            Curve("pressure", x, p / p.max(), ":")])]


CASES = {"Cattaneo-Mindlin, a rigid ball": ball,
         "Cattaneo-Mindlin, two equal spheres": two_spheres,
         "Jaeger-Ciavarella": jaeger}
