"""Pure functions: reading what the program wrote, and figures made of it."""

import csv
import io
import math

from .errors import BenchmarkError


def parse_levels(text, allowed, option="--k"):
    """Numbers and ranges such as '1-4' or '1,3,6', in increasing order."""
    levels = set()
    for part in text.split(","):
        first, _, last = part.partition("-")
        try:
            span = range(int(first), int(last or first) + 1)
        except ValueError:
            span = range(0)
        if not span or not set(span) <= set(allowed):
            raise BenchmarkError(
                f"{option} {text}: '{part}' is no number or range from "
                f"{min(allowed)} to {max(allowed)}, such as 2 or 1-4"
            )
        levels.update(span)
    return sorted(levels)


def parse_names(option, text, allowed):
    """Names of a list with commas, whatever their case; in allowed's order.

    allowed is a mapping from every name that is understood to the one meant.
    """
    meant = {name.lower(): value for name, value in allowed.items()}
    chosen = set()
    for part in text.split(","):
        if part.strip().lower() not in meant:
            raise BenchmarkError(
                f"{option} {text}: '{part}' is none of {', '.join(allowed)}"
            )
        chosen.add(meant[part.strip().lower()])
    return [value for value in dict.fromkeys(allowed.values()) if value in chosen]


def short(number):
    """A number the way people write it: 1e-8, 120."""
    return f"{number:g}".replace("e-0", "e-")


def parse_history(text):
    """[products with Q, KKT residual] of each row of convergence.csv.

    Columns are found by name, as methods differ in the others. Empty if one
    of the two is missing.
    """
    history = []
    for row in csv.DictReader(io.StringIO(text)):
        try:
            point = [
                float(row["dual_multiplications"]),
                float(row["kkt_residual"]),
            ]
        except (KeyError, TypeError, ValueError):
            continue
        if all(math.isfinite(number) for number in point):
            history.append(point)
    return history


def products_to(history, residual):
    """Products with Q when the residual was first reached, else None."""
    return next((p for p, r in history if r <= residual), None)


def look_up(tree, path):
    """The entry 'a/b/c' of nested dicts, None where it is missing or null."""
    for key in path.split("/"):
        tree = tree.get(key) if isinstance(tree, dict) else None
    return tree


def iteration_seconds(summary):
    """Seconds of the dual method alone, with Q given, from summary.json.

    Programs that do not time it apart count the two set-ups in contact_solve.
    """
    seconds = look_up(summary, "seconds") or {}
    if seconds.get("dual_iteration") is not None:
        return seconds["dual_iteration"]
    whole = seconds.get("contact_solve")
    if whole is None:
        return None
    set_up = [seconds.get(key) or 0 for key in ("stiffness_setup", "dual_operator")]
    return max(whole - sum(set_up), 0.0)


def growth_exponent(sizes, costs):
    """p of cost = c size^p by least squares in logarithms; None if < 2 points.

    Costs that are None or not positive are left out.
    """
    points = [
        (math.log(size), math.log(cost))
        for size, cost in zip(sizes, costs)
        if cost is not None and cost > 0
    ]
    if len({x for x, _ in points}) < 2:
        return None
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / sum(
        (x - mean_x) ** 2 for x, _ in points
    )


def relative_difference(vector, reference):
    """Euclidean, relative to the reference; None if either is missing."""
    if not vector or not reference or len(vector) != len(reference):
        return None
    size = math.hypot(*reference)
    return math.dist(vector, reference) / size if size > 0 else None


def ratio(numerator, denominator):
    """A quotient, None if it makes no sense."""
    if numerator is None or not denominator:
        return None
    return numerator / denominator


def performance_profile(costs):
    """The profile of Dolan and More.

    costs: {method: [cost of each problem, None where it failed]}. Returns
    {method: [(factor, share of the problems solved within this factor of the
    best method), ...]} as the corners of a staircase. Problems that nobody
    solved do not count.
    """
    best = [
        min((cost for cost in column if cost is not None), default=None)
        for column in zip(*costs.values())
    ]
    problems = sum(1 for cost in best if cost is not None)
    profile = {}
    for method, row in costs.items():
        factors = sorted(
            cost / least if least > 0 else 1.0
            for cost, least in zip(row, best)
            if cost is not None
        )
        profile[method] = [
            (factor, (solved + 1) / problems)
            for solved, factor in enumerate(factors)
        ]
    return profile


def flatness(values):
    """d of the narrowest band c (1 ± d) around them all; None if < 2 values.

    More values never make it smaller.
    """
    known = [value for value in values if value is not None]
    if len(known) < 2:
        return None
    low, high = min(known), max(known)
    return (high - low) / (high + low)


def all_true(answers):
    """False if one is, else None if one is unknown or there are none."""
    answers = list(answers)
    if any(answer is False for answer in answers):
        return False
    return None if not answers or None in answers else True


def at_most(value, limit):
    """Whether it is; None if there is no value."""
    return None if value is None else value <= limit


def at_least(value, limit):
    """Whether it is; None if there is no value."""
    return None if value is None else value >= limit


def largest(values):
    """Of those that are known; None if there are none."""
    return max((value for value in values if value is not None), default=None)


def smallest(values):
    """Of those that are known; None if there are none."""
    return min((value for value in values if value is not None), default=None)
