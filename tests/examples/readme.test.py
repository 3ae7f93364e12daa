"""The README's C++ program is tests/examples/readme.cpp, word for word; only its first line differs."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
programs = re.findall(r"^```cpp\n(.*?)^```", (root / "README.md").read_text(), re.M | re.S)
built = (root / "tests/examples/readme.cpp").read_text().split("\n", 1)[1]
if len(programs) != 1:
    sys.exit(f"README.md has {len(programs)} C++ programs; this test knows of one")
if programs[0].strip() != built.strip():
    sys.exit("README.md's program is not tests/examples/readme.cpp after its first line")
