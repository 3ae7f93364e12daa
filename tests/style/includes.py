"""Includes only point down: between floors, between rooms and between files there is no circle.

kernel <- predicates <- surgery <- sims. A room is a folder; a header and its source are one file. Of
surgery, sims sees the public headers that CMakeLists.txt lists. CGAL stays out of sims, and VTK in its
room. The order of rooms is drawn in papers/rooms.md: what is not drawn there is refused.

usage: includes.py ROOT | includes.py --self-test | includes.py --draw ROOT > papers/rooms.md
"""
import os
import re
import sys

import house

RANK = {"kernel": 1, "predicates": 2, "surgery": 3, "sims": 4, "tests": 5}
INCLUDE = re.compile(r'^ *# *include *([<"])([^>"]+)[>"]')


def includes_of(root, floors):
    """(file, line, bracket or quote, what is included), for all sources of the floors."""
    return [(path, number, *match.groups())
            for path in house.sources(root, floors)
            for number, line in enumerate(house.text_of(root, path).splitlines(), 1)
            if (match := INCLUDE.match(line))]


def unit(path):
    return path.rsplit(".", 1)[0]


def room(path):
    return os.path.dirname(path)


def public_headers(root):
    """The headers of surgery that CMakeLists.txt installs by name."""
    return set(re.findall(r"^\s+(surgery/[\w/]+\.h)", house.text_of(root, "CMakeLists.txt"), re.M))


def cgal_headers(includes):
    """The headers that bring CGAL in, directly or through another of ours."""
    found = {path for path, _, kind, to in includes if kind == "<" and to.startswith("CGAL/")}
    while more := {path for path, _, kind, to in includes if kind == '"' and to in found} - found:
        found |= more
    return {path for path in found if path.endswith(".h")}


def faults_of_line(path, kind, to, public, cgal):
    """What is wrong with one include by itself."""
    own = path.split("/")
    if kind == "<":
        if own[0] == "sims" and to.startswith("CGAL/"):
            yield "sims includes CGAL"
        if own[0] == "sims" and own[1] != "output" and to.startswith("vtk"):
            yield "VTK belongs to sims/output"
        return
    floor = to.split("/")[0]
    if floor not in RANK:
        yield f'"{to}" does not start with a floor'
        return
    if RANK[floor] > RANK[own[0]]:
        yield f"{own[0]} includes {to}, a floor above it"
    if own[0] != "sims":
        return
    if floor == "predicates":
        yield f"sims includes {to}; it sees surgery and kernel only"
    if floor == "surgery" and to not in public:
        yield f"sims includes {to}; of surgery it sees the public headers that CMakeLists.txt lists"
    if to in cgal:
        yield f"sims includes {to}, which brings CGAL in"
    if to.startswith("sims/cli/") and own[1] != "cli":
        yield f"only sims/cli includes {to}"


def graph(includes, name):
    """Arrows between units or rooms: from each to those that it includes."""
    arrows = {}
    for path, _, kind, to in includes:
        if kind == '"' and to.split("/")[0] in house.FLOORS:
            arrows.setdefault(name(path), set())
            arrows.setdefault(name(to), set())
            if name(path) != name(to):
                arrows[name(path)].add(name(to))
    return arrows


def circles(arrows):
    """The sets of nodes that reach one another, by Tarjan's algorithm; nodes below come first."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for to in sorted(arrows[node]):
            if to not in index:
                visit(to)
            if to in stack:
                low[node] = min(low[node], low[to])
        if low[node] == index[node]:
            at = stack.index(node)
            found.append(sorted(stack[at:]))
            del stack[at:]

    sys.setrecursionlimit(10000)
    for node in sorted(arrows):
        if node not in index:
            visit(node)
    return found


def circle_faults(includes):
    for what, name in (("files", unit), ("rooms", room)):
        arrows = graph(includes, name)
        for circle in circles(arrows):
            if len(circle) > 1:
                yield f"{circle[0]}:1: a circle of {what}: " + ", ".join(circle)
                for path, line, kind, to in includes:
                    if kind == '"' and {name(path), name(to)} <= set(circle) and name(path) != name(to):
                        yield f"  {path}:{line}: {to}"


def drawing(includes):
    """papers/rooms.md: rooms in lines, each above all rooms that it includes; and each one's arrows."""
    arrows = graph(includes, room)
    level = {}
    for circle in circles(arrows):
        floor = circle[0].split("/")[0]
        below = [level[to] for node in circle for to in arrows[node]
                 if to not in circle and to.split("/")[0] == floor]
        for node in circle:
            level[node] = max(below, default=-1) + 1
    lines = [DRAWING_HEAD]
    for floor in reversed(house.FLOORS):
        rooms = [node for node in arrows if node.split("/")[0] == floor]
        for height in range(max((level[node] for node in rooms), default=-1), -1, -1):
            names = sorted(node for node in rooms if level[node] == height)
            lines.append("  " + "   ".join(names) + "\n")
        lines.append("  " + "-" * 60 + "\n")
    lines[-1] = "```\n\n| room | includes |\n|---|---|\n"
    for node in sorted(arrows, key=lambda n: (-RANK[n.split("/")[0]], -level[n], n)):
        to = sorted(arrows[node], key=lambda n: (-RANK[n.split("/")[0]], n))
        lines.append(f"| `{node}` | {', '.join(f'`{name}`' for name in to) or 'nothing'} |\n")
    return "".join(lines)


