"""The page: where everything stands on the picture, and what is written there.

Lengths are inches from the lower left corner; every text has room of its own.
"""

import math

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch, PathPatch, Rectangle
from matplotlib.path import Path
from matplotlib.ticker import FuncFormatter, MaxNLocator

from . import headline
from . import panels as contact_panels
from .slot import BAR, COLUMN, GAP, KEY, TICKS, TITLE, Slot
from .words import ROUNDING, exponent_of, label, number, plain, quantity

WIDTH, MARGIN, HEADER = 12.8, 0.3, 0.95
LEFT, RIGHT = 0.3, 6.55  # two columns
BODY = 5.7  # width
BETWEEN = 0.28  # maps side by side
THICK = 0.13  # a colour bar
MOST = 8  # maps of contact boundaries that are drawn

SMALL, NORMAL, LARGE = 8.5, 10, 15
TEXT, RED = "#212121", "#B00020"
# The colour is what friction does, in grey 0.9, 0.65, 0.75, 0.5, and lines or
# dots over it tell that the node is open, or may be.
OPEN, CLOSED, SLIP, STICK = "#D3E9F7", "#6FBFA5", "#F2B13C", "#3F8FC6"
TIED, TENSION = "#B9A7D6", "#58A55C"
KINDS = {contact_panels.OPEN: ("open", OPEN, None, None),
         contact_panels.CLOSED: ("closed", CLOSED, None, None),
         contact_panels.SLIP: ("slip", SLIP, None, None),
         contact_panels.STICK: ("stick", STICK, None, None),
         contact_panels.OPEN_SLIP: ("open, slip", SLIP, "////", "white"),
         contact_panels.OPEN_STICK: ("open, stick", STICK, "////", "white"),
         contact_panels.MAYBE_SLIP: ("open or closed, slip", SLIP, "....",
                                     "white"),
         contact_panels.MAYBE_STICK: ("open or closed, stick", STICK, "....",
                                      "white"),
         contact_panels.UNDECIDED: ("undecided", "white", "....", "#707070"),
         contact_panels.PRESSED: ("undecided, pressed", CLOSED, "....", "white"),
         contact_panels.TIED: ("tied", TIED, None, None),
         contact_panels.CLAMPED: ("clamped or nothing opposite", "#C4C4C4", "////",
                                  "#707070")}
STRESS, PRESSURE = colormaps["viridis"], colormaps["magma_r"].with_extremes(under=TENSION)


class Page:
    """A page of a given height to put things on from the top downwards."""

    def __init__(self, height):
        self.figure = Figure(figsize=(WIDTH, height), facecolor="white")
        FigureCanvasAgg(self.figure)
        self.height = height

    def axes(self, left, top, width, height, **options):
        """Axes in a box of which the upper left corner is given."""
        return self.figure.add_axes(
            [left / WIDTH, 1 - (top + height) / self.height, width / WIDTH,
             height / self.height], **options)

    def text(self, left, top, words, size=NORMAL, **options):
        """A line of text of which the upper left corner is given."""
        self.figure.text(left / WIDTH, 1 - top / self.height, words,
                         fontsize=size, va="top",
                         **{"color": TEXT, **options})

    def color_bar(self, left, top, width, colors, largest, words, unit, peak=0):
        """A scale from zero to the largest value, the words below; peak: what is to be
        said of how large it is, and may be beyond the scale."""
        if not largest > 0:
            self.text(left, top, "no " + words)
            return
        exponent = exponent_of(largest)
        axes = self.axes(left, top, width, THICK)
        bar = self.figure.colorbar(
            ScalarMappable(Normalize(0, largest), colors), cax=axes,
            orientation="horizontal", extend="max" if peak > largest else "neither")
        style(bar.ax.xaxis, exponent, width)
        if peak > ROUNDING * largest:
            words += "," + ("\n" if len(words) > 30 else " ")
            words += f"up to {number(peak / 10.0**exponent)}"
        bar.set_label(label(words, unit, exponent), size=NORMAL, color=TEXT,
                      labelpad=2)


