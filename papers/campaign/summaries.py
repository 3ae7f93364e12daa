"""Summaries of `suture fuzz`: reading the parts of a campaign, and adding them up."""

import json
import pathlib

COUNTS = ("cases", "remodels", "surgeries", "crashes", "hangs")
NAMES = ("profile", "arithmetic", "collapse")  # a combination; summaries of one can be merged
TABLE = (*NAMES, "first_seed", "last_seed", "ranges", "cases", "ended_early", "remodels",
         "surgeries", "refused", "failures", "crashes", "hangs", "cpu_seconds",
         "surgeries_per_cpu_second", "digest")


class BadSummary(Exception):
    """A file that is no summary of `suture fuzz`: which, and why."""


def read(path):
    """A part: its combination, first seed, counts and so on, and where it ran."""
    path = pathlib.Path(path)
    try:
        summary = json.loads(path.read_text())
        part = {name: int(summary[name]) for name in COUNTS}
        part["refused_by_cause"] = {str(k): int(v) for k, v in summary["refused"].items()}
        part["ended_by_cause"] = {str(k): int(v) for k, v in summary["ended_early"].items()}
        part["failures"] = [{k: f[k] for k in ("seed", "oracle", "cause", "file")}
                            for f in summary["failures"]]
        part["surgeries_by_generator"] = {k: int(v["surgeries"])
                                          for k, v in summary["generators"].items()}
        part["checks_by_oracle"] = {k: int(v["checks"]) for k, v in summary["oracles"].items()}
        part["cpu_seconds"] = float(summary["cpu_seconds"])
        part["digest"] = int(summary["digest"], 16)
        part["version"] = str(summary["version"])
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadSummary(f"{path} is no summary of suture fuzz: {error!r}; "
                         "remove it and run the campaign again, which does that range again")
    try:
        part.update(zip(NAMES, path.parent.name.split("."), strict=True))
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


def digest_of(parts):
    """As `suture fuzz` adds them up, so that their order is no matter."""
    return f"{sum(part['digest'] for part in parts) % 2**64:016x}"


def row(parts, **names):
    """One line of the table: the sums over `parts`, which may be none."""
    result = {name: sum(part[name] for part in parts) for name in COUNTS}
    result["first_seed"] = min((p["first_seed"] for p in parts), default="")
    result["last_seed"] = max((p["first_seed"] + p["cases"] - 1 for p in parts), default="")
    result["ranges"] = len(parts)
    result["refused"] = sum(sum(p["refused_by_cause"].values()) for p in parts)
    result["ended_early"] = sum(sum(p["ended_by_cause"].values()) for p in parts)
    result["failures"] = sum(len(p["failures"]) for p in parts)  # crashes and hangs among them
    seconds = sum(p["cpu_seconds"] for p in parts)
    result["cpu_seconds"] = round(seconds, 1)
    result["surgeries_per_cpu_second"] = round(result["surgeries"] / seconds, 2) if seconds else ""
    return {**result, "digest": digest_of(parts), **names}


def by_combination(parts):
    """{(profile, arithmetic, collapse): parts}, in that order."""
    result = {}
    for part in sorted(parts, key=lambda p: [p[n] for n in NAMES]):
        result.setdefault(tuple(part[n] for n in NAMES), []).append(part)
    return result


def table(parts):
    """A row for each combination, and one for all."""
    rows = [row(own, **dict(zip(NAMES, names))) for names, own in by_combination(parts).items()]
    return rows + [row(parts, **dict.fromkeys(NAMES, "all"))]


def added(parts, name):
    """Counts by cause, generator or oracle over all parts."""
    result = {}
    for part in parts:
        for key, count in part[name].items():
            result[key] = result.get(key, 0) + count
    return dict(sorted(result.items()))


def failures(parts):
    return [{**{n: p[n] for n in NAMES}, **f} for p in parts for f in p["failures"]]


def disagreements(parts, merged):
    """What the program's own merged summary says otherwise than the sum of the parts."""
    total = row(parts)
    theirs = {name: merged.get(name) for name in (*COUNTS, "digest")}
    theirs["failures"] = len(merged.get("failures", []))
    return [f"{name}: {total[name]} here, {theirs[name]} in the merged summary"
            for name in theirs if theirs[name] != total[name]]
