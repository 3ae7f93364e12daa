"""The page, the tables and the log of a campaign, finished or not, from its parts.

usage: report.py FOLDER   (holds parts/, settings.json, program.json and the program itself)
Leaves campaign.json, campaign.csv, campaign.log.csv and campaign.md there.
"""

import csv
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import summaries

RAN = ("host", "processor", "slurm_job", "started", "ended")
LOG = (*summaries.NAMES, "first_seed", "cases", "remodels", "surgeries", "refused", "failures",
       "crashes", "hangs", "cpu_seconds", "digest", *RAN)
MERGED_AT_ONCE = 500  # names on one command line


def write(path, text):
    unfinished = pathlib.Path(f"{path}.unfinished")
    unfinished.write_text(text)
    os.replace(unfinished, path)


def as_csv(rows, columns):
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, extrasaction="ignore", lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def log_rows(parts):
    for part in parts:
        yield {**summaries.row([part]), **{k: part[k] for k in summaries.NAMES},
               **{k: part["ran"].get(k, "") for k in RAN}}


def merged(program, paths, scratch):
    """The program's own merging of one combination, some hundred files at a time."""
    level, todo = 0, [str(p) for p in paths]
    while True:
        done = []
        for i in range(0, len(todo), MERGED_AT_ONCE):
            to = f"{scratch}/{level}.{i}.json"
            ended = subprocess.run([program, "fuzz", "--merge", *todo[i:i + MERGED_AT_ONCE],
                                    "-o", to], stdout=subprocess.DEVNULL)
            if ended.returncode > 1:  # 1: there are failures among them
                raise summaries.BadSummary(f"{program} could not merge the parts; see above")
            done.append(to)
        level, todo = level + 1, done
        if len(todo) == 1:
            return json.loads(pathlib.Path(todo[0]).read_text())


def all_merged(folder, parts, paths):
    """Of each combination; they are checked against our own sums."""
    result = []
    for names, own in summaries.by_combination(parts).items():
        with tempfile.TemporaryDirectory() as scratch:
            one = merged(str(folder / "suture"),
                         [p for p in paths if p.parent.name == ".".join(names)], scratch)
        wrong = summaries.disagreements(own, one)
        if wrong:
            raise summaries.BadSummary(f"the merged summary of {' '.join(names)} is not the sum of "
                                       "its parts: " + "; ".join(wrong))
        result.append(one)
    return result


def markdown_table(rows, columns):
    def line(cells):
        return "| " + " | ".join(cells) + " |\n"
    text = line(c.replace("_", " ") for c in columns) + "|" + "---|" * len(columns) + "\n"
    for row in rows:
        text += line(f"{row[c]:,}" if isinstance(row[c], (int, float)) and "seed" not in c
                     else str(row[c]) for c in columns)
    return text


def conclusion(total):
    if total["failures"] or not total["surgeries"]:
        return (f"{total['surgeries']:,} surgeries: {total['failures']} failures, "
                f"of which {total['crashes']} crashes and {total['hangs']} hangs.\n")
    return (f"{total['surgeries']:,} surgeries without a failure, a crash or a hang. If cases drawn "
            "like these failed independently, the rate of failures would be below "
            f"{3 / total['surgeries']:.1e} a surgery (95 % confidence, rule of three).\n")


def page(folder, parts):
    settings = json.loads((folder / "settings.json").read_text())
    program = json.loads((folder / "program.json").read_text())
    rows = summaries.table(parts)
    failed = {p: p.name.removesuffix(".failed.log") for p in
              (folder / "parts").glob("*/*.failed.log")}
    unfinished = sorted(f"{first} of {p.parent.name}" for p, first in failed.items()
                        if not (p.parent / f"{first}.json").exists())
    text = "# A fuzz campaign\n\n" + conclusion(rows[-1]) + "\n"
    text += ("A surgery is a remodel that changed the mesh. Every profile, arithmetic and collapse "
             "order ran the same seeds. `campaign.log.csv` beside this page has a line for each "
             "range of seeds.\n\n")
    text += markdown_table(rows, summaries.TABLE) + "\n"
    ran = [part["ran"] for part in parts if part["ran"]]
    facts = {"program": f"version {', '.join(sorted({p['version'] for p in parts}))}, commit "
                        f"{program['commit']}, SHA-256 {program['sha256']}",
             "from": min((r["started"] for r in ran), default="unknown"),
             "to": max((r["ended"] for r in ran), default="unknown"),
             "hosts": ", ".join(sorted({f"{r['host']} ({r['processor']})" for r in ran})),
             "over Slurm": f"{sum(bool(r['slurm_job']) for r in ran)} of {len(parts)} ranges",
             "digest of all results": summaries.digest_of(parts),
             **{name.replace("_", " "): " ".join(value) if isinstance(value, list) else value
                for name, value in sorted(settings.items())}}
    text += "".join(f"- {name}: {fact}\n" for name, fact in facts.items())
    for name, title in (("refused_by_cause", "Remodels refused, by cause"),
                        ("ended_by_cause", "Cases that ended early, by cause"),
                        ("surgeries_by_generator", "Surgeries, by generator"),
                        ("checks_by_oracle", "Checks, by oracle")):
        counts = summaries.added(parts, name)
        if counts:
            text += f"\n## {title}\n\n" + "".join(f"- {k}: {v:,}\n" for k, v in counts.items())
    found = summaries.failures(parts)
    if found:
        text += "\n## Failures\n\n" + markdown_table(found, list(found[0]))
    if unfinished:
        text += "\n## Ranges that did not finish\n\n" + "".join(f"- {u}\n" for u in unfinished)
    return text


def report(folder):
    """Writes everything; returns the row of all. Raises BadSummary."""
    folder = pathlib.Path(folder)
    paths = summaries.paths(folder / "parts")
    if not paths:
        raise summaries.BadSummary(f"{folder} holds no finished range yet")
    parts = [summaries.read(path) for path in paths]
    whole = all_merged(folder, parts, paths)
    write(folder / "campaign.json", json.dumps(whole, indent=1) + "\n")
    write(folder / "campaign.csv", as_csv(summaries.table(parts), summaries.TABLE))
    write(folder / "campaign.log.csv", as_csv(log_rows(parts), LOG))
    write(folder / "campaign.md", page(folder, parts))
    return summaries.row(parts)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        report(sys.argv[1])
    except (summaries.BadSummary, OSError, subprocess.CalledProcessError) as problem:
        print(f"report: {problem}", file=sys.stderr)
        sys.exit(2)