def style(axis, exponent, length):
    """Ticks of an axis with numbers over a power of ten, as many as fit."""
    axis.set_major_locator(MaxNLocator(max(1, min(6, int(length / 0.42))),
                                       steps=[1, 2, 5, 10]))
    axis.set_major_formatter(FuncFormatter(
        lambda value, _: number(value / 10.0**exponent)))
    axis.set_tick_params(labelsize=SMALL, labelcolor=TEXT, length=3, pad=2)


def draw(run, panels, body_picture):
    """The whole picture.

    body_picture: function of a width and a height in inches that returns what
    body.picture() does.
    """
    shown = sorted(range(len(panels)), reverse=True,
                   key=lambda i: run.scale.force[panels[i].boundary])[:MOST]
    slots = [Slot(panels[i], run.scale.peak, None if run.time is None else
                  run.scale.friction[panels[i].boundary]) for i in sorted(shown)]
    body_height = min(max(5, slots[0].height), 6.5)
    tops = {RIGHT: HEADER, LEFT: HEADER + body_height + GAP}
    places = []
    for slot in slots:  # to the right of the body, then below it as well
        column = min(tops, key=tops.get)
        places.append((column, tops[column]))
        tops[column] += slot.height
    below = LEFT in {column for column, _ in places}
    page = Page(max(tops.values() if below else
                    (tops[RIGHT], HEADER + body_height)) + MARGIN)
    draw_header(page, run)
    draw_body(page, run, body_picture, body_height)
    names = names_of(run)
    for slot, place in zip(slots, places):
        draw_slot(page, slot, place, names[slot.panel.boundary], run)
    more = len(panels) - MOST
    if more > 0:
        page.text(RIGHT, page.height - MARGIN, f"not drawn: {more} more map{'s' * (more > 1)}",
                  SMALL)
    return page.figure


def names_of(run):
    """What the contact boundaries are called, by their ids, and what else is said of them:
    of a section 'Contact pair NAME' this NAME, and the boundary."""
    def name_of(entry):
        boundary = entry["name"]
        pair = entry.get("pair")
        return (f"Contact pair {pair}", [boundary]) if pair else boundary_name(boundary)

    def boundary_name(name):
        return f"Contact boundary {name}", []

    ids = sorted(set(run.contact.boundary.tolist()))
    said = run.summary["contact"]["boundaries"]
    if len(ids) == len(said) == 1:
        return {ids[0]: name_of(said[0])}
    named = {entry["id"]: name_of(entry) for entry in said if "id" in entry}
    return {i: named.get(i, boundary_name(i)) for i in ids}


def draw_header(page, run):
    """Title and the numbers that matter."""
    page.text(LEFT, 0.16, plain(run.name), LARGE, fontweight="bold")
    if not run.certified:
        page.text(RIGHT, 0.16, "NOT CERTIFIED", LARGE, fontweight="bold",
                  color=RED)
    if run.time is not None:
        page.text(LEFT, 0.53, f"t = {number(run.time)}")
        return
    page.text(LEFT, 0.53, headline.numbers(run))


def draw_body(page, run, body_picture, height):
    """The body in its column, with a colour bar and the directions below."""
    left, width = LEFT, BODY
    room = height - TITLE - BAR - 0.3
    body = body_picture(width, room)
    words = (f"displacement {body.factor:.0f} times as large"
             if body.factor > 1 else "released" if run.released
             else "displacement true to scale" if body.factor == 1
             else "displacement not drawn, up to " + quantity(
                 run.units["length"], run.scale.displacement))
    if body.factor:
        words += ", lines: before loading"
    if body.obstacle is not None:
        words += f", grey: obstacle{body.obstacle}"
    title = "Bodies" if run.n_bodies > 1 else "Body"
    page.text(left, HEADER, f"Deformed {title.lower()}" if body.factor else title,
              fontweight="bold")
    page.text(left, HEADER + 0.2, words, SMALL)
    rows, columns = body.image.shape[:2]
    scale = min(width / columns, room / rows)
    axes = page.axes(left + (width - scale * columns) / 2,
                     HEADER + TITLE + 0.1 + (room - scale * rows) / 2,
                     scale * columns, scale * rows)
    axes.imshow(body.image, aspect="auto", interpolation="antialiased")
    axes.set_axis_off()
    top = HEADER + TITLE + room + 0.25
    draw_directions(page, body.axes, left, top - 0.1)
    page.color_bar(left + 1.2, top, width - 1.4, STRESS, body.highest,
                   "von Mises stress, averaged at nodes", run.units["stress"])


