# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure as SVG, written without other software: axes, points, lines, a legend below the picture.

It follows the colour scheme of the page that shows it (light or dark).
"""
import math
import os
from xml.sax.saxutils import escape

from kinex_results import ResultsError

WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 78, 18, 44, 62
LEGEND_LINE = 20
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00")
STYLE = """text { font: 13px sans-serif; fill: #222; }
.title { font-weight: bold; font-size: 15px; }
.axis { stroke: #222; fill: none; } .grid { stroke: #ddd; fill: none; }
@media (prefers-color-scheme: dark) { .paper { fill: #16181d; } text { fill: #ddd; }
  .axis { stroke: #ddd; } .grid { stroke: #3a3d45; } }"""


def _log_ticks(low, high):
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    ticks = [10.0 ** k for k in range(first, last + 1)]
    if last - first < 3:
        ticks = sorted(ticks + [m * 10.0 ** k for k in range(first, last) for m in (2, 5)])
    return [t for t in ticks if low * 0.999 <= t <= high * 1.001]


def _linear_ticks(low, high):
    raw = (high - low) / 6 or 1
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= raw * 0.999)
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, int(math.floor(high / step + 1e-9)) + 1)]


def number_text(value):
    """Short: 0.25, 1200, 1e+06."""
    if value == 0:
        return "0"
    text = f"{value:.6g}"
    return f"{value:,.0f}".replace(",", "\u2009") if 1 <= abs(value) < 1e7 and value == int(value) else text


class Axis:
    """`log`: all values are positive."""

    def __init__(self, label, log=False):
        self.label, self.log = label, log
        self.low = self.high = None

    def take(self, values):
        for value in values:
            self.low = value if self.low is None else min(self.low, value)
            self.high = value if self.high is None else max(self.high, value)

    def settle(self):
        if self.low is None:
            self.low, self.high = (1.0, 10.0) if self.log else (0.0, 1.0)
        if self.log:
            margin = max((self.high / self.low) ** 0.05, 1.1)
            self.low, self.high = self.low / margin, self.high * margin
        else:
            margin = (self.high - self.low) * 0.05 or 1
            floor = 0 if self.low >= 0 else None  # counts begin at 0
            self.low, self.high = self.low - margin, self.high + margin
            if floor is not None:
                self.low = max(self.low, floor) if self.low + margin > margin else 0
        self.ticks = (_log_ticks if self.log else _linear_ticks)(self.low, self.high)

    def place(self, value):
        """From 0 to 1."""
        if self.log:
            return (math.log(value) - math.log(self.low)) / (math.log(self.high) - math.log(self.low))
        return (value - self.low) / (self.high - self.low)


class Figure:
    """Series are drawn in the order in which they are added."""

    def __init__(self, title, x, y):
        self.title, self.x, self.y = title, x, y
        self.series = []

    def points(self, name, data):
        self._add("points", name, data)

    def line(self, name, data, dashed=False, like=None):
        """`like`: the name of the series whose colour it takes."""
        self._add("dashed" if dashed else "line", name, data, like)

    def steps(self, name, data):
        """A staircase: the value of a point holds from there on."""
        stairs = []
        for x, y in data:
            if stairs:
                stairs.append((x, stairs[-1][1]))
            stairs.append((x, y))
        self._add("line", name, stairs)

    def _add(self, form, name, data, like=None):
        colours = {other: colour for _, other, _, colour in self.series}
        colour = colours.get(like, COLOURS[len(set(colours.values())) % len(COLOURS)])
        self.series.append((form, name, list(data), colour))

    def text(self):
        for _, _, data, _ in self.series:
            self.x.take(x for x, _ in data)
            self.y.take(y for _, y in data)
        self.x.settle()
        self.y.settle()
        height = HEIGHT + LEGEND_LINE * len(self.series)
        out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
               f'height="{height}" role="img"><title>{escape(self.title)}</title><style>{STYLE}</style>',
               f'<rect class="paper" width="{WIDTH}" height="{height}" fill="#fff"/>',
               f'<text class="title" x="{WIDTH / 2}" y="26" text-anchor="middle">{escape(self.title)}</text>']
        self._axes(out)
        for i, one in enumerate(self.series):
            self._draw(out, i, *one)
        return "\n".join(out) + "\n</svg>\n"

    def write(self, path, source, force=False):
        """Refuses to replace `source`, the file that is drawn, and other files unless `force`."""
        if os.path.exists(path) and os.path.samefile(path, source):
            raise ResultsError(f"{path}: it is the input itself; give the figure another name")
        with open(path, "w" if force else "x", encoding="utf-8") as file:
            file.write(self.text())

    def _at(self, x, y):
        return (LEFT + self.x.place(x) * (WIDTH - LEFT - RIGHT),
                HEIGHT - BOTTOM - self.y.place(y) * (HEIGHT - TOP - BOTTOM))

    def _axes(self, out):
        right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
        for tick in self.x.ticks:
            at = LEFT + self.x.place(tick) * (right - LEFT)
            out.append(f'<path class="grid" d="M{at:.1f} {TOP}V{bottom}"/>'
                       f'<text x="{at:.1f}" y="{bottom + 18}" text-anchor="middle">{number_text(tick)}</text>')
        for tick in self.y.ticks:
            at = bottom - self.y.place(tick) * (bottom - TOP)
            out.append(f'<path class="grid" d="M{LEFT} {at:.1f}H{right}"/>'
                       f'<text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">{number_text(tick)}</text>')
        out.append(f'<path class="axis" d="M{LEFT} {TOP}V{bottom}H{right}"/>')
        out.append(f'<text x="{(LEFT + right) / 2}" y="{bottom + 40}" text-anchor="middle">{escape(self.x.label)}</text>')
        middle = (TOP + bottom) / 2
        out.append(f'<text x="16" y="{middle}" text-anchor="middle" '
                   f'transform="rotate(-90 16 {middle})">{escape(self.y.label)}</text>')

    def _draw(self, out, i, form, name, data, colour):
        at = [self._at(x, y) for x, y in data]
        dash = ' stroke-dasharray="6 4"' if form == "dashed" else ""
        if form == "points":
            out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in at]
        elif at:
            path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in at)
            out.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.8"{dash}/>')
        y = HEIGHT - 6 + LEGEND_LINE * i
        if form == "points":
            out.append(f'<circle cx="{LEFT + 14}" cy="{y - 4}" r="3" fill="{colour}"/>')
        else:
            out.append(f'<path d="M{LEFT} {y - 4}h28" stroke="{colour}" stroke-width="1.8"{dash}/>')
        out.append(f'<text x="{LEFT + 36}" y="{y}">{escape(name)}</text>')
