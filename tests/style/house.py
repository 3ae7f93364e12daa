"""Common parts of the style checks in Python: where sources are, and the proof that a check can fail."""
import os
import pathlib
import sys
import tempfile
import tomllib

FLOORS = ["kernel", "predicates", "surgery", "sims"]


def sources(root, floors):
    """The .h and .cpp files of the floors as paths relative to root, sorted."""
    found = []
    for floor in floors:
        for folder, _, names in os.walk(os.path.join(root, floor)):
            found += [os.path.relpath(os.path.join(folder, name), root)
                      for name in names if name.endswith((".h", ".cpp"))]
    return sorted(found)


def text_of(root, path):
    return pathlib.Path(root, path).read_text()


def limits(root):
    """The numbers of tests/style/limits.toml."""
    return tomllib.loads(text_of(root, "tests/style/limits.toml"))


class Planted:
    """A small project in a temporary folder, into which a self-test plants faults."""

    def __init__(self, check):
        self.check = check
        self.folder = tempfile.TemporaryDirectory()
        self.root = self.folder.name

    def plant(self, path, text):
        file = pathlib.Path(self.root, path)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def expect_clean(self):
        found = self.check(self.root)
        if found:
            sys.exit("self-test: a clean project was refused: " + "\n".join(found))

    def expect_fault(self, *parts):
        """Wants one fault that holds all parts."""
        found = self.check(self.root)
        if not any(all(part in fault for part in parts) for fault in found):
            sys.exit(f"self-test: not found: {parts}; found: {found}")

    def remove(self, path):
        pathlib.Path(self.root, path).unlink()


def main(check, self_test):
    """`ROOT`: prints what the check finds, and fails if it finds anything. `--self-test`: plants faults."""
    if sys.argv[1] == "--self-test":
        self_test(Planted(check))
        return
    if not sources(sys.argv[1], FLOORS):
        sys.exit(f"no sources under {sys.argv[1]}")
    found = check(sys.argv[1])
    if found:
        sys.exit("\n".join(found))
