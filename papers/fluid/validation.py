#!/usr/bin/python3
"""The plots of papers/results/fluid_validation.csv, drawn by gnuplot from a script that stays beside them in
out/fluid: a panel for each thing that the fluid is measured against. validation.md says what they show."""

import csv
import math
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
from references import martin_moyce  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COLOURS = ("#c44e2f", "#1f6fb4", "#2a8c4a", "#8a5bb0", "#b8860b", "#3aa6a6", "#a03060", "#606068")
EXACT = "lw 2 dt 2 lc rgb '#202028'"
STYLE = """set terminal pngcairo size 2000,1640 font 'DejaVu Sans,12' background '#fbfbfc'
set grid lc rgb '#d8d8dd'
set border lc rgb '#606068'
set tmargin 2.5
set lmargin 10
set rmargin 2
"""
RESET = """set bmargin 3.8
unset logscale
set xrange [*:*]
set yrange [*:*]
set format '%g'
set xtics auto
set key inside top right vertical maxrows 8 maxcols 2 Left reverse samplen 2 spacing 1 width 0 font ',10'
"""
POWERS = "set format x '10^{%L}'\nset format y '10^{%L}'\n"


class Rows:
    """The file's rows: case, resolution, time, measured, exact, error."""

    def __init__(self, path):
        with open(path, newline="") as text:
            self.all = [{k: v if k == "case" else float(v) for k, v in r.items()} for r in csv.DictReader(text)]

    def of(self, case):
        return [r for r in self.all if r["case"] == case]

    def lines(self, case, x="time", y="measured"):
        """By resolution: the points (x, y)."""
        lines = {}
        for r in self.of(case):
            lines.setdefault(r["resolution"], []).append((r[x], r[y]))
        return sorted(lines.items())

    def line(self, case, x="resolution", y="error"):
        return [(r[x], r[y]) for r in self.of(case)]


class Panel:
    count = 0

    def __init__(self, title, x, y, key, extra=""):
        extra += f"set key {key}\n"
        self.head = f"set title '{title}'\nset xlabel '{x}'\nset ylabel '{y}'\n{extra}"
        self.blocks, self.plots, self.used = "", [], 0
        Panel.count += 1
        self.name = f"p{Panel.count}"

    def points(self, points, title, style="linespoints", colour=None, mark=7, size=0.6, dash=1):
        if not points:
            return
        colour = COLOURS[self.used % len(COLOURS)] if colour is None else colour
        self.used += 1
        name = f"{self.name}_{len(self.plots)}"
        self.blocks += f"${name} << END\n" + "".join(" ".join(f"{v:.8g}" for v in p) + "\n" for p in points) + "END\n"
        dots = f"pt {mark} ps {size} " if "points" in style else ""
        dashes = f"dt {dash} " if "lines" in style else ""
        self.plots.append(f"${name} with {style} {dots}{dashes}lw 1.8 lc rgb '{colour}' "
                          + (f"title '{title}'" if title else "notitle"))

    def formula(self, text, title, style=EXACT):
        self.plots.append(f"{text} with lines {style} " + (f"title '{title}'" if title else "notitle"))

    def script(self):
        return RESET + self.head + "plot " + ", \\\n  ".join(self.plots) + "\n"


def sizes(points):
    return [(x, abs(y)) for x, y in points if y != 0]


def order(points):
    """Between the two finest."""
    (a, x), (b, y) = sorted(sizes(points))[-2:]
    return math.log(x / y) / math.log(b / a)


def with_order(name, points):
    return f"{name}: order {order(points):.1f}" if len(points) > 1 else name


def percent(x):
    return f"{100 * x:+.1f} %".replace("-", "−")


def still(rows):
    panel = Panel("Still water", "step", "largest velocity over √(gh)", "top right",
                  "set logscale y\nset format y '10^{%L}'\nset yrange [1e-18:1]\n")
    for tolerance, line in reversed(rows.lines("still_velocity")):
        panel.points([(x, y) for x, y in line if y > 0], f"tolerance 10^{{−{-round(math.log10(tolerance))}}}", size=0.3)
    panel.formula("1e-6", "bound")
    return panel


def projection(rows):
    panel = Panel("What a projection leaves", "solver''s tolerance", "largest divergence over that before",
                  "bottom right", "set logscale xy\nset xrange [1e-13:1e-1]\n" + POWERS)
    for cells, line in rows.lines("projection_divergence"):
        panel.points(line, f"{cells:g} cells a radius", style="points", size=1.1)
    panel.formula("x", "the tolerance")
    return panel


