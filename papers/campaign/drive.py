"""Runs a fuzz campaign, or goes on with one: what ./run does once everything is installed."""

import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import progress
import report
import summaries

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GROWS = ("cases", "surgeries")  # what may differ where a campaign goes on
LISTS = ("profiles", "arithmetics", "collapses")
LOOK_SECONDS = 5  # at most so long until progress is seen
FINISHED, FOUND, BAD_INPUT, UNFINISHED, STOPPED = 0, 1, 2, 3, 130


class Problem(Exception):
    """What keeps the campaign from running, and what to do."""


def options():
    parser = argparse.ArgumentParser(
        prog="papers/campaign/run", allow_abbrev=False,
        description="Runs a fuzz campaign by ranges of seeds, or goes on where it stopped. Ctrl-C "
        "stops it at once (the ranges under way are lost); --stop from another shell lets them end.",
        epilog="Exit codes: 0 all done and nothing found; 1 failures, crashes or hangs found; 2 bad "
        "input; 3 some ranges did not finish; 130 stopped.")
    add = parser.add_argument
    add("--surgeries", type=int, help="run until so many remodels changed the mesh")
    add("--cases", type=int, help="run so many cases instead, rounded up to whole ranges")
    add("--range", type=int, help="cases a job")
    add("--first-seed", type=int, help="seeds go on from here")
    for name, what in zip(LISTS, ("fuzz profiles: random,hostile,fed_back", "filtered,rational,...",
                                  "straighten,keep,paper")):
        add(f"--{name}", type=lambda text: text.split(","), help=what)
    add("--jobs", type=int, help="jobs at once (local: all cores; Slurm: 1000, for it to queue)")
    add("--profile", default="local", help="where: local, slurm, or a Snakemake profile's folder")
    add("--config", default=HERE / "config.yaml", type=pathlib.Path, help="instead of config.yaml")
    add("--program", type=pathlib.Path, help="a program suture, instead of building it")
    add("-o", "--output", default=ROOT / "out" / "campaign", type=pathlib.Path, help="its folder")
    add("--stop", action="store_true", help="let the campaign that runs there end its ranges, and stop")
    add("--status", action="store_true", help="say how far it is")
    add("--report", action="store_true", help="write the tables of what is done so far")
    add("--publish", action="store_true", help="copy the tables to papers/results")
    return parser.parse_args()


def settings_of(chosen):
    """The YAML and the flags over it; of a campaign that goes on only what is to be reached."""
    import yaml  # installed with snakemake

    settings = yaml.safe_load(chosen.config.read_text())
    flags = {name: value for name, value in vars(chosen).items()
             if name in settings and value is not None}
    if "surgeries" in flags and "cases" not in flags:
        flags["cases"] = 0
    frozen = chosen.output / "settings.json"
    if frozen.exists():
        before = json.loads(frozen.read_text())
        for name, value in flags.items():
            if name not in GROWS and before[name] != value:
                raise Problem(f"{chosen.output} has a campaign with {name} {before[name]}; "
                              "choose another folder with -o, or remove that one")
        flags = {name: value for name, value in flags.items() if name in GROWS}
        settings = before
    settings.update(flags)
    whole = ("surgeries", "cases", "first_seed")
    if any(settings[n] < 0 for n in whole) or settings["range"] < 1 or \
            settings["surgeries"] + settings["cases"] < 1 or not all(settings[n] for n in LISTS):
        raise Problem("surgeries or cases, range and the three lists must not be empty or negative")
    return settings


