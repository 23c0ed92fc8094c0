"""The room of one contact boundary on the page, in inches."""

import math

import numpy as np

from . import panels as contact_panels
from .words import ROUNDING, plain

ROOM = 6.05  # the width of a column of the page
COLUMN, TICKS = 2.55, 0.62  # of maps side by side
TITLE, LEGEND, AXIS, KEY, BAR, GAP = 0.38, 0.34, 0.52, 0.3, 0.62, 0.2
LEGEND_ROW = 0.17  # the second row of a legend and those after it
FRAME_ROWS = 2  # of the legends of frames, where kinds come and go
STRETCH = 16  # the largest ratio of the sides of a map
LONGEST_TITLE = 40  # letters, then it is cut


class Slot:
    """The room of one contact panel: two maps, side by side or stacked."""

    def __init__(self, panel, peak, friction=None):
        self.panel, self.of_frames = panel, friction
        self.counts = contact_panels.counts(panel)
        # four to a row, or three where there are long names
        self.columns = 4 if len(self.counts) <= 4 else 3
        rows = max(math.ceil(len(self.counts) / self.columns),
                   1 if friction is None else FRAME_ROWS)
        self.legend = LEGEND + LEGEND_ROW * (rows - 1)
        low, high = panel.window
        ratio = (high[0] - low[0]) / (high[1] - low[1])
        shown = min(max(ratio, 1 / STRETCH), STRETCH)
        self.stretched = shown != ratio
        whole = ROOM - TICKS - 0.2
        beside, below = min(COLUMN, 4.2 * shown), min(whole, 2.4 * shown)
        self.stacked = below > 1.35 * beside and ratio > 1
        width, self.column = (below, whole) if self.stacked \
            else (beside, COLUMN)
        self.size = np.array([width, width / shown])
        self.choose_arrows(peak)
        self.size *= min(1, (self.column - 2 * self.reach) / width)
        if self.usual:
            self.shorten_arrows()
        self.map_height = self.size[1] + 2 * self.reach + AXIS
        self.height = TITLE + self.legend + self.map_height + BAR + GAP
        if self.stacked:
            self.height += self.map_height + KEY

    def choose_arrows(self, peak):
        """Arrows, friction an inch, and how far they reach out of the map.

        peak: the largest pressure anywhere, beside which friction may be rounding. Of
        frames they are those of the usual and the largest friction in any of them.
        """
        low, high = self.panel.window
        scale = self.size / (high - low)
        self.places, self.friction, distance = contact_panels.some_arrows(
            self.panel, scale, 0.16)
        self.reach, sizes = 0, np.linalg.norm(self.friction, axis=1)
        self.usual = np.percentile(sizes, 95) if len(sizes) else 0
        largest = sizes.max() if len(sizes) else 0
        if self.of_frames is not None:
            distance, (self.usual, largest) = 0.25, self.of_frames
        if self.usual <= ROUNDING * peak:
            self.usual = 0
            return
        self.per_inch = max(self.usual / min(1.2 * distance, 0.4), largest / 0.6)
        reach = largest / self.per_inch
        if not len(sizes):
            self.usual = 0
        elif self.of_frames is None:
            self.shorten_arrows()
            tips = (self.places - low) * scale + self.friction / self.per_inch
            reach = max(-tips.min(), (tips - self.size).max())
        self.reach = reach if reach > 0.05 else 0

    def shorten_arrows(self):
        """No arrow is higher or wider than the map."""
        self.per_inch = max(self.per_inch,
                            (np.abs(self.friction).max(axis=0) / self.size).max())

    def title(self, name, parts):
        """What is seen."""
        parts = [*map(plain, parts), self.panel.seen]
        if self.panel.enlarged:
            parts.append("only where forces act")
        if self.stretched:
            parts.append("sides not to scale")
        if len(name) > LONGEST_TITLE:
            name = name[:LONGEST_TITLE - 1] + "…"
        return plain(name), ", ".join(parts)
