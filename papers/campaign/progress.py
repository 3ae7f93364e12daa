"""How far a campaign is: one line, from the parts that are there."""

import pathlib
import time

import summaries


def clock(seconds):
    minutes = int(seconds // 60)
    return f"{minutes // 60} h {minutes % 60:02d} min" if minutes >= 60 else f"{minutes} min"


class Progress:
    """Reads each part once."""

    def __init__(self, folder, goal, unit):
        self.folder, self.goal, self.unit = pathlib.Path(folder), goal, unit
        self.read = {}
        self.update()
        self.begun, self.at_start = time.monotonic(), self.count(self.unit)

    def update(self):
        for path in summaries.paths(self.folder / "parts"):
            if path not in self.read:
                part = summaries.read(path)
                self.read[path] = {**{n: part[n] for n in summaries.COUNTS},
                                   "failures": len(part["failures"]),
                                   "refused": sum(part["refused_by_cause"].values())}

    def count(self, name):
        return sum(part[name] for part in self.read.values())

    def counts(self):
        self.update()
        done = self.count(self.unit)
        return (f"{done:,} of {self.goal:,} {self.unit} ({100 * done / self.goal:.1f} %), "
                f"{self.count('cases'):,} cases, {self.count('refused'):,} refused, "
                f"failures {self.count('failures')} (crashes {self.count('crashes')}, "
                f"hangs {self.count('hangs')})")

    def line(self):
        """The counts, and how fast they have grown since this was made."""
        text, done = self.counts(), self.count(self.unit)
        rate = (done - self.at_start) / max(time.monotonic() - self.begun, 1e-9)
        text += f"; {rate:.1f} {self.unit}/s"
        if rate > 0 and done < self.goal:
            text += f"; {clock((self.goal - done) / rate)} left"
        return text