def commit():
    git = ["git", "-C", str(ROOT)]
    try:
        name = subprocess.run(git + ["rev-parse", "HEAD"], check=True, capture_output=True, text=True)
        changed = subprocess.run(git + ["status", "--porcelain", "--untracked-files=no"],
                                 check=True, capture_output=True, text=True)
        return name.stdout.strip() + (" and changes" if changed.stdout else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def freeze_program(folder, program):
    """A campaign is of one program: it is copied, so that later builds do not touch it."""
    if (folder / "program.json").exists():
        return
    source = "unknown, given with --program"
    if program is None:
        source = commit()
        done = subprocess.run(["bash", "-c", 'source "$0/.ci/setup.sh"; install_missing '
                               '"${packages[@]}"; [ -f "$build/CMakeCache.txt" ] && configure || '
                               "configure -DSUTURE_TESTS=OFF; build_targets --target suture",
                               str(ROOT)], check=False)
        if done.returncode != 0:
            raise Problem("the program could not be built")
        program = ROOT / "build" / "suture"
    shutil.copy2(program, folder / "suture")
    facts = {"commit": source, "sha256": hashlib.sha256(program.read_bytes()).hexdigest()}
    report.write(folder / "program.json", json.dumps(facts))


def locked(folder):
    """Held by this process and by its Snakemake, however they end."""
    lock = open(folder / "lock", "a+")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise Problem(f"a campaign runs in {folder} already; see --status and --stop")
    lock.truncate(0)
    lock.write(str(os.getpid()))
    lock.flush()
    return lock


def cancel_leftovers(folder):
    """Jobs of a run that was killed: Slurm would do their ranges beside the new ones."""
    mine = subprocess.run(["squeue", "--me", "--noheader", "--format=%i %Z"], check=True,
                          capture_output=True, text=True).stdout.splitlines()
    left = [line.split()[0] for line in mine if line.split(maxsplit=1)[1] == str(folder)]
    if left:
        subprocess.run(["scancel", *left], check=True)


def command(chosen, settings):
    where = [] if chosen.profile == "local" else ["--profile", str(
        HERE / chosen.profile if (HERE / chosen.profile).is_dir() else chosen.profile)]
    jobs = chosen.jobs or (os.cpu_count() if chosen.profile == "local" else None)
    jobs = ["--jobs", str(jobs)] if jobs else []  # of a cluster the profile says how many
    return ["snakemake", "--snakefile", str(HERE / "Snakefile"), *where, *jobs, "--nolock",
            "--directory", str(chosen.output), "--keep-going", "--rerun-incomplete",
            "--rerun-triggers", "mtime", "--configfile", str(chosen.output / "settings.json"),
            "--config", f"cases={settings['cases']}"]


class Run:
    """One Snakemake in a process group of its own, watched."""

    def __init__(self, chosen, settings, lock):
        (chosen.output / "finished").unlink(missing_ok=True)
        self.log = open(chosen.output / "snakemake.log", "a")
        self.process = subprocess.Popen(command(chosen, settings), stdout=self.log,
                                        stderr=subprocess.STDOUT, start_new_session=True,
                                        pass_fds=[lock.fileno()])

    def wait(self, seconds):
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None

    def stop_gently(self):
        self.process.send_signal(signal.SIGTERM)  # Snakemake lets its jobs end

    def stop_now(self):
        os.killpg(self.process.pid, signal.SIGINT)  # Snakemake cancels what runs on a cluster
        if self.wait(30) is None:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.wait(None)


class Stops:
    """Ctrl-C or SIGTERM: at once. SIGUSR1, which --stop sends: when the ranges under way end."""

    def __init__(self):
        self.now = self.gently = False
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda *_: setattr(self, "now", True))
        signal.signal(signal.SIGUSR1, lambda *_: setattr(self, "gently", True))


def say(line, last):
    if sys.stderr.isatty():
        print(f"\r\033[K{line}", end="\n" if last else "", file=sys.stderr, flush=True)
    elif last or time.monotonic() - say.at > 60:
        say.at = time.monotonic()
        print(line, file=sys.stderr, flush=True)


say.at = float("-inf")


def watch(run, stops, watched):
    """Until Snakemake ends; its exit code."""
    asked = False
    while (code := run.wait(LOOK_SECONDS)) is None:
        say(watched.line(), last=False)
        if stops.now:
            run.stop_now()
        elif stops.gently and not asked:
            run.stop_gently()
            asked = True
    return code


