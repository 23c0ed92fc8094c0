"""The numbers that matter, above the picture."""

import math

import numpy as np

from .words import ROUNDING, number, plain, quantity


def numbers(run):
    """The line of them: time, the largest traction, the force, and how many nodes are what."""
    contact, steps = run.summary["contact"], run.summary.get("steps")
    return "   ".join([
        *([f"t = {number(steps[-1]['t'])}"] if steps and run.certified else []),
        *(["nothing is pressed"] if run.released else
          [largest_traction(run, contact), contact_force(run, contact)]),
        "nodes: " + ", ".join(
            f"{status} {contact[status]}" for status in
            ("open", "closed", "slip", "stick", "tied", "undecided")
            if contact.get(status))])


def largest_traction(run, contact):
    """The largest pressure or, where more is pulled than pressed, tension; shear of a tie
    that is neither."""
    pressure, tension = (contact.get(name, 0) for name in ("max_pressure", "max_tension"))
    largest, what = max((pressure, "pressure"), (tension, "tension"), key=lambda of: of[0])
    shear = np.linalg.norm(run.contact.tangential_traction, axis=-1).max()
    if shear > 0 and largest <= ROUNDING * shear:
        largest, what = shear, "shear"
    return f"largest {what} " + quantity(run.units["stress"], largest)


def contact_force(run, contact):
    """That on the one body, or on one of the bodies of a single pair."""
    parts, where = contact["boundaries"], "the body"
    if all(part.get("opposite") for part in parts):
        if len(parts) > 1:
            return f"{len(parts)} pairs"
        contact, where = parts[0], plain(parts[0]["name"])
    what, values = "force", contact["force_on_body"]
    if max(map(abs, values)) < ROUNDING * contact["normal_force"]:  # those of a fit
        what, values = "moment", contact["moment"]
        # the root of the area is a length; bodies that are only squeezed have neither
        if max(map(abs, values)) < (ROUNDING * contact["normal_force"]
                                    * math.sqrt(contact["area"])):
            return "contact presses with " + quantity(run.units["force"],
                                                      contact["normal_force"])
    return f"contact {what} on {where} " + quantity(run.units[what], *values)