def cells_panel(rows):
    panel = Panel("Orders in the size of cells", "cells a side, or a radius", "relative error", "top right",
                  "set logscale xy\nset xrange [4.5:90]\nset yrange [1e-5:100]\nset xtics (6, 8, 12, 16, 24, 32, 64)\n"
                  "set format y '10^{%L}'\n")
    for case, name in (("vortex_error", "vortex, inviscid"), ("vortex_slow_rate", "its decay, slow flow"),
                       ("vortex_rate", "its decay, νT = 0.1"), ("translation_velocity", "twist of a flying ball"),
                       ("fall.2", "fall of a column let go")):
        line = rows.line(case)
        panel.points(sizes(line), with_order(name, line))
    return panel


def steps_panel(rows):
    panel = Panel("Orders in the step, 32 cells a side", "steps", "relative error", "top right",
                  "set logscale xy\nset yrange [1e-4:10]\nset xrange [1.6:80]\nset xtics (2, 4, 8, 16, 32, 64)\n"
                  "set format y '10^{%L}'\n")
    for case, name in (("vortex_steps", "vortex, from the exact"),
                       ("vortex_steps_limit", "vortex, from 128 steps"),
                       ("vortex_slow_rate_steps", "viscous decay, slow flow")):
        line = rows.line(case)
        panel.points(sizes(line), name if case.endswith("limit") else with_order(name, line))
    return panel


def collapse(rows, panel, quantity, case, last):
    """Both columns, of n² = 2 with lines and of 1 with dashes."""
    for n2, mark, name in ((2, 4, ""), (1, 6, ", dashed")):
        panel.points([p for p in zip(*martin_moyce(n2, quantity)) if p[0] < last], f"experiment, n² = {n2}{name}",
                     style="points", colour="#202028", mark=mark, size=1)
        panel.used = 0
        for cells, line in rows.lines(f"{case}.{n2}"):
            panel.points(line, f"{cells:g} cells a width" if n2 == 2 else "", style="lines", dash=3 - n2)
        panel.used = 0
    return panel


def dam_front(rows):
    panel = Panel("The front of a column of water", "T = n·t·√(g/a)", "Z = x/a", "top left", "set yrange [1:6.5]\n")
    return collapse(rows, panel, "Z", "dam", 9)


def dam_height(rows):
    return collapse(rows, Panel("The height that is left at the wall", "τ = t·√(g/a)", "H = height/(n²a)", "top right",
                                "set xrange [0:4.5]\nset yrange [0:1.35]\n"), "H", "dam_height", 4.4)


CAUSES = (("none", "as it is"), ("film", "half a cell thick"), ("uncontrolled", "no volume control"),
          ("short_steps", "a quarter of the step"), ("semi_lagrangian", "semi-Lagrangian"),
          ("tension", "tension of water"),
          ("water", "sticks, ν of water"), ("rubs_3e-4", "sticks, 13 × that"))


def dam_causes(rows):
    panel = Panel("Why the front is ahead, n² = 1, 16 cells", "Z of the experiment", "Z over the experiment''s",
                  "top left maxrows 4", "set yrange [0.98:1.4]\n")
    for case, name in CAUSES:
        line = [(r["exact"], r["measured"] / r["exact"]) for r in rows.of(f"cause_{case}.1")]
        panel.points(line, name, style="lines")
    panel.formula("1", "", EXACT)
    return panel


def drop(rows):
    panel = Panel("The second mode of a drop", "time over Lamb''s period", "amplitude", "bottom left",
                  "set xrange [0:0.85]\nset yrange [-1.7:1.1]\n")
    panel.formula("cos(2*pi*x)", "Lamb 1932")
    lines = rows.lines("drop_bend") + rows.lines("fine_drop_bend")
    for radius, line in lines:
        panel.points(line, f"{radius:g} cells a radius", style="lines")
    return panel


def drop_period(rows):
    panel = Panel("Errors of its period and amplitude", "cells a radius", "relative error", "top right",
                  "set logscale xy\nset xrange [3.5:36]\nset yrange [1e-3:3]\nset xtics (4, 6, 8, 12, 16, 32)\n"
                  "set format y '10^{%L}'\n")
    quarter = rows.line("drop_quarter") + rows.line("fine_drop_quarter")
    panel.points(sizes(quarter), "four times its first quarter", size=1)
    panel.points(sizes(rows.line("drop_period")), "twice from zero to zero", size=1)
    panel.points(sizes(rows.line("drop_turned")), "amplitude lost in half", size=1)
    panel.formula("0.03", "3 %")
    return panel


def currents(rows):
    panel = Panel("Currents round a drop at rest", "cells a radius", "velocity over √(σ/(ρR))", "top right",
                  "set logscale xy\nset yrange [1e-6:1e-2]\nset xrange [3.5:18]\n"
                  "set xtics (4, 6, 8, 12, 16)\nset format y '10^{%L}'\n")
    panel.points(sizes(rows.line("currents_most")), "largest in half a period", size=1)
    panel.points(sizes(rows.line("currents_end")), "at its end", size=1)
    return panel


