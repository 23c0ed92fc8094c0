#!/usr/bin/python3
"""Run the shipped parameter files and make the pictures of doc/gallery.md.

Call:   ./run gallery [NAME ...]
with names of pictures for those alone. Needs build/stiction and what
output/render.py needs. Writes doc/gallery/NAME.png and doc/gallery.md.
"""

import glob
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "output"))
import render  # pylint: disable=wrong-import-position

SHARPNESS = 70  # dots an inch: 896 wide
GALLERY = os.path.join(ROOT, "doc", "gallery")
STICTION = os.path.join(ROOT, "build", "stiction")

# what is to be seen, by file in parameters/
PICTURES = {
    "brick": "The reference brick with Coulomb friction: clamped at y = 0, "
    "pressed down where y > 1.5 and pulled at its back, it slips at the back, "
    "sticks in a band and is open near the clamped end.",
    "brick_given_friction": "The same with given friction: the bound is the "
    "same everywhere, so nodes with hardly any pressure, and open ones (hatched), "
    "stick as well.",
    "brick_frictionless": "The same without friction: no arrows, no node "
    "sticks.",
    "sphere": "A rigid sphere in a block; its gap is exaggerated as much as "
    "the displacement, so that it lies in the dent it makes.",
    "stl": "A stamp given by triangles: the pressure is highest at its edges.",
    "block_on_slope": "A block on a slope that nothing but contact and friction "
    "holds: the lower edge bears most, the upper one opens, and all but a core slips.",
    "several_bodies/three_bars": "Three bars on one another, of which two are held by "
    "contact alone: the top one is about to slip, and its pair sticks in the middle only.",
    "several_bodies/two_spheres": "Two equal balls pressed on one another and moved "
    "aside: the middle of the circle sticks.",
    "several_bodies/press_fit": "A hub shrunk onto a hollow shaft and turned: friction "
    "is used up first where the shaft is held.",
    "several_bodies/pin_in_hole": "A lug pulled over a pin with clearance: the hole, "
    "unrolled, touches the pin on less than half of its way round.",
    "several_bodies/glued_pad": "A pad of rubber glued under a block of steel, pressed on "
    "the floor and dragged: it slides but for a part near its trailing edge, which lifts; "
    "at the leading edge the glue is pulled.",
    "several_bodies/wedges": "A wedge driven under another one that bears a load and leans "
    "against a wall: all nodes slip, on the floor and on the slope.",
    "several_bodies/foot_over_joint": "The foot of a machine over the joint of a plate of "
    "steel and one of aluminium, pressed and dragged: it leans on its leading edge, and the "
    "pressure has a seam where the steel ends.",
    "several_bodies/block_between_blocks": "A block of rubber held between two of steel, "
    "and pulled to the right.",
    "several_bodies/brick_on_elastic_foundation": "The reference brick on a slab of the "
    "same steel, which gives way under it.",
    "crack": "A slice of a plate with a crack, compressed and sheared: its lips stay closed "
    "and rub, by as much as in an infinite plate but for 3 %.",
    "seal": "A rubber seal squeezed into a groove, half of its length: it fills the groove "
    "and presses against its walls, and comes out at its free end.",
    "two_contact_boundaries": "A bar between a foundation and a plane, "
    "each with its own law of friction: each contact boundary has its own "
    "maps, all with the same colours of pressure.",
    "greco_plate": "The GRECO plate of Code_Aster: a strip of contact, open at "
    "the left, then slipping, then sticking; the map stretches its thickness.",
    "hertz": "Hertz' contact, a quarter by symmetry: the map shows the small "
    "part that touches, in which the pressure is half an ellipsoid.",
    "sliding_sphere": "A sphere pressed on and drawn sideways: a part sticks, "
    "the rim slips; small cells with hanging nodes where it touches.",
    "roller": "A roller pressed on rubber and turned: it drags the rubber along, "
    "the middle sticks, the rim slips.",
    "latch": "A leaf that a rigid roller lifts as it passes under its end, which it "
    "touches along a line; the forces rise while the corner climbs the roller, and more "
    "slowly as this goes on under the leaf.",
    "rolling": "A wheel that rolls along a strip of rubber and drives it back: its front "
    "sticks, its back slips; the force along the strip comes to what Carter says while the "
    "wheel rolls by some widths of its contact.",
    "ball_press_drag_return": "A ball pressed on rubber, dragged, brought back "
    "beyond where it was and dragged again: the half of its contact that symmetry "
    "leaves, the middle sticks and the ring around it slips.",
    "punch_twist": "A round punch pressed on and twisted until all slips: "
    "friction goes around the axis.",
    "brick_loaded_unloaded": "The reference brick after its pull was taken away "
    "again: what has slipped does not come back, the arrows are the friction that "
    "remains.",
    "brake_pad": "A brake pad on a moving disc: friction tips it, and the coefficient "
    "falls with the pressure.",
    "two_materials": "A soft layer under a stiff one: the stress is in the "
    "stiff layer.",
    "gravity": "A wall under the pressure of water and its own weight, "
    "clamped at one side: its foot opens towards the water.",
    "orthotropic": "Wood pressed down and drawn along its grain: all of it "
    "slips.",
    "orthotropic_friction": "An ellipse of friction: the arrows are longer "
    "along x than along y where the block slips.",
    "rubber": "A sphere pressed deep into nearly incompressible rubber: nearly "
    "all of the contact sticks.",
    "quadratic": "The brick with triquadratic elements, their corners and the "
    "nodes between them.",
    "contact_refinement": "The brick with smaller cells at a part of the "
    "contact boundary, and hanging nodes.",
    "adaptive": "The brick refined where the estimated error is large.",
    "half_ball": "A half ball on a foundation, pressed and shifted: a curved "
    "contact boundary seen along its mean normal.",
    "cylinder": "A cylinder pressed down and twisted: friction turns around "
    "the axis, the middle sticks.",
    "mesh_file": "A distorted block from a Gmsh file.",
    "bracket": "A bracket from CAD, of tetrahedra cut into hexahedra: a pin presses on "
    "the upper part of the hole in its eye, which the maps show unrolled.",
    "methods/newton_multigrid": "The brick with 162,435 unknowns, solved in "
    "displacements.",
    "methods/qpq_as_printed": "The brick of the first row of Table 1.",
    "methods/squares": "The brick with discs replaced by two squares: what "
    "does not certify is titled so.",
    "table_1/unknowns_coulomb": "The 3 x 1 x 1 brick of the other reading of "
    "Table 1, first row.",
}

