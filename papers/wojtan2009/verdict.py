"""What was claimed in print, what was measured here, and whether the claim holds: a page, and printed."""

import csv
import pathlib
import sys

sys.dont_write_bytecode = True
from tables import number, write  # noqa: E402

EL_TOPO = "El Topo: −0.179 % of volume and 2.5e-4 mean distance at T, −0.25 % at T/2, 343 s"
ROUNDED = 0.1  # cells from a corner to the surface: less would not be seen in Figure 11
PARTICLES = "the particle level set keeps more than the level set (volume and mean distance), not the corners"


class Tables:
    def __init__(self, folder):
        self.rows = []
        for name in ("zalesak", "enright", "topology", "others"):
            with open(folder / f"{name}.csv", newline="") as text:
                self.rows += list(csv.DictReader(text))

    def at(self, run, time=None):
        """The row of a run (the first whose name begins so) at a time, or at its last."""
        mine = [r for r in self.rows if r["run"] == run] or \
               [r for r in self.rows if r["run"].startswith(run + ".")]
        if time is not None:
            mine = [r for r in mine if abs(number(r, "time") - time) < 1e-3 * time]
        return mine[-1] if mine else None

    def runs(self, start):
        return [r for r in self.rows if r["run"].startswith(start)]


def percent(x):
    return f"{100 * x:+.3g} %"


def verdict(figure, claim, ours, holds):
    word = "no rows" if holds is None else "holds" if holds else "DOES NOT HOLD"
    return {"figure": figure, "claim": claim, "ours": ours, "verdict": word}


def missing(t, figure, claim, run):
    """No row to judge by: nothing was run, or what was did not get there, which is no pass."""
    rows = t.runs(run + ".") + [r for r in t.rows if r["run"] == run]
    if not rows:
        return verdict(figure, claim, "the runs for it are not there", None)
    return verdict(figure, claim, f"{run}: {rows[-1].get('outcome', '')} {rows[-1].get('failure', '')}",
                   False)


def zalesak(t, resolution):
    figure, claim = "Figure 11, Zalesak's sphere", \
        "the mesh \"perfectly preserves the sharp corners\" (2009)"
    for turns, time in (("one turn", 628), ("two turns", 1256)):
        row, floor = t.at(f"zalesak.mesh.{resolution}", time), t.at(f"zalesak.markers.{resolution}", time)
        if row is None or floor is None:
            absent = "mesh" if row is None else "markers"
            yield missing(t, f"{figure}, {turns}", claim, f"zalesak.{absent}.{resolution}")
            continue
        cells, cell = number(row, "cells_resampled"), number(row, "cell_size")
        marker, least = number(row, "marker_max"), number(floor, "marker_max")
        ours = (f"{number(row, 'start_triangles'):.0f} triangles; {cells:.0f} cells re-sampled; volume "
                f"{percent(number(row, 'volume_drift'))} of the start's; exact corners "
                f"{number(row, 'corner_max') / cell:.2g} cells from the surface, vertices (corners' own "
                f"too) at most {marker / cell:.2g} cells off (RK4 markers {least / cell:.2g})")
        holds = cells == 0 and abs(number(row, "volume_drift")) < 1e-6 and marker <= 1.001 * least
        yield verdict(f"{figure}, {turns}", claim, ours, holds)
    baselines = {"level_set": "level sets round the corners off",
              "level_set_mac_cormack": "level sets round the corners off",
              "particle_level_set": PARTICLES, "particle_level_set_weno": PARTICLES,
              "semi_lagrangian_contouring": "contouring every step rounds the corners off"}
    level_set = t.at(f"zalesak.level_set.{resolution}", 628)
    for method, said in baselines.items():
        row = t.at(f"zalesak.{method}.{resolution}", 628)
        if row is None or level_set is None:
            absent = method if row is None else "level_set"
            yield missing(t, f"{figure}, {method}", said, f"zalesak.{absent}.{resolution}")
            continue
        cell = number(row, "cell_size")
        ours = (f"volume {percent(number(row, 'volume_error'))}, mean distance "
                f"{number(row, 'mean_distance') / cell:.2g} cells, exact corners "
                f"{number(row, 'corner_max') / cell:.2g} cells from the surface")
        if method.startswith("particle"):
            ours += (f"; the level set: volume {percent(number(level_set, 'volume_error'))}, mean distance "
                     f"{number(level_set, 'mean_distance') / number(level_set, 'cell_size'):.2g} cells")
        holds = number(row, "corner_max") > ROUNDED * cell and \
            (not method.startswith("particle") or keeps_more(row, level_set))
        yield verdict(f"{figure}, {method}", said, ours, holds)


def keeps_more(row, other):
    """Of the volume and of the shape: being better in one of them is not enough."""
    return all(abs(number(row, of)) < abs(number(other, of)) for of in ("volume_error", "mean_distance"))


