"""Tests mirror the rooms: tests/FLOOR/ROOM/x.test.cpp tests FLOOR/ROOM/x.h or x.cpp.

ROOM.test.cpp and ROOM_more.test.cpp test the whole room. What cuts across rooms lies in tests/FLOOR
itself. Every room has a folder of tests.
"""
import os

import house


def check(root):
    found, tested = [], set()
    for path in house.sources(root, [f"tests/{floor}" for floor in house.FLOORS]):
        if not path.endswith(".test.cpp"):
            continue
        room = os.path.relpath(os.path.dirname(path), "tests")
        tested.add(room)
        name = os.path.basename(path)[:-len(".test.cpp")]
        own = os.path.basename(room)
        if "/" in room and name != own and not name.startswith(own + "_") and not any(
                os.path.exists(os.path.join(root, room, name + end)) for end in (".h", ".cpp")):
            found.append(f"{path}:1: there is no {room}/{name}.h or .cpp; tests of the whole room are "
                         f"{own}_*.test.cpp, those across rooms lie in tests/{room.split('/')[0]}")
    for room in sorted({os.path.dirname(path) for path in house.sources(root, house.FLOORS)}):
        if not any(name == room or name.startswith(room + "/") for name in tested):
            found.append(f"{room}: has no test in tests/{room}")
    return found


def self_test(planted):
    planted.plant("kernel/shapes/torus.h", "")
    planted.plant("tests/kernel/shapes/torus.test.cpp", "")
    planted.plant("tests/kernel/shapes/shapes_closed.test.cpp", "")
    planted.plant("tests/kernel/all_of_it.test.cpp", "")
    planted.plant("tests/kernel/shapes/folder.h", "")
    planted.expect_clean()
    planted.plant("tests/kernel/shapes/taurus.test.cpp", "")
    planted.expect_fault("tests/kernel/shapes/taurus.test.cpp:1: there is no kernel/shapes/taurus")
    planted.plant("sims/flows/fold.cpp", "")
    planted.expect_fault("sims/flows: has no test")


if __name__ == "__main__":
    house.main(check, self_test)
