#!/usr/bin/python3
"""The plots of papers/results/fluid_validation.csv, drawn by gnuplot from a script that stays beside them in
out/fluid: the dam's front with the experiment's points, how drops swing, how shear decays."""

import csv
import math
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
from references import martin_moyce  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COLOURS = ("#c44e2f", "#1f6fb4", "#2a8c4a", "#8a5bb0", "#e39a6f")
STYLE = """set terminal pngcairo size 1650,600 font 'DejaVu Sans,11' background '#fbfbfc'
set grid lc rgb '#d8d8dd'
set border lc rgb '#606068'
set key outside below center horizontal maxcols 2 font ',9'
"""


def rows_of(path):
    with open(path, newline="") as text:
        return list(csv.DictReader(text))


def lines_of(rows, case):
    """By resolution: time, measured, exact."""
    lines = {}
    for r in rows:
        if r["case"] == case:
            lines.setdefault(float(r["resolution"]), []).append(
                (float(r["time"]), float(r["measured"]), float(r["exact"])))
    return sorted(lines.items())


def block(name, line):
    return f"${name} << END\n" + "".join(" ".join(f"{x:.8g}" for x in point) + "\n" for point in line) + "END\n"


def value(rows, case, resolution, column):
    return next((float(r[column]) for r in rows if r["case"] == case and float(r["resolution"]) == resolution), math.nan)


def panel(title, x, y, plots, extra=""):
    return f"set title '{title}'\nset xlabel '{x}'\nset ylabel '{y}'\n{extra}plot " + ", \\\n  ".join(plots) + "\n"


def dam(rows):
    blocks, plots = "", []
    for n2, mark in ((1, 6), (2, 4)):
        name = f"experiment{n2}"
        blocks += block(name, list(zip(*martin_moyce(n2, "Z"))))
        plots.append(f"${name} with points pt {mark} ps 1.4 lw 1.5 lc rgb '#404048' title "
                     f"'Martin and Moyce, n² = {n2}'")
        for i, (cells, line) in enumerate(lines_of(rows, f"dam.{n2}")):
            name = f"dam{n2}_{i}"
            blocks += block(name, line)
            plots.append(f"${name} with lines lw 2 dt {3 - n2} lc rgb '{COLOURS[i]}' title "
                         f"'n² = {n2}, {cells:g} cells a width'")
    return blocks, panel("The front of a column of water", "T = n·t·√(g/a)", "Z = x/a", plots,
                         "set key inside top left vertical maxcols 1\n")


def drop(rows):
    blocks, plots = "", ["cos(2*pi*x) with lines lw 1.5 dt 2 lc rgb '#404048' title 'Lamb'"]
    for i, (radius, line) in enumerate(lines_of(rows, "drop_bend")):
        blocks += block(f"drop{i}", line)
        error = value(rows, "drop_period", radius, "error")
        plots.append(f"$drop{i} with linespoints pt 7 ps 0.5 lw 2 lc rgb '{COLOURS[i]}' title "
                     f"'{radius:g} cells a radius" + ("'" if math.isnan(error) else f": period {100 * error:+.1f} %'"))
    return blocks, panel("The second mode of a drop", "time over Lamb''s period", "amplitude", plots,
                         "set key outside below horizontal maxcols 2\n")


def shear(rows):
    blocks, plots = "", ["exp(-x) with lines lw 1.5 dt 2 lc rgb '#404048' title 'exact'"]
    for i, (cells, line) in enumerate(lines_of(rows, "shear_amplitude")):
        start, whole, _ = line[0]  # of which interpolation takes a part that is the same ever after
        blocks += block(f"shear{i}", [(time - start, measured / whole) for time, measured, _ in line])
        error = value(rows, "shear_rate", cells, "error")
        plots.append(f"$shear{i} with linespoints pt 7 ps 0.8 lw 2 lc rgb '{COLOURS[i]}' title "
                     f"'{cells:g} cells a radius: rate {100 * error:+.1f} %'")
    return blocks, panel("A twisted ball slows by viscosity", "time × νk²", "amplitude", plots,
                         "set xrange [0:0.85]\n")


def main():
    rows = rows_of(ROOT / "papers/results/fluid_validation.csv")
    folder = ROOT / "out/fluid"
    folder.mkdir(parents=True, exist_ok=True)
    parts = [make(rows) for make in (dam, drop, shear)]
    picture = HERE / "validation.png"
    script = STYLE + f"set output '{picture}'\n" + "".join(blocks for blocks, _ in parts)
    script += "set multiplot layout 1,3\n" + "".join(plot for _, plot in parts) + "unset multiplot\n"
    (folder / "validation.gp").write_text(script)
    subprocess.run(["gnuplot", "validation.gp"], cwd=folder, check=True)


if __name__ == "__main__":
    main()
