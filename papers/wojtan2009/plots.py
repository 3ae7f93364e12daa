"""Orders of convergence, fitted, and the plots, drawn by gnuplot from scripts that stay beside them."""

import csv
import math
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
from tables import number, write  # noqa: E402

STYLE = """set terminal pngcairo size 1500,560 font 'DejaVu Sans,11' background '#fbfbfc'
set logscale xy
set format x '%.3g'
set format y '10^{%T}'
set grid lc rgb '#d8d8dd'
set border lc rgb '#606068'
set key outside below center horizontal maxcols 3 font ',9'
"""
COLOURS = {"mesh": "#c44e2f", "markers": "#404048", "mesh_without_topology": "#e39a6f",
           "level_set": "#1f6fb4", "level_set_mac_cormack": "#5aa9d6",
           "particle_level_set": "#2a8c4a", "particle_level_set_weno": "#86c98f", "semi_lagrangian_contouring": "#8a5bb0"}
# What is varied, the column it is in, the error that is plotted, what the axes say.
PANELS = (("cell", "cell_size", "mean_distance", "cell size", "mean distance at T"),
          ("edge", "edge", "mean_distance", "edge length", "mean distance at T/2"),
          ("step", "time_step", "mean_distance", "time step", "mean distance at T"),
          ("turn", "time_step", "marker_max", "time step (Zalesak)", "largest marker error"))


def rows_in(path):
    with open(path, newline="") as text:
        return list(csv.DictReader(text))


def points(rows, panel):
    """(x, error) by method, at the time that the panel is about."""
    kind, x_column, error, _, caption = panel
    mine = [r for r in rows if r["run"].split(".")[0] == kind and r["outcome"] in ("done", "refused")]
    times = sorted({number(r, "time") for r in mine})
    if not times:
        return {}
    time = times[0] if "T/2" in caption else times[-1]
    lines = {}
    for r in mine:
        x = float(r["run"].split(".", 2)[2]) if x_column == "edge" else number(r, x_column)
        y = number(r, error)
        if abs(number(r, "time") - time) < 1e-3 * time and y > 0 and x > 0:
            lines.setdefault(r["run"].split(".")[1], []).append((x, y))
    return {method: sorted(line) for method, line in lines.items()}


def order(line):
    """The slope of the least squares line through the logarithms; nothing for fewer than three."""
    if len(line) < 3:
        return float("nan")
    xs, ys = [math.log(x) for x, _ in line], [math.log(y) for _, y in line]
    mx, my = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - mx) * (y - my) for x, y in zip(xs, ys)) / sum((x - mx) ** 2 for x in xs)


def data_block(name, line):
    return f"${name} << END\n" + "".join(f"{x:.10g} {y:.10g}\n" for x, y in line) + "END\n"


def convergence(rows):
    out, blocks, page = [], [], []
    for i, panel in enumerate(PANELS):
        lines = points(rows, panel)
        if not lines:
            continue
        plots = []
        for method, line in lines.items():
            name = f"d{i}_{method}"
            blocks.append(data_block(name, line))
            p = order(line)
            slope = "" if math.isnan(p) else f", order {p:.2f}"
            plots.append(f"${name} using 1:2 with linespoints pt 7 ps 1.1 lw 2 lc rgb "
                         f"'{COLOURS.get(method, '#000000')}' title '{method.replace('_', ' ')}{slope}'")
            page.append((panel, method, line, p))
        floor = floor_of(rows, panel)
        if floor > 0:
            plots.append(f"{floor:.6g} with lines dt 2 lw 1.5 lc rgb '#404048' title "
                         "'RK4 markers on a fixed mesh'")
        out.append(f"set xlabel '{panel[3]}'\nset ylabel '{panel[4]}'\nplot " + ", \\\n  ".join(plots))
    count = max(1, len(out))
    script = STYLE.replace("1500", str(500 * count)) + "set output 'convergence.png'\n" + "".join(blocks)
    script += f"set multiplot layout 1,{count}\n" + "\n".join(out) + "\nunset multiplot\n"
    return script, page


def floor_of(rows, panel):
    """What the finest run of markers on a mesh that never changes gives, where others are plotted."""
    if panel[0] != "cell":
        return 0
    line = points(rows, ("step", "time_step", panel[2], "", panel[4])).get("markers", [])
    return min((y for _, y in line), default=0)


def orders_page(page):
    out = ["# Orders of convergence", "", "Slopes of least-squares lines through the logarithms of what "
           "`convergence.csv` has.", "", "| varied | error | method | values | errors | order |",
           "|---|---|---|---|---|--:|"]
    for panel, method, line, p in page:
        xs = ", ".join(f"{x:.4g}" for x, _ in line)
        ys = ", ".join(f"{y:.3g}" for _, y in line)
        out.append(f"| {panel[3]} | {panel[4]} | {method} | {xs} | {ys} | "
                   f"{'–' if math.isnan(p) else f'{p:.2f}'} |")
    return "\n".join(out) + "\n"


def error_bars(zalesak, enright):
    """Volume error and mean distance of every method at each resolution, as points."""
    blocks, plots = [], {"volume_error": [], "mean_distance": []}
    for test, rows in (("zalesak", zalesak), ("enright", enright)):
        times = sorted({number(r, "time") for r in rows if r["run"].startswith(test + ".")})
        if not times:
            continue
        time = 628.0 if test == "zalesak" else times[-1]
        for method, colour in COLOURS.items():
            for error in plots:
                line = sorted((number(r, "resolution"), abs(number(r, error))) for r in rows
                              if r["run"].startswith(f"{test}.{method}.")
                              and not r["run"].endswith("polyhedron")
                              and abs(number(r, "time") - time) < 1e-3 * time
                              and abs(number(r, error)) > 0)
                if not line:
                    continue
                name = f"{test}_{method}_{error}"
                blocks.append(data_block(name, line))
                mark, title = ("5", "Zalesak") if test == "zalesak" else ("9", "Enright")
                plots[error].append(f"${name} using 1:2 with linespoints pt {mark} ps 1.3 lw 1.5 lc rgb "
                                    f"'{colour}' title '{method.replace('_', ' ')}, {title}'")
    script = STYLE.replace("1500", "1300").replace("size 1300,560", "size 1300,700") + \
        "set output 'error.png'\nset xlabel 'cells along the domain'\n"
    script += "".join(blocks) + "set multiplot layout 1,2\n"
    for error, caption in (("volume_error", "relative volume error, after a turn or at T"),
                           ("mean_distance", "mean distance, after a turn or at T, in the test''s unit")):
        if plots[error]:
            script += f"set ylabel '{caption}'\nplot " + ", \\\n  ".join(plots[error]) + "\n"
    return script + "unset multiplot\n"


def draw(folder, name, script):
    write(folder / f"{name}.gp", script)
    subprocess.run(["gnuplot", f"{name}.gp"], cwd=folder, check=True)


def main():
    folder = pathlib.Path(sys.argv[1])
    script, page = convergence(rows_in(folder / "convergence.csv"))
    draw(folder, "convergence", script)
    draw(folder, "error", error_bars(rows_in(folder / "zalesak.csv"), rows_in(folder / "enright.csv")))
    write(folder / "orders.md", orders_page(page))


if __name__ == "__main__":
    main()