DRAWING_HEAD = """# The order of rooms

`python3 tests/style/includes.py --draw . > papers/rooms.md` writes this page, and a test compares it with
the sources. A room is a folder. Each includes only rooms on lines below its own; the table says which.
An include that adds a row's entry has to be drawn here first, where a reader of the change sees it.
`sims` sees of `surgery` only the public headers that `CMakeLists.txt` lists.

```
"""


def check(root):
    includes = includes_of(root, RANK)
    public = public_headers(root)
    cgal = cgal_headers([i for i in includes if i[0].split("/")[0] in house.FLOORS[:3]])
    found = [f"{path}:{line}: {what}" for path, line, kind, to in includes
             for what in faults_of_line(path, kind, to, public, cgal)]
    ours = [i for i in includes if i[0].split("/")[0] in house.FLOORS]
    found += circle_faults(ours)
    page = os.path.join(root, "papers/rooms.md")
    if not os.path.exists(page) or house.text_of(root, "papers/rooms.md") != drawing(ours):
        found.append("papers/rooms.md:1: is not the order of rooms; python3 tests/style/includes.py --draw "
                     ". > papers/rooms.md draws it, and what changes there wants a reason")
    return found


def self_test(planted):
    def draw():
        ours = [i for i in includes_of(planted.root, house.FLOORS)]
        planted.plant("papers/rooms.md", drawing(ours))

    planted.plant("CMakeLists.txt", "list(APPEND public_headers\n  surgery/check/surgery_check.h\n"
                  "  surgery/tracker.h)\n")
    for path, to in {"kernel/mesh.h": "<CGAL/Surface_mesh.h>", "kernel/through.h": '"kernel/mesh.h"',
                     "kernel/plain.h": "<vector>", "surgery/tracker.h": '"kernel/plain.h"',
                     "surgery/check/surgery_check.h": '"kernel/plain.h"',
                     "surgery/operate/cut.h": '"kernel/through.h"',
                     "sims/driver/run.h": '<vector>',
                     "sims/driver/run.cpp": '"surgery/tracker.h"\n#include "sims/driver/run.h"',
                     "sims/fuzz/oracles.cpp": '"surgery/check/surgery_check.h"',
                     "sims/cli/flags.cpp": '"sims/driver/run.h"',
                     "tests/surgery/cut.test.cpp": '"surgery/operate/cut.h"'}.items():
        planted.plant(path, f"#include {to}\n")
    draw()
    planted.expect_clean()
    if "`sims/cli` | `sims/driver`" not in drawing(includes_of(planted.root, house.FLOORS)):
        sys.exit("self-test: the drawing lacks an arrow")
    for path, to, parts in (
            ("predicates/up.h", '"surgery/tracker.h"', ["predicates includes"]),
            ("sims/a.cpp", '"surgery/operate/cut.h"', ["of surgery it sees the public"]),
            ("sims/b.cpp", "<CGAL/Surface_mesh.h>", ["sims includes CGAL"]),
            ("sims/c.cpp", '"kernel/through.h"', ["brings CGAL in"]),
            ("sims/d.cpp", '"sims/cli/flags.h"', ["only sims/cli"]),
            ("sims/e.cpp", "<vtkActor.h>", ["VTK"]),
            ("sims/f.cpp", '"predicates/oracle.h"', ["surgery and kernel only"]),
            ("kernel/g.cpp", '"g.h"', ["does not start with a floor"]),
            ("kernel/plain.cpp", '"surgery/tracker.h"', ["a circle of files: kernel/plain, surgery/tracker"]),
            ("sims/driver/up.h", '"sims/fuzz/oracles.h"\n#include "sims/cli/new.h"',
             ["a circle of rooms: sims/cli, sims/driver"]),
            ("sims/fuzz/more.cpp", '"sims/driver/run.h"', ["papers/rooms.md:1: is not the order"])):
        planted.plant(path, f"#include {to}\n")
        if "rooms.md" not in parts[0]:
            draw()
        planted.expect_fault(*parts)
        planted.remove(path)


if __name__ == "__main__":
    if sys.argv[1] == "--draw":
        print(drawing(includes_of(sys.argv[2], house.FLOORS)), end="")
    else:
        house.main(check, self_test)
