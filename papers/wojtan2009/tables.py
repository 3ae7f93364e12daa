"""Gathers the runs' rows into the tables: CSV by group, and Markdown of what matters in each."""

import csv
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True

GROUPS = {"zalesak": "Zalesak's sphere", "enright": "Enright's test", "others": "Other flows",
          "bodies": "Two bodies", "topology": "Many balls in normal flow",
          "convergence": "Convergence"}
LENGTHS = ("mean_distance", "max_distance", "crease_max", "corner_max", "marker_max")
COLUMNS = {  # of the page, for each group
    "zalesak": ("run", "time", "outcome", "triangles", "volume_error", "volume_drift",
                "symmetric_difference", "mean_distance", "max_distance", "crease_max", "corner_max",
                "marker_max", "cells_resampled", "components", "euler", "seconds", "peak_megabytes"),
    "enright": ("run", "time", "outcome", "triangles_mean", "volume_error", "volume_drift",
                "symmetric_difference", "mean_distance", "max_distance", "cells_resampled",
                "self_intersecting_pairs", "components", "euler", "seconds", "peak_megabytes"),
    "topology": ("run", "outcome", "components", "euler", "closed_manifold", "triangles",
                 "triangles_max", "surgeries", "refused", "seconds", "peak_megabytes"),
}


def write(path, text):
    part = pathlib.Path(str(path) + ".part")
    part.write_text(text)
    os.replace(part, path)


def rows_of(folder):
    """All rows by group, in the order of the plan."""
    runs = json.loads((folder / "runs.json").read_text())
    groups = {group: [] for group in (*GROUPS, "pictures")}
    for name, run in runs.items():
        with open(folder / "parts" / f"{name}.csv", newline="") as text:
            for row in csv.DictReader(text):
                groups[run["group"]].append({**row, "run": name})
    return groups


def as_csv(rows):
    columns = []
    for row in rows:
        columns += [c for c in row if c not in columns]
    lines = []

    class Lines:
        write = lines.append

    table = csv.DictWriter(Lines, columns, restval="", lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    return "".join(lines)


def number(row, column):
    try:
        return float(row.get(column, "") or "nan")
    except ValueError:
        return float("nan")


def cell(row, column):
    text = row.get(column, "")
    if column in LENGTHS and text:  # in cells, so that domains can be compared
        return f"{float(text) / float(row['cell_size']):.3g}"
    if column in ("volume_error", "volume_drift", "symmetric_difference") and text:
        return f"{100 * float(text):.3g} %"
    try:
        return f"{float(text):.4g}"
    except ValueError:
        return text


def page(groups):
    out = ["# Tables", "", "Made by `papers/wojtan2009/run`; all columns, and the command of each row, are in "
           "the CSV files.", "Distances are in cells of the row. `volume_error` is against the exact volume, "
           "`volume_drift` against", "the start mesh; creases and corners are exact ones, as far as they are from the "
           "surface. Seconds are CPU seconds.", ""]
    for group, title in GROUPS.items():
        if not groups[group]:
            continue
        columns = COLUMNS.get(group, COLUMNS["enright"])
        out += [f"## {title}", "", "| " + " | ".join(c.replace("_", " ") for c in columns) + " |",
                "|" + "---|" + "--:|" * (len(columns) - 1)]
        out += ["| " + " | ".join(cell(row, c) for c in columns) + " |" for row in groups[group]]
        out.append("")
    return "\n".join(out)


def coarser_and_finer(groups):
    """The runs of Enright's test at every resolution, the end of each: what the order is fitted to."""
    for row in groups["enright"]:
        test, method, *rest = row["run"].split(".")
        if test == "enright" and rest and rest[0].isdigit() and method not in ("markers", "mesh_without_topology"):
            if abs(number(row, "time") - 3) < 1e-9:
                yield {**row, "run": f"cell.{method}.{rest[0]}"}


def main():
    folder = pathlib.Path(sys.argv[1])
    groups = rows_of(folder)
    groups["topology"] = groups["bodies"] + groups["topology"]
    groups["bodies"] = []
    groups["convergence"] += coarser_and_finer(groups)
    for group in ("zalesak", "enright", "topology", "others", "convergence"):
        write(folder / f"{group}.csv", as_csv(groups[group]))
    write(folder / "tables.md", page(groups))


if __name__ == "__main__":
    main()