def enright(t, resolution):
    for scene, variant in (("enright_eltopo", "El Topo's variant"), ("enright", "LeVeque's variant")):
        yield from enright_variant(t, scene, variant, resolution)


def enright_variant(t, scene, variant, resolution):
    row, half = t.at(f"{scene}.mesh.{resolution}", 3), t.at(f"{scene}.mesh.{resolution}", 1.5)
    if row is None or half is None:
        yield missing(t, f"Enright's test, {variant}", EL_TOPO, f"{scene}.mesh.{resolution}")
        return
    triangles = number(row, "triangles_mean")
    ours = (f"{percent(number(row, 'volume_error'))} and {number(row, 'mean_distance'):.2g} at T, "
            f"{percent(number(half, 'volume_error'))} at T/2, {triangles:.0f} triangles on average, "
            f"{number(row, 'seconds'):.0f} s")
    yield verdict(f"Enright's test, {variant}, beside El Topo", EL_TOPO, ours,
                  abs(number(row, "volume_error")) < 1.79e-3 and number(row, "mean_distance") < 2.5e-4
                  and abs(number(half, "volume_error")) < 2.5e-3 and number(row, "seconds") < 343)
    yield verdict(f"Enright's test, {variant}, our own goal",
                  "under 0.01 % and 5e-5 at T, 0.15 % at T/2, 25,000 triangles, 20 s", ours,
                  abs(number(row, "volume_error")) < 1e-4 and number(row, "mean_distance") < 5e-5
                  and abs(number(half, "volume_error")) < 1.5e-3 and triangles <= 25000
                  and number(row, "seconds") < 20)


def published_level_sets(t):
    """What a study before this code had of OpenVDB with its defaults, at each resolution; nobody published it."""
    for resolution, said in ((64, -0.628), (100, -0.361), (128, -0.252)):
        row = t.at(f"enright.level_set.{resolution}", 3)
        claim = f"our own study of OpenVDB's defaults, not published, at {resolution}³: {percent(said)} of volume"
        if row is None:
            yield missing(t, "Enright's test, level set", claim, f"enright.level_set.{resolution}")
            continue
        error = number(row, "volume_error")
        yield verdict("Enright's test, level set", claim, f"{percent(error)}", abs(error - said) < 0.05)


def is_sound(row):
    return row["outcome"] == "done" and row.get("closed_manifold") == "yes"


def topology(t):
    for count, wanted, said in ((100, 100, "100 of 100 runs, 6.1 minutes a run"),
                                (1000, 20, "50 of 50 runs, 44.6 minutes a run")):
        rows = t.runs(f"spheres_{count}.")
        claim = f"Heiss-Synak et al. 2024: {said}"
        if not rows:
            yield missing(t, f"{count} balls in normal flow", claim, f"spheres_{count}")
            continue
        sound = [r for r in rows if is_sound(r) and number(r, "components") == 1]
        mean = sum(number(r, "seconds") for r in rows) / len(rows)
        triangles = sum(number(r, "triangles_max") for r in rows) / len(rows)
        ours = (f"{len(sound)} of {len(rows)} runs closed, oriented, manifold and one body, {mean:.1f} CPU "
                f"seconds a run, up to {triangles:.0f} triangles")
        whole = len(rows) >= wanted
        yield verdict(f"{count} balls in normal flow", claim, ours,
                      len(sound) == len(rows) if whole else None)
    for scene, said in (("two_spheres", "one body, χ = 2"), ("dumbbell", "two bodies, χ = 4")):
        row = t.at(f"{scene}.mesh")
        if row is None:
            yield missing(t, scene, said, f"{scene}.mesh")
            continue
        yield verdict(scene.replace("_", " "), said,
                      f"{row['outcome']}: {number(row, 'components'):.0f} components, χ = "
                      f"{number(row, 'euler'):.0f}",
                      is_sound(row) and number(row, "components") == number(row, "components_expected")
                      and number(row, "euler") == number(row, "euler_expected"))


def main():
    folder = pathlib.Path(sys.argv[1])
    t = Tables(folder)
    resolution = (folder / "resolution").read_text().strip()
    all_of_them = [*zalesak(t, resolution), *enright(t, resolution), *published_level_sets(t),
                   *topology(t)]
    out = ["# Verdicts", "", "| figure or test | claimed | measured | verdict |", "|---|---|---|---|"]
    for v in all_of_them:
        out.append(f"| {v['figure']} | {v['claim']} | {v['ours']} | {v['verdict']} |")
        print(f"{v['figure']}\n  claimed:  {v['claim']}\n  measured: {v['ours']}\n  {v['verdict']}")
    write(folder / "verdict.md", "\n".join(out) + "\n")


if __name__ == "__main__":
    main()
