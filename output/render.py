#!/usr/bin/python3
"""Draw the result of a run of stiction: the body and its contact boundaries.

Call:   xvfb-run -a /usr/bin/python3 output/render.py DIRECTORY [PICTURE.png]
        xvfb-run -a /usr/bin/python3 output/render.py --frames DIRECTORY
after, for instance, './run parameters/brick.prm' with DIRECTORY output/brick.

DIRECTORY holds what the run wrote, on any number of ranks; without
PICTURE.png the picture is DIRECTORY/picture.png. Needs the Debian packages
python3-vtk9 and python3-matplotlib, and xvfb and xauth where there is no
screen.

Left: the deformed body, exaggerated, with the von Mises stress (the values of
all cells at a node averaged), its outline before loading, and the obstacle,
moved along with what it touches, and bent only where the exaggerated body would
cover it; above a flat boundary with a deep dent its gaps are exaggerated as
much. Right: the contact boundaries, of more than eight those that bear most, seen
along their mean normals or, if they are sides of cylinders, unrolled; where forces act
only in a small part, this part.
The first map shows the status: every node colours the part of the boundary
nearest to it, so that no status is ever interpolated. The colour tells what
friction does, white lines over it that the node is open all the same (given
friction), white dots that rounding would decide whether it is; of a run that is
not certified, as the page says, the pressure is shown of undecided nodes as
well, and which of them it presses; arrows of friction start at their nodes, on
fine meshes at some of them. The second one shows the pressure, and where tied
boundaries are pulled; its colours end with the largest pressure of all boundaries, of
one with less than a third of it with its own.

Of a run of several steps this is the last one, and history.png beside it
(PICTURE_history.png, if the picture has another name) has the curves of
history.csv: the forces on the body over t and over displacements of obstacles
that moved, or their moments where the forces add up to nothing, and what friction
dissipates; over t dotted from the start, where the body is as it is made, to the
first step. With --frames DIRECTORY/frame_0001.png and so on are the pictures of
all certified steps of which there are files, all with the same scales, camera and
parts of boundaries, for an animation.
"""

import functools
import io
import os
import sys
from types import SimpleNamespace

try:
    import numpy
    import PIL.Image
    import vtk

    from render_parts import (Unusable, body, history, page, panels,
                              results)
except ImportError as error:
    sys.exit(f"render.py: {sys.executable}: {error}; install the packages "
             "python3-vtk9 and python3-matplotlib and call Debian's own "
             "/usr/bin/python3.")

SHARPNESS = 144  # dots an inch


def render(directory, picture, sharpness=SHARPNESS):
    """Draw the run that wrote into a directory, and the curves of its history."""
    run = results.read(directory, results.last_tag(directory))
    write(draw(run, sharpness), picture, sharpness)
    boundaries = history.read(directory)
    if boundaries:
        start = float(run.summary.get("input", {}).get("Time/Start", 0))
        write(history.draw(boundaries, run.units, start), curves_beside(picture), sharpness)


def curves_beside(picture):
    """The name of the curves of a history: history.png beside picture.png."""
    folder, name = os.path.split(picture)
    return os.path.join(folder, "history.png" if name == "picture.png" else
                        os.path.splitext(name)[0] + "_history.png")


def render_frames(directory, sharpness=SHARPNESS):
    """Draw every step; returns the names of the pictures."""
    steps = results.steps_of(directory)
    if not steps or not steps[0][1]:
        raise Unusable(f"{directory} has no steps, frames are made of a run with "
                       "several 'Time/Steps'.")
    shared = shared_by_frames(directory, steps)
    pictures = [os.path.join(directory, f"frame{tag}.png") for _, tag in steps]
    for picture, (time, tag) in zip(pictures, steps):
        run = results.read(directory, tag, time)
        run.scale = shared.scale
        write(draw(run, sharpness, shared), picture, sharpness)
    give_one_height(pictures)
    return pictures