def draw_directions(page, directions, left, top):
    """Arrows along x, y and z as they are in the picture of the body."""
    axes = page.axes(left, top, 0.8, 0.8)
    axes.set(xlim=(-1.5, 1.5), ylim=(-1.5, 1.5))
    axes.set_axis_off()
    # two that come out over one another still have to be told apart
    for name, (x, y) in zip("xyz", directions):
        axes.annotate("", (x, y), (0, 0), annotation_clip=False,
                      arrowprops={"arrowstyle": "-|>", "color": TEXT,
                                  "shrinkA": 0, "shrinkB": 0})
        axes.text(*(np.array([x, y]) * (1 + 0.35 / math.hypot(x, y))), name, size=NORMAL, color=TEXT,
                  ha="center", va="center")


def draw_slot(page, slot, place, names, run):
    """Title, legend and both maps of a contact panel, from a place on."""
    (left, top), (width, height), units = place, slot.size, run.units
    title, seen = slot.title(*names)
    page.text(left, top, title, fontweight="bold")
    page.text(left, top + 0.2, seen, SMALL)
    draw_legend(page, slot, left, top + TITLE + 0.1)
    top += TITLE + slot.legend
    inset = TICKS + (slot.column - width) / 2
    status = page.axes(left + inset, top + slot.reach, width, height)
    draw_status(status, slot.panel)
    frame(status, slot, units["length"])
    draw_arrows(page, status, slot, (left + TICKS, top + slot.map_height),
                units["stress"])
    if slot.stacked:
        top += slot.map_height + KEY
    else:
        left += COLUMN + BETWEEN
    pressure = page.axes(left + inset, top + slot.reach, width, height)
    largest = contact_panels.end_of_colors(run.scale.pressure, slot.panel.boundary)
    draw_pressure(pressure, slot.panel, largest)
    frame(pressure, slot, units["length"], upwards=slot.stacked)
    words = "pressure" if run.certified else "pressure, not certified"
    if contact_panels.has_tension(slot.panel):
        words += ", green: tension"
    peak = slot.panel.pressure.max()
    # above the picture is the largest of all, and the scale may end with it
    is_said = run.time is None and largest == run.scale.peak == peak
    page.color_bar(left + TICKS, top + slot.map_height + 0.02, COLUMN, PRESSURE,
                   largest, words, units["stress"], 0 if is_said else peak)


def draw_legend(page, slot, left, top):
    """The colours of the status with the numbers of nodes."""
    patches = []
    for kind, count in slot.counts.items():
        name, color, hatch, lines = KINDS[kind]
        patches.append(Patch(facecolor=color, hatch=hatch, linewidth=0.4,
                             edgecolor=lines or TEXT, label=f"{name} {count}"))
    page.figure.legend(handles=patches, loc="upper left", ncol=slot.columns,
                       borderpad=0,
                       bbox_to_anchor=(left / WIDTH, 1 - top / page.height),
                       frameon=False, fontsize=SMALL, columnspacing=1.2,
                       handlelength=1.4, handletextpad=0.5, borderaxespad=0,
                       labelcolor=TEXT)