def shear(rows):
    panel = Panel("A twisted ball slows by viscosity", "time × νk²", "amplitude", "bottom left",
                  "set xrange [0:0.85]\n")
    panel.formula("exp(-x)", "exact")
    for cells, line in rows.lines("shear_amplitude"):
        error = next(r["error"] for r in rows.of("shear_rate") if r["resolution"] == cells)
        panel.points(line, f"{cells:g} cells a radius: rate {percent(error)}")
    return panel


def elastic(rows):
    panel = Panel("A twisted elastic ball swings", "modulus × (time/radius)²/ρ", "period over exact", "bottom right",
                  "set logscale x\nset format x '10^{%L}'\nset yrange [0.98:1.02]\nset xrange [1e-3:1e7]\n")
    panel.formula("1", "exact")
    panel.points([(r["resolution"], r["error"] + 1) for r in rows.of("elastic_modulus")], "6 cells a radius", size=1)
    for r in rows.of("elastic_period"):
        if r["resolution"] > 6:
            name = f"{r['resolution']:g} cells: {percent(r['error'])}"
            panel.points([(1, r["error"] + 1)], name, style="points", size=1.2)
    return panel


def yielding(rows):
    panel = Panel("What yields stays", "largest strain on the way over yield''s", "strain left over yield''s",
                  "top left", "set logscale xy\nset xrange [0.2:20]\nset yrange [1e-3:20]\n")
    panel.formula("x > 1 ? x - 1 : 1/0", "all that is beyond yield")
    for n, (strain, line) in enumerate(rows.lines("yield_left")):
        panel.points(sizes(line), f"yields at {strain:g}", size=1.4 - 0.4 * n, mark=(6, 4, 7)[n % 3])
    return panel


def slosh(rows):
    panel = Panel("A tank sloshes, 16 cells wide", "time × √(g/width)", "volume over that at first",
                  "bottom left", "set yrange [0.5:1.1]\n")
    scale = math.sqrt(10)
    for case, name in (("free", "without volume control"), ("controlled", "with it")):
        line = [(r["time"] * scale, r["measured"] / r["exact"]) for r in rows.of(f"slosh_{case}")]
        panel.points(line, name, size=0.3)
    panel.formula("1", "")
    return panel


def meeting(rows):
    panel = Panel("Two drops meet, 12 cells a radius", "time × speed/radius", "over what it was at first",
                  "bottom left", "set yrange [0.8:1.05]\n")
    size = math.hypot(*(r["exact"] for c in "xyz" for r in rows.of(f"meeting_momentum_{c}_controlled")[:1]))
    for case, name in (("volume", "volume"), ("energy", "kinetic energy")):
        lines = dict(rows.lines(f"meeting_{case}_controlled", y="error"))
        panel.points([(t, 1 + e) for t, e in lines.get(12, [])], name, size=0.4)
    for c in "xyz":
        panel.points([(r["time"], 1 + (r["measured"] - r["exact"]) / size)
                      for r in rows.of(f"meeting_momentum_{c}_controlled") if r["resolution"] == 12],
                     f"1 + error of momentum {c}", size=0.4)
    panel.formula("1", "")
    return panel


def buckling(rows):
    panel = Panel("A thick column under a plate", "shortening over length", "deflection over width", "bottom right",
                  "set logscale y\nset yrange [0.003:10]\n")
    for cells, line in rows.lines("buckling_aside"):
        panel.points(line, f"{cells / 10:g} cells a width", style="lines")
    euler = rows.lines("buckling_aside", y="exact")[:1]
    for _, line in euler:
        panel.points(line, "Euler, slender and slight", style="lines", colour="#202028", dash=2)
    return panel


PANELS = (still, projection, cells_panel, steps_panel, dam_front, dam_height, dam_causes, shear, drop, drop_period,
          currents, elastic, yielding, slosh, meeting, buckling)


def main():
    rows = Rows(ROOT / "papers/results/fluid_validation.csv")
    folder = ROOT / "out/fluid"
    folder.mkdir(parents=True, exist_ok=True)
    panels = [p for p in (make(rows) for make in PANELS) if p.plots]  # a case that has not been run has none
    script = STYLE + f"set output '{HERE / 'validation.png'}'\n" + "".join(p.blocks for p in panels)
    script += "set multiplot layout 4,4\n" + "".join(p.script() for p in panels) + "unset multiplot\n"
    (folder / "validation.gp").write_text(script)
    subprocess.run(["gnuplot", "validation.gp"], cwd=folder, check=True)


if __name__ == "__main__":
    main()