# these show the same as others
ALIKE = {
    "methods/admm": "brick", "methods/fixed_point": "brick",
    "methods/newton": "brick", "methods/mpgp": "brick_given_friction",
    "table_1/nodes_coulomb": "methods/qpq_as_printed",
    "table_1/nodes_given_friction": "brick_given_friction, coarser",
    "table_1/unknowns_given_friction": "table_1/unknowns_coulomb",
}


def fail(sentence):
    """End with one sentence on stderr and exit status 1."""
    sys.exit(f"gallery.py: {sentence}")


def check_names(chosen):
    """All shipped files have to be known here, and all chosen ones exist."""
    shipped = {os.path.relpath(file, os.path.join(ROOT, "parameters"))[:-4]
               for file in glob.glob(os.path.join(ROOT, "parameters", "**",
                                                  "*.prm"), recursive=True)}
    for name in shipped ^ (PICTURES.keys() | ALIKE.keys()):
        fail(f"parameters/{name}.prm is shipped or named here, but not both.")
    for name in chosen:
        if name not in PICTURES:
            fail(f"there is no picture '{name}', there are "
                 f"{', '.join(PICTURES)}.")


def picture_of(name):
    """Where the picture of a parameter file is, from doc/."""
    return "gallery/" + os.path.basename(name) + ".png"


def make(name, directory):
    """Run a parameter file and draw its picture."""
    output = os.path.join(directory, os.path.basename(name))
    done = subprocess.run([STICTION, f"parameters/{name}.prm", "--output",
                           output], cwd=ROOT, stdout=subprocess.DEVNULL)
    if done.returncode not in (0, 2):  # 2: not certified, and titled so
        fail(f"parameters/{name}.prm ended with status {done.returncode}.")
    render.render(output, os.path.join(ROOT, "doc", picture_of(name)),
                  SHARPNESS)
    print(f"Wrote doc/{picture_of(name)}", flush=True)


def write_page():
    """doc/gallery.md."""
    lines = ["# What the shipped parameter files show", "",
             "Made by `./run gallery`; `./run FILE.prm --picture` makes such a "
             "picture of any", "run. Read it so: on the left the deformed body "
             "with its von Mises stress, grey", "lines where it was before, and "
             "the obstacle, bent where the body would cover", "it, or, above a flat "
             "boundary with a deep dent, all gaps exaggerated as much", "as the "
             "displacement. On the right the contact boundaries, of more than eight "
             "those", "that bear most: the status of their nodes with arrows of friction "
             "(hatched: open),", "and the pressure.", ""]
    for name, sentence in PICTURES.items():
        lines += [f"## {name}", "", sentence, "",
                  f"![{name}]({picture_of(name)})", ""]
        curves = render.curves_beside(picture_of(name))
        if os.path.exists(os.path.join(ROOT, "doc", curves)):
            lines += [f"![history of {name}]({curves})", ""]
    lines += ["## The others", ""]
    lines += [f"- `parameters/{name}.prm`: as {other}" for name, other
              in ALIKE.items()]
    with open(os.path.join(ROOT, "doc", "gallery.md"), "w",
              encoding="utf-8") as page:
        page.write("\n".join(lines) + "\n")


def main(chosen):
    """Make the chosen pictures, or all."""
    if chosen in (["-h"], ["--help"]):
        print(__doc__.strip())
        return
    check_names(chosen)
    if not os.path.exists(STICTION):
        fail("there is no build/stiction, './run gallery' builds it.")
    if not os.environ.get("DISPLAY"):
        os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, "-B", __file__,
                               *chosen])
    os.makedirs(GALLERY, exist_ok=True)
    with tempfile.TemporaryDirectory() as directory:
        for name in chosen or PICTURES:
            make(name, directory)
    write_page()


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except render.Unusable as unusable:
        fail(unusable)
