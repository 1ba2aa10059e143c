# SPDX-License-Identifier: MIT
"""Pictures with logarithmic axes, drawn by gnuplot: one or more panels in a grid."""
import dataclasses
import math
import subprocess

PANEL_WIDTH, PANEL_HEIGHT = 600, 460 # pixels
KEY_WIDTH = 170 # where the key stands beside the panel
# Told apart by people who see colours differently (Okabe, Ito), and by their marks.
COLORS = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#777777", "#8C6D31", "#F0A3FF")
MARKS = (7, 5, 9, 13, 11, 4, 6, 8)
HEAVY_COLORS = ("#000000", "#B00000", "#5A189A")

STYLE = """set terminal pngcairo size {width},{height} font "DejaVu Sans,11" background "#ffffff"
set output "{path}"
set logscale xy
set format x "{xformat}"
set format y "%g"
set border 3 lc rgb "#555555"
set tics nomirror out tc rgb "#333333"
set mxtics 10
set mytics 10
set grid xtics ytics lt 1 lw 1 lc rgb "#c8c8c8"
set key {key} reverse Left samplen 2 spacing 1.15 font ",10"
set lmargin 10
set rmargin {rmargin}
set tmargin 3
set bmargin 4
"""


@dataclasses.dataclass
class Series:
    label: str
    points: list # (x, y, low, high) or (x, y)
    color: int = 0 # of COLORS and MARKS
    dashed: bool = False
    bare: bool = False # a curve, without marks
    heavy: bool = False # what the picture is about


@dataclasses.dataclass
class Panel:
    title: str
    xlabel: str
    ylabel: str
    series: list


def quoted(text):
    """Text for gnuplot, whose enhanced mode gives these characters a meaning; n^{1.2} is meant so."""
    for char in "\\_@&~":
        text = text.replace(char, "\\" + char)
    return '"' + text.replace('"', "'").replace("\\", "\\\\") + '"'


def around(values):
    """A range around the values whose ends are 1, 2 or 5 times a power of ten, and in which two powers are: they have labels."""
    steps = [float(f"{step}e{power}") for power in range(-12, 15) for step in (1, 2, 5)]
    low = max(step for step in steps if step <= min(values) * (1 + 1e-9))
    high = min(step for step in steps if step >= max(values) * (1 - 1e-9))
    if math.floor(math.log10(high) + 1e-9) - math.ceil(math.log10(low) - 1e-9) < 1:
        low = 10.0 ** math.floor(math.log10(low) + 1e-9)
        high = max(10.0 ** math.ceil(math.log10(high) - 1e-9), 10 * low)
    return low, high


def ranges(points, lines):
    """Ranges of both axes, with room for a key of so many lines in the upper left, should something be there."""
    left, right = around([point[0] for point in points])
    low, high = around([value for point in points for value in point[1:]])
    share = 0.1 + 0.05 * lines if lines else 0 # of the height that the key takes
    in_the_way = max([max(point[1:]) for point in points if math.log(point[0] / left) < 0.45 * math.log(right / left)], default=low)
    if math.log(in_the_way / low) > (1 - share) * math.log(high / low):
        high = low * (in_the_way / low) ** (1 / (1 - share))
    return f"set xrange [{left:g}:{right:g}]", f"set yrange [{low:g}:{high:g}]"


def data_block(name, series):
    lines = [" ".join(f"{value:.9g}" for value in (point if len(point) == 4 else (*point, point[1], point[1]))) for point in series.points]
    return "\n".join([f"${name} << EOD", *lines, "EOD"])


def plot_terms(name, series):
    colors = HEAVY_COLORS if series.heavy else COLORS
    color, mark = colors[series.color % len(colors)], MARKS[series.color % len(MARKS)]
    line = f'lc rgb "{color}" lw {3.5 if series.heavy else 2}{" dt 2" if series.dashed else ""}'
    if series.bare:
        return [f"${name} using 1:2 with lines {line} title {quoted(series.label)}"]
    return [f'${name} using 1:2:3:4 with yerrorbars lc rgb "{color}" lw 1 pt -1 notitle',
            f"${name} using 1:2 with linespoints {line} pt {mark} ps 1 title {quoted(series.label)}"]


def panel_script(number, panel, key):
    drawn = [series for series in panel.series if series.points]
    if not drawn:
        return "set multiplot next\n"
    blocks, terms = [], []
    for i, series in enumerate(drawn):
        blocks.append(data_block(f"d{number}x{i}", series))
        terms += plot_terms(f"d{number}x{i}", series)
    points = [point for series in drawn for point in series.points]
    return "\n".join(blocks + [f"set title {quoted(panel.title)} font \",13\"", f"set xlabel {quoted(panel.xlabel)}",
                               f"set ylabel {quoted(panel.ylabel)}", *ranges(points, len(drawn) if key == "top left" else 0),
                               "plot " + ", \\\n  ".join(terms)])


def draw(path, panels, columns, key="top left", xformat="10^{%L}"):
    """Write a PNG of the panels that have points; nothing when none has. A key that is "outside" stands to the right of each panel."""
    panels = [panel for panel in panels if any(series.points for series in panel.series)]
    if not panels:
        return False
    columns = min(columns, len(panels))
    rows = -(-len(panels) // columns)
    beside = KEY_WIDTH if key == "outside" else 0
    script = STYLE.format(width=columns * (PANEL_WIDTH + beside), height=rows * PANEL_HEIGHT, path=path, key=key, xformat=xformat,
                          rmargin=25 if beside else 3)
    script += f"set multiplot layout {rows},{columns}\n"
    script += "\n".join(panel_script(i, panel, key) for i, panel in enumerate(panels))
    script += "\nunset multiplot\n"
    done = subprocess.run(["gnuplot"], input=script, capture_output=True, text=True)
    if done.returncode != 0 or "line " in done.stderr:
        raise SystemExit(f"bench: gnuplot: {done.stderr}")
    return True


def exponent(points):
    """The slope of a straight line through the logarithms; None for fewer than three points."""
    if len(points) < 3:
        return None
    xs, ys = [math.log(point[0]) for point in points], [math.log(point[1]) for point in points]
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) / sum((x - mean_x) ** 2 for x in xs)