def more_cases(settings, watched):
    """How many cases the wanted surgeries will take, by what they took until now."""
    done, cases = watched.count("surgeries"), watched.count("cases")
    if done == 0:
        return max(2 * cases, 1)  # rounded up to a range a combination
    return max(cases + 1, int(cases * settings["surgeries"] / done * 1.01) + 1)


def goal(settings):
    """Cases in whole ranges of every combination, as the Snakefile has them; or surgeries."""
    if not settings["cases"]:
        return "surgeries", settings["surgeries"]
    whole = settings["range"] * len(settings["profiles"]) * len(settings["arithmetics"]) * \
        len(settings["collapses"])
    return "cases", -(-settings["cases"] // whole) * whole


def campaign(chosen, settings, lock):
    """Runs until the goal is reached; whether every range finished, or None if it was stopped."""
    unit, wanted = goal(settings)
    stops, watched = Stops(), progress.Progress(chosen.output, wanted, unit)
    if chosen.profile == "slurm":
        cancel_leftovers(chosen.output)
    while True:
        cases = settings["cases"] if unit == "cases" else more_cases(settings, watched)
        code = watch(Run(chosen, {**settings, "cases": cases}, lock), stops, watched)
        say(watched.line(), last=True)
        if stops.now or stops.gently:
            return None
        if code != 0:
            return False
        if unit == "cases" or watched.count("surgeries") >= wanted:
            return True


def tell(folder, total):
    print(f"{total['surgeries']:,} surgeries, {total['cases']:,} cases, {total['refused']:,} refused; "
          f"failures {total['failures']} (crashes {total['crashes']}, hangs {total['hangs']}); "
          f"see {folder / 'campaign.md'}")
    return FOUND if total["failures"] else FINISHED


def publish(folder):
    results = ROOT / "papers" / "results"
    for name in ("campaign.csv", "campaign.log.csv", "campaign.md"):
        shutil.copyfile(folder / name, results / name)
        print(results / name)


def run(chosen):
    settings = settings_of(chosen)
    chosen.output.mkdir(parents=True, exist_ok=True)
    lock = locked(chosen.output)
    freeze_program(chosen.output, chosen.program)
    report.write(chosen.output / "settings.json", json.dumps(settings, indent=1))
    done = campaign(chosen, settings, lock)
    result = FINISHED
    if done or summaries.paths(chosen.output / "parts"):
        result = tell(chosen.output, report.report(chosen.output))
    if done is None:
        print("stopped; the same command goes on")
        return STOPPED
    if not done:
        print(f"some ranges did not finish: see {chosen.output}/snakemake.log and "
              "parts/*/*.failed.log; the same command tries them again")
        return UNFINISHED
    return result


def look(chosen):
    """--status, --stop, --report and --publish: of a campaign that is there."""
    folder = chosen.output
    if not (folder / "settings.json").exists():
        raise Problem(f"there is no campaign in {folder}")
    unit, wanted = goal(json.loads((folder / "settings.json").read_text()))
    if chosen.status:
        print(progress.Progress(folder, wanted, unit).counts())
    if chosen.stop:
        try:
            locked(folder)
        except Problem:
            os.kill(int((folder / "lock").read_text()), signal.SIGUSR1)
            print("the ranges under way will end, and then it stops")
        else:
            print("no campaign runs there")
    if chosen.report or chosen.publish:
        tell(folder, report.report(folder))
    if chosen.publish:
        publish(folder)
    return FINISHED


def main():
    chosen = options()
    chosen.output = chosen.output.resolve()
    try:
        asked = chosen.status or chosen.stop or chosen.report or chosen.publish
        return look(chosen) if asked else run(chosen)
    except (Problem, summaries.BadSummary, OSError, subprocess.CalledProcessError) as problem:
        print(f"campaign: {problem}", file=sys.stderr)
        return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main())
