"""Seconds, volumes and topology of the figures' runs, beside what the paper says of them."""

import json
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "wojtan2009"))
from tables import as_csv, write

# What the paper says: of its figure, of its seconds a frame in 2009, of its triangles at first (0: it gives none).
CLAIMS = {
    "figure_7.mesh": ("the folded wave keeps its detail; under a second a frame", 1, 0),
    "figure_7.level_set": ("detail below a cell is lost", 0, 0),
    "figure_7.particle_level_set": ("keeps more than the level set, less than the mesh", 0, 0),
    "figure_8.mesh": ("thin legs stay, and many merge", 0, 0),
    "figure_1.mesh": ("carved detail stays where nothing merged; 63 s a frame, for fifteen balls of above 420,000 "
                      "triangles each", 63, 15 * 420000),
    "figure_10.mesh": ("droplets form and merge; 12.9 s a frame", 12.9, 0),
    "figure_10.mesh_without_topology": ("without topology change they bounce", 0, 0),
}
# Spent by the tracker; all others are the solver's.
TRACKER = ("move", "remodel", "improve")
# Stages of a remodel that find inside and outside; the others change topology or look for where to.
DISTANCE = ("crossings", "winding", "distance")


def distance_share(report):
    """Of the seconds of all remodels."""
    stages = {}
    for remodel in report.get("remodels", []):
        for stage, seconds in remodel["seconds"].items():
            stages[stage] = stages.get(stage, 0) + seconds
    return sum(stages.get(stage, 0) for stage in DISTANCE) / (sum(stages.values()) or 1)


def row_of(name, report):
    steps, summary = report["steps"], report["summary"]
    frames = max(1, len(steps) - 1)
    first, last = steps[0], steps[-1]
    spent = report["cost"]["seconds"]
    modules = {m["name"]: m["seconds"] for m in report["modules"]}
    if "remodel" in spent or "improve" in spent:  # of these only moving is within the solver's steps
        tracker = sum(spent.get(part, 0) for part in TRACKER)
        solver = sum(modules.values()) - modules.get("surface", 0)
    else:  # a surface that is contoured when the solver asks for it, whichever module does
        tracker = sum(spent.values())
        solver = max(0, sum(modules.values()) - tracker)
    remodel = spent.get("remodel", 0) / tracker if tracker else 0
    distance = remodel * distance_share(report)
    volumes = [s["volume"] / first["volume"] - 1 for s in steps]
    return {"run": name, "frames": frames, "finished": summary["finished"] and not summary["vanished"],
            "seconds_a_frame": sum(s["seconds"] for s in steps[1:]) / frames,
            "solver_cpu_a_frame": solver / frames, "tracker_cpu_a_frame": tracker / frames,
            "topology_share": remodel - distance, "distance_share": distance,
            "rest_share": 1 - remodel if remodel else 0,
            "substeps": modules and max(m["calls"] for m in report["modules"] if m["name"] == "pressure") / frames,
            "triangles_first": first["triangles"], "triangles_last": last["triangles"],
            "triangles_most": max(s["triangles"] for s in steps),
            "liquid_cells_most": max(s.get("fluid", {}).get("liquid", 0) for s in steps),
            "components_first": first["components"], "components_last": last["components"],
            "volume_last": volumes[-1], "volume_worst": max(volumes, key=abs),
            "remodels": summary["remodels"], "committed": summary["committed"], "refused": summary["refused"],
            "merged": summary["merges"], "split": summary["splits"],
            "untouched_area": last.get("untouched_area", ""),
            "closed_manifold": report.get("audit", {}).get("closed_manifold", "")}


def word_on_seconds(row, seconds, triangles):
    """Seconds are compared only where the work is the paper's, as far as we know what it was."""
    if row["triangles_first"] < 0.9 * triangles:
        return (f"seconds not comparable: {row['triangles_first']:,} triangles at first, the paper's "
                f"{triangles:,} are {triangles / row['triangles_first']:.0f} times as many")
    return "seconds hold" if row["seconds_a_frame"] < seconds else "SECONDS DO NOT HOLD"


def verdict_of(row):
    """What can be told by numbers; what the pictures show is in README.md."""
    said, seconds, triangles = CLAIMS.get(row["run"], ("", 0, 0))
    ours = (f"{row['seconds_a_frame']:.3g} s a frame (CPU: solver {row['solver_cpu_a_frame']:.3g}, tracker "
            f"{row['tracker_cpu_a_frame']:.3g}), {row['triangles_first']} to {row['triangles_most']} triangles, "
            f"up to {row['liquid_cells_most']} liquid cells; {row['merged']} merged, {row['split']} split; volume "
            f"{100 * row['volume_last']:+.2g} % at the end, {100 * row['volume_worst']:+.2g} % at worst")
    if row["untouched_area"] != "":
        ours += f"; {100 * row['untouched_area']:.0f} % of the surface never re-sampled"
    sound = row["refused"] == 0 and row["closed_manifold"] and row["finished"]
    words = ["every surface sound" if sound else "NOT SOUND"]
    if seconds:
        words.append(word_on_seconds(row, seconds, triangles))
    return f"| {row['run']} | {said} | {ours} | {'; '.join(words)} |"


def tracker_table(rows):
    """What the paper's section 8 says of its tracker's time, and ours."""
    percent = lambda x: f"{100 * x:.0f} %"
    return ["", "## Where the tracker's time goes (CPU)", "", "| run | topology | distance | rest |",
            "|---|--:|--:|--:|", "| the paper, section 8 | 60 % | 20 % | 20 % |"] + [
        f"| {row['run']} | {percent(row['topology_share'])} | {percent(row['distance_share'])} | "
        f"{percent(row['rest_share'])} |" for row in rows if row["remodels"]]


def price_table(reports):
    """Each module's CPU seconds a frame, and megabytes at most; nothing where a scene does not name it."""
    names = list(dict.fromkeys(m["name"] for r in reports.values() for m in r["modules"]))
    lines = ["", "## What each module takes (CPU seconds a frame, megabytes of arrays)", "",
             "| module | " + " | ".join(reports) + " |", "|---|" + "--:|" * len(reports)]
    for name in names:
        cells = []
        for report in reports.values():
            module = next((m for m in report["modules"] if m["name"] == name), None)
            frames = max(1, len(report["steps"]) - 1)
            cells.append(f"{module['seconds'] / frames:.3f} s, {module['bytes'] / 1e6:.0f} MB" if module else "")
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return lines


def main():
    folder = pathlib.Path(sys.argv[1])
    reports = {p.stem: json.loads(p.read_text()) for p in sorted((folder / "runs").glob("*.json"))}
    rows = [row_of(name, report) for name, report in reports.items()]
    write(folder / "fluid.csv", as_csv(rows))
    write(folder / "modules.csv",
          as_csv([{"run": name, **m} for name, r in reports.items() for m in r["modules"]]))
    out = ["# The fluid's figures", "", "The last column judges soundness and seconds, no more: `README.md` says whether the "
           "pictures show what the", "paper claims.", "", "| run | the paper | here | verdict |", "|---|---|---|---|"]
    out += [verdict_of(row) for row in rows] + tracker_table(rows) + price_table(reports)
    write(folder / "verdict.md", "\n".join(out) + "\n")


if __name__ == "__main__":
    main()