def frame(axes, slot, unit, upwards=True):
    """Limits, ticks and names of the axes of a map."""
    low, high = slot.panel.window
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    for name, side in axes.spines.items():
        side.set_visible(slot.reach > 0 and name in ("left", "bottom"))
        side.set_position(("outward", 72 * slot.reach))
    for c, axis in enumerate((axes.xaxis, axes.yaxis)):
        exponent = exponent_of(max(abs(low[c]), abs(high[c])))
        style(axis, exponent, slot.size[c])
        axis.set_label_text(label(slot.panel.axes[c], unit, exponent),
                            size=SMALL, color=TEXT)
        axis.labelpad = 3
    if slot.size[1] < 0.9:  # too flat for a name along the axis
        axes.yaxis.label.set(text=axes.get_ylabel().replace(" [", "\n["),
                             rotation=0, ha="right", va="center")
    if not upwards:
        axes.set_ylabel("")
        axes.set_yticklabels([])
    if slot.panel.enlarged:
        axes.add_artist(Rectangle((0, 0), 1, 1, transform=axes.transAxes,
                                  clip_on=False, fill=False, edgecolor=TEXT,
                                  linewidth=0.8))


def polygons(places):
    """One path of many quadrilaterals, all the same way round."""
    across, along = places[:, 2] - places[:, 0], places[:, 3] - places[:, 1]
    turned = across[:, 0] * along[:, 1] < across[:, 1] * along[:, 0]
    places = places.copy()
    places[turned] = places[turned][:, ::-1]
    vertices = np.concatenate([places, places[:, :1]], axis=1)
    codes = [Path.MOVETO] + 3 * [Path.LINETO] + [Path.CLOSEPOLY]
    return Path(vertices.reshape(-1, 2), np.tile(codes, len(places)))


def draw_outline(axes, panel):
    """A line around the boundary: what is drawn next covers its inner half."""
    axes.add_artist(PathPatch(polygons(panel.places[panel.shown]),
                              facecolor=TEXT, edgecolor=TEXT, linewidth=1.6,
                              clip_on=panel.enlarged))


def draw_status(axes, panel):
    """Every node colours the part of the faces that is nearest to it."""
    draw_outline(axes, panel)
    for kind, (_, color, hatch, lines) in KINDS.items():
        parts = contact_panels.quarters(panel, kind)
        if len(parts):
            axes.add_artist(PathPatch(polygons(parts), facecolor=color,
                                      linewidth=0, hatch=hatch,
                                      edgecolor=lines))


def draw_pressure(axes, panel, largest):
    """The pressure, bilinear on each face."""
    draw_outline(axes, panel)
    pieces = int(np.clip(math.sqrt(30000 / panel.shown.sum()), 1, 8))
    places, values = contact_panels.subdivided(panel, pieces)
    if not contact_panels.has_tension(panel):
        values = np.maximum(values, 0)  # rounding, or what one mesh passes to another
    ids = np.arange(values.size).reshape(values.shape)
    quads = [ids[:, :-1, :-1], ids[:, 1:, :-1], ids[:, 1:, 1:], ids[:, :-1, 1:]]
    triangles = [np.stack([quads[i] for i in corners], axis=-1).reshape(-1, 3)
                 for corners in ((0, 1, 2), (0, 2, 3))]
    axes.tripcolor(*places.reshape(-1, 2).T, values.reshape(-1),
                   triangles=np.concatenate(triangles), shading="gouraud",
                   cmap=PRESSURE, vmin=0, vmax=largest or 1)


def draw_arrows(page, axes, slot, corner, unit):
    """Arrows of friction, and what one of them is worth at a corner."""
    left, top = corner
    if slot.usual == 0:
        touches = contact_panels.loaded(slot.panel).any()
        page.text(left, top, "no friction" if touches else "nothing touches",
                  SMALL)
        return
    quiver = axes.quiver(*slot.places.T, *slot.friction.T, scale=slot.per_inch,
                         scale_units="inches", units="inches", width=0.012,
                         color=TEXT, headwidth=4.5, headlength=5,
                         headaxislength=4.5, minlength=0.5, clip_on=False)
    key = float(f"{slot.usual:.0e}")
    what = "shear" if (slot.panel.kind == contact_panels.TIED).any() else "friction"
    axes.quiverkey(quiver, (left + key / slot.per_inch / 2) / WIDTH,
                   1 - (top + 0.08) / page.height, key,
                   quantity(unit, key) + f" of {what} on the body",
                   coordinates="figure", labelpos="E", labelcolor=TEXT,
                   labelsep=0.08, fontproperties={"size": SMALL})
