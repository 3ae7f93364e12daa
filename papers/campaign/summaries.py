"""Summaries of `suture fuzz`: reading the parts of a campaign, and adding them up."""

import json
import pathlib

COUNTS = ("cases", "remodels", "surgeries", "crashes", "hangs")
TABLE = ("profile", "arithmetic", "collapse", "first_seed", "last_seed", "ranges", "cases",
         "remodels", "surgeries", "refused", "failures", "crashes", "hangs", "cpu_seconds",
         "surgeries_per_cpu_second")


class BadSummary(Exception):
    """A file that is no summary of `suture fuzz`: which, and why."""


def read(path):
    """A part: {combination, first_seed, ...} as the program wrote it, and where it ran."""
    path = pathlib.Path(path)
    try:
        summary = json.loads(path.read_text())
        part = {name: int(summary[name]) for name in COUNTS}
        part["refused_by_cause"] = {str(k): int(v) for k, v in summary["refused"].items()}
        part["failures"] = [{k: f.get(k, "") for k in ("seed", "oracle", "cause", "file")}
                            for f in summary["failures"]]
        part["cpu_seconds"] = float(summary["cpu_seconds"])
        part["digest"] = str(summary["digest"])
        part["version"] = str(summary["version"])
        part["by_generator"] = summary.get("by_generator", {})
        part["by_oracle"] = summary.get("by_oracle", {})
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadSummary(f"{path} is no summary of suture fuzz: {error!r}; "
                         "remove it and run the campaign again, which does that range again")
    try:
        part["profile"], part["arithmetic"], part["collapse"] = path.parent.name.split(".")
        part["first_seed"] = int(path.stem)
    except ValueError:
        raise BadSummary(f"{path} is not at PROFILE.ARITHMETIC.COLLAPSE/FIRST_SEED.json")
    ran = path.with_suffix(".ran")
    part["ran"] = json.loads(ran.read_text()) if ran.exists() else {}
    return part


def paths(folder):
    """The parts that are done, in the order of combinations and seeds."""
    return sorted(pathlib.Path(folder).glob("*.*.*/[0-9]*.json"),
                  key=lambda p: (p.parent.name, int(p.stem)))


def row(parts, **names):
    """One line of the table: the sums over `parts`, which may be none."""
    result = {name: sum(part[name] for part in parts) for name in COUNTS}
    result["first_seed"] = min((p["first_seed"] for p in parts), default="")
    result["last_seed"] = max((p["first_seed"] + p["cases"] - 1 for p in parts), default="")
    result["ranges"] = len(parts)
    result["refused"] = sum(sum(p["refused_by_cause"].values()) for p in parts)
    result["failures"] = sum(len(p["failures"]) for p in parts)
    seconds = sum(p["cpu_seconds"] for p in parts)
    result["cpu_seconds"] = round(seconds, 1)
    result["surgeries_per_cpu_second"] = round(result["surgeries"] / seconds, 2) if seconds else ""
    return {**result, **names}


def table(parts):
    """A row for each profile, arithmetic and collapse order, and one for all."""
    def combination(part):
        return part["profile"], part["arithmetic"], part["collapse"]
    rows = []
    for profile, arithmetic, collapse in sorted({combination(p) for p in parts}):
        own = [p for p in parts if combination(p) == (profile, arithmetic, collapse)]
        rows.append(row(own, profile=profile, arithmetic=arithmetic, collapse=collapse))
    return rows + [row(parts, profile="all", arithmetic="all", collapse="all")]


def added(parts, name):
    """Counts by cause, generator or oracle over all parts."""
    result = {}
    for part in parts:
        for key, count in part[name].items():
            if isinstance(count, (int, float)):
                result[key] = result.get(key, 0) + count
    return dict(sorted(result.items()))


def failures(parts):
    return [{"profile": p["profile"], "arithmetic": p["arithmetic"], "collapse": p["collapse"], **f}
            for p in parts for f in p["failures"]]


def disagreements(parts, merged):
    """What the program's own merged summary says otherwise than the sum of the parts."""
    total = row(parts)
    theirs = {name: merged.get(name) for name in COUNTS}
    theirs["failures"] = len(merged.get("failures", []))
    return [f"{name}: {total[name]} here, {theirs[name]} in the merged summary"
            for name in theirs if theirs[name] != total[name]]