def shared_by_frames(directory, steps):
    """What is the same in all frames: the scale, the layout of maps on one mesh, the
    windows of maps, and from where to where what is drawn of the bodies goes."""
    scale, layouts = None, []
    for time, tag in steps:  # read again below: all may be too much for memory
        run = results.read(directory, tag, time)
        scale = largest_of(scale, run.scale)
        layouts.append(panels.touched(run.contact))
    one_mesh = len({layout.pressure.shape for layout in layouts}) == 1
    layout = functools.reduce(largest_of, layouts) if one_mesh else None
    scale.dented = set()
    for _ in range(2):  # once more with dents that were found in a later step
        reaches, windows = [], []
        for time, tag in steps:
            run = results.read(directory, tag, time)
            run.scale = scale
            reaches.append(body.reach_of(body.scene_of(run, ())))
            windows.append([panel.window for panel in panels.panels_of(
                run.contact, run.body.points, True, layout)])
        if not scale.dented:
            break
    same_panels = len({len(those) for those in windows}) == 1
    return SimpleNamespace(scale=scale, layout=layout, reach=around(reaches),
                           windows=[around(those) for those in zip(*windows)] * same_panels)


def around(spans):
    """The span, from one corner to the other, that has all of these in it."""
    spans = numpy.array(spans)
    return spans[:, 0].min(axis=0), spans[:, 1].max(axis=0)


def largest_of(before, one):
    """Of each number, or array of numbers, the larger one."""
    return one if before is None else SimpleNamespace(**{
        name: numpy.maximum(value, getattr(before, name))
        for name, value in vars(one).items() if name != "dented"})


def give_one_height(pictures):
    """Add white below pictures that are lower than others."""
    heights = [PIL.Image.open(picture).height for picture in pictures]
    for picture, height in zip(pictures, heights):
        if height < max(heights):
            image = PIL.Image.open(picture)
            page_of_all = PIL.Image.new("RGB", (image.width, max(heights)), "white")
            page_of_all.paste(image)
            save(page_of_all, picture)


def draw(run, sharpness, shared=SimpleNamespace(layout=None, windows=(), reach=None)):
    """The page of a run; shared: what frames have in common."""
    def body_picture(width, height):
        dots = 2 * sharpness  # drawn larger, then shrunk: smooth lines
        return body.picture(run, page.STRESS(range(256)),
                            (width * dots, height * dots), shared.reach)

    shown = panels.panels_of(run.contact, run.body.points, run.certified, shared.layout)
    for panel, window in zip(shown, shared.windows):
        panels.show(panel, *window)
    return page.draw(run, shown, body_picture)


def write(figure, picture, sharpness):
    """Save a figure as a small file."""
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=sharpness)
    image = PIL.Image.open(drawn).convert("RGB")
    # 64 shades of each colour, which nobody sees, make smaller files
    image = image.point([round(c / 255 * 63) * 255 // 63 for c in range(256)] * 3)
    save(image, picture)


def save(image, picture):
    """Write an image to a file."""
    try:
        image.save(picture, format="PNG", optimize=True)
    except OSError as error:
        raise Unusable(f"the picture {picture} cannot be written: {error}.") \
            from error


def main(arguments):
    """Draw what the command line says."""
    if arguments in (["-h"], ["--help"]):
        print(__doc__.strip())
        return
    try:
        frames = arguments[:1] == ["--frames"]
        if len(arguments) not in ((2,) if frames else (1, 2)):
            raise Unusable("call it as render.py DIRECTORY [PICTURE.png] or "
                           "render.py --frames DIRECTORY.")
        if not os.environ.get("DISPLAY"):
            raise Unusable("there is no screen, put 'xvfb-run -a' before the "
                           "command.")
        vtk.vtkObject.GlobalWarningDisplayOff()
        if frames:
            pictures = render_frames(arguments[1])
            print(f"Wrote {pictures[0]} to {pictures[-1]}")
            return
        picture = (arguments[1:] or [os.path.join(arguments[0], "picture.png")])[0]
        render(arguments[0], picture)
        print(f"Wrote {picture}")
    except Unusable as sentence:
        sys.exit(f"render.py: {sentence}")


if __name__ == "__main__":
    main(sys.argv[1:])
